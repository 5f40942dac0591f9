//! Joints, one file each, composed of [relations](crate::relations).

mod angle;
mod constant_orientation;
mod cylindrical;
mod distance;
mod fixed;
mod generic;
mod in_line;
mod in_plane;
mod joint;
mod kind;
mod planar;
mod prismatic;
mod revolute;
mod spherical;
mod travel;
mod universal;

pub use angle::Angle;
pub use constant_orientation::ConstantOrientation;
pub use cylindrical::Cylindrical;
pub use distance::Distance;
pub use fixed::Fixed;
pub use generic::Generic;
pub use in_line::InLine;
pub use in_plane::InPlane;
pub use joint::{Joint, JointShape};
pub use kind::JointKind;
pub use planar::Planar;
pub use prismatic::Prismatic;
pub use revolute::Revolute;
pub use spherical::Spherical;
pub use travel::Travel;
pub use universal::Universal;
