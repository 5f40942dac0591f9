//! What the tests and benchmarks of several packages share: bodies, witnesses, helpers of proofs, tolerances, compilers, CalculiX.
//!
//! No package depends on it but for development. Integration tests of a package that this one depends on share its
//! types; unit tests inside such a package do not, since they are compiled apart.
#![forbid(unsafe_code)]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // helpers of tests are tests

pub mod c_compilers;
pub mod calculix;
pub mod random;
pub mod random_body;
pub mod scene_text;
pub mod tolerances;

#[cfg(feature = "runtime")]
pub mod bodies;
#[cfg(feature = "runtime")]
pub mod convergence;
#[cfg(feature = "runtime")]
pub mod every_joint;
#[cfg(feature = "runtime")]
pub mod held;
#[cfg(feature = "runtime")]
pub mod naive_body;
#[cfg(feature = "runtime")]
pub mod provided;
#[cfg(feature = "runtime")]
pub mod reference;

#[cfg(feature = "codegen")]
pub mod doors;
#[cfg(feature = "codegen")]
mod filled;
#[cfg(feature = "codegen")]
pub mod interpreted_body;
#[cfg(feature = "codegen")]
pub mod witness;

#[cfg(feature = "proof")]
pub mod proof;
