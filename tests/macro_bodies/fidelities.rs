//! Every fidelity keeps its own energy and its own momenta, to the accuracy of the integrator.

#![allow(clippy::unwrap_used)] // helpers of tests are tests

use ffrf::nalgebra::{SMatrix, SVector, UnitQuaternion, Vector2, Vector3};
use ffrf::{DenseForms, FlexibleBody, FreeBody, GeneralisedForce, Observables};
use ffrf_codegen::fidelity::EnergyTerm;
use ffrf_codegen::{Fidelity, GenerateOptions, Kernels};
use ffrf_test_kit::interpreted_body::InterpretedBody;
use ffrf_test_kit::random_body::{Modes, random_body, stiffened};

/// Half a second of motion with periods of about half a second: a step of 1 ms leaves h⁴ of some 1e-10.
const CONSERVED: f64 = 1e-8;
/// Halving the step divides the drift of a method of order 4 by 16, less what is not yet asymptotic.
const LEAST_RATIO: f64 = 8.0;
/// Below this the drift is round-off of the steps, and its ratio says nothing.
const ROUND_OFF: f64 = 1e-12;

/// Size of the geometric stiffness, beside masses of modes of about one.
const STIFFENING: f64 = 0.3;

type Interpreted = InterpretedBody<2, 8>;

fn body(fidelity: Fidelity) -> Interpreted {
    let mut model = stiffened(random_body(11, 2, Modes::Random), 12, STIFFENING);
    model.damping.iter_mut().for_each(|row| row.fill(0.0));
    let options = GenerateOptions { fidelity, ..GenerateOptions::default() };
    InterpretedBody(Kernels::formulate(&model, &options).unwrap())
}

fn flying<B: FlexibleBody<Modal = Vector2<f64>>>(body: B) -> FreeBody<B> {
    FreeBody::new(body)
        .with_position(Vector3::new(0.4, -0.1, 0.2))
        .with_orientation(UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -0.8, 0.5)))
        .with_velocity(Vector3::new(0.5, -0.4, 0.2))
        .with_spin(Vector3::new(1.0, 2.0, -1.5))
        .with_deformation(Vector2::new(0.15, -0.1), Vector2::new(0.6, 0.5))
}

/// Relative drifts of energy, linear and angular momentum over half a second.
fn drifts<B: Observables<Modal = Vector2<f64>>>(body: B, steps: usize) -> [f64; 3] {
    let mut body = flying(body);
    let before =
        (body.kinetic_energy() + body.elastic_energy(), body.linear_momentum(), body.angular_momentum());
    for _ in 0..steps {
        body.step_rk4(0.5 / steps as f64, &()).unwrap();
    }
    let energy = body.kinetic_energy() + body.elastic_energy();
    assert!((body.state.modal_coordinates - Vector2::new(0.15, -0.1)).norm() > 0.01, "nothing moved");
    [
        (energy - before.0).abs() / before.0,
        (body.linear_momentum() - before.1).norm() / before.1.norm(),
        (body.angular_momentum() - before.2).norm() / before.2.norm(),
    ]
}

#[track_caller]
fn keeps_energy_and_momenta(fidelity: Fidelity) {
    let name = fidelity.to_string();
    let (coarse, fine) = (drifts(body(fidelity.clone()), 250), drifts(body(fidelity), 500));
    eprintln!("{name}: {coarse:?} with 250 steps, {fine:?} with 500");
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        assert!(fine < CONSERVED, "{name}: {fine:e}");
        assert!(coarse < ROUND_OFF || coarse / fine > LEAST_RATIO, "{name}: {coarse:e} -> {fine:e}");
    }
}

#[test]
fn rigid_keeps_energy_and_momenta() {
    keeps_energy_and_momenta(Fidelity::Rigid);
}

#[test]
fn constant_keeps_energy_and_momenta() {
    keeps_energy_and_momenta(Fidelity::Constant);
}

#[test]
fn linear_keeps_energy_and_momenta() {
    keeps_energy_and_momenta(Fidelity::Linear);
}

#[test]
fn unstiffened_keeps_energy_and_momenta() {
    keeps_energy_and_momenta(Fidelity::Unstiffened);
}

#[test]
fn full_keeps_energy_and_momenta() {
    keeps_energy_and_momenta(Fidelity::Full);
}

#[test]
fn each_single_term_alone_and_each_term_left_out_keeps_energy_and_momenta() {
    let optional = || EnergyTerm::ALL.into_iter().filter(|term| !term.is_always_kept());
    for term in optional() {
        keeps_energy_and_momenta(Fidelity::Terms([term].into()));
        keeps_energy_and_momenta(Fidelity::Terms(optional().filter(|other| *other != term).collect()));
    }
}

/// Terms dropped from the equations, not from the energy: the mass matrix follows the deformation, the
/// quadratic velocity vector is that of the undeformed body.
struct Careless {
    full: Interpreted,
    constant: Interpreted,
}

impl Careless {
    fn acceleration(&self, q: &Vector2<f64>, omega: &Vector3<f64>, q_dot: &Vector2<f64>) -> SVector<f64, 8> {
        let mass: SMatrix<f64, 8, 8> = self.full.mass_matrix(q);
        let mut force = -self.constant.quadratic_velocity(q, omega, q_dot);
        for (mu, internal) in self.full.internal_force(q, q_dot).iter().enumerate() {
            force[6 + mu] -= internal;
        }
        mass.cholesky().unwrap().solve(&force)
    }
}

/// The reason for truncating the energy: truncated equations lose energy, however small the step.
#[test]
fn terms_dropped_from_the_equations_lose_energy() {
    let careless = Careless { full: body(Fidelity::Full), constant: body(Fidelity::Constant) };
    let state = flying(body(Fidelity::Full)).state;
    let (q, omega, q_dot) = (state.modal_coordinates, state.angular_velocity, state.modal_rates);
    // The power that the equations leave: the body's own accelerations against the careless ones.
    let nothing = GeneralisedForce::zeros(&q);
    let right = careless.full.forward_dynamics(&q, &omega, &q_dot, &nothing).to_vector::<8>();
    let wrong = careless.acceleration(&q, &omega, &q_dot);
    let velocity = state.body_velocity();
    let speeds = state.velocities().to_vector::<8>();
    let power = speeds.dot(&(careless.full.mass_matrix(&q) * (wrong - right)));
    let energy = careless.full.kinetic_energy(&q, &velocity, &omega, &q_dot);
    eprintln!("power out of nothing: {power:e} W at {energy:e} J");
    assert!(power.abs() > 1e-3 * energy);
    // The same with the kernels of one energy is round-off.
    let mut stepped = FreeBody::new(careless.full.clone()).with_state(state);
    stepped.step_rk4(1e-6, &()).unwrap();
    let after = stepped.kinetic_energy() + stepped.elastic_energy();
    let before = energy + careless.full.elastic_energy(&q);
    assert!((after - before).abs() < ROUND_OFF * before);
}
