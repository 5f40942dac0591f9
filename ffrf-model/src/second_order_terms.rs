//! What a body holds of the kinetic energy that is of second order in its modal coordinates.

use serde::{Deserialize, Serialize};

/// What a body holds of the kinetic energy of second order in q: the change of inertia ½ q_μ q_ν ω·Θ_μν ω, and the stress stiffness
/// of centrifugal forces, which enters it as -½ q_μ q_ν ω·Θ(Γ_μν) ω.
///
/// A body that was reduced from a finite-element model knows both. One that was read from integrals (standard input data) may know
/// their sum, or nothing of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum SecondOrderTerms {
    /// T_μν is the moment of the modes, Γ_μν the stress stiffness.
    #[default]
    Known,
    /// Of the symmetric parts of T_μν and Γ_μν only the difference and the trace of T_μν are known: a fidelity keeps
    /// both terms or neither.
    Together,
    /// Of the symmetric part of T_μν only the trace is known, of that of Γ_μν nothing: a fidelity keeps neither term.
    Unknown,
}

impl SecondOrderTerms {
    /// Whether the terms are known each by itself.
    pub fn is_known(&self) -> bool {
        *self == Self::Known
    }
}
