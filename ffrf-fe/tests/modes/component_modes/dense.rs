//! The full model as dense matrices, written down independently of the library.

use faer::Mat;
use faer::linalg::solvers::Solve;
use ffrf_fe::FeModel;
use ffrf_fe::component_modes::{Coupling, Interface};

/// The part with its couplings: u = T y, interface motions B y.
pub struct Dense {
    pub stiffness: Mat<f64>,
    pub mass: Mat<f64>,
    pub transformation: Mat<f64>,
    pub motion: Mat<f64>,
}

/// u = v + ω × (x - p) as a 3 x 6 block.
fn rigid(x: [f64; 3], p: [f64; 3]) -> [[f64; 6]; 3] {
    let r = [x[0] - p[0], x[1] - p[1], x[2] - p[2]];
    [[1.0, 0.0, 0.0, 0.0, r[2], -r[1]], [0.0, 1.0, 0.0, -r[2], 0.0, r[0]], [0.0, 0.0, 1.0, r[1], -r[0], 0.0]]
}

impl Dense {
    pub fn new(model: &FeModel, interfaces: &[Interface]) -> Self {
        let nodes = model.nodes.len();
        let full_stiffness = model.stiffness.as_ref().unwrap().to_dense();
        let scalar = model.mass.to_dense();
        let full_mass =
            Mat::from_fn(
                3 * nodes,
                3 * nodes,
                |i, j| {
                    if i % 3 == j % 3 { scalar[(i / 3, j / 3)] } else { 0.0 }
                },
            );
        let rigid_ones: Vec<&Interface> =
            interfaces.iter().filter(|i| *i.coupling() == Coupling::Rigid).collect();
        let claimed = |row: usize| rigid_ones.iter().position(|interface| interface.nodes().contains(&row));
        let free: Vec<usize> = (0..3 * nodes).filter(|dof| claimed(dof / 3).is_none()).collect();
        let size = free.len() + 6 * rigid_ones.len();
        let mut transformation = Mat::zeros(3 * nodes, size);
        for (place, &dof) in free.iter().enumerate() {
            transformation[(dof, place)] = 1.0;
        }
        for row in 0..nodes {
            let Some(number) = claimed(row) else { continue };
            let block = rigid(model.nodes.positions[row], rigid_ones[number].reference_point());
            for i in 0..3 {
                for k in 0..6 {
                    transformation[(3 * row + i, free.len() + 6 * number + k)] = block[i][k];
                }
            }
        }
        let mut motion = Mat::zeros(6 * interfaces.len(), size);
        let mut number = 0;
        for (place, interface) in interfaces.iter().enumerate() {
            match interface.coupling() {
                Coupling::Rigid => {
                    for k in 0..6 {
                        motion[(6 * place + k, free.len() + 6 * number + k)] = 1.0;
                    }
                    number += 1;
                }
                Coupling::Average { weights } => {
                    let rows = average(model, interface, weights) * &transformation;
                    for k in 0..6 {
                        for j in 0..size {
                            motion[(6 * place + k, j)] = rows[(k, j)];
                        }
                    }
                }
            }
        }
        Self {
            stiffness: transformation.transpose() * &full_stiffness * &transformation,
            mass: transformation.transpose() * &full_mass * &transformation,
            transformation,
            motion,
        }
    }

    /// Number of coordinates.
    pub fn size(&self) -> usize {
        self.stiffness.nrows()
    }

    /// B (K - ω²M)⁻¹ Bᵀ.
    pub fn receptance(&self, hertz: f64) -> Mat<f64> {
        let value = (std::f64::consts::TAU * hertz).powi(2);
        let dynamic =
            Mat::from_fn(self.size(), self.size(), |i, j| self.stiffness[(i, j)] - value * self.mass[(i, j)]);
        &self.motion * dynamic.full_piv_lu().solve(self.motion.transpose())
    }

    /// Static displacements with the interfaces at `motion`: [K Bᵀ; B 0]. Shape: 3N x columns of `motion`.
    pub fn prescribed(&self, motion: &Mat<f64>) -> Mat<f64> {
        let (size, rows) = (self.size(), self.motion.nrows());
        // Multipliers in units of stiffness, so that the matrix is not badly scaled.
        let unit = self.stiffness[(0, 0)];
        let saddle = Mat::from_fn(size + rows, size + rows, |i, j| match (i < size, j < size) {
            (true, true) => self.stiffness[(i, j)],
            (true, false) => unit * self.motion[(j - size, i)],
            (false, true) => unit * self.motion[(i - size, j)],
            (false, false) => 0.0,
        });
        let right = Mat::from_fn(size + rows, motion.ncols(), |i, j| {
            if i < size { 0.0 } else { unit * motion[(i - size, j)] }
        });
        let solution = saddle.full_piv_lu().solve(&right);
        &self.transformation * solution.get(..size, ..)
    }
}

/// Rows of the weighted least-squares rigid motion, by the normal equations of all six unknowns at once.
fn average(model: &FeModel, interface: &Interface, weights: &[f64]) -> Mat<f64> {
    let mut normal = Mat::<f64>::zeros(6, 6);
    let mut right = Mat::<f64>::zeros(6, 3 * model.nodes.len());
    for (&row, &weight) in interface.nodes().iter().zip(weights) {
        let block = rigid(model.nodes.positions[row], interface.reference_point());
        for k in 0..6 {
            for i in 0..3 {
                right[(k, 3 * row + i)] = weight * block[i][k];
                for l in 0..6 {
                    normal[(k, l)] += weight * block[i][k] * block[i][l];
                }
            }
        }
    }
    normal.full_piv_lu().solve(&right)
}

/// Largest entry of |a - b| over the largest of |a|.
pub fn deviation(a: &Mat<f64>, b: &Mat<f64>) -> f64 {
    assert_eq!((a.nrows(), a.ncols()), (b.nrows(), b.ncols()));
    (a - b).norm_max() / a.norm_max()
}
