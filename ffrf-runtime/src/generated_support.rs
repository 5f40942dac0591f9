//! What generated code calls. Not part of the public interface: it changes together with the generator.

pub use crate::body::bent;
pub use crate::invariants::checks;
pub use crate::lanes;
pub use crate::math::*;
pub use crate::mechanism::generated as mechanism;
