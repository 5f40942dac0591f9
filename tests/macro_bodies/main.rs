//! `flexible_body!` at work: from finite-element files to numbers, models, number types, invariants at run time, fidelities,
//! and what its options cost.

mod conrod;
mod fidelities;
mod generic_scalar;
mod invariants;
mod lever_arms;
mod models;
mod parameter_lanes;
mod reference_bodies;
mod shaft;
