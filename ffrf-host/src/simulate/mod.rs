//! Simulation of a scene: the way through time, and what is seen on it.

mod advance;
mod check;
mod co_simulation;
mod events;
mod one_step;
mod point;
mod run;
mod sample;
mod saved_state;
mod spin;
mod watch;

pub use advance::{Advance, Advancing};
pub use check::{SceneCheck, check};
pub use co_simulation::{CoSimulation, Point};
pub use events::{Ended, Event, EventFunction, Then, run_with_events};
pub use one_step::States;
pub(crate) use one_step::{step_in_space, tolerances};
pub use run::{Progress, SimulationError, Summary, simulate};
pub use sample::{Sample, header};
pub(crate) use sample::{read as read_sensor, total_energy};
pub use saved_state::{BodyState, SavedState, StateError, WholeStep};
pub use spin::SpinWarning;
pub use watch::Passed;
