//! Checks of one compiled body against the naive form of the equations and against the interpreter.

use ffrf_codegen::Kernels;
use ffrf_model::{Matrix3, ReducedBody};
use ffrf_runtime::nalgebra::{SMatrix, SVector, Vector3};
use ffrf_runtime::{DenseForms, FlexibleBody, GeneralisedForce, Observables};

use crate::naive_body::{Invariants, NaiveBody};
use crate::provided::Provided;
use crate::random::Random;

/// Kernels of polynomials: a few hundred operations on numbers of one size.
const POLYNOMIAL: f64 = 1e-13;
/// Accelerations: the mass matrices of the random bodies have condition numbers below 1e4.
const ACCELERATION: f64 = 1e-10;
/// Single precision with the same condition numbers.
const SINGLE: f64 = 2e-3;

/// The invariants of a model as the naive form wants them.
pub fn invariants<const M: usize>(body: &ReducedBody) -> Invariants<M> {
    let inertia = &body.inertia;
    let modal = |matrix: &[Vec<f64>]| std::array::from_fn(|mu| std::array::from_fn(|nu| matrix[mu][nu]));
    let pair = |mu: usize, nu: usize| -> Matrix3 { inertia.mode_mode_moment[mu][nu] };
    Invariants {
        mass: inertia.mass,
        centre_of_mass: inertia.first_moment.map(|x| x / inertia.mass),
        modal_centre_of_mass: std::array::from_fn(|mu| {
            inertia.modal_first_moment[mu].map(|x| x / inertia.mass)
        }),
        euler_tensor: inertia.second_moment,
        modal_euler_tensor: std::array::from_fn(|mu| inertia.position_mode_moment[mu]),
        modal_pair_euler_tensor: std::array::from_fn(|mu| std::array::from_fn(|nu| pair(mu, nu))),
        stiffness: modal(&body.stiffness),
        damping: modal(&body.damping),
    }
}

struct Sample<const M: usize, const N: usize> {
    q: SVector<f64, M>,
    velocity: Vector3<f64>,
    omega: Vector3<f64>,
    q_dot: SVector<f64, M>,
    force: SVector<f64, N>,
    gravity: Vector3<f64>,
}

fn samples<const M: usize, const N: usize>() -> Vec<Sample<M, N>> {
    let mut random = Random::new(99);
    (0..6)
        .map(|k| {
            let amplitude = 0.1 * f64::from(k);
            Sample {
                q: SVector::from_fn(|_, _| amplitude * random.number()),
                velocity: Vector3::from_fn(|_, _| random.number()),
                omega: Vector3::from_fn(|_, _| 3.0 * random.number()),
                q_dot: SVector::from_fn(|_, _| random.number()),
                force: SVector::from_fn(|_, _| 10.0 * random.number()),
                gravity: Vector3::from_fn(|_, _| 9.81 * random.number()),
            }
        })
        .collect()
}

#[track_caller]
fn close(what: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let size = expected.iter().fold(1e-3_f64, |size, x| size.max(x.abs()));
    for (k, (found, expected)) in found.iter().zip(expected).enumerate() {
        let error = (found - expected).abs() / size;
        assert!(error <= tolerance, "{what}[{k}]: {found} and {expected}, relative error {error:e}");
    }
}

/// All kernels of `compiled` at several states; against the naive form only if its energy is the full one.
#[track_caller]
pub fn check<const M: usize, const N: usize, B: DenseForms<M, N> + Observables>(
    compiled: &B,
    body: &ReducedBody,
    kernels: &Kernels,
    full: bool,
) {
    let naive = NaiveBody::<M, N>::new(&invariants(body)).stiffened(body.geometric_stiffness.as_ref());
    for s in samples::<M, N>() {
        let (q, v, w, p, f) = (&s.q, &s.velocity, &s.omega, &s.q_dot, &s.force);
        let slices = (q.as_slice(), v.as_slice(), w.as_slice(), p.as_slice(), f.as_slice());
        let mass = compiled.mass_matrix(q);
        let quadratic = compiled.quadratic_velocity(q, w, p);
        let acceleration = accelerations(compiled, &s);
        let together = compiled.equations_of_motion(q, w, p, f);
        close("mass", together.mass_matrix.as_slice(), mass.as_slice(), POLYNOMIAL);
        close("quadratic", together.quadratic_velocity.as_slice(), quadratic.as_slice(), POLYNOMIAL);
        close("acceleration", together.acceleration.as_slice(), acceleration.as_slice(), ACCELERATION);

        close("mass", mass.as_slice(), &kernels.mass_matrix(slices.0).concat(), POLYNOMIAL);
        let expected = kernels.quadratic_velocity(slices.0, slices.2, slices.3);
        close("quadratic", quadratic.as_slice(), &expected, POLYNOMIAL);
        let expected = kernels.forward_dynamics(slices.0, slices.2, slices.3, slices.4);
        close("acceleration", acceleration.as_slice(), &expected, ACCELERATION);
        let gravity = compiled.gravity_force(q, &s.gravity).to_vector::<N>();
        close(
            "gravity",
            gravity.as_slice(),
            &kernels.gravity_force(slices.0, s.gravity.as_slice()),
            POLYNOMIAL,
        );
        let internal = compiled.internal_force(q, p);
        close("internal", internal.as_slice(), &kernels.internal_force(slices.0, slices.3), POLYNOMIAL);
        consistent(compiled, &s, mass);
        prepared(compiled, &s);
        if full {
            against_naive(compiled, &naive, &s);
        }
    }
}

/// The accelerations at a state, one below the other.
fn accelerations<const M: usize, const N: usize, B: DenseForms<M, N>>(
    body: &B,
    s: &Sample<M, N>,
) -> SVector<f64, N> {
    let force = GeneralisedForce::from_vector(&s.force);
    body.forward_dynamics(&s.q, &s.omega, &s.q_dot, &force).to_vector()
}

/// The body's own `prepare` and constants, which joints and implicit steps use, against its other kernels.
#[track_caller]
fn prepared<const M: usize, const N: usize, B: DenseForms<M, N> + Observables>(body: &B, s: &Sample<M, N>) {
    let (q, v, w, p) = (&s.q, &s.velocity, &s.omega, &s.q_dot);
    let provided = Provided(body);
    let mass: SMatrix<f64, N, N> = provided.mass_matrix(q);
    close("prepared mass", mass.as_slice(), body.mass_matrix(q).as_slice(), POLYNOMIAL);
    let quadratic: SVector<f64, N> = provided.quadratic_velocity(q, w, p);
    let expected = body.quadratic_velocity(q, w, p);
    close("prepared quadratic", quadratic.as_slice(), expected.as_slice(), POLYNOMIAL);
    let internal = body.prepare(q, w, p).internal_force;
    close("prepared internal", internal.as_slice(), body.internal_force(q, p).as_slice(), POLYNOMIAL);
    let internal = provided.internal_force(q, p);
    close("constant matrices", internal.as_slice(), body.internal_force(q, p).as_slice(), POLYNOMIAL);
    let weight = provided.gravity_force(q, &s.gravity).to_vector::<N>();
    let expected = body.gravity_force(q, &s.gravity).to_vector::<N>();
    close("prepared gravity", weight.as_slice(), expected.as_slice(), POLYNOMIAL);
    let expected = accelerations(body, s);
    close("eliminated", accelerations(&provided, s).as_slice(), expected.as_slice(), ACCELERATION);
    let observed = |body: &dyn Observables<Modal = SVector<f64, M>>| {
        let (linear, angular) = (body.linear_momentum(q, v, w, p), body.angular_momentum(q, v, w, p));
        let moment = body.first_mass_moment(q);
        let vectors = [linear, angular, moment].map(<[f64; 3]>::from).concat();
        [&[body.kinetic_energy(q, v, w, p), body.elastic_energy(q), body.mass()], vectors.as_slice()].concat()
    };
    close("prepared observables", &observed(&provided), &observed(body), POLYNOMIAL);
}

/// What must hold at every fidelity: M w + Q + internal force = force, and energy and momenta belong to M.
#[track_caller]
fn consistent<const M: usize, const N: usize, B: DenseForms<M, N> + Observables>(
    body: &B,
    s: &Sample<M, N>,
    mass: SMatrix<f64, N, N>,
) {
    let acceleration = accelerations(body, s);
    let mut residual = mass * acceleration + body.quadratic_velocity(&s.q, &s.omega, &s.q_dot) - s.force;
    let internal = body.internal_force(&s.q, &s.q_dot);
    for mu in 0..M {
        residual[6 + mu] += internal[mu];
    }
    close("residual + force", (residual + s.force).as_slice(), s.force.as_slice(), POLYNOMIAL * 100.0);
    let mut velocities = SVector::<f64, N>::zeros();
    for i in 0..3 {
        velocities[i] = s.velocity[i];
        velocities[3 + i] = s.omega[i];
    }
    for mu in 0..M {
        velocities[6 + mu] = s.q_dot[mu];
    }
    let momenta = mass * velocities;
    let linear = body.linear_momentum(&s.q, &s.velocity, &s.omega, &s.q_dot);
    let angular = body.angular_momentum(&s.q, &s.velocity, &s.omega, &s.q_dot);
    let energy = body.kinetic_energy(&s.q, &s.velocity, &s.omega, &s.q_dot);
    close("linear", linear.as_slice(), &momenta.as_slice()[..3], POLYNOMIAL);
    close("angular", angular.as_slice(), &momenta.as_slice()[3..6], POLYNOMIAL);
    close("kinetic", &[energy], &[0.5 * velocities.dot(&momenta)], POLYNOMIAL);
    let weight = body.gravity_force(&s.q, &s.gravity).to_vector::<N>();
    let columns = mass.fixed_columns::<3>(0) * s.gravity;
    close("gravity", weight.as_slice(), columns.as_slice(), POLYNOMIAL);
}

#[track_caller]
fn against_naive<const M: usize, const N: usize, B: DenseForms<M, N> + Observables>(
    body: &B,
    naive: &NaiveBody<M, N>,
    s: &Sample<M, N>,
) {
    let (q, v, w, p) = (&s.q, &s.velocity, &s.omega, &s.q_dot);
    close("mass", body.mass_matrix(q).as_slice(), naive.mass_matrix(q).as_slice(), POLYNOMIAL);
    let expected = naive.quadratic_velocity(q, w, p);
    close("quadratic", body.quadratic_velocity(q, w, p).as_slice(), expected.as_slice(), POLYNOMIAL);
    let expected = accelerations(naive, s);
    close("acceleration", accelerations(body, s).as_slice(), expected.as_slice(), ACCELERATION);
    close("kinetic", &[body.kinetic_energy(q, v, w, p)], &[naive.kinetic_energy(q, v, w, p)], POLYNOMIAL);
    close("elastic", &[body.elastic_energy(q)], &[naive.elastic_energy(q)], POLYNOMIAL);
    close("stiffness", body.stiffness_matrix().as_slice(), naive.stiffness_matrix().as_slice(), POLYNOMIAL);
    close("damping", body.damping_matrix().as_slice(), naive.damping_matrix().as_slice(), POLYNOMIAL);
}

/// Mass matrix and accelerations of a single-precision body against the interpreter in double precision.
#[track_caller]
pub fn check_single<const M: usize, const N: usize, B: DenseForms<M, N, f32>>(body: &B, kernels: &Kernels) {
    for s in samples::<M, N>() {
        let q = s.q.map(|x| x as f32);
        let (w, p, f) = (s.omega.map(|x| x as f32), s.q_dot.map(|x| x as f32), s.force.map(|x| x as f32));
        let mass = body.mass_matrix(&q).map(f64::from);
        close("mass", mass.as_slice(), &kernels.mass_matrix(s.q.as_slice()).concat(), SINGLE);
        let force = GeneralisedForce::from_vector(&f);
        let acceleration = body.forward_dynamics(&q, &w, &p, &force).to_vector::<N>().map(f64::from);
        let expected = kernels.forward_dynamics(
            s.q.as_slice(),
            s.omega.as_slice(),
            s.q_dot.as_slice(),
            s.force.as_slice(),
        );
        close("acceleration", acceleration.as_slice(), &expected, SINGLE);
    }
}
