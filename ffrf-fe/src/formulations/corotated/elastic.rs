//! Elastic energy, force and the low-rank part of the tangent of a co-rotated body.

use faer::Mat;

use super::model::turned;
use super::{CorotatedModel, Frame};
use crate::formulations::FormulationError;
use crate::formulations::rotation::skew;

/// Everything elastic at given coordinates; vectors in body components.
#[derive(Debug, Clone)]
pub struct ElasticState {
    /// A, body to inertial.
    pub rotation: Mat<f64>,
    /// Γ̄ᵀ of the frame. Shape: 3N x 3.
    pub spin: Mat<f64>,
    /// Displacement s = A_bdᵀ r - x, up to a translation. Shape: 3N.
    pub displacement: Mat<f64>,
    /// K s. Shape: 3N.
    pub linear_force: Mat<f64>,
    /// K s + f_nl: with A_bd, the gradient of the energy. Shape: 3N. Units: N.
    pub force: Mat<f64>,
    /// ½ sᵀ K s. Units: J.
    pub energy: f64,
}

impl ElasticState {
    /// Evaluates energy and force. Source: (12), (61).
    ///
    /// With δs = δr̄ - δθ̄ × r̄ and δθ̄ = Γ̄ δr̄ the gradient of ½ sᵀ K s is K s + Γ̄ᵀ τ, τ = -Σ s_n × (K s)_n: the
    /// second part is the small nonlinear term, quadratic in s. (Σ x_n × (K s)_n = 0 since K annihilates rotations.)
    /// Errors: as [`Frame::at`].
    pub fn at(
        model: &CorotatedModel,
        frame: &Frame,
        coordinates: &Mat<f64>,
    ) -> Result<Self, FormulationError> {
        let position = frame.at(coordinates.as_ref())?;
        let back = turned(coordinates.as_ref(), position.rotation.transpose());
        let displacement = back - &model.reference;
        let linear_force = &model.stiffness * &displacement;
        let energy = 0.5 * (displacement.transpose() * &linear_force)[(0, 0)];
        let mut force = linear_force.clone();
        if model.nonlinear_term {
            force += &position.spin * (stacked_skew(&displacement).transpose() * &linear_force);
        }
        let (rotation, spin) = (position.rotation, position.spin);
        Ok(Self { rotation, spin, displacement, linear_force, force, energy })
    }

    /// Force in inertial components, the gradient of the energy. Shape: 3N. Units: N.
    pub fn inertial_force(&self) -> Mat<f64> {
        turned(self.force.as_ref(), self.rotation.as_ref())
    }

    /// U and Vᵀ with tangent ≈ K + U Vᵀ in the body frame; rank 6 (3 without the nonlinear term).
    ///
    /// From δs = (I + B Γ̄) δr̄ with B = s̃ (K B sees only the turned displacement) and δ(A f) = A (δθ̄ × f + δf);
    /// only the change of Γ̄ itself is left out, which is small of second order.
    pub(super) fn low_rank(&self, model: &CorotatedModel) -> (Mat<f64>, Mat<f64>) {
        let size = self.displacement.nrows();
        let b = stacked_skew(&self.displacement);
        let kb = &model.stiffness * &b;
        let turning = &kb - stacked_skew(&self.force);
        if !model.nonlinear_term {
            return (turning, self.spin.transpose().to_owned());
        }
        // Rows (K B)ᵀ + p̃ᵀ-terms of δ(Bᵀ K s) = Bᵀ K δs + Σ p̃_n δs_n.
        let p = stacked_skew(&self.linear_force);
        let lever = stacked_skew(&(&self.displacement + &model.reference));
        // [p̃_1 p̃_2 ...] is the transpose of the stack with the sign changed.
        let rows = kb.transpose() - p.transpose();
        let corner = b.transpose() * &kb - p.transpose() * &lever;
        let second = &rows + corner * self.spin.transpose();
        let mut u = Mat::zeros(size, 6);
        u.as_mut().submatrix_mut(0, 0, size, 3).copy_from(turning);
        u.as_mut().submatrix_mut(0, 3, size, 3).copy_from(&self.spin);
        let mut v = Mat::zeros(6, size);
        v.as_mut().submatrix_mut(0, 0, 3, size).copy_from(self.spin.transpose());
        v.as_mut().submatrix_mut(3, 0, 3, size).copy_from(second);
        (u, v)
    }
}

/// [w̃_1; w̃_2; ...] of the triples of a vector. Shape: 3N x 3.
fn stacked_skew(vector: &Mat<f64>) -> Mat<f64> {
    let mut stack = Mat::zeros(vector.nrows(), 3);
    for n in 0..vector.nrows() / 3 {
        let block = skew([0, 1, 2].map(|i| vector[(3 * n + i, 0)]));
        stack.as_mut().submatrix_mut(3 * n, 0, 3, 3).copy_from(block);
    }
    stack
}
