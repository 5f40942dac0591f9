//! What follows from [`Prepared`](ffrf_runtime::Prepared) against dense formulas: the modes eliminated first or not.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

use ffrf_runtime::nalgebra::{Cholesky, Matrix3, SMatrix, SVector, Vector2, Vector3};
use ffrf_runtime::{DenseForms, FlexibleBody, GeneralisedForce, ModalMatrix, Motion, Observables, RigidBody};
use ffrf_test_kit::bodies::{cloud, rigid_about};
use ffrf_test_kit::naive_body::NaiveBody;
use ffrf_test_kit::provided::Provided;
use ffrf_test_kit::tolerances::{ROUND_OFF, SOLVED};

/// A state, and a force, with no zero in them; numbers of order one.
struct Sample<const M: usize, const N: usize> {
    q: SVector<f64, M>,
    velocity: Vector3<f64>,
    omega: Vector3<f64>,
    q_dot: SVector<f64, M>,
    force: SVector<f64, N>,
}

impl<const M: usize, const N: usize> Sample<M, N> {
    fn new(seed: usize) -> Self {
        let wave = |scale: f64, k: usize| scale * (1.3 * (k + 7 * seed) as f64 + 0.4).sin();
        Self {
            q: SVector::from_fn(|k, _| wave(0.2, k)),
            velocity: Vector3::from_fn(|k, _| wave(0.7, k + 11)),
            omega: Vector3::from_fn(|k, _| wave(2.0, k + 23)),
            q_dot: SVector::from_fn(|k, _| wave(0.5, k + 31)),
            force: SVector::from_fn(|k, _| wave(3.0, k + 47)),
        }
    }
}

fn close<const R: usize>(found: &SVector<f64, R>, expected: &SVector<f64, R>, tolerance: f64) {
    let (difference, scale) = ((found - expected).amax(), expected.amax().max(1.0));
    assert!(difference <= tolerance * scale, "{found} {expected}");
}

/// All that the traits provide, against the naive body's own dense formulas.
fn provided_methods_agree<const M: usize, const N: usize>(seed: usize) {
    let naive = cloud::<M, N>(seed as u64, 30.0, 0.7).0;
    let provided = Provided(naive);
    let Sample { q, velocity, omega, q_dot, force } = Sample::<M, N>::new(seed);
    let resultant = GeneralisedForce::from_vector(&force);

    let expected = naive.forward_dynamics(&q, &omega, &q_dot, &resultant).to_vector::<N>();
    assert!(expected.iter().all(|entry| *entry != 0.0));
    close(&provided.forward_dynamics(&q, &omega, &q_dot, &resultant).to_vector(), &expected, SOLVED);
    let equations = provided.equations_of_motion(&q, &omega, &q_dot, &force);
    close(&equations.acceleration, &expected, SOLVED);
    let difference = equations.mass_matrix - naive.mass_matrix(&q);
    assert!(difference.amax() < ROUND_OFF, "{difference}");
    let alone: SMatrix<f64, N, N> = provided.mass_matrix(&q);
    assert_eq!(alone, equations.mass_matrix);
    close(&equations.quadratic_velocity, &naive.quadratic_velocity(&q, &omega, &q_dot), ROUND_OFF);

    close(&provided.internal_force(&q, &q_dot), &naive.internal_force(&q, &q_dot), ROUND_OFF);
    let weight = provided.gravity_force(&q, &velocity).to_vector::<N>();
    close(&weight, &naive.gravity_force(&q, &velocity).to_vector(), ROUND_OFF);
    assert_eq!(DenseForms::<M, N>::stiffness_matrix(&provided), naive.stiffness().dense());
    assert_eq!(DenseForms::<M, N>::damping_matrix(&provided), naive.damping().dense());

    let energies = |body: &dyn Observables<Modal = SVector<f64, M>>| {
        let kinetic = body.kinetic_energy(&q, &velocity, &omega, &q_dot);
        SVector::from([kinetic, body.elastic_energy(&q), body.mass()])
    };
    close(&energies(&provided), &energies(&naive), ROUND_OFF);
    let linear = provided.linear_momentum(&q, &velocity, &omega, &q_dot);
    close(&linear, &naive.linear_momentum(&q, &velocity, &omega, &q_dot), ROUND_OFF);
    let angular = provided.angular_momentum(&q, &velocity, &omega, &q_dot);
    close(&angular, &naive.angular_momentum(&q, &velocity, &omega, &q_dot), ROUND_OFF);
    close(&provided.first_mass_moment(&q), &naive.first_mass_moment(&q), ROUND_OFF);
}

#[test]
fn provided_methods_are_the_dense_formulas() {
    for seed in 1..20 {
        provided_methods_agree::<0, 6>(seed);
        provided_methods_agree::<1, 7>(seed);
        provided_methods_agree::<2, 8>(seed);
        provided_methods_agree::<5, 11>(seed);
        provided_methods_agree::<9, 15>(seed);
    }
}

/// One elimination serves many right-hand sides, without and with implicit terms of stiffness and damping.
#[test]
fn one_elimination_solves_for_many_forces() {
    for seed in 1..20 {
        let naive = cloud::<4, 10>(seed as u64, 30.0, 0.7).0;
        let Sample { q, omega, q_dot, .. } = Sample::<4, 10>::new(seed);
        let prepared = naive.prepare(&q, &omega, &q_dot);
        for gamma_h in [0.0, 1e-2, 1.0] {
            let implicit = naive.damping_matrix() * gamma_h + naive.stiffness_matrix() * (gamma_h * gamma_h);
            let mut dense: SMatrix<f64, 10, 10> = naive.mass_matrix(&q);
            let mut block = dense.fixed_view_mut::<4, 4>(6, 6);
            block += implicit;
            let dense = Cholesky::new(dense).unwrap();
            let modal = naive.modal_mass().plus(gamma_h, &naive.damping());
            let modal = modal.plus(gamma_h * gamma_h, &naive.stiffness());
            let factored = prepared.eliminate(modal.factor().unwrap()).factor().unwrap();
            for force in (0..5).map(|k| Sample::<4, 10>::new(seed + 100 * k).force) {
                let found = factored.solve(&GeneralisedForce::from_vector(&force));
                close(&found.to_vector(), &dense.solve(&force), SOLVED);
            }
        }
        // and it undoes the product with the mass matrix
        let factored = prepared.eliminate(naive.modal_mass().factor().unwrap()).factor().unwrap();
        let motion = Motion::from_vector(&Sample::<4, 10>::new(seed).force);
        let back = factored.solve(&prepared.mass_times(&naive.modal_mass(), &motion));
        close(&back.to_vector::<10>(), &motion.to_vector(), SOLVED);
    }
}

#[test]
fn what_has_no_positive_mass_is_not_eliminated() {
    let naive = cloud::<2, 8>(3, 30.0, 0.0).0;
    let Sample { q, omega, q_dot, force, .. } = Sample::<2, 8>::new(3);
    let sound = naive.prepare(&q, &omega, &q_dot);
    let factors = || naive.modal_mass().factor().unwrap();
    assert!(sound.eliminate(factors()).factor().is_some());
    for mass in [-1.0, 0.0, f64::NAN] {
        let mut broken = sound;
        broken.mass = mass;
        assert!(broken.eliminate(factors()).factor().is_none(), "{mass}");
    }
    let mut broken = sound;
    broken.inertia = Matrix3::zeros();
    assert!(broken.eliminate(factors()).factor().is_none());
    // forward dynamics of such a body is not a number, in every component
    let broken: NaiveBody<0, 6> = rigid_about(-1.0, Vector3::zeros(), Vector3::new(1.0, 1.0, 1.0));
    let push = GeneralisedForce::from_vector(&force.fixed_rows::<6>(0).into_owned());
    let none = SVector::<f64, 0>::zeros();
    for accelerations in [
        broken.forward_dynamics(&none, &omega, &none, &push),
        Provided(broken).forward_dynamics(&none, &omega, &none, &push),
    ] {
        assert!(accelerations.to_vector::<6>().iter().all(|entry| entry.is_nan()));
    }
}

#[test]
fn a_diagonal_matrix_is_the_dense_one_with_zeros() {
    let (one, two) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.5, 4.0, -0.25));
    let vector = Vector3::new(-1.0, 0.7, 0.2);
    let diagonal = ModalMatrix::Diagonal(one);
    let dense = ModalMatrix::<Vector3<f64>, f64>::Dense(diagonal.dense());
    assert_eq!(diagonal.dense(), Matrix3::from_diagonal(&one));
    assert_eq!(diagonal.product(&vector), dense.product(&vector));
    let other = ModalMatrix::Diagonal(two);
    assert!(matches!(diagonal.plus(0.3, &other), ModalMatrix::Diagonal(_)));
    let expected = Matrix3::from_diagonal(&(one + two * 0.3));
    for sum in [
        diagonal.plus(0.3, &other),
        dense.plus(0.3, &other),
        diagonal.plus(0.3, &ModalMatrix::Dense(other.dense())),
    ] {
        assert!((sum.dense() - expected).amax() < ROUND_OFF);
        close(&sum.factor().unwrap().solve(&vector), &vector.component_div(&(one + two * 0.3)), ROUND_OFF);
    }
    // two has a negative entry
    assert!(
        other.factor().is_none() && ModalMatrix::<Vector3<f64>, f64>::Dense(other.dense()).factor().is_none()
    );
    for entry in [0.0, f64::NAN, f64::INFINITY] {
        assert!(ModalMatrix::Diagonal(Vector2::new(1.0, entry)).factor().is_none(), "{entry}");
    }
}

/// A rigid body by its few numbers is the body without modes by its invariants.
#[test]
fn a_rigid_body_is_one_without_modes() {
    let (centre, principal) = (Vector3::new(0.1, -0.3, 0.2), Vector3::new(0.5, 0.7, 0.9));
    let naive = rigid_about(2.0, centre, principal);
    let rigid = RigidBody::new(2.0, centre, Matrix3::from_diagonal(&principal));
    let Sample { q, velocity, omega, q_dot, force } = Sample::<0, 6>::new(5);
    let push = GeneralisedForce::from_vector(&force);
    let expected = naive.forward_dynamics(&q, &omega, &q_dot, &push).to_vector::<6>();
    close(&rigid.forward_dynamics(&q, &omega, &q_dot, &push).to_vector(), &expected, SOLVED);
    let energy =
        |body: &dyn Observables<Modal = SVector<f64, 0>>| body.kinetic_energy(&q, &velocity, &omega, &q_dot);
    assert!((energy(&rigid) - energy(&naive)).abs() < ROUND_OFF);
    assert_eq!((rigid.elastic_energy(&q), rigid.mass()), (0.0, 2.0));
}
