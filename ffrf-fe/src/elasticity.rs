//! Isotropic linear elasticity.

/// Isotropic elasticity: a material without its mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elasticity {
    /// Young's modulus E. Units: N/m².
    pub youngs_modulus: f64,
    /// Poisson's ratio ν.
    pub poisson_ratio: f64,
}

impl Elasticity {
    /// Lamé's first parameter λ. Units: N/m².
    pub fn lame_lambda(&self) -> f64 {
        self.youngs_modulus * self.poisson_ratio
            / ((1.0 + self.poisson_ratio) * (1.0 - 2.0 * self.poisson_ratio))
    }

    /// Shear modulus μ. Units: N/m².
    pub fn shear_modulus(&self) -> f64 {
        self.youngs_modulus / (2.0 * (1.0 + self.poisson_ratio))
    }

    /// True for constants of a stable material: E > 0 and -1 < ν < 1/2.
    pub fn is_stable(&self) -> bool {
        let Self { youngs_modulus, poisson_ratio } = *self;
        youngs_modulus.is_finite() && youngs_modulus > 0.0 && poisson_ratio > -1.0 && poisson_ratio < 0.5
    }

    /// Stress of small strain, σ = λ tr(ε) I + 2 μ ε: xx, yy, zz, xy, xz, yz.
    ///
    /// `gradient[i][k]` is ∂u_i/∂x_k. Units: N/m².
    pub fn stress(&self, gradient: &[[f64; 3]; 3]) -> [f64; 6] {
        let (lambda, mu) = (self.lame_lambda(), self.shear_modulus());
        let volume = lambda * (gradient[0][0] + gradient[1][1] + gradient[2][2]);
        let on = |i: usize| volume + 2.0 * mu * gradient[i][i];
        let off = |i: usize, k: usize| mu * (gradient[i][k] + gradient[k][i]);
        [on(0), on(1), on(2), off(0, 1), off(0, 2), off(1, 2)]
    }
}
