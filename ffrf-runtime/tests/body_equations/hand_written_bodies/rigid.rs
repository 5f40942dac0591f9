//! A rigid body written by hand, its frame in the centre of mass and along the principal axes.

use ffrf_runtime::nalgebra::{Matrix3, SVector, Vector3};
use ffrf_runtime::{DenseForms, FlexibleBody, GeneralisedForce, ModalMatrix, Observables, Prepared};

type None = SVector<f64, 0>;

#[derive(Clone, Copy)]
pub struct Brick {
    pub mass: f64,
    pub principal: Vector3<f64>,
}

impl FlexibleBody for Brick {
    type Modal = None;

    fn undeformed(&self) -> None {
        None::zeros()
    }

    fn modal_mass(&self) -> ModalMatrix<None, f64> {
        ModalMatrix::Diagonal(None::zeros())
    }

    fn stiffness(&self) -> ModalMatrix<None, f64> {
        ModalMatrix::Diagonal(None::zeros())
    }

    fn damping(&self) -> ModalMatrix<None, f64> {
        ModalMatrix::Diagonal(None::zeros())
    }

    fn prepare(&self, q: &None, omega: &Vector3<f64>, _: &None) -> Prepared<None> {
        Prepared {
            mass: self.mass,
            first_moment: Vector3::zeros(),
            inertia: Matrix3::from_diagonal(&self.principal),
            modal_first_moment: [*q; 3],
            rotation_modal_coupling: [*q; 3],
            quadratic_velocity: GeneralisedForce {
                force: Vector3::zeros(),
                moment: omega.cross(&self.principal.component_mul(omega)),
                modal: *q,
            },
            internal_force: *q,
        }
    }
}

impl Observables for Brick {}
impl DenseForms<0, 6> for Brick {}
