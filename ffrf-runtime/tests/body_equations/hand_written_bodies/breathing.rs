//! A ball with one breathing mode written by hand: displacement φ = x, so that its size is 1 + q.

use ffrf_runtime::nalgebra::{Matrix3, Vector1, Vector3};
use ffrf_runtime::{DenseForms, FlexibleBody, GeneralisedForce, ModalMatrix, Observables, Prepared};

type One = Vector1<f64>;

#[derive(Clone, Copy)]
pub struct Ball {
    pub mass: f64,
    /// S in the Euler tensor S I of the undeformed ball. Units: kg m².
    pub euler: f64,
    pub stiffness: f64,
}

impl FlexibleBody for Ball {
    type Modal = One;

    fn undeformed(&self) -> One {
        One::zeros()
    }

    fn modal_mass(&self) -> ModalMatrix<One, f64> {
        ModalMatrix::Diagonal(One::new(3.0 * self.euler))
    }

    fn stiffness(&self) -> ModalMatrix<One, f64> {
        ModalMatrix::Diagonal(One::new(self.stiffness))
    }

    fn damping(&self) -> ModalMatrix<One, f64> {
        ModalMatrix::Diagonal(One::zeros())
    }

    fn prepare(&self, q: &One, omega: &Vector3<f64>, q_dot: &One) -> Prepared<One> {
        // Θ_rr = 2 S (1 + q)² I, Θ_μ^d = 2 S (1 + q) I
        let (size, two) = (1.0 + q.x, 2.0 * self.euler);
        Prepared {
            mass: self.mass,
            first_moment: Vector3::zeros(),
            inertia: Matrix3::from_diagonal_element(two * size * size),
            modal_first_moment: [One::zeros(); 3],
            rotation_modal_coupling: [One::zeros(); 3],
            quadratic_velocity: GeneralisedForce {
                force: Vector3::zeros(),
                moment: omega * (2.0 * two * size * q_dot.x),
                modal: One::new(-two * size * omega.norm_squared()),
            },
            internal_force: q * self.stiffness,
        }
    }
}

impl Observables for Ball {}
impl DenseForms<1, 7> for Ball {}
