//! Rigid motion in the coordinates y, and the fewest supports that stop it.

use faer::{Mat, Par};

use crate::FeError;
use crate::modes::{ModeError, gram, product, subtract_product, symmetric_eigen};

use super::coordinates::Coordinates;
use super::coupling_rbe2::rigid_rows;
use super::small::subtract;

/// Rigid motions that the export's boundary conditions leave, as shapes with unit mass.
pub(crate) struct RigidMotion {
    /// R with RᵀMR = I. Shape: n x r, r from 0 to 6.
    pub shapes: Mat<f64>,
    /// M R.
    pub mass_shapes: Mat<f64>,
    /// Largest distance from the centre of mass along an axis. Units: m.
    pub size: f64,
}

impl RigidMotion {
    /// Errors: a mass that is not positive.
    pub fn new(coordinates: &Coordinates<'_>) -> Result<Self, FeError> {
        let (centre, size) = centre_and_size(coordinates)?;
        let field = |position| rigid_rows(subtract(position, centre)).map(|row| scaled(row, size));
        let turn = 1.0 / size;
        let rotation = [
            [0.0, 0.0, 0.0, turn, 0.0, 0.0],
            [0.0, 0.0, 0.0, 0.0, turn, 0.0],
            [0.0, 0.0, 0.0, 0.0, 0.0, turn],
        ];
        let all = coordinates.sample(field, rotation);
        let positions = &coordinates.model.nodes.positions;
        let held = &coordinates.held;
        let at_supports = Mat::from_fn(held.len(), 6, |i, k| field(positions[held[i] / 3])[held[i] % 3][k]);
        let (values, vectors) =
            symmetric_eigen(gram(at_supports.as_ref(), at_supports.as_ref(), Par::Seq).as_ref())?;
        // Rotations are scaled by the size, so that all entries are of order one.
        let count = values.iter().take_while(|&&value| value < 1e-10).count();
        let mut shapes = product(all.as_ref(), vectors.get(.., 0..count), Par::Seq);
        // Twice, so that the second pass works on shapes that are orthonormal but for round-off.
        for _ in 0..if count == 0 { 0 } else { 2 } {
            let (values, vectors) = symmetric_eigen(coordinates.mass_gram(shapes.as_ref()).as_ref())?;
            if let Some(&value) = values.first().filter(|&&value| value.is_nan() || value <= 0.0) {
                return Err(ModeError::MassNotPositive { mass: value }.into());
            }
            let scaling = Mat::from_fn(count, count, |i, j| vectors[(i, j)] / values[j].sqrt());
            shapes = product(shapes.as_ref(), scaling.as_ref(), Par::Seq);
        }
        let mass_shapes = coordinates.mass_times(shapes.as_ref());
        Ok(Self { shapes, mass_shapes, size })
    }

    /// Number of rigid motions.
    pub fn count(&self) -> usize {
        self.shapes.ncols()
    }

    /// Y := Y - R RᵀM Y, twice: what is left of a shape in mean axes.
    pub fn remove_from(&self, shapes: &mut Mat<f64>) {
        for _ in 0..2 {
            let coefficients = gram(self.mass_shapes.as_ref(), shapes.as_ref(), Par::Seq);
            subtract_product(shapes.as_mut(), self.shapes.as_ref(), coefficients.as_ref(), Par::Seq);
        }
    }

    /// F := F - M R RᵀF, twice: forces with the inertia forces of the rigid acceleration that they cause.
    pub fn balance(&self, forces: &mut Mat<f64>) {
        for _ in 0..2 {
            let coefficients = gram(self.shapes.as_ref(), forces.as_ref(), Par::Seq);
            subtract_product(forces.as_mut(), self.mass_shapes.as_ref(), coefficients.as_ref(), Par::Seq);
        }
    }

    /// As many coordinates as there are rigid motions, which stop them all when they are held.
    ///
    /// The six motions of a rigid interface if there is one. Otherwise those that move most, each measured across
    /// what the ones before it leave.
    pub fn supports(&self, coordinates: &Coordinates<'_>) -> Vec<usize> {
        if let (6, Some(first)) = (self.count(), coordinates.rigid_places().next()) {
            return (first..first + 6).collect();
        }
        let mut rows = self.shapes.clone();
        let mut found = Vec::new();
        // A rotation of a reference point is compared with displacements by the displacement it makes.
        let first_motion = coordinates.rigid_places().next().unwrap_or(coordinates.dimension());
        for _ in 0..self.count() {
            let length = |i: usize| -> f64 {
                let unit = if i >= first_motion && (i - first_motion) % 6 >= 3 { self.size } else { 1.0 };
                unit * (0..rows.ncols()).map(|k| rows[(i, k)].powi(2)).sum::<f64>().sqrt()
            };
            let best = (0..rows.nrows()).max_by(|&a, &b| length(a).total_cmp(&length(b))).unwrap_or(0);
            let norm: f64 = (0..rows.ncols()).map(|k| rows[(best, k)].powi(2)).sum::<f64>().sqrt();
            let direction: Vec<f64> = (0..rows.ncols()).map(|k| rows[(best, k)] / norm).collect();
            for i in 0..rows.nrows() {
                let along: f64 = (0..direction.len()).map(|k| rows[(i, k)] * direction[k]).sum();
                for (k, component) in direction.iter().enumerate() {
                    rows[(i, k)] -= along * component;
                }
            }
            found.push(best);
        }
        found.sort_unstable();
        found
    }
}

/// A row of displacements with its rotations per unit displacement at distance `size`.
fn scaled(row: [f64; 6], size: f64) -> [f64; 6] {
    let [a, b, c, x, y, z] = row;
    [a, b, c, x / size, y / size, z / size]
}

fn centre_and_size(coordinates: &Coordinates<'_>) -> Result<([f64; 3], f64), ModeError> {
    let model = coordinates.model;
    let (mut total, mut moment) = (0.0, [0.0; 3]);
    for (node, position) in model.nodes.positions.iter().enumerate() {
        let weight: f64 = model.mass.val_of_col(node).iter().sum();
        total += weight;
        for i in 0..3 {
            moment[i] += weight * position[i];
        }
    }
    if total.is_nan() || total <= 0.0 {
        return Err(ModeError::MassNotPositive { mass: total });
    }
    let centre = moment.map(|value| value / total);
    let distance =
        |position: &[f64; 3]| (0..3).fold(0.0_f64, |far, i| far.max((position[i] - centre[i]).abs()));
    let size = model.nodes.positions.iter().map(distance).fold(0.0, f64::max);
    Ok((centre, if size > 0.0 { size } else { 1.0 }))
}
