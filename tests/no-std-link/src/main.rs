//! Proof at link time: runtime and generated code need neither the standard library nor an allocator.
//!
//! There is no global allocator here, so a single allocation anywhere in it would not link.
//! Proof of the same kind, in the release build: no panic is reachable, see the panic handler.
//! The exit code says which check failed; 0 means that all passed.
#![no_std]
#![no_main]

mod generated;
mod mechanisms;
mod point_masses;
mod pulsating_ball;

use ffrf::nalgebra::{Matrix3, SVector, Vector1, Vector2, Vector3};
use ffrf::{
    DenseForms, FlexibleBody, Frame, FreeBody, GeneralisedForce, Gravity, Marker, MarkerLoad, Observables,
    Pair, PairSystem, PlacedMarker, RigidBody, State, Wrench, step_linearly_implicit, step_rk4,
};
use point_masses::PointMasses;
use pulsating_ball::PulsatingBall;

// The three uses of `unsafe` below are declarations, which a program without `std` cannot do without.

// SAFETY: the C library's `abort` takes nothing, returns nothing and may be called at any time. The other
// function exists nowhere: an optimised build links only if no panic is reachable from `main`.
unsafe extern "C" {
    #[cfg(debug_assertions)]
    safe fn abort() -> !;
    #[cfg(not(debug_assertions))]
    safe fn a_panic_is_reachable() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    #[cfg(debug_assertions)]
    abort();
    #[cfg(not(debug_assertions))]
    a_panic_is_reachable();
}

/// The prebuilt `core` refers to this symbol of the standard library in its unwinding tables.
///
/// Never called: panics abort.
// SAFETY: no other definition exists in a program without `std`; nothing unwinds.
#[unsafe(no_mangle)]
pub extern "C" fn rust_eh_personality() {}

/// Called by the C start code.
// SAFETY: `main` is the one symbol of this name in the program, and has the C signature.
#[unsafe(no_mangle)]
pub extern "C" fn main(_: i32, _: *const *const u8) -> i32 {
    if !flight_keeps_energy_and_momentum() {
        return 1;
    }
    if !loads_work() {
        return 2;
    }
    if !bad_steps_are_refused() {
        return 3;
    }
    if !dense_forms_agree_with_elimination() {
        return 4;
    }
    if !pairs_keep_their_momentum() {
        return 5;
    }
    if !generated::every_form_flies() {
        return 6;
    }
    if !mechanisms::they_move() {
        return 7;
    }
    0
}

fn flying() -> FreeBody<PulsatingBall> {
    FreeBody::new(PulsatingBall)
        .with_velocity(Vector3::new(1.0, 0.5, 0.0))
        .with_spin(Vector3::new(0.1, 0.2, 3.0))
        .with_deformation(Vector1::new(0.1), Vector1::zeros())
}

fn flight_keeps_energy_and_momentum() -> bool {
    let masses = FreeBody::new(PointMasses::new())
        .with_velocity(Vector3::new(1.0, 0.5, 0.0))
        .with_spin(Vector3::new(0.1, 0.2, 1.0))
        .with_deformation(Vector2::new(0.1, 0.05), Vector2::zeros());
    keeps_energy_and_momentum(flying()) && keeps_energy_and_momentum(masses)
}

fn keeps_energy_and_momentum<const M: usize, B>(mut body: FreeBody<B>) -> bool
where
    B: Observables<Modal = SVector<f64, M>>,
{
    let q = body.state.modal_coordinates;
    let energy = body.kinetic_energy() + body.elastic_energy();
    let (linear, angular) = (body.linear_momentum(), body.angular_momentum());
    for _ in 0..1_000 {
        if body.step_rk4(1e-3, &()).is_err() {
            return false;
        }
    }
    let change = body.kinetic_energy() + body.elastic_energy() - energy;
    // RK4 at h ω = 0.01: the error of the energy is some 1e-10 of it
    change.abs() < 1e-9 * energy
        && (body.linear_momentum() - linear).norm() < 1e-9
        && (body.angular_momentum() - angular).norm() < 1e-9
        && (body.state.modal_coordinates - q).amax() > 1e-3
}

fn loads_work() -> bool {
    let mut marker = Marker::rigid(Vector3::new(0.5, 0.0, 0.0), &Vector1::zeros());
    marker.translation[0].x = 1.0;
    let load = (
        Gravity { acceleration: Vector3::new(0.0, 0.0, -9.81) },
        MarkerLoad::force(marker, Vector3::new(0.0, 2.0, 0.0), Frame::Body),
    );
    let mut body = flying();
    for _ in 0..100 {
        if body.step_linearly_implicit(1e-2, &load).is_err() {
            return false;
        }
    }
    // one second of fall: second order in h is exact for a parabola
    (body.time - 1.0).abs() < 1e-9 && body.state.position.z < -3.0 && body.state.is_finite()
}

fn bad_steps_are_refused() -> bool {
    let mut body = flying();
    body.step_rk4(-1.0, &()).is_err() && body.step_rk4(f64::NAN, &()).is_err() && body.time == 0.0
}

/// The mass matrix times the accelerations, which come from an elimination, is the force that made them.
fn dense_forms_agree_with_elimination() -> bool {
    let body = PointMasses::new();
    let (q, q_dot) = (Vector2::new(0.1, -0.2), Vector2::new(0.4, 0.3));
    let omega = Vector3::new(1.0, -2.0, 0.5);
    let force = SVector::from([1.0, 2.0, 3.0, -1.0, -2.0, -3.0, 0.5, -0.5]);
    let equations = body.equations_of_motion(&q, &omega, &q_dot, &force);
    let mut residual = equations.mass_matrix * equations.acceleration + equations.quadratic_velocity - force;
    let internal = body.internal_force(&q, &q_dot);
    residual[6] += internal.x;
    residual[7] += internal.y;
    residual.amax() < 1e-9
}

type Bodies = Pair<PointMasses, RigidBody>;
type States = Pair<State<Vector2<f64>>, State<SVector<f64, 0>>>;
type Forces = Pair<GeneralisedForce<Vector2<f64>>, GeneralisedForce<SVector<f64, 0>>>;

/// A spring between a point of the first body and the origin of the second.
fn spring(bodies: &Bodies, _: f64, state: &States, forces: &mut Forces) {
    let marker = &bodies.first.0[2].1;
    let origin = Marker::rigid(Vector3::zeros(), &state.second.modal_coordinates);
    let first = PlacedMarker::new(marker, &state.first);
    let second = PlacedMarker::new(&origin, &state.second);
    let force = (second.motion(&state.second).position - first.motion(&state.first).position) * 30.0;
    let wrench = |force| Wrench { force, moment: Vector3::zeros() };
    forces.first.add_scaled(1.0, &first.generalised_force(&wrench(force)));
    forces.second.add_scaled(1.0, &second.generalised_force(&wrench(-force)));
}

fn pairs_keep_their_momentum() -> bool {
    let second = RigidBody::new(2.0, Vector3::new(0.1, 0.0, 0.0), Matrix3::identity());
    let bodies = Pair { first: PointMasses::new(), second };
    let first = FreeBody::new(bodies.first).with_spin(Vector3::new(0.1, 0.2, 1.0)).state;
    let second = FreeBody::new(second).with_position(Vector3::new(1.0, 0.5, 0.0)).state;
    let mut state = Pair { first, second };
    let momentum = |state: &States| {
        FreeBody::new(bodies.first).with_state(state.first).linear_momentum()
            + FreeBody::new(bodies.second).with_state(state.second).linear_momentum()
    };
    let start = momentum(&state);
    let system = PairSystem { bodies: &bodies, load: &spring };
    for _ in 0..200 {
        match step_rk4(&system, &state, 0.0, 1e-3) {
            Ok((next, _)) => state = next,
            Err(_) => return false,
        }
    }
    (momentum(&state) - start).norm() < 1e-9
        && state.second.velocity.norm() > 0.1
        && step_linearly_implicit(&system, &state, 0.0, 1e-3).is_ok()
}
