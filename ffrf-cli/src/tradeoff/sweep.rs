//! A sweep in its folder: what it is of, its reference, what is done, and what is written of it.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use anyhow::{Context, Result};
use ffrf_host::tradeoff::{
    Configuration, Done, Outcome, Quantity, Reference, ReferenceOptions, Study, sweep,
};

use super::asked::Asked;
use super::store::Store;
use super::{report, saved, target_counts};
use crate::arguments::Core;
use crate::budget::Workshop;

/// What is swept: a scene, the quantities in which errors are taken, and the reference.
#[derive(Debug, Clone, PartialEq)]
pub struct Question {
    /// Scene file.
    pub scene: PathBuf,
    /// What errors are taken in; without any, every sensor, or the frames of all bodies.
    pub quantities: Vec<Quantity>,
    /// Relative tolerance per step of the reference.
    pub reference_tolerance: f64,
    /// Models of flexible bodies that the reference has in the place of those of the scene: paths that are absolute.
    pub reference_models: BTreeMap<String, PathBuf>,
}

/// A scene with what its errors are taken against.
pub struct Measure {
    /// What is swept.
    pub question: Question,
    /// The scene.
    pub study: Study,
    /// The reference.
    pub reference: Reference,
}

impl Question {
    /// The file, for messages.
    fn context(&self) -> String {
        self.scene.display().to_string()
    }

    /// Reads the scene. Errors: it cannot be simulated.
    pub fn study(&self) -> Result<Study> {
        Study::read(&self.scene).with_context(|| self.context())
    }

    /// What decides every number of a sweep besides the configurations. Errors: a file cannot be read.
    pub fn asked(&self, study: &Study) -> Result<Asked> {
        let Self { scene, quantities, reference_tolerance, reference_models } = self;
        Asked::of(scene, study, quantities, *reference_tolerance, reference_models)
    }

    /// The scene with the models of the reference, if it has others. Errors: see [`Study::with_models`].
    fn richer(&self, study: &Study) -> Result<Option<Study>> {
        if self.reference_models.is_empty() {
            return Ok(None);
        }
        study.with_models(&self.reference_models).with_context(|| self.context()).map(Some)
    }

    fn compute(&self, study: &Study) -> Result<Reference> {
        let options = ReferenceOptions { tolerance: self.reference_tolerance };
        Reference::compute(study, &self.quantities, options).with_context(|| self.context())
    }

    /// Reads the scene and computes the reference. Errors: the scene, or a quantity that it does not have.
    pub fn measure(self) -> Result<Measure> {
        let study = self.study()?;
        let richer = self.richer(&study)?;
        let reference = self.compute(richer.as_ref().unwrap_or(&study))?;
        Ok(Measure { question: self, study, reference })
    }

    /// Reads the scene and a reference that was computed of it elsewhere, as [`Measure::reference_text`] has it.
    ///
    /// Errors: besides those of the scene, it is not what `asked` was taken of: another scene, model or version.
    pub fn measure_with(self, reference: &str, asked: &Asked) -> Result<Measure> {
        let study = self.study()?;
        if let Some(what) = self.asked(&study)?.difference(asked) {
            anyhow::bail!("{}: the reference is of {what}", self.context());
        }
        let channels = study.channels(&self.quantities).with_context(|| self.context())?;
        let reference = saved::reference_from_json(reference, channels)?;
        Ok(Measure { question: self, study, reference })
    }
}

impl Measure {
    /// The reference as text, to its last bit.
    pub fn reference_text(&self) -> Result<String> {
        saved::reference_to_json(&self.reference)
    }
}

/// A sweep in its folder, where one that was interrupted goes on.
pub struct Sweep {
    measure: Arc<Measure>,
    store: Store,
    folder: PathBuf,
}

impl Sweep {
    /// Opens the folder or makes it. The reference is read from it, or else computed (`computing` is called before) and kept.
    ///
    /// Errors: the scene, a quantity that it does not have, a folder that holds something else.
    pub fn open(question: Question, folder: &Path, computing: impl FnOnce()) -> Result<Self> {
        let study = question.study()?;
        Self::of(study, question, folder, computing)
    }

    /// The same of a scene that has been read.
    pub fn of(study: Study, question: Question, folder: &Path, computing: impl FnOnce()) -> Result<Self> {
        let channels = study.channels(&question.quantities).with_context(|| question.context())?;
        let richer = question.richer(&study)?;
        let store = Store::open(folder, &question.asked(&study)?)?;
        let reference = match store.reference(channels)? {
            Some(reference) => reference,
            None => {
                computing();
                let reference = question.compute(richer.as_ref().unwrap_or(&study))?;
                store.keep_reference(&reference)?;
                reference
            }
        };
        let measure = Arc::new(Measure { question, study, reference });
        Ok(Self { measure, store, folder: folder.to_owned() })
    }

    /// The scene and the reference.
    pub fn measure(&self) -> &Arc<Measure> {
        &self.measure
    }

    /// The outcomes that are there, of these configurations, by their keys.
    pub fn known(&self, configurations: &[Configuration]) -> Result<BTreeMap<String, Outcome>> {
        self.store.outcomes(configurations)
    }

    /// Keeps outcomes, all in one file that is whole or not there.
    pub fn keep(&self, outcomes: &[Outcome]) -> io::Result<()> {
        self.store.keep(outcomes)
    }

    /// Runs what is not in `known` on so many threads, keeps it, and gives all outcomes in the order of the configurations.
    ///
    /// Errors: what cannot be composed or kept, and what `told` says, which is called whenever some are kept.
    pub fn run(
        &self,
        configurations: &[Configuration],
        known: &BTreeMap<String, Outcome>,
        threads: usize,
        told: &mut dyn FnMut(Done) -> io::Result<()>,
    ) -> Result<Vec<Outcome>> {
        let Measure { question, study, reference } = &*self.measure;
        let outcomes = sweep(study, reference, configurations, known, threads, &mut |outcomes, done| {
            self.store.keep(outcomes)?;
            told(done)
        });
        outcomes.with_context(|| question.context())
    }

    /// Counts on a core what a step of these configurations takes, where it is not counted yet. `told`: how many programs are
    /// done, of how many.
    ///
    /// Errors: see [`target_counts::count`].
    pub(crate) fn count(
        &self,
        outcomes: &[Outcome],
        core: Core,
        workshop: &Workshop,
        told: &mut dyn FnMut(usize, usize),
    ) -> Result<()> {
        let counts = self.store.target_counts()?;
        let mut keep = |counts: &_| self.store.keep_target_counts(counts);
        target_counts::count(&self.measure.study, outcomes, (core, workshop), counts, &mut keep, told)
    }

    /// Writes tables, pictures and the page, which it gives the name of.
    pub fn write(&self, outcomes: &[Outcome]) -> Result<PathBuf> {
        let scene = &self.measure.question.scene;
        let title = scene.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        let counts = self.store.target_counts()?;
        report::write_all(&self.folder, &title, &self.measure.reference, outcomes, &counts)?;
        Ok(self.folder.join(report::PAGE))
    }
}
