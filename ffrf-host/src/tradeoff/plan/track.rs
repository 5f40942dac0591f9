//! The motion of the whole model, body by body.

use ffrf_runtime::State;
use ffrf_runtime::mechanism::Constrained;
use nalgebra::Vector3;

use super::super::{MotionLimits, Reference, Variant};
use crate::{HostBody, HostModal};

/// The motion of one body: its state at each time, its accelerations, and gravity in its frame.
pub(super) struct Track {
    pub(super) states: Vec<State<HostModal>>,
    pub(super) accelerations: Vec<ffrf_runtime::Motion<HostModal, f64>>,
    /// Units: m/s². Frame: body.
    pub(super) gravity: Vec<Vector3<f64>>,
}

/// The motion of every body; a state in which no accelerations exist is left out, of all.
pub(super) fn tracks(reference: &Reference, whole: &Variant, states: &[Vec<f64>]) -> Vec<Track> {
    let mechanism = &whole.scene.mechanism;
    let nothing = || Track { states: Vec::new(), accelerations: Vec::new(), gravity: Vec::new() };
    let mut tracks: Vec<Track> = mechanism.bodies().iter().map(|_| nothing()).collect();
    for (time, row) in reference.times.iter().zip(states) {
        let mut numbers = row.iter().copied();
        let all: Vec<State<HostModal>> = mechanism
            .bodies()
            .iter()
            .map(|body| {
                let mut state = State::at_rest(body);
                state.set_numbers(&mut numbers);
                state
            })
            .collect();
        let found = Constrained(mechanism).evaluate(*time, all.clone(), None, |ports, _| {
            ports.0.iter().map(|port| port.motion.clone()).collect::<Vec<_>>()
        });
        let Ok(accelerations) = found else { continue };
        for ((track, state), acceleration) in tracks.iter_mut().zip(all).zip(accelerations) {
            track.gravity.push(state.orientation.inverse() * mechanism.gravity());
            track.accelerations.push(acceleration);
            track.states.push(state);
        }
    }
    tracks
}

/// What the body does at most at the times that are known.
pub(super) fn limits(body: &HostBody, track: &Track) -> MotionLimits {
    let mut limits = MotionLimits::at_rest(body.mode_count());
    for ((state, acceleration), gravity) in track.states.iter().zip(&track.accelerations).zip(&track.gravity)
    {
        let sizes = |modal: &HostModal| modal.0.iter().map(|x| x.abs()).collect();
        limits.include(&MotionLimits {
            acceleration: (acceleration.linear - gravity).norm(),
            spin: state.angular_velocity.norm(),
            spin_rate: acceleration.angular.norm(),
            coordinates: sizes(&state.modal_coordinates),
            rates: sizes(&state.modal_rates),
            accelerations: sizes(&acceleration.modal),
        });
    }
    limits
}
