//! The naive form of a body's equations, for any number of modes from 0 to 5.

use ffrf_host::HostModal;
use ffrf_model::ReducedBody;
use ffrf_runtime::{DenseForms, FlexibleBody, State};
use ffrf_test_kit::naive_body::NaiveBody;
use ffrf_test_kit::witness::invariants;
use nalgebra::{DMatrix, DVector, SVector, Vector3};

/// M w = f(state) of one free body, one below the other: [linear, angular, modes], body frame.
pub trait Naive {
    /// Mass matrix. Shape: (6 + M) x (6 + M).
    fn mass(&self, state: &State<HostModal>) -> DMatrix<f64>;
    /// Stiffness, damping of the modes. Shape: M x M.
    fn stiffness_and_damping(&self) -> [DMatrix<f64>; 2];
    /// Gravity less quadratic velocity, elastic and damping forces. Shape: 6 + M.
    fn force(&self, state: &State<HostModal>, gravity: &Vector3<f64>) -> DVector<f64>;
}

/// The witness of a model with at most five modes, or with nine or thirteen.
pub fn naive(model: &ReducedBody) -> Box<dyn Naive> {
    match model.mode_count() {
        0 => Box::new(NaiveBody::<0, 6>::new(&invariants(model))),
        1 => Box::new(NaiveBody::<1, 7>::new(&invariants(model))),
        2 => Box::new(NaiveBody::<2, 8>::new(&invariants(model))),
        3 => Box::new(NaiveBody::<3, 9>::new(&invariants(model))),
        4 => Box::new(NaiveBody::<4, 10>::new(&invariants(model))),
        5 => Box::new(NaiveBody::<5, 11>::new(&invariants(model))),
        9 => Box::new(NaiveBody::<9, 15>::new(&invariants(model))),
        13 => Box::new(NaiveBody::<13, 19>::new(&invariants(model))),
        more => panic!("no witness for {more} modes"),
    }
}

impl<const M: usize, const N: usize> Naive for NaiveBody<M, N> {
    fn mass(&self, state: &State<HostModal>) -> DMatrix<f64> {
        let q = SVector::from_column_slice(state.modal_coordinates.0.as_slice());
        let mass = self.mass_matrix(&q);
        DMatrix::from_fn(N, N, |i, j| mass[(i, j)])
    }

    fn stiffness_and_damping(&self) -> [DMatrix<f64>; 2] {
        [FlexibleBody::stiffness(self).dense(), FlexibleBody::damping(self).dense()]
            .map(|matrix| DMatrix::from_fn(M, M, |i, j| matrix[(i, j)]))
    }

    fn force(&self, state: &State<HostModal>, gravity: &Vector3<f64>) -> DVector<f64> {
        let q = SVector::<f64, M>::from_column_slice(state.modal_coordinates.0.as_slice());
        let q_dot = SVector::<f64, M>::from_column_slice(state.modal_rates.0.as_slice());
        let weight = self.gravity_force(&q, &state.to_body(gravity)).to_vector::<N>();
        let mut force = weight - self.quadratic_velocity(&q, &state.angular_velocity, &q_dot);
        let internal = self.internal_force(&q, &q_dot);
        for mu in 0..M {
            force[6 + mu] -= internal[mu];
        }
        DVector::from_column_slice(force.as_slice())
    }
}
