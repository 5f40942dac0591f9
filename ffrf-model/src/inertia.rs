//! The constant inertia invariants of a flexible body (206-208, corrected: `docs/theory/equations.md`).

use serde::{Deserialize, Serialize};

/// Three numbers: x, y, z.
pub type Vector3 = [f64; 3];
/// Rows of a 3 x 3 matrix.
pub type Matrix3 = [[f64; 3]; 3];

/// Inertia invariants about the frame origin, in body components.
///
/// They are the Gram matrix, in the mass inner product, of the scalar fields 1, xⁱ and φ_μⁱ,
/// hence positive semidefinite as a whole.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Inertia {
    /// Mass m. Units: kg.
    pub mass: f64,
    /// First moment m a = ∫ρ x. Units: kg m.
    pub first_moment: Vector3,
    /// Modal first moments m b_μ = ∫ρ φ_μ. Shape: M x 3.
    pub modal_first_moment: Vec<Vector3>,
    /// Second moment (Euler tensor) T^{ij} = ∫ρ xⁱ xʲ. Units: kg m^2.
    pub second_moment: Matrix3,
    /// Position-mode moments T_μ^{ij} = ∫ρ xⁱ φ_μʲ. Shape: M x 3 x 3, not symmetric.
    pub position_mode_moment: Vec<Matrix3>,
    /// Mode-mode moments T_μν^{ij} = ∫ρ φ_μⁱ φ_νʲ. Shape: M x M x 3 x 3, T_νμ = T_μνᵀ.
    pub mode_mode_moment: Vec<Vec<Matrix3>>,
}
