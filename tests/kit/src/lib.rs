//! What the tests and benchmarks of several packages share: bodies, witnesses, helpers of proofs, tolerances.
//!
//! No package depends on it but for development. Integration tests of a package that this one depends on share its
//! types; unit tests inside such a package do not, since they are compiled apart.
#![forbid(unsafe_code)]

pub mod random;
pub mod random_body;
