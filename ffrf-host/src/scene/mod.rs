//! Scene files: mechanisms without a compiler.

mod bodies;
mod calls;
mod compose;
mod consistency;
mod efforts;
mod error;
mod events;
pub mod file;
mod forces;
mod joints;
mod lines;
mod mechanism_model;
mod modes_value;
mod names;
mod scene_model;
mod sensors;
mod settings;

pub use calls::{BodyCall, MacroCalls, camel, macro_calls};
pub use compose::Scene;
pub use consistency::{Residuals, residuals};
pub use error::SceneError;
pub use events::{Direction, SceneEvent};
pub use lines::Lines;
pub use modes_value::ModesValue;
pub use scene_model::SceneModel;
pub use sensors::{Sensor, SensorKind};
pub use settings::{Coordinates, Integrator, Settings, StepChoice};
