//! What modes and terms do in the motion of the whole model.

use ffrf_codegen::Fidelity;
use ffrf_runtime::{Envelope, State};

use super::super::{Modes, MotionLimits, Reference, Study, TradeoffError, Variant};
use super::modes::{ModeUse, mode_uses};
use super::statics::{Truncation, truncation};
use super::terms::{TermUse, term_uses};
use super::track::{limits, tracks};
use crate::HostModal;

/// What a plan found out about the motion that it is for.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// What each mode does.
    pub modes: Vec<ModeUse>,
    /// How large each term of the kinetic energy is.
    pub terms: Vec<TermUse>,
    /// For each flexible body its name and what it does at most, and `MARGIN` beyond: what bounds of terms are taken from.
    pub limits: Vec<(String, MotionLimits)>,
    /// For each flexible body its name and what a monitor on the target may hold it to: what it does in this motion, and
    /// `MARGIN` beyond.
    pub envelopes: Vec<(String, Envelope)>,
}

impl Motion {
    /// The modes of all bodies in the order of what they take part: of the largest elastic energy that one stores over that of its
    /// body. Modes of several bodies that have the same number go together.
    pub fn ranking(&self) -> Vec<usize> {
        let most = self.modes.iter().map(|one| one.mode).max().unwrap_or(0);
        let mut shares = vec![0.0_f64; most];
        for one in &self.modes {
            if let Some(share) = shares.get_mut(one.mode - 1) {
                *share = share.max(one.energy_share);
            }
        }
        let mut ranking: Vec<usize> = (0..most).collect();
        // the lower mode first where they are equal
        ranking.sort_by(|a, b| shares[*b].total_cmp(&shares[*a]));
        ranking
    }

    /// The terms that can contribute more than `share` of the forces in any body, and those that are always kept.
    pub fn needed_terms(&self, share: f64) -> Fidelity {
        let needed = self.terms.iter().filter(|one| one.largest_bound() > share);
        Fidelity::Terms(needed.flat_map(|one| one.terms.iter().copied()).collect())
    }
}

/// How far a motion may leave the samples of the planned one: what is dropped grows with the square, to 1.6 of what was planned
/// for.
const MARGIN: f64 = 1.25;

/// Looks at the motion. `states`: for each time the numbers of all bodies, one after the other.
pub(super) fn look(
    study: &Study,
    reference: &Reference,
    whole: &Variant,
    states: &[Vec<f64>],
) -> Result<Motion, TradeoffError> {
    let mut motion =
        Motion { modes: Vec::new(), terms: Vec::new(), limits: Vec::new(), envelopes: Vec::new() };
    let tracks = tracks(reference, whole, states);
    let bodies = whole.scene.mechanism.bodies().iter().zip(&whole.scene.body_names).zip(&tracks);
    for (index, ((body, name), track)) in bodies.enumerate() {
        if body.mode_count() == 0 {
            continue;
        }
        let model = study.model(index)?;
        let uses = mode_uses(body, &model, name, track, &reference.times);
        let limits = limits(body, track).scaled(MARGIN);
        motion.envelopes.push((name.clone(), envelope(&uses, &track.states)));
        motion.modes.extend(uses);
        motion.terms.extend(term_uses(study, index, &model, name, track, &limits)?);
        motion.limits.push((name.clone(), limits));
    }
    Ok(motion)
}

/// What a model of these modes loses by truncation in each channel, see [`Truncation`].
pub(super) fn truncations(
    reference: &Reference,
    whole: &Variant,
    states: &[Vec<f64>],
    uses: &[ModeUse],
    modes: &Modes,
) -> Vec<Truncation> {
    truncation(reference, whole, &tracks(reference, whole, states), uses, modes)
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
