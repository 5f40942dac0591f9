//! From a reduced flexible body to Rust kernels.
#![forbid(unsafe_code)]

pub mod body;
pub mod derive;
pub mod expression;
pub mod fidelity;
pub mod formulate;
pub mod layout;
pub mod polynomial;

mod error;
mod options;

pub use error::CodegenError;
pub use fidelity::Fidelity;
pub use options::{DEFAULT_LAYOUT_TOLERANCE, FusedMultiplyAdd, GenerateOptions, ScalarType};
