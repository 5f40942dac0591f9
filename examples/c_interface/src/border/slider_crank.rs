//! `include/slider_crank.h`.
#![allow(clippy::missing_safety_doc)] // the contract of the module above

use ffrf::mechanism::Mechanism;

use super::held::{Held, NO_STATE, Status, is_rotation, numbers, object, of_step, put, status, write};
use crate::parts::{SliderCrank, SliderCrankState, slider_crank};

/// `SLIDER_CRANK_DOUBLES`.
pub const DOUBLES: usize = 272;
/// `SLIDER_CRANK_STATE`: time, moment of the motor, and the states of crank, rod and piston.
pub const STATE: usize = 2 + SliderCrankState::SIZE;

const MARK: u64 = u64::from_le_bytes(*b"slidercr");
const _: () = assert!(Held::<Mechanism<SliderCrank>>::fits(DOUBLES));

/// What is measured, as the header has it.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sensors {
    /// Units: s.
    pub time: f64,
    /// Position of the piston. Units: m. Frame: inertial.
    pub stroke: [f64; 3],
    /// Force of the main bearing on the crank. Units: N. Frame: inertial.
    pub bearing: [f64; 3],
    /// Angular velocity of the crank about z. Units: rad/s.
    pub speed: f64,
}

/// At rest, stretched out.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slider_crank_init(memory: *mut f64) -> Status {
    // SAFETY: the contract of the header.
    unsafe { put(memory, MARK, slider_crank()) }
}

/// One linearly implicit step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slider_crank_step(memory: *mut f64, step: f64) -> Status {
    // SAFETY: the contract of the header.
    unsafe { with(memory, |crank| crank.step_linearly_implicit(step).map(|_| ()).map_err(of_step)) }
}

/// The moment of the motor.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slider_crank_set_moment(memory: *mut f64, moment: f64) -> Status {
    // SAFETY: the contract of the header; the number is our own.
    unsafe {
        with(memory, |crank| {
            let [moment] = numbers(&raw const moment)?;
            crank.model.motor.kind.moment = moment;
            Ok(())
        })
    }
}

/// What is measured now.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slider_crank_measure(memory: *mut f64, sensors: *mut Sensors) -> Status {
    // SAFETY: the contract of the header.
    unsafe {
        with(memory, |crank| {
            let Mechanism { model, state, time } = crank;
            let measured = Sensors {
                time: *time,
                stroke: model.stroke(state).into(),
                bearing: model.bearing(*time, state).map_err(of_step)?.into(),
                speed: state.crank.angular_velocity.z,
            };
            write(sensors, measured)
        })
    }
}

/// Every number of the state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slider_crank_save(memory: *mut f64, state: *mut f64) -> Status {
    // SAFETY: the contract of the header.
    unsafe {
        with(memory, |crank| {
            let mut saved = [0.0; STATE];
            let (head, bodies) = saved.split_at_mut(2);
            head.copy_from_slice(&[crank.time, crank.model.motor.kind.moment]);
            bodies.copy_from_slice(&crank.state.to_array());
            write(state.cast::<[f64; STATE]>(), saved)
        })
    }
}

/// Takes up a state again, bit by bit.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slider_crank_restore(memory: *mut f64, state: *const f64) -> Status {
    // SAFETY: the contract of the header.
    unsafe {
        with(memory, |crank| {
            let saved: [f64; STATE] = numbers(state)?;
            let ([time, moment], bodies) = saved.split_first_chunk().ok_or(NO_STATE)?;
            let bodies = bodies.first_chunk().ok_or(NO_STATE)?;
            // crank, rod with four modes, piston: the orientation stands behind the position
            if ![3, 13 + 3, 13 + 21 + 3].iter().all(|at| is_rotation(&bodies[*at..*at + 4])) {
                return Err(NO_STATE);
            }
            crank.state = crank.model.state_from_array(bodies);
            (crank.time, crank.model.motor.kind.moment) = (*time, *moment);
            Ok(())
        })
    }
}

/// Does something with the object of C.
///
/// # Safety
/// As the functions of the header.
unsafe fn with(
    memory: *mut f64,
    act: impl FnOnce(&mut Mechanism<SliderCrank>) -> Result<(), Status>,
) -> Status {
    // SAFETY: the contract of the header.
    status(unsafe { object(memory, MARK) }.and_then(act))
}
