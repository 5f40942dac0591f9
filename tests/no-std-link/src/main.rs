//! Proof at link time: runtime and generated code need neither the standard library nor an allocator.
//!
//! There is no global allocator here, so a single allocation anywhere in it would not link.
//! Proof of the same kind, in the release build: no panic is reachable, see the panic handler.
//! The exit code says which check failed; 0 means that all passed.
#![no_std]
#![no_main]

mod generated;
mod pulsating_ball;

use ffrf::nalgebra::{SVector, Vector3};
use ffrf::{Frame, FreeBody, Gravity, Marker, MarkerLoad};
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
    if !generated::every_form_flies() {
        return 4;
    }
    0
}

fn flying() -> FreeBody<PulsatingBall, 1, 7> {
    FreeBody::new(PulsatingBall)
        .with_velocity(Vector3::new(1.0, 0.5, 0.0))
        .with_spin(Vector3::new(0.1, 0.2, 3.0))
        .with_deformation(SVector::<f64, 1>::new(0.1), SVector::zeros())
}

fn flight_keeps_energy_and_momentum() -> bool {
    let mut body = flying();
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
        && (body.state.modal_coordinates[0] - 0.1).abs() > 1e-3
}

fn loads_work() -> bool {
    let marker = Marker { position: [0.5, 0.0, 0.0], translation: [[1.0, 0.0, 0.0]], rotation: [[0.0; 3]] };
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
