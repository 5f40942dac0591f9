//! Quantities that follow from the inertia invariants alone (204-208, corrected).

use crate::{Inertia, Matrix3, Vector3};

impl Inertia {
    /// Number of modes M.
    pub fn mode_count(&self) -> usize {
        self.modal_first_moment.len()
    }

    /// Centre of mass a of the undeformed body.
    ///
    /// Shape: 3. Units: m. Frame: body. Source: (206). Panics: never.
    pub fn centre_of_mass(&self) -> Vector3 {
        self.first_moment.map(|moment| moment / self.mass)
    }

    /// Displacement b_μ of the centre of mass per unit modal coordinate.
    ///
    /// Shape: 3. Frame: body. Source: (206). Panics: if there is no mode `mu`.
    pub fn modal_centre_of_mass(&self, mu: usize) -> Vector3 {
        self.modal_first_moment[mu].map(|moment| moment / self.mass)
    }

    /// Inertia tensor Θ = tr(T) I - T about the frame origin, undeformed body.
    ///
    /// Shape: 3 x 3, symmetric. Units: kg m². Frame: body. Source: (207). Panics: never.
    pub fn inertia_tensor(&self) -> Matrix3 {
        trace_minus_transpose(&self.second_moment)
    }

    /// Θ_μ = tr(T_μ) I - T_μᵀ.
    ///
    /// Shape: 3 x 3, not symmetric. Units: kg m². Frame: body. Source: (207), transpose restored.
    /// Panics: if there is no mode `mu`.
    pub fn mode_inertia(&self, mu: usize) -> Matrix3 {
        trace_minus_transpose(&self.position_mode_moment[mu])
    }

    /// Θ_μν = tr(T_μν) I - T_μνᵀ.
    ///
    /// Shape: 3 x 3, Θ_νμ = Θ_μνᵀ. Units: kg m². Frame: body. Source: (207), transpose restored.
    /// Panics: if there is no mode `mu` or `nu`.
    pub fn mode_mode_inertia(&self, mu: usize, nu: usize) -> Matrix3 {
        trace_minus_transpose(&self.mode_mode_moment[mu][nu])
    }

    /// ϑ_μ = ∫ρ x × φ_μ, the angular momentum per unit modal rate of the undeformed body.
    ///
    /// Shape: 3. Units: kg m². Frame: body. Source: (208), from T_μ. Panics: if there is no mode `mu`.
    pub fn rotation_coupling(&self, mu: usize) -> Vector3 {
        antisymmetric_part(&self.position_mode_moment[mu])
    }

    /// ϑ_μν = ∫ρ φ_μ × φ_ν.
    ///
    /// Shape: 3, ϑ_νμ = -ϑ_μν. Units: kg m². Frame: body. Source: (208), from T_μν.
    /// Panics: if there is no mode `mu` or `nu`.
    pub fn mode_mode_coupling(&self, mu: usize, nu: usize) -> Vector3 {
        antisymmetric_part(&self.mode_mode_moment[mu][nu])
    }

    /// Modal mass matrix Θ_ff = [tr T_μν].
    ///
    /// Shape: M x M, symmetric. Source: (207). Panics: never on a body that passed its shape check.
    pub fn modal_mass(&self) -> Vec<Vec<f64>> {
        let trace = |matrix: &Matrix3| matrix[0][0] + matrix[1][1] + matrix[2][2];
        self.mode_mode_moment.iter().map(|row| row.iter().map(trace).collect()).collect()
    }
}

/// tr(T) I - Tᵀ; the diagonal is summed without the entry that would cancel.
fn trace_minus_transpose(moment: &Matrix3) -> Matrix3 {
    let mut inertia = [[0.0; 3]; 3];
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        inertia[i][i] = moment[j][j] + moment[k][k];
        inertia[i][j] = -moment[j][i];
        inertia[i][k] = -moment[k][i];
    }
    inertia
}

/// ε_ijk T^{ij} e_k.
fn antisymmetric_part(moment: &Matrix3) -> Vector3 {
    [moment[1][2] - moment[2][1], moment[2][0] - moment[0][2], moment[0][1] - moment[1][0]]
}
