//! What the page calls: plain numbers in and out, so that no memory is shared.
//!
//! `unsafe` stands here in the attributes alone that give the exported functions their names.

mod crank;
mod dropped;
mod motion;
mod rod;

use std::cell::RefCell;

pub use motion::{Choice, Motion};

/// What the page looks at.
#[derive(Default)]
struct Session {
    running: Option<Box<dyn Motion>>,
    /// Numbers of the motion as they were asked for last.
    numbers: Vec<f64>,
    /// Text that is being handed over, byte by byte.
    text: Vec<u8>,
    /// A body of the user's own.
    body: Option<ffrf_model::ReducedBody>,
    /// Why something did not go.
    message: String,
}

thread_local! {
    static SESSION: RefCell<Session> = RefCell::default();
}

fn with<R>(act: impl FnOnce(&mut Session) -> R) -> R {
    SESSION.with_borrow_mut(act)
}

/// Begins a motion: 0 the rod, 1 the slider-crank, 2 the body that was handed over; so many modes; fidelity 0 full, 1 linear; scalar
/// 0 f64, 1 f32. One if there is such a motion, else zero, and a message.
// SAFETY: no other function of this name is in the module.
#[unsafe(no_mangle)]
pub extern "C" fn begin(scene: u32, modes: u32, fidelity: u32, scalar: u32) -> u32 {
    with(|session| {
        let choice = Choice { modes: modes as usize, linear: fidelity == 1, single: scalar == 1 };
        let started = match scene {
            0 => rod::flying(choice),
            1 => crank::turning(choice),
            _ => session
                .body
                .as_ref()
                .ok_or_else(|| "no body was handed over".to_owned())
                .and_then(|body| dropped::flying(body, choice)),
        };
        let taken = match started {
            Ok(motion) => Some(motion),
            Err(message) => {
                session.message = message;
                None
            }
        };
        session.running = taken;
        u32::from(session.running.is_some())
    })
}

/// Takes so many steps; how many were taken. Fewer: one was refused, and the message says why.
// SAFETY: no other function of this name is in the module.
#[unsafe(no_mangle)]
pub extern "C" fn advance(steps: u32) -> u32 {
    with(|session| {
        let Some(motion) = &mut session.running else { return 0 };
        for taken in 0..steps {
            if let Err(message) = motion.step() {
                session.message = message;
                return taken;
            }
        }
        steps
    })
}

/// Length of a step. Units: s.
// SAFETY: no other function of this name is in the module.
#[unsafe(no_mangle)]
pub extern "C" fn step_size() -> f64 {
    with(|session| session.running.as_ref().map_or(f64::NAN, |motion| motion.step_size()))
}

/// Kinetic, elastic and potential energy together. Units: J.
// SAFETY: no other function of this name is in the module.
#[unsafe(no_mangle)]
pub extern "C" fn energy() -> f64 {
    with(|session| session.running.as_ref().map_or(f64::NAN, |motion| motion.energy()))
}

/// Looks at the motion: how many numbers there are. For each body position, orientation (x, y, z, w) and modal coordinates.
// SAFETY: no other function of this name is in the module.
#[unsafe(no_mangle)]
pub extern "C" fn look() -> u32 {
    with(|session| {
        session.numbers.clear();
        if let Some(motion) = &session.running {
            motion.look(&mut session.numbers);
        }
        session.numbers.len() as u32
    })
}

/// One of these numbers.
// SAFETY: no other function of this name is in the module.
#[unsafe(no_mangle)]
pub extern "C" fn number(place: u32) -> f64 {
    with(|session| session.numbers.get(place as usize).copied().unwrap_or(f64::NAN))
}

/// Hands over one more byte of a body (`*.ffrf.json`).
// SAFETY: no other function of this name is in the module.
#[unsafe(no_mangle)]
pub extern "C" fn push_byte(byte: u32) {
    with(|session| session.text.push(byte as u8));
}

/// Reads what was handed over: the number of modes, or -1 and a message. The next byte begins another body.
// SAFETY: no other function of this name is in the module.
#[unsafe(no_mangle)]
pub extern "C" fn read_body() -> i32 {
    with(|session| {
        let text = String::from_utf8_lossy(&std::mem::take(&mut session.text)).into_owned();
        match ffrf_model::ReducedBody::from_json(&text) {
            Ok(body) => {
                let modes = body.modes.len();
                session.body = Some(body);
                modes as i32
            }
            Err(error) => {
                session.message = chain(&error);
                -1
            }
        }
    })
}

/// Byte number `place` of the message; zero behind its end.
// SAFETY: no other function of this name is in the module.
#[unsafe(no_mangle)]
pub extern "C" fn message_byte(place: u32) -> u32 {
    with(|session| session.message.as_bytes().get(place as usize).copied().unwrap_or(0).into())
}

fn chain(error: &dyn std::error::Error) -> String {
    let mut text = error.to_string();
    let mut cause = error.source();
    while let Some(next) = cause {
        text = format!("{text}: {next}");
        cause = next.source();
    }
    text
}
