//! Implicit methods on free bodies: momentum and energy to round-off, orders, stiff modes.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use ffrf_runtime::nalgebra::{Vector1, Vector2, Vector3};
use ffrf_runtime::{
    EnergyMomentum, FlexibleBody, FreeBody, FreeSystem, GeneralisedAlpha, Gravity, ModalMatrix, Prepared,
    RadauIIA, RadauMemory, State, StepError, Tolerances, step_exponential, step_linearly_implicit_euler,
    step_rk4,
};
use ffrf_test_kit::bodies::cloud;
use ffrf_test_kit::convergence::measured_order;
use ffrf_test_kit::naive_body::{Invariants, NaiveBody};
use ffrf_test_kit::random_body::random_geometric_stiffness;
use ffrf_test_kit::tolerances::SLOPE;

type Body = FreeBody<NaiveBody<2, 8>>;
type Place = State<Vector2<f64>>;

/// Momentum after 2,000 steps of some hundred roundings each that add up like a random walk, at a distance of 6 m.
const KEPT: f64 = 1e-12;

/// A body of random points, not about its centre of mass, that spins, flies and vibrates.
fn body(stiffness: f64, damping: f64) -> Body {
    FreeBody::new(cloud::<2, 8>(7, stiffness, damping).0)
        .with_velocity(Vector3::new(0.3, -0.2, 0.5))
        .with_spin(Vector3::new(1.0, 2.0, -0.5))
        .with_deformation(Vector2::new(0.05, -0.03), Vector2::new(0.1, 0.2))
}

/// The largest difference of places and velocities.
fn difference(found: &Place, expected: &Place) -> f64 {
    (found.position - expected.position)
        .amax()
        .max((found.orientation.coords - expected.orientation.coords).amax())
        .max((found.modal_coordinates - expected.modal_coordinates).amax())
        .max((found.angular_velocity - expected.angular_velocity).amax())
        .max((found.modal_rates - expected.modal_rates).amax())
}

#[test]
fn a_free_body_keeps_energy_and_momentum_to_round_off() {
    keeps_energy_and_momentum(body(200.0, 0.0));
}

/// Stress stiffness brings terms into the kinetic energy whose derivatives the quadratic velocity vector does not show.
#[test]
fn a_body_with_geometric_stiffness_keeps_energy_and_momentum_to_round_off() {
    let mut body = body(200.0, 0.0);
    body.body = body.body.stiffened(Some(&random_geometric_stiffness(3, 2, 0.2)));
    keeps_energy_and_momentum(body);
}

fn keeps_energy_and_momentum(mut body: Body) {
    let energy = |body: &Body| body.kinetic_energy() + body.elastic_energy();
    let (before, linear, angular) = (energy(&body), body.linear_momentum(), body.angular_momentum());
    assert!(body.elastic_energy() > 0.01 * before, "it vibrates");
    let method = EnergyMomentum::new();
    let mut most = 0;
    for _ in 0..2_000 {
        let system = FreeSystem { body: &body.body, load: &() };
        let (state, report) = method.step(&system, &body.state, body.time, 5e-3).unwrap();
        most = most.max(report.iterations);
        body.state = state;
    }
    let errors = [
        (energy(&body) - before).abs() / before,
        (body.linear_momentum() - linear).norm() / linear.norm(),
        (body.angular_momentum() - angular).norm() / angular.norm(),
    ];
    eprintln!("energy, momenta: {errors:?}, at most {most} iterations");
    assert!(errors.iter().all(|error| *error < KEPT), "{errors:?}");
    assert!(most <= 12, "{most}");
}

#[test]
fn orders_of_free_bodies_are_two() {
    let gravity = Gravity { acceleration: Vector3::new(0.3, 0.0, -9.81) };
    let start = body(200.0, 0.5);
    let system = FreeSystem { body: &start.body, load: &gravity };
    let mut exact = start.state;
    for k in 0..4000 {
        exact = step_rk4(&system, &exact, k as f64 * 2.5e-4, 2.5e-4).unwrap().0;
    }
    let conserving = measured_order(100, 2, |steps| {
        let (method, h) = (EnergyMomentum::new(), 1.0 / steps as f64);
        let mut state = start.state;
        for k in 0..steps {
            state = method.step(&system, &state, k as f64 * h, h).unwrap().0;
        }
        difference(&state, &exact)
    });
    assert!((conserving - 2.0).abs() < SLOPE, "{conserving}");
    let tolerances = Tolerances { relative: 1e-13, absolute: 1e-14 };
    for spectral_radius in [0.0, 0.5, 1.0] {
        let method = GeneralisedAlpha { spectral_radius, iterations: 30, tolerances };
        let order = measured_order(200, 2, |steps| {
            let h = 1.0 / steps as f64;
            let mut state = start.state;
            let mut memory = method.start(&system, &state, 0.0, h).unwrap();
            for k in 0..steps {
                state = method.step(&system, &mut memory, &state, k as f64 * h, h).unwrap().0;
            }
            difference(&state, &exact)
        });
        assert!((order - 2.0).abs() < SLOPE, "{spectral_radius}: {order}");
    }
}

#[test]
fn radau_methods_have_orders_five_and_seven_on_free_bodies() {
    let gravity = Gravity { acceleration: Vector3::new(0.3, 0.0, -9.81) };
    let start = body(200.0, 0.5);
    let system = FreeSystem { body: &start.body, load: &gravity };
    let tolerances = Tolerances { relative: 1e-14, absolute: 1e-15 };
    let (five, seven) = (
        RadauIIA { iterations: 40, tolerances, ..RadauIIA::order_five() },
        RadauIIA { iterations: 40, tolerances, ..RadauIIA::order_seven() },
    );
    let run = |steps: usize, seventh: bool, is_remembered: bool| {
        let h = 1.0 / steps as f64;
        let (mut of_five, mut of_seven) = (RadauMemory::new(), RadauMemory::new());
        (0..steps).fold(start.state, |state, k| {
            let time = k as f64 * h;
            let next = match (seventh, is_remembered) {
                (true, true) => seven.step_from(&system, &mut of_seven, &state, time, h),
                (true, false) => seven.step(&system, &state, time, h),
                (false, true) => five.step_from(&system, &mut of_five, &state, time, h),
                (false, false) => five.step(&system, &state, time, h),
            };
            next.unwrap().0
        })
    };
    let exact = run(400, true, false);
    for is_remembered in [false, true] {
        let order = measured_order(50, 2, |steps| difference(&run(steps, false, is_remembered), &exact));
        assert!((order - 5.0).abs() < SLOPE, "{order}");
        let order = measured_order(20, 2, |steps| difference(&run(steps, true, is_remembered), &exact));
        assert!((order - 7.0).abs() < SLOPE, "{order}");
    }
}

#[test]
fn a_memory_of_another_motion_or_step_size_leaves_radau_steps_as_they_are() {
    let (start, other) = (body(200.0, 0.5), body(200.0, 0.5).with_spin(Vector3::new(-3.0, 1.0, 2.0)));
    let system = FreeSystem { body: &start.body, load: &() };
    let tolerances = Tolerances { relative: 1e-11, absolute: 1e-12 };
    let method = RadauIIA { tolerances, ..RadauIIA::order_five() };
    let expected = method.step(&system, &start.state, 0.0, 0.01).unwrap().0;
    for before in [0.01, 0.008, 0.002, 1e-6] {
        let mut memory = RadauMemory::new();
        let mut state = other.state;
        for _ in 0..4 {
            state = method.step_from(&system, &mut memory, &state, 0.0, before).unwrap().0;
        }
        let found = method.step_from(&system, &mut memory, &start.state, 0.0, 0.01).unwrap().0;
        // both leave a root mean square within tolerance, of numbers of the order of one
        let apart = difference(&found, &expected);
        assert!(apart < 1e-10, "{before}: {apart:e}");
    }
    // nothing that a step without memory solves is refused with one, and sweeps that led nowhere are counted
    let few = |iterations: usize| RadauIIA { iterations, ..method };
    let needed = method.step(&system, &start.state, 0.0, 0.01).unwrap().1.iterations;
    let wild = body(200.0, 0.5).with_spin(Vector3::new(-40.0, 30.0, 20.0));
    let mut memory = RadauMemory::new();
    method.step_from(&system, &mut memory, &wild.state, 0.0, 0.01).unwrap();
    let (state, report) = few(needed).step_from(&system, &mut memory, &start.state, 0.0, 0.01).unwrap();
    assert_eq!(report.iterations, 2 * needed);
    assert_eq!(state, expected);
    let refused = few(needed - 1).step_from(&system, &mut memory, &start.state, 0.0, 40.0);
    assert!(refused.is_err(), "{refused:?}");
}

#[test]
fn stiff_modes_do_not_limit_the_step() {
    // frequencies of 1e5 rad/s and more at a step of 0.01 s
    let start = FreeBody::new(cloud::<2, 8>(7, 1e10, 0.0).0).with_spin(Vector3::new(1.0, 2.0, -0.5));
    let system = FreeSystem { body: &start.body, load: &() };
    let method = GeneralisedAlpha::new();
    let mut memory = method.start(&system, &start.state, 0.0, 0.01).unwrap();
    let (mut alpha, mut euler, mut radau) = (start.state, start.state, start.state);
    for _ in 0..500 {
        alpha = method.step(&system, &mut memory, &alpha, 0.0, 0.01).unwrap().0;
        euler = step_linearly_implicit_euler(&system, &euler, 0.0, 0.01).unwrap().0;
        radau = RadauIIA::order_seven().step(&system, &radau, 0.0, 0.01).unwrap().0;
    }
    let energy = start.kinetic_energy();
    for (name, state, allowed) in [("alpha", alpha, 0.01), ("euler", euler, 0.1), ("radau", radau, 1e-6)] {
        let change = (start.with_state(state).kinetic_energy() - energy).abs() / energy;
        eprintln!("{name}: {change:e}");
        assert!(change < allowed, "{name}: {change}");
    }
}

#[test]
fn a_step_that_cannot_be_solved_is_refused_with_what_is_left() {
    let start = body(200.0, 0.0);
    let system = FreeSystem { body: &start.body, load: &() };
    let strict = EnergyMomentum { iterations: 2, ..EnergyMomentum::new() };
    match strict.step(&system, &start.state, 0.0, 0.02) {
        Err(StepError::NotConverged { iterations: 2, residual }) => assert!(residual > 1.0),
        other => panic!("{other:?}"),
    }
    // ten turns in a step
    let wild = EnergyMomentum::new().step(&system, &start.state, 0.0, 40.0);
    assert!(wild.is_err(), "{wild:?}");
    let method = GeneralisedAlpha { iterations: 1, ..GeneralisedAlpha::new() };
    let mut memory = method.start(&system, &start.state, 0.0, 0.02).unwrap();
    let before = memory;
    assert!(matches!(
        method.step(&system, &mut memory, &start.state, 0.0, 0.02),
        Err(StepError::NotConverged { iterations: 1, .. })
    ));
    assert_eq!(memory, before);
    let method = RadauIIA { iterations: 2, ..RadauIIA::order_five() };
    assert!(matches!(
        method.step(&system, &start.state, 0.0, 0.02),
        Err(StepError::NotConverged { iterations: 2, residual }) if residual > 1.0
    ));
    let wild = RadauIIA::order_seven().step(&system, &start.state, 0.0, 40.0);
    assert!(wild.is_err(), "{wild:?}");
}

/// A body whose one mode has a diagonal mass, as one number is.
#[derive(Clone, Copy)]
struct Ball(NaiveBody<1, 7>);

impl FlexibleBody for Ball {
    type Modal = Vector1<f64>;

    fn undeformed(&self) -> Self::Modal {
        self.0.undeformed()
    }

    fn modal_mass(&self) -> ModalMatrix<Self::Modal, f64> {
        ModalMatrix::Diagonal(self.0.modal_mass().dense().diagonal())
    }

    fn stiffness(&self) -> ModalMatrix<Self::Modal, f64> {
        ModalMatrix::Diagonal(self.0.stiffness().dense().diagonal())
    }

    fn damping(&self) -> ModalMatrix<Self::Modal, f64> {
        ModalMatrix::Diagonal(self.0.damping().dense().diagonal())
    }

    fn prepare(&self, q: &Self::Modal, omega: &Vector3<f64>, q_dot: &Self::Modal) -> Prepared<Self::Modal> {
        self.0.prepare(q, omega, q_dot)
    }
}

/// A ball that breathes, with a little damping; its mode has no momentum of its own: what the exponential step is for.
fn ball(stiffness: f64) -> Ball {
    let tensor = [[0.4, 0.0, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.5]];
    Ball(NaiveBody::new(&Invariants {
        mass: 2.0,
        centre_of_mass: [0.0; 3],
        modal_centre_of_mass: [[0.0; 3]],
        euler_tensor: tensor,
        modal_euler_tensor: [tensor],
        modal_pair_euler_tensor: [[tensor]],
        stiffness: [[stiffness]],
        damping: [[1e-3]],
    }))
}

#[test]
fn the_exponential_step_is_exact_in_free_vibration_and_has_order_two() {
    // at rest but for the mode, small: all that is left is one oscillator, at 500 radians per step
    let kernels = ball(1.2e9);
    let mut body = FreeBody::new(kernels).with_deformation(Vector1::new(1e-9), Vector1::zeros());
    let system = FreeSystem { body: &kernels, load: &() };
    for _ in 0..10 {
        body.state = step_exponential(&system, &body.state, 0.0, 0.01).unwrap().0;
    }
    let omega = (1.2e9_f64 / 1.2).sqrt();
    let decay = 0.5 * 1e-3 / 1.2;
    let (sine, cosine) = (omega * 0.1).sin_cos();
    let expected = 1e-9 * (-decay * 0.1_f64).exp() * (cosine + decay / omega * sine);
    // of 3000 radians round-off leaves 1e-12
    assert!(
        (body.state.modal_coordinates.x - expected).abs() < 1e-11 * 1e-9,
        "{}",
        body.state.modal_coordinates.x
    );

    let start = FreeBody::new(ball(120.0))
        .with_spin(Vector3::new(1.0, 2.0, -0.5))
        .with_deformation(Vector1::new(0.05), Vector1::new(0.1));
    let gravity = Gravity { acceleration: Vector3::new(0.3, 0.0, -9.81) };
    let system = FreeSystem { body: &start.body, load: &gravity };
    let run = |steps: usize, exponential: bool| {
        let h = 1.0 / steps as f64;
        (0..steps).fold(start.state, |state, k| {
            let time = k as f64 * h;
            if exponential {
                step_exponential(&system, &state, time, h).unwrap().0
            } else {
                step_rk4(&system, &state, time, h).unwrap().0
            }
        })
    };
    let exact = run(2000, false);
    let order = measured_order(50, 3, |steps| {
        let state = run(steps, true);
        (state.angular_velocity - exact.angular_velocity).norm()
            + (state.modal_coordinates - exact.modal_coordinates).norm()
    });
    assert!((order - 2.0).abs() < SLOPE, "{order}");
}

#[test]
fn the_exponential_step_refuses_what_does_not_separate() {
    let start = body(200.0, 0.0);
    let system = FreeSystem { body: &start.body, load: &() };
    let refused = step_exponential(&system, &start.state, 0.0, 1e-3);
    assert_eq!(refused.map(|_| ()), Err(StepError::ModesNotSeparate));
}
