//! The motions that the joints leave: a basis of the tangent space of the constraints.

use faer::Mat;
use ffrf_runtime::{FlexibleBody as _, State};
use nalgebra::{Cholesky, DMatrix, DVector};

use super::AnalysisError;
use super::evaluate::Point;
use crate::{HostBody, HostModal};

/// A row counts as new if its singular value is above this; rows have unit length in the metric of kinetic energy.
const NEW: f64 = 1e-7;

/// Changes of places N y, and of velocities N ẏ + W y, keep the constraints to first order.
///
/// N is orthonormal in the mass matrix M of all velocities, Nᵀ M N = I, and W is the least change of velocities that goes with
/// a change of place, Nᵀ M W = 0.
pub(super) struct Tangent {
    /// N. Shape: n x f.
    pub(super) places: DMatrix<f64>,
    /// W. Shape: n x f.
    pub(super) followed: DMatrix<f64>,
    /// Nᵀ M. Shape: f x n.
    pub(super) projection: DMatrix<f64>,
}

impl Tangent {
    pub(super) fn new(point: &Point<'_>, body_names: &[String]) -> Result<Self, AnalysisError> {
        let n = point.size();
        let (mass, root) = mass_matrix(point, body_names)?;
        let zero = DVector::zeros(n);
        let unit = |k: usize| DVector::from_fn(n, |i, _| if i == k { 1.0 } else { 0.0 });
        let (mut gradient, mut carried) = (Vec::new(), Vec::new());
        for k in 0..n {
            // the same for places and velocities: the gradient of the residuals
            let by_velocity = point.evaluate(&zero, &unit(k))?;
            let by_place = point.evaluate(&unit(k), &zero)?;
            gradient.extend(by_velocity.velocity_residuals.iter().map(|row| row.eps));
            carried.extend(by_place.velocity_residuals.iter().map(|row| row.eps));
        }
        let rows = gradient.len() / n.max(1);
        // column k has been appended as a whole
        let (gradient, mut carried) =
            (DMatrix::from_vec(rows, n, gradient), DMatrix::from_vec(rows, n, carried));
        // Ĝ = G L⁻ᵀ with rows of unit length
        let mut weighted = solve_lower(&root, gradient.transpose())?.transpose();
        for row in 0..rows {
            let length = weighted.row(row).norm();
            if length > 0.0 {
                weighted.row_mut(row).unscale_mut(length);
                carried.row_mut(row).unscale_mut(length);
            }
        }
        let (rank, left, sizes, right) = decompose(&weighted)?;
        let free = right.columns(rank, n - rank).into_owned();
        let back = |columns: DMatrix<f64>| solve_upper(&root, columns);
        let places = back(free)?;
        // the least velocities, by the pseudo-inverse
        let mut wanted = -(left.columns(0, rank).transpose() * &carried * &places);
        for row in 0..rank {
            wanted.row_mut(row).unscale_mut(sizes[row]);
        }
        let followed = back(right.columns(0, rank) * wanted)?;
        let projection = places.transpose() * mass;
        Ok(Self { places, followed, projection })
    }

    /// Degrees of freedom f.
    pub(super) fn freedom(&self) -> usize {
        self.places.ncols()
    }
}

fn solve_lower(root: &DMatrix<f64>, right: DMatrix<f64>) -> Result<DMatrix<f64>, AnalysisError> {
    let what = "the solution by factors of the mass matrix";
    root.solve_lower_triangular(&right).ok_or(AnalysisError::NotConverged { what })
}

fn solve_upper(root: &DMatrix<f64>, right: DMatrix<f64>) -> Result<DMatrix<f64>, AnalysisError> {
    let what = "the solution by factors of the mass matrix";
    root.tr_solve_lower_triangular(&right).ok_or(AnalysisError::NotConverged { what })
}

/// Rank, U, singular values and V (all of it) of a matrix.
type Decomposition = (usize, DMatrix<f64>, Vec<f64>, DMatrix<f64>);

fn decompose(matrix: &DMatrix<f64>) -> Result<Decomposition, AnalysisError> {
    let (rows, n) = matrix.shape();
    if rows == 0 {
        return Ok((0, DMatrix::zeros(0, 0), Vec::new(), DMatrix::identity(n, n)));
    }
    let what = "the singular value decomposition of the constraints";
    let svd = Mat::from_fn(rows, n, |i, j| matrix[(i, j)])
        .svd()
        .map_err(|_| AnalysisError::NotConverged { what })?;
    let sizes: Vec<f64> = svd.S().column_vector().iter().copied().collect();
    let rank = sizes.iter().filter(|size| **size > NEW).count();
    let (u, v) = (svd.U(), svd.V());
    Ok((
        rank,
        DMatrix::from_fn(rows, rows, |i, j| u[(i, j)]),
        sizes,
        DMatrix::from_fn(n, n, |i, j| v[(i, j)]),
    ))
}

/// The mass matrix of all velocities (of frame origins inertial, all else in body frames) and its factor L of L Lᵀ.
fn mass_matrix(
    point: &Point<'_>,
    body_names: &[String],
) -> Result<(DMatrix<f64>, DMatrix<f64>), AnalysisError> {
    let n = point.size();
    let (mut mass, mut root) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
    let mut start = 0;
    for (index, (body, state)) in point.mechanism.bodies().iter().zip(&point.state).enumerate() {
        let block = body_mass_matrix(body, state);
        let size = block.nrows();
        let factor = Cholesky::new(block.clone()).ok_or_else(|| AnalysisError::Mass {
            body: body_names.get(index).cloned().unwrap_or_default(),
        })?;
        mass.view_mut((start, start), (size, size)).copy_from(&block);
        root.view_mut((start, start), (size, size)).copy_from(&factor.l());
        start += size;
    }
    Ok((mass, root))
}

/// The mass matrix of one body, with the velocity of its frame origin in inertial components.
pub(super) fn body_mass_matrix(body: &HostBody, state: &State<HostModal>) -> DMatrix<f64> {
    let prepared = body.prepare(&state.modal_coordinates, &state.angular_velocity, &state.modal_rates);
    let (modes, rigid) = (body.mode_count(), prepared.rigid_mass());
    let (modal, coupling) = (body.modal_mass().dense(), prepared.coupling());
    let resolved = DMatrix::from_fn(6 + modes, 6 + modes, |i, j| match (i < 6, j < 6) {
        (true, true) => rigid[(i, j)],
        (true, false) => coupling[i].0[j - 6],
        (false, true) => coupling[j].0[i - 6],
        (false, false) => modal[(i - 6, j - 6)],
    });
    let mut turn = DMatrix::identity(6 + modes, 6 + modes);
    turn.view_mut((0, 0), (3, 3)).copy_from(&state.orientation.to_rotation_matrix().into_inner());
    &turn * resolved * turn.transpose()
}
