//! How large each term of the kinetic energy can be in the equations, before anything is integrated: from what a motion reaches
//! at most.
//!
//! Each term E_k of the energy gives its part of the equations, d/dt ∂E_k/∂v + ω × ∂E_k/∂v and so on (`docs/theory/README.md`). They
//! are products of invariants with q, q̇, q̈, ω, ω̇ and the acceleration of the frame; the triangle inequality bounds each by the
//! norms of its factors. The velocity of the frame is in none of them.

use ffrf_codegen::fidelity::EnergyTerm;
use ffrf_model::ReducedBody;
use nalgebra::{Matrix3, Vector3};

/// What a body does at most in a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionLimits {
    /// |p̈ - g| of the frame origin, gravity taken off. Units: m/s².
    pub acceleration: f64,
    /// |ω|. Units: rad/s.
    pub spin: f64,
    /// |ω̇|. Units: rad/s².
    pub spin_rate: f64,
    /// |q_μ|. Shape: M.
    pub coordinates: Vec<f64>,
    /// |q̇_μ|. Shape: M. Units: 1/s.
    pub rates: Vec<f64>,
    /// |q̈_μ|. Shape: M. Units: 1/s².
    pub accelerations: Vec<f64>,
}

impl MotionLimits {
    /// A motion of a body of so many modes that rests.
    pub fn at_rest(modes: usize) -> Self {
        let none = vec![0.0; modes];
        Self {
            acceleration: 0.0,
            spin: 0.0,
            spin_rate: 0.0,
            coordinates: none.clone(),
            rates: none.clone(),
            accelerations: none,
        }
    }

    /// Widens the limits to hold another state.
    pub fn include(&mut self, other: &Self) {
        let widen = |own: &mut f64, other: f64| *own = own.max(other);
        widen(&mut self.acceleration, other.acceleration);
        widen(&mut self.spin, other.spin);
        widen(&mut self.spin_rate, other.spin_rate);
        for (own, other) in [
            (&mut self.coordinates, &other.coordinates),
            (&mut self.rates, &other.rates),
            (&mut self.accelerations, &other.accelerations),
        ] {
            own.iter_mut().zip(other).for_each(|(own, other)| widen(own, *other));
        }
    }

    /// The limits times a factor.
    pub fn scaled(&self, factor: f64) -> Self {
        let all = |numbers: &[f64]| numbers.iter().map(|number| factor * number).collect();
        Self {
            acceleration: factor * self.acceleration,
            spin: factor * self.spin,
            spin_rate: factor * self.spin_rate,
            coordinates: all(&self.coordinates),
            rates: all(&self.rates),
            accelerations: all(&self.accelerations),
        }
    }
}

/// The size of a generalised force.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceSize {
    /// Of the force on the frame. Units: N.
    pub force: f64,
    /// Of the moment about its origin. Units: N m.
    pub moment: f64,
    /// Of the force on each mode. Shape: M.
    pub modal: Vec<f64>,
}

impl ForceSize {
    pub(super) fn nothing(modes: usize) -> Self {
        Self { force: 0.0, moment: 0.0, modal: vec![0.0; modes] }
    }

    /// The most that both together can be.
    pub(super) fn plus(&self, other: &Self) -> Self {
        Self {
            force: self.force + other.force,
            moment: self.moment + other.moment,
            modal: self.modal.iter().zip(&other.modal).map(|(own, other)| own + other).collect(),
        }
    }
}

/// The most that a term of the kinetic energy can contribute to the equations of a body within limits.
///
/// Exact for one mode and directions that agree; with many modes their sum, whatever their signs.
pub fn term_bound(body: &ReducedBody, term: EnergyTerm, limits: &MotionLimits) -> ForceSize {
    let inertia = &body.inertia;
    let modes = body.mode_count();
    let (a, w, w_dot) = (limits.acceleration, limits.spin, limits.spin_rate);
    let [q, q_dot, q_ddot] = [&limits.coordinates, &limits.rates, &limits.accelerations];
    let at = |list: &[f64], mode: usize| list.get(mode).copied().unwrap_or(0.0);
    let mut bound = ForceSize::nothing(modes);
    match term {
        EnergyTerm::Translation => bound.force = inertia.mass * a,
        EnergyTerm::FirstMoment => {
            let moment = Vector3::from(inertia.first_moment).norm();
            (bound.force, bound.moment) = (moment * (w_dot + w * w), moment * a);
        }
        EnergyTerm::ModalMomentum => {
            let moments: Vec<f64> =
                inertia.modal_first_moment.iter().map(|moment| Vector3::from(*moment).norm()).collect();
            let along =
                |list: &[f64]| -> f64 { moments.iter().zip(list).map(|(moment, x)| moment * x).sum() };
            bound.force = along(q_ddot) + 2.0 * w * along(q_dot) + (w_dot + w * w) * along(q);
            bound.moment = along(q) * a;
            bound.modal = moments.iter().map(|moment| moment * a).collect();
        }
        EnergyTerm::Rotation => {
            let tensor = Tensor::of(&inertia.second_moment);
            bound.moment = 0.5 * (tensor.norm * w_dot + tensor.spread * w * w);
        }
        EnergyTerm::RotationLinear => {
            for (mode, moment) in inertia.position_mode_moment.iter().enumerate() {
                let tensor = Tensor::of(moment);
                bound.moment += at(q, mode) * (tensor.norm * w_dot + tensor.spread * w * w)
                    + at(q_dot, mode) * tensor.norm * w;
                bound.modal[mode] = 0.5 * tensor.norm * w * w;
            }
        }
        EnergyTerm::ModalRotation => {
            for (mode, moment) in inertia.position_mode_moment.iter().enumerate() {
                let axial = axial(moment).norm();
                bound.moment += axial * (at(q_ddot, mode) + w * at(q_dot, mode));
                bound.modal[mode] = axial * w_dot;
            }
        }
        EnergyTerm::Modal => {
            for (mode, row) in inertia.mode_mode_moment.iter().enumerate() {
                let entry = |(other, moment): (usize, &[[f64; 3]; 3])| {
                    (0..3).map(|i| moment[i][i]).sum::<f64>().abs() * at(q_ddot, other)
                };
                bound.modal[mode] = row.iter().enumerate().map(entry).sum();
            }
        }
        EnergyTerm::RotationQuadratic => {
            of_pairs(&mut bound, limits, |first, second| {
                Tensor::of(&inertia.mode_mode_moment[first][second])
            });
        }
        EnergyTerm::CentrifugalStiffening => {
            if let Some(geometric) = &body.geometric_stiffness {
                of_pairs(&mut bound, limits, |first, second| {
                    Tensor::of(&geometric.linear_load[first][second])
                });
            }
        }
        EnergyTerm::ModalRotationDeformed => {
            for (first, row) in inertia.mode_mode_moment.iter().enumerate() {
                for (second, moment) in row.iter().enumerate() {
                    // q_first ω·ϑ q̇_second; ϑ changes its sign with the order, so that q̇ q̇ ϑ is none
                    let axial = axial(moment).norm();
                    bound.moment += axial * at(q, first) * (at(q_ddot, second) + w * at(q_dot, second));
                    bound.modal[second] += axial * (2.0 * at(q_dot, first) * w + at(q, first) * w_dot);
                }
            }
        }
        EnergyTerm::AngularAccelerationStiffening => {
            if let Some(geometric) = &body.geometric_stiffness {
                for (second, row) in geometric.linear_load.iter().enumerate() {
                    for (first, load) in row.iter().enumerate() {
                        let own = axial(load);
                        let turned = axial(&geometric.linear_load[first][second]);
                        bound.moment += own.norm()
                            * (at(q, first) * (at(q_ddot, second) + w * at(q_dot, second))
                                + at(q_dot, first) * at(q_dot, second));
                        bound.modal[second] +=
                            own.norm() * at(q, first) * w_dot + (own - turned).norm() * at(q_dot, first) * w;
                    }
                }
            }
        }
        EnergyTerm::LinearAccelerationStiffening => {
            if let Some(geometric) = &body.geometric_stiffness {
                for (mode, row) in geometric.uniform_load.iter().enumerate() {
                    for (other, load) in row.iter().enumerate() {
                        let load = Vector3::from(*load).norm();
                        let (place, rate) = (at(q, mode) * at(q, other), at(q, mode) * at(q_dot, other));
                        let second = at(q, mode) * at(q_ddot, other) + at(q_dot, mode) * at(q_dot, other);
                        bound.force += load * (second + 2.0 * w * rate + 0.5 * (w_dot + w * w) * place);
                        bound.moment += 0.5 * load * place * a;
                        bound.modal[mode] += load * at(q, other) * a;
                    }
                }
            }
        }
    }
    bound
}

/// Of ½ q_μ q_ν ω·Θ_μν ω.
fn of_pairs(bound: &mut ForceSize, limits: &MotionLimits, tensor: impl Fn(usize, usize) -> Tensor) {
    let (w, w_dot) = (limits.spin, limits.spin_rate);
    for (first, (q, q_dot)) in limits.coordinates.iter().zip(&limits.rates).enumerate() {
        for (second, other) in limits.coordinates.iter().enumerate() {
            let tensor = tensor(first, second);
            // of Θ + Θᵀ, twice the symmetric part
            bound.moment += 0.5 * q * other * (tensor.norm * w_dot + tensor.spread * w * w)
                + tensor.norm * q_dot * other * w;
            bound.modal[first] += 0.5 * tensor.norm * other * w * w;
        }
    }
}

/// Sizes of Θ + Θᵀ, with Θ = tr(T) I - Tᵀ of a moment T.
struct Tensor {
    /// |S ω| is at most this times |ω|.
    norm: f64,
    /// |ω × S ω| is at most this times |ω|²: half the distance of its outer eigenvalues.
    spread: f64,
}

impl Tensor {
    fn of(moment: &[[f64; 3]; 3]) -> Self {
        let moment = Matrix3::from_fn(|i, j| moment[i][j]);
        let tensor = Matrix3::from_diagonal_element(2.0 * moment.trace()) - moment - moment.transpose();
        let values = tensor.symmetric_eigenvalues();
        Self { norm: values.amax(), spread: 0.5 * (values.max() - values.min()) }
    }
}

/// ε_ijk T^{ij} e_k
fn axial(moment: &[[f64; 3]; 3]) -> Vector3<f64> {
    Vector3::new(moment[1][2] - moment[2][1], moment[2][0] - moment[0][2], moment[0][1] - moment[1][0])
}
