//! Mechanisms: in which order their equations are solved, and where every number of them stands.

mod elimination_order;
mod known_force;
mod known_joint;
mod places;
mod topology;

pub use known_force::soft_row_count;
pub use known_joint::{KNOWN_JOINTS, KnownJoint};
pub use places::{
    BlockPlace, BodyPlace, CouplingPlace, EndPlace, JointPlace, MechanismPlan, ModalEndPlace, ModesPlace,
    SharedPlace, StepPlace,
};
pub use topology::{Hub, JointTopology, Topology, TopologyError};
