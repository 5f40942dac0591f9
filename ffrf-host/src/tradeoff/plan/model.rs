//! How few modes and terms are enough: each model integrated with error control, and compared with the whole one.

use std::collections::BTreeMap;

use ffrf_codegen::Fidelity;

use super::super::reference::controlled;
use super::super::{History, Reference, SceneModes, Study, TradeoffError, Variant};
use super::ranking::Ranking;

/// A model that was tried.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// Modes of the flexible bodies.
    pub modes: SceneModes,
    /// Terms that are kept.
    pub fidelity: Fidelity,
    /// What it lacks against all modes and terms, over the scale of the worst quantity; infinite where it cannot be run.
    pub error: f64,
}

/// A model, and its motion.
pub(super) struct Model {
    pub(super) modes: SceneModes,
    pub(super) fidelity: Fidelity,
    pub(super) variant: Variant,
    pub(super) error: f64,
    /// As exact as the reference.
    pub(super) history: History,
}

/// Tries models, each once.
pub(super) struct Search<'a> {
    study: &'a Study,
    reference: &'a Reference,
    tolerance: f64,
    /// Every term that the bodies hold.
    richest: Fidelity,
    /// The levels, and the terms that are not negligible by their bounds where no level has just these.
    fidelities: Vec<Fidelity>,
    /// The modes in the order of what they take part in the motion of the whole model.
    ranking: Ranking,
    tried: Vec<Choice>,
    /// None of models that cannot be assembled or run.
    known: BTreeMap<(SceneModes, String), Option<Model>>,
}

impl<'a> Search<'a> {
    /// `needed`: the terms that are not negligible; `ranking`: the modes, those first that take part most.
    pub(super) fn new(
        study: &'a Study,
        reference: &'a Reference,
        tolerance: f64,
        needed: Fidelity,
        ranking: Ranking,
    ) -> Self {
        let mut fidelities = study.levels();
        if !fidelities.iter().any(|level| level.terms().eq(needed.terms())) {
            fidelities.push(needed);
        }
        let (tried, known) = (Vec::new(), BTreeMap::new());
        Self { study, reference, tolerance, richest: study.richest(), fidelities, ranking, tried, known }
    }

    pub(super) fn tried(self) -> Vec<Choice> {
        self.tried
    }

    /// The fewest modes, then the cheapest terms, that lack no more than `error`; none if even the whole model cannot.
    ///
    /// By halving, of the first so many of every body and of those that take part most, whichever body's they are; of several
    /// bodies then of each by itself, in the order of what its own take part. More modes are taken to be no worse.
    pub(super) fn least(&mut self, error: f64) -> Option<(SceneModes, Fidelity)> {
        let first = self.fewest(0, self.study.most_modes(), error, |_, count| SceneModes::first(count))?;
        if first.is_rigid() {
            // without modes all fidelities are the same body
            return Some((first, Fidelity::Full));
        }
        let ranked = |search: &Self, count: usize| search.ranking.choice(count);
        // none of these would be worth it with as many modes as of the first
        let most = self.ranking.count(&first) - 1;
        let modes = self.fewest(1, most, error, ranked).unwrap_or(first);
        let modes = self.trimmed(modes, error);
        let mut by_cost: Vec<(f64, Fidelity)> = Vec::new();
        for fidelity in self.fidelities.clone() {
            if let Ok(variant) = self.study.variant(&modes, &fidelity) {
                by_cost.push((variant.cost.operations, fidelity));
            }
        }
        by_cost.sort_by(|a, b| a.0.total_cmp(&b.0));
        let enough = by_cost.into_iter().find(|(_, level)| self.error(&modes, level) <= error);
        enough.map(|(_, level)| (modes, level))
    }

    /// Fewer modes of one body after the other where that lacks no more than `error`; of a single body nothing is left to try.
    fn trimmed(&mut self, mut modes: SceneModes, error: f64) -> SceneModes {
        let bodies = self.ranking.bodies().to_vec();
        if bodies.len() < 2 {
            return modes;
        }
        for (body, available) in &bodies {
            let own = modes.of(body, *available).count();
            if own == 0 {
                continue;
            }
            let before = modes.clone();
            let fewer = |search: &Self, count: usize| search.ranking.with(&before, body, count);
            if let Some(found) = self.fewest(0, own - 1, error, fewer) {
                modes = found;
            }
        }
        modes
    }

    /// The fewest of `low` to `high` modes that lack no more than `error` with every term.
    fn fewest(
        &mut self,
        mut low: usize,
        mut high: usize,
        error: f64,
        modes: impl Fn(&Self, usize) -> SceneModes,
    ) -> Option<SceneModes> {
        if low > high {
            return None;
        }
        let richest = self.richest.clone();
        while low < high {
            let middle = low.midpoint(high);
            let some = modes(self, middle);
            if self.error(&some, &richest) <= error {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        let found = modes(self, low);
        (self.error(&found, &richest) <= error).then_some(found)
    }

    /// What a model lacks; infinite where it cannot be assembled or run.
    fn error(&mut self, modes: &SceneModes, fidelity: &Fidelity) -> f64 {
        self.model(modes, fidelity).map_or(f64::INFINITY, |model| model.error)
    }

    /// A model with its motion; none if it cannot be assembled or run.
    pub(super) fn model(&mut self, modes: &SceneModes, fidelity: &Fidelity) -> Option<&Model> {
        let key = (modes.clone(), fidelity.to_string());
        if !self.known.contains_key(&key) {
            let model = self.integrate(modes, fidelity).ok();
            let error = model.as_ref().map_or(f64::INFINITY, |model| model.error);
            self.tried.push(Choice { modes: modes.clone(), fidelity: fidelity.clone(), error });
            self.known.insert(key.clone(), model);
        }
        self.known.get(&key).and_then(Option::as_ref)
    }

    fn integrate(&self, modes: &SceneModes, fidelity: &Fidelity) -> Result<Model, TradeoffError> {
        let variant = self.study.variant(modes, fidelity)?;
        let Reference { channels, times, history, .. } = self.reference;
        // the whole model has been integrated
        let is_whole = self.ranking.has_all(modes) && *fidelity == self.richest;
        let history = if is_whole {
            history.clone()
        } else {
            controlled(self.study, &variant, channels, times, self.tolerance)?.0
        };
        let error = self.reference.errors(&history).into_iter().fold(0.0, f64::max);
        Ok(Model { modes: modes.clone(), fidelity: fidelity.clone(), variant, error, history })
    }
}
