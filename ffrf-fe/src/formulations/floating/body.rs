//! Mass matrix and gyroscopic forces from the constant inertia invariants.

use faer::{Mat, MatRef};

use crate::FeModel;
use crate::formulations::FormulationError;
use crate::formulations::gcms::gram_matrix;
use crate::formulations::rotation::{cross, dot, skew};

/// Inertia invariants as one Gram matrix, and the modal stiffness.
#[derive(Debug, Clone)]
pub struct FloatingBody {
    /// Gram matrix of {1, xⁱ, φ_μⁱ}: m, m a, m b_μ, T, T_μ, T_μν. Shape: (4 + 3M) square. Source: (206), (207).
    pub gram: Mat<f64>,
    /// K_ff. Shape: M x M. Source: (193).
    pub stiffness: Mat<f64>,
}

impl FloatingBody {
    /// Reduces a mesh to given modes (3N x M).
    ///
    /// Errors: missing stiffness, mode shapes of another size.
    pub fn new(model: &FeModel, mode_shapes: MatRef<'_, f64>) -> Result<Self, FormulationError> {
        let stiffness = model.stiffness.as_ref().ok_or(FormulationError::MissingStiffness)?;
        let (expected, found) = (3 * model.nodes.len(), mode_shapes.nrows());
        if expected != found {
            return Err(FormulationError::Size { what: "the matrix of mode shapes", expected, found });
        }
        Ok(Self {
            gram: gram_matrix(&model.nodes.positions, mode_shapes, &model.mass),
            stiffness: mode_shapes.transpose() * (stiffness * mode_shapes),
        })
    }

    /// Number of modes M.
    pub fn modes(&self) -> usize {
        self.stiffness.nrows()
    }

    /// m r = m a + q_μ m b_μ. Source: (204), corrected.
    fn first_moment(&self, q: &[f64]) -> [f64; 3] {
        [0, 1, 2].map(|i| {
            self.gram[(0, 1 + i)]
                + q.iter().enumerate().map(|(mu, q)| q * self.gram[(0, 4 + 3 * mu + i)]).sum::<f64>()
        })
    }

    /// T_μ^d = T_μ + q_ν T_νμ for all μ side by side, and T^d = T + q_ν T_ν. Shape: 3 x 3(1 + M).
    ///
    /// Row i is the field xⁱ + q_ν φ_νⁱ of the deformed body, column the field xʲ or φ_μʲ.
    fn deformed_moments(&self, q: &[f64]) -> Mat<f64> {
        let mut fields = Mat::zeros(3, self.gram.nrows());
        for i in 0..3 {
            fields[(i, 1 + i)] = 1.0;
            for (nu, &q) in q.iter().enumerate() {
                fields[(i, 4 + 3 * nu + i)] = q;
            }
        }
        fields * self.gram.subcols(1, self.gram.ncols() - 1)
    }

    /// M(q) in body components, unknowns [α; ω̇; q̈]. Shape: (6 + M) square. Source: (203)-(208), corrected.
    pub fn mass_matrix(&self, q: &[f64]) -> Mat<f64> {
        let modes = self.modes();
        let moments = self.deformed_moments(q);
        let mut mass = Mat::zeros(6 + modes, 6 + modes);
        let lever = skew(self.first_moment(q));
        let second = second_moment(&moments, q);
        let trace = second[(0, 0)] + second[(1, 1)] + second[(2, 2)];
        for i in 0..3 {
            mass[(i, i)] = self.gram[(0, 0)];
            for j in 0..3 {
                mass[(i, 3 + j)] = -lever[(i, j)];
                mass[(3 + j, i)] = -lever[(i, j)];
                mass[(3 + i, 3 + j)] = if i == j { trace } else { 0.0 } - second[(i, j)];
            }
        }
        for mu in 0..modes {
            let t = |i: usize, j: usize| moments[(i, 3 + 3 * mu + j)];
            for i in 0..3 {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                let coupling = t(j, k) - t(k, j);
                for (row, value) in [(i, self.gram[(0, 4 + 3 * mu + i)]), (3 + i, coupling)] {
                    mass[(row, 6 + mu)] = value;
                    mass[(6 + mu, row)] = value;
                }
            }
            for nu in 0..modes {
                mass[(6 + mu, 6 + nu)] = (0..3).map(|i| self.gram[(4 + 3 * mu + i, 4 + 3 * nu + i)]).sum();
            }
        }
        mass
    }

    /// Gyroscopic forces Q(q, ω, q̇) in body components, on the side of M w. Shape: 6 + M. Source: (185), corrected.
    pub fn gyroscopic(&self, q: &[f64], omega: [f64; 3], q_dot: &[f64]) -> Mat<f64> {
        let modes = self.modes();
        let moments = self.deformed_moments(q);
        let second = second_moment(&moments, q);
        let inertia = |t: &dyn Fn(usize, usize) -> f64, w: [f64; 3]| {
            // (tr T I - Tᵀ) w.
            let trace = t(0, 0) + t(1, 1) + t(2, 2);
            [0, 1, 2].map(|i| trace * w[i] - (0..3).map(|j| t(j, i) * w[j]).sum::<f64>())
        };
        let lever = self.first_moment(q);
        let rate = self.modal_rate(q_dot);
        let (centripetal, coriolis) = (cross(omega, cross(omega, lever)), cross(omega, rate));
        let mut moment = cross(omega, inertia(&|i, j| second[(i, j)], omega));
        let mut forces = Mat::zeros(6 + modes, 1);
        // φ̇ fields Σ q̇_ν φ_ν against each φ_μ: ω · ϑ_νμ q̇_ν summed at once.
        let rates = self.rate_moments(q_dot);
        for mu in 0..modes {
            let momentum = inertia(&|i, j| moments[(i, 3 + 3 * mu + j)], omega);
            for i in 0..3 {
                moment[i] += 2.0 * q_dot[mu] * momentum[i];
            }
            let t = |i: usize, j: usize| rates[(i, 3 * mu + j)];
            let vector = [t(1, 2) - t(2, 1), t(2, 0) - t(0, 2), t(0, 1) - t(1, 0)];
            forces[(6 + mu, 0)] = -dot(omega, momentum) + 2.0 * dot(omega, vector);
        }
        for i in 0..3 {
            forces[(i, 0)] = centripetal[i] + 2.0 * coriolis[i];
            forces[(3 + i, 0)] = moment[i];
        }
        forces
    }

    /// m B q̇.
    fn modal_rate(&self, q_dot: &[f64]) -> [f64; 3] {
        [0, 1, 2].map(|i| q_dot.iter().enumerate().map(|(mu, r)| r * self.gram[(0, 4 + 3 * mu + i)]).sum())
    }

    /// q̇_ν T_νμ side by side. Shape: 3 x 3M.
    fn rate_moments(&self, q_dot: &[f64]) -> Mat<f64> {
        let mut fields = Mat::zeros(3, 3 * self.modes());
        for i in 0..3 {
            for (nu, &rate) in q_dot.iter().enumerate() {
                fields[(i, 3 * nu + i)] = rate;
            }
        }
        let modal = self.gram.as_ref().submatrix(4, 4, 3 * self.modes(), 3 * self.modes());
        fields * modal
    }
}

/// T + q_μ (T_μ + T_μᵀ) + q_μ q_ν T_μν of the deformed body, symmetric. Shape: 3 x 3.
fn second_moment(moments: &Mat<f64>, q: &[f64]) -> Mat<f64> {
    Mat::from_fn(3, 3, |i, j| {
        moments[(i, j)] + q.iter().enumerate().map(|(mu, q)| q * moments[(i, 3 + 3 * mu + j)]).sum::<f64>()
    })
}
