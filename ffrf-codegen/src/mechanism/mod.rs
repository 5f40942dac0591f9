//! Mechanisms: in which order their equations are solved, where every number of them stands, and what one is as a whole.

mod branches;
mod composition;
mod elimination_order;
mod known_force;
mod known_joint;
mod model;
mod places;
mod topology;

pub use branches::BranchPlace;
pub use composition::{CompositionModel, ElementRule, JointRule, ParameterModel, ParameterPlace};
pub use known_force::soft_row_count;
pub use known_joint::{KNOWN_JOINTS, KnownJoint};
pub use model::{
    ActuatorModel, AttachmentModel, BodyKind, BodyModel, EffortModel, ElementKindModel, ElementModel,
    FlexibleModel, JointModel, MarkerModel, MechanismModel, RelationModel, SensorKindModel, SensorModel,
    StepMethod,
};
pub use places::{
    BlockPlace, BodyPlace, CouplingPlace, EndPlace, JointPlace, MechanismPlan, ModalEndPlace, ModesPlace,
    SharedPlace, StepPlace,
};
pub use topology::{Hub, JointTopology, Topology, TopologyError};
