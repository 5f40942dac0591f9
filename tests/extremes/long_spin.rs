//! Many steps of free spin beside the intermediate axis.

use ffrf::nalgebra::Vector3;
use ffrf::{FreeBody, State};

use crate::row;
use crate::settings::{PRINCIPAL, brick, double, largest};
use crate::table::{Figure, Real, Section, below};
use crate::tolerances::{LONG_ENERGY, LONG_MOMENTUM, UNIT_QUATERNION};

/// Of one step. Units: rad.
const TURN: f64 = 0.01;
const STEPS: usize = 100_000;
/// How often it is looked at.
const LOOKS: usize = 100;

pub fn section() -> Section {
    Section {
        title: "Free spin beside the intermediate axis",
        text: "A rigid body (1, 2, 2.5 kg m²) that turns at 1 rad/s about its intermediate axis, a thousandth beside it, flips \
               over again and again: RK4, 1e5 steps of 0.01 rad (1e7 steps, and a flexible rotor over 1e6: [benches/long_runs.md](../benches/long_runs.md)). Energy and angular momentum drift as RK4 loses them (f64) or as rounding adds up (f32); the quaternion keeps its norm, which is taken \
               anew in every step. When it flips is not predictable for longer than the growth of rounding allows: the \
               difference of a start by one unit in the last place grows by a factor of e in 3 s.",
        rows: vec![
            row!("drift of energy", energy),
            row!("drift of angular momentum", momentum),
            row!("norm of the quaternion", norm),
            row!("exactly about the intermediate axis, 1e4 steps", steady),
        ],
    }
}

struct Drifts {
    energy: f64,
    momentum: f64,
    norm: f64,
}

fn run<T: Real>() -> Drifts {
    let mut body = FreeBody::new(brick::<T>()).with_spin(Vector3::new(T::of(1e-3), T::one(), T::zero()));
    let principal = Vector3::from(PRINCIPAL);
    let momentum = |state: &State<_, T>| {
        double(&state.orientation) * state.angular_velocity.map(T::double).component_mul(&principal)
    };
    let energy = |state: &State<_, T>| {
        let spin = state.angular_velocity.map(T::double);
        spin.component_mul(&spin).dot(&principal)
    };
    let (first_momentum, first_energy) = (momentum(&body.state), energy(&body.state));
    let mut drifts = Drifts { energy: 0.0, momentum: 0.0, norm: 0.0 };
    let mut flips = 0;
    let mut side = 1.0;
    for _ in 0..LOOKS {
        for _ in 0..STEPS / LOOKS {
            body.step_rk4(T::of(TURN), &()).unwrap();
            let now = body.state.angular_velocity.y.double();
            if now * side < 0.0 {
                side = -side;
                flips += 1;
            }
        }
        drifts.energy = largest([drifts.energy, (energy(&body.state) / first_energy - 1.0).abs()]);
        drifts.momentum = largest([
            drifts.momentum,
            (momentum(&body.state) - first_momentum).norm() / first_momentum.norm(),
        ]);
        let norm = body.state.orientation.coords.map(T::double).norm();
        drifts.norm = largest([drifts.norm, (norm - 1.0).abs()]);
    }
    assert!(flips > 10, "it tumbles: {flips} flips");
    drifts
}

/// Measured once for the rows of one number type.
fn drifts<T: Real>() -> &'static Drifts {
    static DOUBLE: std::sync::OnceLock<Drifts> = std::sync::OnceLock::new();
    static SINGLE: std::sync::OnceLock<Drifts> = std::sync::OnceLock::new();
    if T::SINGLE { &SINGLE } else { &DOUBLE }.get_or_init(run::<T>)
}

fn energy<T: Real>() -> Figure {
    below::<T>(drifts::<T>().energy, LONG_ENERGY)
}

fn momentum<T: Real>() -> Figure {
    below::<T>(drifts::<T>().momentum, LONG_MOMENTUM)
}

fn norm<T: Real>() -> Figure {
    below::<T>(drifts::<T>().norm, UNIT_QUATERNION)
}

/// Without anything beside the axis there is nothing that grows: products with zero are zero.
fn steady<T: Real>() -> Figure {
    let spin = Vector3::new(T::zero(), T::one(), T::zero());
    let mut body = FreeBody::new(brick::<T>()).with_spin(spin);
    for _ in 0..10_000 {
        body.step_rk4(T::of(TURN), &()).unwrap();
    }
    assert_eq!(body.state.angular_velocity, spin);
    Figure::Holds("spin stays, same bits")
}
