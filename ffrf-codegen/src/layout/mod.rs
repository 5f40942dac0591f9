//! Layout: what is known about each invariant when the code is generated.
//!
//! An invariant that is known to be zero, or the identity, costs nothing: no data, no operation, no code.
//! [`Layout`] is declared for bodies whose invariants come at run time, and [found](found()) in a model
//! by a relative tolerance for bodies whose invariants are baked in.

mod declared;
mod found;
mod parse;

pub use crate::invariants::Structure;
pub use declared::Layout;
pub use found::{GramScales, found, negligible_first_moment};
