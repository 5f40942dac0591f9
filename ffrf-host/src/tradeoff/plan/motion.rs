//! What modes and terms do in the motion of the whole model.

use ffrf_codegen::Fidelity;
use ffrf_codegen::fidelity::EnergyTerm;
use ffrf_runtime::{Envelope, FlexibleBody, ModalMatrix, Observables, State};

use super::super::{Study, TradeoffError, Variant};
use crate::{HostBody, HostModal};

/// What a mode does in a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeUse {
    /// Name of the body.
    pub body: String,
    /// The mode, from 1.
    pub mode: usize,
    /// √(K/Θ_ff) of the mode by itself. Units: Hz.
    pub frequency: f64,
    /// The largest displacement that it gives a marker of the body. Units: m.
    pub displacement: f64,
    /// Its largest elastic energy over the largest of the body.
    pub energy_share: f64,
}

/// How large a term of the kinetic energy is in a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct TermUse {
    /// Name of the body.
    pub body: String,
    /// The term.
    pub term: EnergyTerm,
    /// Its largest size over the largest kinetic energy of the body: what the equations lose without it.
    pub share: f64,
}

/// What a plan found out about the motion that it is for.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// What each mode does.
    pub modes: Vec<ModeUse>,
    /// How large each term of the kinetic energy is.
    pub terms: Vec<TermUse>,
    /// For each flexible body its name and what a monitor on the target may hold it to: what it does in this motion, and
    /// `MARGIN` beyond.
    pub envelopes: Vec<(String, Envelope)>,
}

/// How far a motion may leave the planned one: what is dropped grows with the square, to 1.6 of what was planned for.
const MARGIN: f64 = 1.25;

/// Looks at the motion. `states`: for each time the numbers of all bodies, one after the other.
pub(super) fn look(study: &Study, whole: &Variant, states: &[Vec<f64>]) -> Result<Motion, TradeoffError> {
    let (mut modes, mut terms, mut envelopes) = (Vec::new(), Vec::new(), Vec::new());
    let mechanism = &whole.scene.mechanism;
    let mut start = 0;
    for (index, (body, name)) in mechanism.bodies().iter().zip(&whole.scene.body_names).enumerate() {
        let end = start + 13 + 2 * body.mode_count();
        let own: Vec<State<HostModal>> = states.iter().map(|row| state(body, &row[start..end])).collect();
        start = end;
        if body.mode_count() == 0 {
            continue;
        }
        let uses = mode_uses(body, name, &mechanism.markers()[index], &own);
        envelopes.push((name.clone(), envelope(&uses, &own)));
        modes.extend(uses);
        let energies =
            |body: &HostBody| -> Vec<f64> { own.iter().map(|state| kinetic(body, state)).collect() };
        let all = energies(body);
        let largest = all.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        for term in EnergyTerm::ALL.into_iter().filter(|term| !term.is_always_kept()) {
            let others = EnergyTerm::ALL.into_iter().filter(|other| *other != term);
            let without = study.body_with(index, &Fidelity::Terms(others.collect()))?;
            let size = all.iter().zip(energies(&without)).map(|(all, without)| (all - without).abs());
            terms.push(TermUse { body: name.clone(), term, share: size.fold(0.0, f64::max) / largest });
        }
    }
    Ok(Motion { modes, terms, envelopes })
}

fn envelope(modes: &[ModeUse], states: &[State<HostModal>]) -> Envelope {
    let largest = |size: fn(&State<HostModal>) -> f64| MARGIN * states.iter().map(size).fold(0.0, f64::max);
    let lowest = modes.iter().map(|mode| mode.frequency).fold(f64::INFINITY, f64::min);
    Envelope {
        deformation: largest(|state| state.modal_coordinates.0.norm()),
        speed: largest(|state| state.velocity.norm()),
        spin: largest(|state| state.angular_velocity.norm()),
        bending: std::f64::consts::TAU * lowest,
    }
}

fn state(body: &HostBody, numbers: &[f64]) -> State<HostModal> {
    let mut state = State::at_rest(body);
    state.set_numbers(&mut numbers.iter().copied());
    state
}

fn kinetic(body: &HostBody, state: &State<HostModal>) -> f64 {
    let velocity = state.body_velocity();
    body.kinetic_energy(&state.modal_coordinates, &velocity, &state.angular_velocity, &state.modal_rates)
}

fn mode_uses(
    body: &HostBody,
    name: &str,
    markers: &[ffrf_runtime::Marker<HostModal, f64>],
    states: &[State<HostModal>],
) -> Vec<ModeUse> {
    let on_diagonal = |matrix: &ModalMatrix<HostModal, f64>, mode: usize| matrix.dense()[(mode, mode)];
    let (stiffness, mass) = (body.stiffness(), body.modal_mass());
    let total = states.iter().map(|state| body.elastic_energy(&state.modal_coordinates));
    let total = total.fold(f64::MIN_POSITIVE, f64::max);
    let one = |mode: usize| {
        let amplitudes = states.iter().map(|state| state.modal_coordinates.0[mode].abs());
        let amplitude = amplitudes.fold(0.0, f64::max);
        let moved = markers
            .iter()
            .map(|marker| marker.translation.iter().map(|row| row.0[mode].powi(2)).sum::<f64>().sqrt());
        let stiffness = on_diagonal(&stiffness, mode);
        ModeUse {
            body: name.to_owned(),
            mode: mode + 1,
            frequency: (stiffness / on_diagonal(&mass, mode)).max(0.0).sqrt() / std::f64::consts::TAU,
            displacement: amplitude * moved.fold(0.0, f64::max),
            energy_share: 0.5 * stiffness * amplitude * amplitude / total,
        }
    };
    (0..body.mode_count()).map(one).collect()
}
