//! What each mode does in a motion, by what it is loaded with.

use ffrf_model::{ModeKind, ReducedBody};
use ffrf_runtime::FlexibleBody;
use nalgebra::{DVector, Matrix3, Vector3};

use super::spectrum::highest_frequency;
use super::track::Track;
use crate::{HostBody, HostModal};

/// What a mode does in a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeUse {
    /// Name of the body.
    pub body: String,
    /// The mode, from 1.
    pub mode: usize,
    /// How it was made.
    pub kind: ModeKind,
    /// √(K/Θ_ff) of the mode by itself. Units: Hz.
    pub frequency: f64,
    /// Its effective mass over that of the body, in translation and in rotation about the centre of mass: what part of these
    /// motions' inertia shakes the mode. None of both where the modes are measured in mean axes.
    pub effective_mass: [f64; 2],
    /// Below this is `MOST` of the power with which its load changes. Units: Hz.
    pub load_frequency: f64,
    /// The largest displacement that it gives a marker of the body. Units: m.
    pub displacement: f64,
    /// The same of its static part, its load over its stiffness. Units: m.
    pub static_displacement: f64,
    /// Its largest elastic energy by itself. Units: J.
    pub energy: f64,
    /// The same over the largest of the body.
    pub energy_share: f64,
}

/// A load that changes slower than this share of a mode's frequency bends it as a load at rest does, to a tenth: the answer to
/// a harmonic load is the static one over 1 - r², r the ratio of frequencies.
const QUASI_STATIC: f64 = 0.3;

impl ModeUse {
    /// Whether the mode follows its load as if that were at rest.
    pub fn is_quasi_static(&self) -> bool {
        self.load_frequency < QUASI_STATIC * self.frequency
    }
}

/// The static part of the modes at each time: K⁻¹ (K q + D q̇ + Θ_ff q̈), what the load of each instant gives if it lasts; zeros
/// where the stiffness is singular.
pub(super) fn static_parts(body: &HostBody, track: &Track) -> Vec<DVector<f64>> {
    let Some(stiffness) = body.stiffness().factor() else {
        return track.states.iter().map(|state| DVector::zeros(state.modal_coordinates.0.len())).collect();
    };
    let mass = body.modal_mass();
    let steps = track.states.iter().zip(&track.accelerations);
    steps
        .map(|(state, acceleration)| {
            let rest = mass.product(&acceleration.modal).0 + body.damping().product(&state.modal_rates).0;
            &state.modal_coordinates.0 + stiffness.solve(&HostModal(rest)).0
        })
        .collect()
}

/// What the modes of one body do. `times`: s.
pub(super) fn mode_uses(
    body: &HostBody,
    model: &ReducedBody,
    name: &str,
    track: &Track,
    times: &[f64],
) -> Vec<ModeUse> {
    let diagonal = |matrix: ffrf_runtime::ModalMatrix<HostModal, f64>| matrix.dense().diagonal();
    let (stiffness, mass) = (diagonal(body.stiffness()), diagonal(body.modal_mass()));
    let energies = track.states.iter().map(|state| elastic_energy(body, state.modal_coordinates.0.clone()));
    let total = energies.fold(f64::MIN_POSITIVE, f64::max);
    let statics = static_parts(body, track);
    let interval = match times {
        [first, .., last] => (last - first) / (times.len() - 1) as f64,
        _ => 1.0,
    };
    let one = |mode: usize| {
        let largest =
            |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |most: f64, x| most.max(x.abs()));
        let amplitude = largest(&mut track.states.iter().map(|state| state.modal_coordinates.0[mode]));
        let at_rest = largest(&mut statics.iter().map(|part| part[mode]));
        let moved = model.markers.iter().map(|marker| Vector3::from(marker.translation[mode]).norm());
        let moved = moved.fold(0.0, f64::max);
        let load: Vec<f64> = statics.iter().map(|part| part[mode]).collect();
        let energy = 0.5 * stiffness[mode] * amplitude * amplitude;
        ModeUse {
            body: name.to_owned(),
            mode: mode + 1,
            kind: model.modes[mode].kind,
            frequency: (stiffness[mode] / mass[mode]).max(0.0).sqrt() / std::f64::consts::TAU,
            effective_mass: effective_mass(model, mode, mass[mode]),
            load_frequency: highest_frequency(&load, interval),
            displacement: amplitude * moved,
            static_displacement: at_rest * moved,
            energy,
            energy_share: energy / total,
        }
    };
    (0..body.mode_count()).map(one).collect()
}

fn elastic_energy(body: &HostBody, q: DVector<f64>) -> f64 {
    let q = HostModal(q);
    0.5 * body.stiffness().product(&q).0.dot(&q.0)
}

/// |m b|²/(m Θ_ff) and ϑ·Θ⁻¹ϑ/Θ_ff, both about the centre of mass.
fn effective_mass(model: &ReducedBody, mode: usize, modal_mass: f64) -> [f64; 2] {
    let inertia = &model.inertia;
    let moment = Vector3::from(inertia.modal_first_moment[mode]);
    let centre = Vector3::from(inertia.first_moment) / inertia.mass;
    let t = inertia.position_mode_moment[mode];
    let axial = Vector3::new(t[1][2] - t[2][1], t[2][0] - t[0][2], t[0][1] - t[1][0]) - centre.cross(&moment);
    let second =
        Matrix3::from_fn(|i, j| inertia.second_moment[i][j]) - centre * centre.transpose() * inertia.mass;
    let about_centre = Matrix3::from_diagonal_element(second.trace()) - second;
    let turned = about_centre.try_inverse().map_or(0.0, |inverse| axial.dot(&(inverse * axial)));
    [moment.norm_squared() / (inertia.mass * modal_mass), turned / modal_mass]
}
