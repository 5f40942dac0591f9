//! Whether invariants that come at run time can be those of a body.
//!
//! The generator prints `check` of such a body as a list of calls to [`checks`]; the layout decides which.

#[doc(hidden)]
pub mod checks;
mod entries;
mod error;
mod pivots;
mod tolerances;

pub use error::{InvariantError, InvariantExpectation, InvariantIndex};
