//! Products with mass and stiffness in the coordinates y.

use faer::{Mat, MatRef, Par};

use crate::compensated::dot;
use crate::modes::{entries, gram, mass_times_full, stiffness_times, symmetrised};

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

    /// F - Tᵀ K T Y, its sums with twice the digits: what a step of refinement needs where the stiffness is far from one.
    pub fn residual(&self, forces: MatRef<'_, f64>, shapes: MatRef<'_, f64>) -> Mat<f64> {
        let full = self.expand(shapes);
        let mut rest = Mat::zeros(full.nrows(), full.ncols());
        for j in 0..full.ncols() {
            let (column, result) = (full.col_as_slice(j), rest.col_as_slice_mut(j));
            for (dof, sum) in result.iter_mut().enumerate() {
                // K is symmetric: its column is its row. What a rigid interface gathers starts from its forces below.
                let start = self.place_of(dof).map_or(0.0, |place| forces[(place, j)]);
                let products = entries(self.stiffness, dof).map(|(row, value)| (-value, column[row]));
                *sum = dot(std::iter::once((start, 1.0)).chain(products));
            }
        }
        let mut rest = self.contract(rest.as_ref());
        for place in self.rigid_places().flat_map(|first| first..first + 6) {
            for j in 0..forces.ncols() {
                rest[(place, j)] += forces[(place, j)];
            }
        }
        rest
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
