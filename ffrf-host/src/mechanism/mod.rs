//! Mechanisms of run-time size.

mod drive;
mod host_mechanism;
mod plan;
mod states;

pub use drive::Drive;
pub use host_mechanism::{HostMechanism, HostPorts};
pub use states::HostIncrement;
