//! Mechanisms: bodies, joints and forces as one system.

mod assembly;
mod body_port;
mod cast;
mod connection;
mod constraints;
mod elimination;
mod plan;
mod port;

pub use assembly::{Assembly, Constrained, Treatment};
pub use body_port::{AttachedRow, BodyPort, ImplicitTerms};
pub use connection::{Attachment, Connection};
pub use constraints::{Constraints, Level, Regularisation, Storage};
pub use elimination::{Coupling, Elimination, LARGEST_NODE, Step};
pub use plan::{Block, BodyPlace, EndPlace, JointPlace, Plan, SharedPlace};
pub use port::{Port, Ports};
