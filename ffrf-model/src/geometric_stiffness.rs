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
    /// Stress stiffness of unit loads at markers, for those that were asked for.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub marker_loads: Vec<MarkerLoadStiffness>,
}

/// Geometric stiffness Γ of the stresses that unit forces and moments at a marker leave in the supported body.
///
/// A force F and a moment N there add F_k Γ_μν^k + N_k Γ_μν^{3+k} to K_ff: a pull stiffens, a push softens. It is also what the marker
/// moves by in second order: -½ q_μ q_ν Γ_μν^k along axis k, and so the part of its rows that follows q is -Γ_μν q_ν.
/// Symmetric in μ and ν. Frame: body. Source: as [`GeometricStiffness`]; standard input data hold it as Φ1 and Ψ1 of a node.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MarkerLoadStiffness {
    /// Name of the marker.
    pub marker: String,
    /// Γ_μν of unit forces along x, y, z and unit moments about them. Shape: M x M x 6. Units for unit modes: 1/m and 1.
    pub stiffness: Vec<Vec<[f64; 6]>>,
}
