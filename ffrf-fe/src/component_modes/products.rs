//! Products with mass and stiffness in the coordinates y.

use faer::{Mat, MatRef, Par};

use crate::modes::{gram, mass_times_full, stiffness_times, symmetrised};

use super::coordinates::Coordinates;

impl Coordinates<'_> {
    /// TᵀMT Y.
    pub fn mass_times(&self, shapes: MatRef<'_, f64>) -> Mat<f64> {
        self.contract(mass_times_full(&self.model.mass, &self.expand(shapes)).as_ref())
    }

    /// TᵀKT Y.
    pub fn stiffness_times(&self, shapes: MatRef<'_, f64>) -> Mat<f64> {
        self.contract(stiffness_times(self.stiffness, &self.expand(shapes)).as_ref())
    }

    /// YᵀMY, symmetric to the bit.
    pub fn mass_gram(&self, shapes: MatRef<'_, f64>) -> Mat<f64> {
        symmetrised(gram(shapes, self.mass_times(shapes).as_ref(), Par::Seq).as_ref())
    }

    /// YᵀKY, symmetric to the bit.
    pub fn stiffness_gram(&self, shapes: MatRef<'_, f64>) -> Mat<f64> {
        symmetrised(gram(shapes, self.stiffness_times(shapes).as_ref(), Par::Seq).as_ref())
    }
}
