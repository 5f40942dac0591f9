//! `include/free_rod.h`.
#![allow(clippy::missing_safety_doc)] // the contract of the module above

use ffrf::FlexibleBody;
use ffrf::nalgebra::Vector3;

use super::held::{Held, NO_STATE, Status, is_rotation, numbers, object, of_step, put, status, write};
use crate::parts::{FreeRod, Rod};

/// `FREE_ROD_DOUBLES`.
pub const DOUBLES: usize = 96;
/// `FREE_ROD_STATE`: time, force (3), position (3), orientation (4), q (4), velocity (3), angular velocity (3), rates (4).
pub const STATE: usize = 4 + 21;

const MARK: u64 = u64::from_le_bytes(*b"free rod");
const _: () = assert!(Held::<FreeRod>::fits(DOUBLES));

/// What is measured, as the header has it.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sensors {
    /// Units: s.
    pub time: f64,
    /// Position of the small end. Units: m. Frame: inertial.
    pub tip: [f64; 3],
    /// Its velocity. Units: m/s. Frame: inertial.
    pub tip_velocity: [f64; 3],
    /// Units: J.
    pub kinetic_energy: f64,
    /// Units: J.
    pub elastic_energy: f64,
}

/// At rest at the origin.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn free_rod_init(memory: *mut f64, gravity: *const f64) -> Status {
    // SAFETY: the contract of the header.
    match unsafe { numbers::<3>(gravity) } {
        // SAFETY: the contract of the header.
        Ok(gravity) => unsafe { put(memory, MARK, FreeRod::new(Vector3::from(gravity))) },
        Err(status) => status,
    }
}

/// The largest step that is stable.
#[unsafe(no_mangle)]
pub extern "C" fn free_rod_largest_stable_step() -> f64 {
    FlexibleBody::<f64>::largest_stable_step(&Rod).unwrap_or(f64::INFINITY)
}

/// One explicit step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn free_rod_step(memory: *mut f64, step: f64) -> Status {
    // SAFETY: the contract of the header.
    unsafe { with(memory, |rod| rod.step(step).map_err(of_step)) }
}

/// The force at the small end.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn free_rod_set_force(memory: *mut f64, force: *const f64) -> Status {
    // SAFETY: the contract of the header.
    unsafe {
        with(memory, |rod| {
            rod.push.force = Vector3::from(numbers::<3>(force)?);
            Ok(())
        })
    }
}

/// What is measured now.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn free_rod_measure(memory: *mut f64, sensors: *mut Sensors) -> Status {
    // SAFETY: the contract of the header.
    unsafe {
        with(memory, |FreeRod { rod, .. }| {
            let tip = rod.marker_motion(&Rod::SMALL_END);
            let measured = Sensors {
                time: rod.time,
                tip: tip.position.into(),
                tip_velocity: tip.velocity.into(),
                kinetic_energy: rod.kinetic_energy(),
                elastic_energy: rod.elastic_energy(),
            };
            write(sensors, measured)
        })
    }
}

/// Every number of the state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn free_rod_save(memory: *mut f64, state: *mut f64) -> Status {
    // SAFETY: the contract of the header.
    unsafe {
        with(memory, |FreeRod { rod, push, .. }| {
            let mut saved = [0.0; STATE];
            let numbers =
                core::iter::once(rod.time).chain(push.force.iter().copied()).chain(rod.state.numbers());
            for (place, number) in saved.iter_mut().zip(numbers) {
                *place = number;
            }
            write(state.cast::<[f64; STATE]>(), saved)
        })
    }
}

/// Takes up a state again, bit by bit.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn free_rod_restore(memory: *mut f64, state: *const f64) -> Status {
    // SAFETY: the contract of the header.
    unsafe {
        with(memory, |rod| {
            let saved: [f64; STATE] = numbers(state)?;
            let ([time, x, y, z], body) = saved.split_first_chunk().ok_or(NO_STATE)?;
            if !is_rotation(&body[3..7]) {
                return Err(NO_STATE);
            }
            rod.rod.state.set_numbers(&mut body.iter().copied());
            (rod.rod.time, rod.push.force) = (*time, Vector3::new(*x, *y, *z));
            Ok(())
        })
    }
}

/// Does something with the object of C.
///
/// # Safety
/// As the functions of the header.
unsafe fn with(memory: *mut f64, act: impl FnOnce(&mut FreeRod) -> Result<(), Status>) -> Status {
    // SAFETY: the contract of the header.
    status(unsafe { object(memory, MARK) }.and_then(act))
}
