//! How few modes and terms are enough: each model integrated with error control, and compared with the whole one.

use std::collections::BTreeMap;

use ffrf_codegen::Fidelity;

use super::super::reference::controlled;
use super::super::{History, Reference, Study, TradeoffError, Variant};

/// A model that was tried.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// Modes of each flexible body.
    pub modes: usize,
    /// Terms that are kept.
    pub fidelity: Fidelity,
    /// What it lacks against all modes and terms, over the scale of the worst quantity; infinite where it cannot be run.
    pub error: f64,
}

/// A model, and its motion.
pub(super) struct Model {
    pub(super) modes: usize,
    pub(super) fidelity: Fidelity,
    pub(super) variant: Variant,
    pub(super) error: f64,
    /// As exact as the reference.
    pub(super) history: History,
}

/// The levels from the cheapest; each is nested in the next.
pub(super) const LEVELS: [Fidelity; 3] = [Fidelity::Constant, Fidelity::Linear, Fidelity::Full];

/// Tries models, each once.
pub(super) struct Search<'a> {
    study: &'a Study,
    reference: &'a Reference,
    tolerance: f64,
    /// The levels, and the terms that are not negligible by their bounds where no level has just these.
    fidelities: Vec<Fidelity>,
    tried: Vec<Choice>,
    /// None of models that cannot be assembled or run.
    known: BTreeMap<(usize, String), Option<Model>>,
}

impl<'a> Search<'a> {
    /// `needed`: the terms that are not negligible.
    pub(super) fn new(study: &'a Study, reference: &'a Reference, tolerance: f64, needed: Fidelity) -> Self {
        let is_level = LEVELS.iter().any(|level| level.terms().eq(needed.terms()));
        let fidelities = LEVELS.into_iter().chain((!is_level).then_some(needed)).collect();
        Self { study, reference, tolerance, fidelities, tried: Vec::new(), known: BTreeMap::new() }
    }

    pub(super) fn tried(self) -> Vec<Choice> {
        self.tried
    }

    /// The fewest modes, then the cheapest terms, that lack no more than `error`; none if even the whole model cannot.
    ///
    /// By halving: more modes are taken to be no worse.
    pub(super) fn least(&mut self, error: f64) -> Option<(usize, Fidelity)> {
        let (mut low, mut high) = (0, self.study.most_modes());
        while low < high {
            let middle = low.midpoint(high);
            if self.error(middle, &Fidelity::Full) <= error {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        if self.error(low, &Fidelity::Full) > error {
            return None;
        }
        if low == 0 {
            return Some((0, Fidelity::Full));
        }
        let mut by_cost: Vec<(f64, Fidelity)> = Vec::new();
        for fidelity in self.fidelities.clone() {
            if let Ok(variant) = self.study.variant(low, &fidelity) {
                by_cost.push((variant.cost.operations, fidelity));
            }
        }
        by_cost.sort_by(|a, b| a.0.total_cmp(&b.0));
        by_cost.into_iter().find(|(_, level)| self.error(low, level) <= error).map(|(_, level)| (low, level))
    }

    /// What a model lacks; infinite where it cannot be assembled or run.
    fn error(&mut self, modes: usize, fidelity: &Fidelity) -> f64 {
        self.model(modes, fidelity).map_or(f64::INFINITY, |model| model.error)
    }

    /// A model with its motion; none if it cannot be assembled or run.
    pub(super) fn model(&mut self, modes: usize, fidelity: &Fidelity) -> Option<&Model> {
        let key = (modes, fidelity.to_string());
        if !self.known.contains_key(&key) {
            let model = self.integrate(modes, fidelity).ok();
            let error = model.as_ref().map_or(f64::INFINITY, |model| model.error);
            self.tried.push(Choice { modes, fidelity: fidelity.clone(), error });
            self.known.insert(key.clone(), model);
        }
        self.known.get(&key).and_then(Option::as_ref)
    }

    fn integrate(&self, modes: usize, fidelity: &Fidelity) -> Result<Model, TradeoffError> {
        let variant = self.study.variant(modes, fidelity)?;
        let Reference { channels, times, history, .. } = self.reference;
        // the whole model has been integrated
        let is_whole = modes >= self.study.most_modes() && *fidelity == Fidelity::Full;
        let history = if is_whole {
            history.clone()
        } else {
            controlled(self.study, &variant, channels, times, self.tolerance)?.0
        };
        let error = self.reference.errors(&history).into_iter().fold(0.0, f64::max);
        Ok(Model { modes, fidelity: fidelity.clone(), variant, error, history })
    }
}
