//! Stress stiffness of unit inertial loads: what makes a body stiffer or softer while it is accelerated.

use serde::{Deserialize, Serialize};

use crate::{Matrix3, Vector3};

/// Geometric stiffness Γ = Ψᵀ K_σ Ψ of the stresses that unit body forces leave in the supported body.
///
/// The body moves with the acceleration a(x) = α + (ω̇~ + ω~ ω~) x, which loads it by the body force -ρ a. The stress σ of this
/// load, and with it K_σ = ∫ ∇φᵀ σ ∇φ, is linear in the load: -α_j Γ_μν^j - (ω̇~ + ω~ ω~)_ji Γ_μν^{ij} is the stiffness that
/// the state adds to K_ff. Symmetric in μ and ν. Frame: body. Units: N/m per N/m³ of load, times those of ρ: kg for unit modes.
/// Source: Wallrapp and Schwertassek, International Journal for Numerical Methods in Engineering 32 (1991);
/// `docs/theory/geometric-stiffening.md`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GeometricStiffness {
    /// Γ_μν^j of the body forces ρ e_j. Shape: M x M x 3. Units: kg/m for unit modes.
    pub uniform_load: Vec<Vec<Vector3>>,
    /// Γ_μν^{ij} of the body forces ρ xⁱ e_j. Shape: M x M x 3 x 3, not symmetric in i and j. Units: kg for unit modes.
    pub linear_load: Vec<Vec<Matrix3>>,
}
