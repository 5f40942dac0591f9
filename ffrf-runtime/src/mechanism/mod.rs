//! Mechanisms: bodies, joints and forces as one system.

mod assemble;
mod assembly;
mod attached_rows;
mod body_in_tree;
mod body_port;
mod cast;
mod connection;
mod constrained;
mod constraints;
mod drive;
mod element;
mod elimination;
mod energy;
mod evaluated_joint;
mod fixed_plan;
#[doc(hidden)]
pub mod generated;
mod implicit_terms;
mod joint_friction;
mod kept_modes;
mod kept_plan;
mod loaded;
mod moving;
mod node;
mod plan;
mod port;
mod regularisation;
mod rigid_frame;
mod room;
mod rubbing;
mod sensing;
mod soft_rows;
mod softening;
mod solved;
mod sweep;
mod tree;
mod tree_port;
mod triads;

pub use assembly::{Assembly, Treatment};
pub use attached_rows::AttachedRows;
pub use body_port::BodyPort;
pub use connection::{Attachment, Connection};
pub use constrained::Constrained;
pub use constraints::{Constraints, Level, Storage, Target};
pub use drive::{Drive, MOST_COEFFICIENTS, polynomial};
pub use element::Element;
pub use elimination::Elimination;
pub use energy::{Energy, Momentum};
pub use evaluated_joint::EvaluatedJoint;
pub use fixed_plan::FixedPlan;
pub use implicit_terms::ImplicitTerms;
pub use joint_friction::JointFriction;
pub use kept_modes::{Keeping, KeptModes};
pub use kept_plan::{PlanLists, PlanSizes, Unexpanded, keeps_modes};
pub use loaded::Loaded;
pub use moving::{Mechanism, NotAssembled};
pub use node::{Coupling, LARGEST_NODE, Step};
pub use plan::{
    Block, BodyPlace, EndPlace, Equations, JointPlace, ModalEndPlace, ModalPairPlace, ModesPlace, Plan,
    SharedPlace,
};
pub use port::{Phase, Port, Ports};
pub use regularisation::Regularisation;
pub use rigid_frame::RigidFrame;
pub use room::Room;
pub use rubbing::FRICTION_PASSES;
pub use sensing::{acceleration, reaction};
pub use soft_rows::SoftLink;
pub use tree::{Branch, Freedom, Limb, LimbEnd, sweeps};
pub use tree_port::TreePort;
pub use triads::{along_axis, second_triad, turn_about};
