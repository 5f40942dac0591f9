//! A material of elements made here.

use crate::Elasticity;

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

    /// E and ν.
    pub fn elasticity(&self) -> Elasticity {
        Elasticity { youngs_modulus: self.youngs_modulus, poisson_ratio: self.poisson_ratio }
    }

    /// Lamé's first parameter λ. Units: N/m².
    pub fn lame_lambda(&self) -> f64 {
        self.elasticity().lame_lambda()
    }

    /// Shear modulus μ. Units: N/m².
    pub fn shear_modulus(&self) -> f64 {
        self.elasticity().shear_modulus()
    }
}
