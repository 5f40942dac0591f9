//! Rigid-body modes: the motions without strain that the supports leave.

use faer::{Mat, Par};

use super::ModeError;
use super::block::{column_norm, gram, product, subtract_tall_product, tall_gram};
use super::problem::Problem;
use super::symmetric_eigen::symmetric_eigen;

/// Mass-orthonormal rigid-body modes on the free degrees of freedom.
pub(crate) struct RigidModes {
    /// Shapes R. Shape: n x (0 to 6).
    pub shapes: Mat<f64>,
    /// M R.
    pub mass_shapes: Mat<f64>,
    /// Rayleigh quotients RᵀKR, ideally zero. Units: (rad/s)².
    pub rayleigh: Vec<f64>,
    /// Residuals ||K r|| / || |K| |r| ||, ideally round-off.
    pub residuals: Vec<f64>,
    /// Centre of mass. Units: m.
    pub centre: [f64; 3],
    /// Largest distance from the centre of mass along an axis. Units: m.
    pub size: f64,
    threads: usize,
}

impl RigidModes {
    /// Translations and rotations that keep every held degree of freedom at rest.
    pub fn new(problem: &Problem<'_>) -> Result<Self, ModeError> {
        let (centre, size) = centre_and_size(problem)?;
        let all = rigid_fields(&problem.model.nodes.positions, centre, size);
        let admissible = if problem.held.is_empty() {
            all
        } else {
            let at_supports = Mat::from_fn(problem.held.len(), 6, |i, j| all[(problem.held[i], j)]);
            let (values, vectors) =
                symmetric_eigen(gram(at_supports.as_ref(), at_supports.as_ref(), Par::Seq).as_ref())?;
            // Rotations are scaled by the size, so that all entries are of order one.
            let count = values.iter().take_while(|&&value| value < 1e-10).count();
            product(all.as_ref(), vectors.get(.., 0..count), Par::Seq)
        };
        let shapes = orthonormalise(problem, problem.restrict(admissible.as_ref()), 1e-12);
        let mass_shapes = problem.mass_times(shapes.as_ref());
        let forces = problem.stiffness_times(shapes.as_ref());
        let rayleigh = (0..shapes.ncols())
            .map(|j| (0..shapes.nrows()).map(|i| shapes[(i, j)] * forces[(i, j)]).sum())
            .collect();
        let residuals = (0..shapes.ncols())
            .map(|j| {
                let absolute = problem.absolute_stiffness_times(shapes.col_as_slice(j));
                let scale = absolute.iter().map(|value| value * value).sum::<f64>().sqrt();
                if scale > 0.0 { column_norm(forces.as_ref(), j) / scale } else { 0.0 }
            })
            .collect();
        Ok(Self { shapes, mass_shapes, rayleigh, residuals, centre, size, threads: problem.threads })
    }

    /// Number of rigid-body modes that the supports leave.
    pub fn count(&self) -> usize {
        self.shapes.ncols()
    }

    /// No model has more elastic modes than this.
    pub fn most_elastic(&self, problem: &Problem<'_>) -> usize {
        problem.massive.saturating_sub(self.count())
    }

    /// X := X - R Rᵀ M X, twice, so that the rest is orthogonal to round-off.
    pub fn remove_from(&self, shapes: &mut Mat<f64>) {
        for _ in 0..2 {
            let coefficients = tall_gram(self.mass_shapes.as_ref(), shapes.as_ref(), self.threads);
            subtract_tall_product(shapes.as_mut(), self.shapes.as_ref(), coefficients.as_ref(), self.threads);
        }
    }

    /// Refuses a stiffness that resists rigid motion, which the solver would otherwise project away.
    ///
    /// Errors: [`ModeError::RigidMotionStrained`].
    pub fn check_unstrained(&self, elastic_scale: f64) -> Result<(), ModeError> {
        // A thousandth of the lowest elastic frequency: far above what rounded node coordinates cause,
        // far below any real spring to ground that would matter.
        const LIMIT: f64 = 1e-6;
        for (&rayleigh, &residual) in self.rayleigh.iter().zip(&self.residuals) {
            let ratio = rayleigh.abs() / elastic_scale;
            if ratio > LIMIT {
                return Err(ModeError::RigidMotionStrained { ratio, limit: LIMIT, residual });
            }
        }
        Ok(())
    }
}

/// Mass-orthonormal basis of the span of `shapes` by modified Gram-Schmidt, twice; columns whose norm² drops
/// below `threshold` times its start are left out.
pub(crate) fn orthonormalise(problem: &Problem<'_>, shapes: Mat<f64>, threshold: f64) -> Mat<f64> {
    let mut kept: Vec<Mat<f64>> = Vec::new();
    let mut kept_mass: Vec<Mat<f64>> = Vec::new();
    let dot = |a: &Mat<f64>, b: &Mat<f64>| -> f64 {
        a.col_as_slice(0).iter().zip(b.col_as_slice(0)).map(|(x, y)| x * y).sum()
    };
    for j in 0..shapes.ncols() {
        let mut column = shapes.get(.., j..j + 1).to_owned();
        let start = dot(&column, &problem.mass_times(column.as_ref()));
        for _ in 0..2 {
            for (basis, mass_basis) in kept.iter().zip(&kept_mass) {
                let factor = dot(mass_basis, &column);
                for (x, y) in column.col_as_slice_mut(0).iter_mut().zip(basis.col_as_slice(0)) {
                    *x -= factor * y;
                }
            }
        }
        let mut mass_column = problem.mass_times(column.as_ref());
        let norm_squared = dot(&column, &mass_column);
        if norm_squared > threshold * start && norm_squared > 0.0 {
            let scale = norm_squared.sqrt().recip();
            column.col_as_slice_mut(0).iter_mut().for_each(|x| *x *= scale);
            mass_column.col_as_slice_mut(0).iter_mut().for_each(|x| *x *= scale);
            kept.push(column);
            kept_mass.push(mass_column);
        }
    }
    Mat::from_fn(shapes.nrows(), kept.len(), |i, j| kept[j][(i, 0)])
}

/// Displacement fields e_i and e_i × (x - centre) / size on all degrees of freedom. Shape: 3N x 6.
pub(crate) fn rigid_fields(positions: &[[f64; 3]], centre: [f64; 3], size: f64) -> Mat<f64> {
    Mat::from_fn(3 * positions.len(), 6, |dof, column| {
        let (node, axis) = (dof / 3, dof % 3);
        if column < 3 {
            return if axis == column { 1.0 } else { 0.0 };
        }
        let about = column - 3;
        let x = |i: usize| (positions[node][i] - centre[i]) / size;
        if axis == (about + 1) % 3 {
            -x((about + 2) % 3)
        } else if axis == (about + 2) % 3 {
            x((about + 1) % 3)
        } else {
            0.0
        }
    })
}

fn centre_and_size(problem: &Problem<'_>) -> Result<([f64; 3], f64), ModeError> {
    let model = problem.model;
    let positions = &model.nodes.positions;
    let mut total = 0.0;
    let mut moment = [0.0; 3];
    for node in 0..positions.len() {
        let weight: f64 = model.mass.val_of_col(node).iter().sum();
        total += weight;
        for i in 0..3 {
            moment[i] += weight * positions[node][i];
        }
    }
    if total.is_nan() || total <= 0.0 {
        return Err(ModeError::MassNotPositive { mass: total });
    }
    let centre = moment.map(|value| value / total);
    let size = positions
        .iter()
        .flat_map(|position| (0..3).map(move |i| (position[i] - centre[i]).abs()))
        .fold(0.0, f64::max);
    Ok((centre, if size > 0.0 { size } else { 1.0 }))
}
