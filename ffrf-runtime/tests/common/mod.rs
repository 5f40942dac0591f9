//! What the tests of the runtime share.
#![allow(dead_code)] // each test file uses its own part

pub mod bodies;
pub mod convergence;
pub mod held;
pub mod naive_body;
pub mod provided;
pub mod reference;
pub mod tolerances;
