//! Helpers of proofs: polynomials that are compared, numbers without rounding, numbers with derivatives, wrong copies.

pub mod compare;
pub mod dual;
pub mod exact;
pub mod mutated;
pub mod residual;
pub mod sample;
