//! Spin from nothing to a million radians per second.

use ffrf::nalgebra::Vector3;
use ffrf::{Envelope, FlexibleBody, FreeBody};

use crate::row;
use crate::settings::{PRINCIPAL, Rod, brick, double, largest};
use crate::table::{Figure, Real, Section, below, refused};
use crate::tolerances::{TUMBLING, VIBRATING};

/// Of one step at unit spin. Units: rad.
const TURN: f64 = 0.01;
const STEPS: usize = 10_000;

pub fn section() -> Section {
    Section {
        title: "Spin from 0 to 1e6 rad/s",
        text: "A free rigid body (1, 2, 2.5 kg m²) that tumbles, 10,000 RK4 steps of 0.01 rad: drift of energy and angular \
               momentum over their size. A rigid body knows no time of its own: spin times 2ⁿ with a step over 2ⁿ gives the \
               same orientations to the last bit, until the squares of the spin leave the number type. The connecting rod \
               (4 modes, first bending frequency 1.0e4 rad/s) turns about its length, then across it, 2,000 steps: drift of \
               energy; beyond its bending frequency linear modes are no model, which `Envelope` says: the motion stays \
               finite or is refused.",
        rows: vec![
            row!("rigid, at rest", at_rest),
            row!("rigid, 1 rad/s", tumbling, 1.0),
            row!("rigid, 1e6 rad/s", tumbling, 1e6),
            row!("rigid, 2²⁰ rad/s against 1 rad/s", scaled, 20),
            row!("rigid, 2⁻⁴⁰ rad/s against 1 rad/s", scaled, -40),
            row!("rigid, smallest positive spin", smallest),
            row!("rod along its length, 1e3 rad/s", turning, Vector3::new(1e3, 0.0, 0.0)),
            row!("rod along its length, 1e6 rad/s", turning, Vector3::new(1e6, 0.0, 0.0)),
            row!("rod across its length, 1e3 rad/s", turning, Vector3::new(0.0, 0.0, 1e3)),
            row!("rod across its length, 1e5 rad/s", turning, Vector3::new(0.0, 0.0, 1e5)),
            row!("rod across its length, 1e6 rad/s", turning, Vector3::new(0.0, 0.0, 1e6)),
        ],
    }
}

/// Beside the intermediate axis.
fn start<T: Real>(size: T) -> Vector3<T> {
    Vector3::new(T::of(0.125), T::one(), T::of(0.0625)) * size
}

fn at_rest<T: Real>() -> Figure {
    let mut body = FreeBody::new(brick::<T>());
    let before = body.state;
    for _ in 0..100 {
        body.step_rk4(T::one(), &()).unwrap();
    }
    assert_eq!(body.state, before);
    Figure::Holds("stays, same bits")
}

fn tumbling<T: Real>(size: f64) -> Figure {
    let mut body = FreeBody::new(brick::<T>()).with_spin(start(T::of(size)));
    let step = T::of(TURN / size);
    let momentum = |body: &FreeBody<_, T>| {
        let spin = body.state.angular_velocity.map(T::double);
        double(&body.state.orientation) * spin.component_mul(&Vector3::from(PRINCIPAL))
    };
    let energy = |body: &FreeBody<_, T>| {
        let spin = body.state.angular_velocity.map(T::double);
        0.5 * spin.component_mul(&spin).dot(&Vector3::from(PRINCIPAL))
    };
    let (first_momentum, first_energy) = (momentum(&body), energy(&body));
    let mut drift = 0.0;
    for _ in 0..STEPS {
        body.step_rk4(step, &()).unwrap();
        drift = largest([
            drift,
            (momentum(&body) - first_momentum).norm() / first_momentum.norm(),
            (energy(&body) / first_energy - 1.0).abs(),
        ]);
    }
    below::<T>(drift, TUMBLING)
}

fn scaled<T: Real>(power: i32) -> Figure {
    let scale = T::of(2.0_f64.powi(power));
    let mut slow = FreeBody::new(brick::<T>()).with_spin(start(T::one()));
    let mut fast = FreeBody::new(brick::<T>()).with_spin(start(scale));
    let step = T::of(TURN);
    for _ in 0..STEPS {
        slow.step_rk4(step, &()).unwrap();
        fast.step_rk4(step / scale, &()).unwrap();
    }
    assert_eq!(slow.state.orientation, fast.state.orientation);
    assert_eq!(slow.state.angular_velocity * scale, fast.state.angular_velocity);
    Figure::Holds("same bits")
}

/// Squares of the spin are zero: it turns as if the body were a sphere.
fn smallest<T: Real>() -> Figure {
    let smallest = T::of(if T::SINGLE { 1e-45 } else { 5e-324 });
    let mut body = FreeBody::new(brick::<T>()).with_spin(Vector3::new(smallest, smallest, T::zero()));
    for _ in 0..100 {
        body.step_rk4(T::of(1e3), &()).unwrap();
    }
    assert_eq!(body.state.angular_velocity, Vector3::new(smallest, smallest, T::zero()));
    Figure::Holds("spin stays, same bits")
}

fn turning<T: Real>(spin: Vector3<f64>) -> Figure {
    // beside the axis, and deformed: so that what can grow does
    let beside = Vector3::new(1e-3, 2e-3, -1e-3) * spin.norm();
    let mut body = FreeBody::new(Rod).with_spin((spin + beside).map(T::of));
    body.state.modal_coordinates.as_mut_slice()[0] = T::of(1e-6);
    let limit = FlexibleBody::<T>::largest_stable_step(&Rod).unwrap().double();
    let step = T::of((0.05 * limit).min(TURN / spin.norm()));
    let planned =
        Envelope { deformation: T::one(), speed: T::one(), spin: T::of(2e6), bending: T::of(10_041.0) };
    let energy = |body: &FreeBody<Rod, T>| (body.kinetic_energy() + body.elastic_energy()).double();
    let (first, mut drift) = (energy(&body), 0.0);
    let across = spin.yz().norm();
    for _ in 0..2_000 {
        if let Err(error) = body.step_rk4(step, &()) {
            return refused(error);
        }
        drift = largest([drift, (energy(&body) / first - 1.0).abs()]);
    }
    assert_eq!(planned.departure(&body.state).bending, across > 1e4 || spin.x > 1e4, "{spin:?}");
    below::<T>(drift, VIBRATING)
}
