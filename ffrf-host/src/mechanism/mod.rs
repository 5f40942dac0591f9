//! Mechanisms of run-time size.

mod drive;
mod element;
mod formula;
mod host_mechanism;
mod joint_coordinates;
mod plan;
mod ports;
mod scheduled_actuator;
mod states;
mod table;

pub use drive::Drive;
pub use element::{Element, ElementKind};
pub use formula::{Formula, FormulaError};
pub use host_mechanism::HostMechanism;
pub use joint_coordinates::{JointCoordinates, TreeError};
pub use ports::HostPorts;
pub use scheduled_actuator::ScheduledActuator;
pub use states::HostIncrement;
pub use table::{Table, TableError};
