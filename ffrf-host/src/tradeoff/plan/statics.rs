//! What truncation loses in what the user asks for, and what of it is static, which one shape more would give back.

use ffrf_runtime::State;
use ffrf_runtime::mechanism::Constrained;
use nalgebra::DVector;

use super::super::channel::{Channel, Source};
use super::super::{Reference, SceneModes, Variant};
use super::modes::{ModeUse, static_parts};
use super::track::Track;
use crate::HostModal;
use crate::scene::SensorKind;
use crate::simulate::read_sensor;

/// What leaving out modes does to a channel, at the places that the whole model goes through.
#[derive(Debug, Clone, PartialEq)]
pub struct Truncation {
    /// Name of the channel.
    pub channel: String,
    /// The most that the dropped modes move it, over its scale.
    pub lost: f64,
    /// What would be left of that with the static part, load over stiffness, in the place of those that follow their load as if
    /// it were at rest.
    pub with_static_correction: f64,
}

/// Places, orientations, angles and stresses; what follows from accelerations is no matter of places.
pub(super) fn truncation(
    reference: &Reference,
    whole: &Variant,
    tracks: &[Track],
    uses: &[ModeUse],
    modes: &SceneModes,
) -> Vec<Truncation> {
    let bodies = whole.scene.mechanism.bodies().iter().zip(&whole.scene.body_names).zip(tracks);
    let statics: Vec<Vec<DVector<f64>>> = bodies
        .map(|((body, name), track)| {
            let mut parts = static_parts(body, track);
            // what vibrates is not helped by statics
            for one in uses.iter().filter(|one| one.body == *name && !one.is_quasi_static()) {
                parts.iter_mut().for_each(|part| part[one.mode - 1] = 0.0);
            }
            parts
        })
        .collect();
    let steps = tracks.first().map_or(0, |track| track.states.len());
    let mut found = Vec::new();
    for (channel, scale) in reference.channels.iter().zip(&reference.scales) {
        let (mut lost, mut left) = (0.0_f64, 0.0_f64);
        let mut is_known = true;
        for step in 0..steps {
            let state = |change: &dyn Fn(usize, usize, f64) -> f64| -> Vec<State<HostModal>> {
                let all = tracks.iter().zip(&whole.scene.body_names).enumerate();
                all.map(|(index, (track, name))| {
                    let mut state = track.states[step].clone();
                    let all = state.modal_coordinates.0.iter_mut().enumerate();
                    let dropped = all.filter(|(mode, _)| !modes.has(name, *mode));
                    dropped.for_each(|(mode, q)| *q = change(index, mode, *q));
                    state
                })
                .collect()
            };
            let read = |state| read(channel, whole, reference.times[step], state);
            let all = [
                read(state(&|_, _, q| q)),
                read(state(&|_, _, _| 0.0)),
                read(state(&|index, mode, _| statics[index][step][mode])),
            ];
            let [Some(exact), Some(without), Some(corrected)] = all else {
                is_known = false;
                break;
            };
            let distance = |other: &[f64]| {
                exact.iter().zip(other).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt() / scale
            };
            (lost, left) = (lost.max(distance(&without)), left.max(distance(&corrected)));
        }
        if is_known && steps > 0 {
            let channel = channel.name.clone();
            found.push(Truncation { channel, lost, with_static_correction: left });
        }
    }
    found
}

/// A channel of places or stresses in a state; none of another, or where no accelerations exist.
fn read(channel: &Channel, whole: &Variant, time: f64, state: Vec<State<HostModal>>) -> Option<Vec<f64>> {
    let Source::Sensor(kind) = &channel.source else { return None };
    let is_of_places = matches!(
        kind,
        SensorKind::Position(_)
            | SensorKind::Orientation(_)
            | SensorKind::Angle(_)
            | SensorKind::Stress { .. }
    );
    if !is_of_places {
        return None;
    }
    let mechanism = &whole.scene.mechanism;
    let mut values = Vec::new();
    Constrained(mechanism)
        .evaluate(time, state, None, |ports, storage| {
            read_sensor(kind, mechanism, ports, storage, &mut None, &mut values);
        })
        .ok()?;
    Some(values)
}
