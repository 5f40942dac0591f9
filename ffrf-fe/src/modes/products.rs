//! Products of the mass and the stiffness with several shapes at once.
//!
//! Shapes are multiplied eight at a time: each entry of a matrix is then read once for eight products. Each row sums
//! in the order of its entries, so that the result depends neither on the grouping nor on the threads.

use faer::{Mat, MatMut, MatRef};

use super::block::both;
use super::problem::{Problem, entries};

impl Problem<'_> {
    /// M X. Shape: as X, on the free degrees of freedom.
    pub fn mass_times(&self, shapes: MatRef<'_, f64>) -> Mat<f64> {
        self.times(shapes, |dof| {
            let direction = dof % 3;
            entries(&self.model.mass, dof / 3).map(move |(node, value)| (3 * node + direction, value))
        })
    }

    /// K X. Shape: as X, on the free degrees of freedom.
    pub fn stiffness_times(&self, shapes: MatRef<'_, f64>) -> Mat<f64> {
        // K is symmetric: its column is its row.
        self.times(shapes, |dof| entries(self.stiffness, dof))
    }

    /// Products with the matrix whose row `row_of(dof)` lists full column numbers and values.
    fn times<R: Iterator<Item = (usize, f64)>>(
        &self,
        shapes: MatRef<'_, f64>,
        row_of: impl Fn(usize) -> R + Sync,
    ) -> Mat<f64> {
        let mut result = Mat::zeros(shapes.nrows(), shapes.ncols());
        let mut first = 0;
        while first < shapes.ncols() {
            let rest = shapes.ncols() - first;
            first += match rest {
                8.. => self.times_group::<8, R>(shapes, result.as_mut(), first, &row_of),
                4.. => self.times_group::<4, R>(shapes, result.as_mut(), first, &row_of),
                _ => self.times_group::<1, R>(shapes, result.as_mut(), first, &row_of),
            };
        }
        result
    }

    /// `LANES` columns from `first` on; returns their number.
    fn times_group<const LANES: usize, R: Iterator<Item = (usize, f64)>>(
        &self,
        shapes: MatRef<'_, f64>,
        result: MatMut<'_, f64>,
        first: usize,
        row_of: &(impl Fn(usize) -> R + Sync),
    ) -> usize {
        // Degrees of freedom that are not free stay zero.
        let mut full = vec![[0.0; LANES]; 3 * self.model.nodes.len()];
        for lane in 0..LANES {
            let column = shapes.col(first + lane);
            for (i, &dof) in self.free.iter().enumerate() {
                full[dof][lane] = column[i];
            }
        }
        let half = self.free.len().div_ceil(2);
        let (upper, lower) = result.get_mut(.., first..first + LANES).split_at_row_mut(half);
        let (upper_dofs, lower_dofs) = self.free.split_at(half);
        both(
            self.threads,
            || times_rows(&full, upper, upper_dofs, row_of),
            || times_rows(&full, lower, lower_dofs, row_of),
        );
        LANES
    }
}

fn times_rows<const LANES: usize, R: Iterator<Item = (usize, f64)>>(
    full: &[[f64; LANES]],
    mut result: MatMut<'_, f64>,
    dofs: &[usize],
    row_of: &impl Fn(usize) -> R,
) {
    for (i, &dof) in dofs.iter().enumerate() {
        let mut sum = [0.0; LANES];
        for (column, value) in row_of(dof) {
            let source = &full[column];
            for lane in 0..LANES {
                sum[lane] += value * source[lane];
            }
        }
        for lane in 0..LANES {
            result[(i, lane)] = sum[lane];
        }
    }
}
