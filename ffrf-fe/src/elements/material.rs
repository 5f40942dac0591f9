//! Isotropic linear elasticity.

/// An isotropic material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus E. Units: N/m².
    pub youngs_modulus: f64,
    /// Poisson's ratio ν.
    pub poisson_ratio: f64,
    /// Density ρ. Units: kg/m³.
    pub density: f64,
}

impl Material {
    /// Structural steel with rounded values.
    pub const STEEL: Self = Self { youngs_modulus: 2.1e11, poisson_ratio: 0.3, density: 7850.0 };

    /// Lamé's first parameter λ. Units: N/m².
    pub fn lame_lambda(&self) -> f64 {
        self.youngs_modulus * self.poisson_ratio
            / ((1.0 + self.poisson_ratio) * (1.0 - 2.0 * self.poisson_ratio))
    }

    /// Shear modulus μ. Units: N/m².
    pub fn shear_modulus(&self) -> f64 {
        self.youngs_modulus / (2.0 * (1.0 + self.poisson_ratio))
    }
}
