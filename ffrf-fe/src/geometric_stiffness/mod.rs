//! Geometric stiffness: what the stresses of inertial loads add to the stiffness of the modes.
//!
//! The way through this module: `loads` are the forces of unit accelerations; `support` balances them as the frame of the modes
//! asks and gives the displacements that they cause; `integrate` turns these into stresses inside the elements, and the
//! stresses into Γ_μν = ∫ ∇φ_μᵀ σ ∇φ_ν. `marker_loads` does the same for forces and moments at markers. `second_order` goes the
//! other way round, for checks.

mod compute;
mod integrate;
mod loads;
mod marker_loads;
mod second_order;
mod support;

pub use crate::error::GeometricStiffnessError;
pub use compute::geometric_stiffness;
pub use marker_loads::marker_load_stiffness;
pub use second_order::{SecondOrder, second_order_displacements};
pub use support::PrestressSupport;
