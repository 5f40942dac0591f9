//! How few modes and terms are enough: each model integrated with error control, and compared with the whole one.

use std::collections::BTreeMap;

use ffrf_codegen::Fidelity;

use super::super::reference::controlled;
use super::super::{History, Modes, Reference, Study, TradeoffError, Variant};

/// A model that was tried.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// Modes of each flexible body.
    pub modes: Modes,
    /// Terms that are kept.
    pub fidelity: Fidelity,
    /// What it lacks against all modes and terms, over the scale of the worst quantity; infinite where it cannot be run.
    pub error: f64,
}

/// A model, and its motion.
pub(super) struct Model {
    pub(super) modes: Modes,
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
    ranking: Vec<usize>,
    tried: Vec<Choice>,
    /// None of models that cannot be assembled or run.
    known: BTreeMap<(Modes, String), Option<Model>>,
}

impl<'a> Search<'a> {
    /// `needed`: the terms that are not negligible; `ranking`: the modes, those first that take part most.
    pub(super) fn new(
        study: &'a Study,
        reference: &'a Reference,
        tolerance: f64,
        needed: Fidelity,
        ranking: Vec<usize>,
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
    /// By halving, of the first so many and of those that take part most: more modes are taken to be no worse.
    pub(super) fn least(&mut self, error: f64) -> Option<(Modes, Fidelity)> {
        let first = self.fewest(0, self.study.most_modes(), error, |_, count| Modes::first(count))?;
        if first.count() == 0 {
            // without modes all fidelities are the same body
            return Some((first, Fidelity::Full));
        }
        let ranked =
            |search: &Self, count: usize| Modes::listed(search.ranking.iter().copied().take(count).collect());
        // none of these would be worth it with as many modes as of the first
        let modes = self.fewest(1, first.count() - 1, error, ranked).unwrap_or(first);
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

    /// The fewest of `low` to `high` modes that lack no more than `error` with every term.
    fn fewest(
        &mut self,
        mut low: usize,
        mut high: usize,
        error: f64,
        modes: impl Fn(&Self, usize) -> Modes,
    ) -> Option<Modes> {
        if low > high {
            return None;
        }
        while low < high {
            let middle = low.midpoint(high);
            let some = modes(self, middle);
            if self.error(&some, &self.richest.clone()) <= error {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        let found = modes(self, low);
        (self.error(&found, &self.richest.clone()) <= error).then_some(found)
    }

    /// What a model lacks; infinite where it cannot be assembled or run.
    fn error(&mut self, modes: &Modes, fidelity: &Fidelity) -> f64 {
        self.model(modes, fidelity).map_or(f64::INFINITY, |model| model.error)
    }

    /// A model with its motion; none if it cannot be assembled or run.
    pub(super) fn model(&mut self, modes: &Modes, fidelity: &Fidelity) -> Option<&Model> {
        let key = (modes.clone(), fidelity.to_string());
        if !self.known.contains_key(&key) {
            let model = self.integrate(modes, fidelity).ok();
            let error = model.as_ref().map_or(f64::INFINITY, |model| model.error);
            self.tried.push(Choice { modes: modes.clone(), fidelity: fidelity.clone(), error });
            self.known.insert(key.clone(), model);
        }
        self.known.get(&key).and_then(Option::as_ref)
    }

    fn integrate(&self, modes: &Modes, fidelity: &Fidelity) -> Result<Model, TradeoffError> {
        let variant = self.study.variant(modes, fidelity)?;
        let Reference { channels, times, history, .. } = self.reference;
        // the whole model has been integrated
        let is_whole = modes.are_all(self.study.most_modes()) && *fidelity == self.richest;
        let history = if is_whole {
            history.clone()
        } else {
            controlled(self.study, &variant, channels, times, self.tolerance)?.0
        };
        let error = self.reference.errors(&history).into_iter().fold(0.0, f64::max);
        Ok(Model { modes: modes.clone(), fidelity: fidelity.clone(), variant, error, history })
    }
}
