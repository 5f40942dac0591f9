//! `flexible_body!` at work: models, number types, invariants at run time, fidelities, and what its options cost.

mod fidelities;
mod generic_scalar;
mod invariants;
mod lever_arms;
mod models;
mod parameter_lanes;
