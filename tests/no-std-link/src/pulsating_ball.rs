//! A ball with one breathing mode: the smallest flexible body that still couples deformation and spin.

use ffrf::nalgebra::{Matrix3, Vector1, Vector3};
use ffrf::{DenseForms, FlexibleBody, GeneralisedForce, ModalMatrix, Observables, Prepared};

const MASS: f64 = 2.0;
/// Euler tensor of the undeformed ball, T = S I. Units: kg m².
const S: f64 = 0.4;
const STIFFNESS: f64 = 120.0;

/// Displacement φ = x, so T_μ = T, T_μν = T and everything scales with 1 + q.
#[derive(Clone, Copy)]
pub struct PulsatingBall;

type One = Vector1<f64>;

impl FlexibleBody for PulsatingBall {
    type Modal = One;

    fn undeformed(&self) -> One {
        One::zeros()
    }

    fn modal_mass(&self) -> ModalMatrix<One, f64> {
        ModalMatrix::Diagonal(One::new(3.0 * S))
    }

    fn stiffness(&self) -> ModalMatrix<One, f64> {
        ModalMatrix::Diagonal(One::new(STIFFNESS))
    }

    fn damping(&self) -> ModalMatrix<One, f64> {
        ModalMatrix::Diagonal(One::zeros())
    }

    fn prepare(&self, q: &One, omega: &Vector3<f64>, q_dot: &One) -> Prepared<One> {
        let size = 1.0 + q.x;
        // Θ_rr = 2 S (1 + q)² I and Θ_μ^d = 2 S (1 + q) I
        let modal_inertia = 2.0 * S * size;
        Prepared {
            mass: MASS,
            first_moment: Vector3::zeros(),
            inertia: Matrix3::from_diagonal_element(modal_inertia * size),
            modal_first_moment: [One::zeros(); 3],
            rotation_modal_coupling: [One::zeros(); 3],
            quadratic_velocity: GeneralisedForce {
                force: Vector3::zeros(),
                moment: omega * (2.0 * q_dot.x * modal_inertia),
                modal: One::new(-modal_inertia * omega.norm_squared()),
            },
            internal_force: q * STIFFNESS,
        }
    }
}

impl Observables for PulsatingBall {}
impl DenseForms<1, 7> for PulsatingBall {}
