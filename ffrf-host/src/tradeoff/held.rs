//! Which terms of the kinetic energy the bodies of a scene hold: one fidelity is for all of them.

use std::collections::BTreeSet;
use std::path::Path;

use ffrf_codegen::Fidelity;
use ffrf_codegen::fidelity::EnergyTerm;
use ffrf_model::{ReducedBody, SecondOrderTerms};

use crate::scene::file::{FidelityValue, SceneFile};
use crate::scene::{Scene, SceneError, SceneModel};

/// The terms whose sum alone a body may hold.
pub(super) const TOGETHER: [EnergyTerm; 2] =
    [EnergyTerm::RotationQuadratic, EnergyTerm::CentrifugalStiffening];

/// What the flexible bodies of a scene hold.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Held {
    /// For each flexible body its name, and what it holds of second order.
    bodies: Vec<(String, SecondOrderTerms)>,
    /// Whether one of them has geometric stiffness.
    is_stiffened: bool,
}

impl Held {
    /// Of a scene in which each body has all its modes.
    pub(super) fn by(whole: &Scene) -> Self {
        let models = || {
            let all = whole.body_names.iter().zip(&whole.models);
            all.filter_map(|(name, model)| model.as_ref().map(|SceneModel { model, .. }| (name, model)))
        };
        Self {
            bodies: models().map(|(name, model)| (name.clone(), model.second_order_terms)).collect(),
            is_stiffened: models().any(|(_, model)| model.geometric_stiffness.is_some()),
        }
    }

    /// Errors: the first body that lacks a term of the fidelity.
    pub(super) fn check(&self, fidelity: &Fidelity) -> Result<(), SceneError> {
        let mut refused = self.bodies.iter().filter_map(|(name, held)| {
            let error = fidelity.check_held(*held).err()?;
            Some(SceneError::Key { key: format!("bodies.{name}.fidelity"), message: error.to_string() })
        });
        refused.next().map_or(Ok(()), Err)
    }

    /// Every term that all bodies hold: a level where one has just these.
    pub(super) fn richest(&self) -> Fidelity {
        let had = |level: &&Fidelity| self.check(level).is_ok();
        let level = Fidelity::LEVELS.iter().rev().find(had).cloned().unwrap_or(Fidelity::Rigid);
        if level == Fidelity::Full || !self.is_stiffened {
            return level;
        }
        // stress stiffness that has nothing to do with what is lacking
        let list = optional(&Fidelity::Full).filter(|term| !TOGETHER.contains(term));
        let list = Fidelity::Terms(list.collect());
        if self.check(&list).is_ok() { list } else { level }
    }

    /// The levels that all bodies have, from the cheapest, from `constant` on, each with a term more; the last one is
    /// [`richest`](Self::richest).
    pub(super) fn levels(&self) -> Vec<Fidelity> {
        let richest = self.richest();
        let between =
            [Fidelity::Constant, Fidelity::Linear, Fidelity::Unstiffened].into_iter().filter(|level| {
                // without geometric stiffness `unstiffened` is `full` by another name
                let is_another = self.is_stiffened || *level != Fidelity::Unstiffened;
                is_another && *level != richest && self.check(level).is_ok()
            });
        between.chain([richest.clone()]).collect()
    }

    /// The fidelity, with both terms of which a body holds only the sum where it keeps one of them.
    pub(super) fn completed(&self, fidelity: Fidelity) -> Fidelity {
        if self.check(&fidelity).is_ok() {
            return fidelity;
        }
        let all: BTreeSet<EnergyTerm> = optional(&fidelity).chain(TOGETHER).collect();
        let all = Fidelity::Terms(all);
        if self.check(&all).is_ok() { all } else { self.richest() }
    }
}

/// The terms of a fidelity that are not always kept.
fn optional(fidelity: &Fidelity) -> impl Iterator<Item = EnergyTerm> + '_ {
    fidelity.terms().filter(|term| !term.is_always_kept())
}

/// The scene with the richest fidelity of each body where it says none: a study varies it, so that none has to be said.
pub(super) fn with_fidelities(file: &SceneFile, folder: &Path) -> SceneFile {
    let mut copy = file.clone();
    for (_, table) in &mut copy.bodies {
        let (Some(model), None) = (&table.model, &table.fidelity) else { continue };
        // a model that cannot be read is refused when the scene is composed
        let Ok(model) = ReducedBody::read(folder.join(model)) else { continue };
        if !model.second_order_terms.is_known() {
            let richest = Fidelity::richest(model.second_order_terms);
            table.fidelity = Some(FidelityValue::Level(richest.name().to_owned()));
        }
    }
    copy
}
