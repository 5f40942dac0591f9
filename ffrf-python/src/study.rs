//! A scene with its reference, and runs of its configurations in any process.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use ffrf_cli::tradeoff::{Asked, Measure, Question};
use ffrf_host::tradeoff::{Quantity, SceneModes, TradeoffError, Variant, run};
use pyo3::prelude::*;
use pyo3::types::PyType;

use crate::arrays::{Array, array};
use crate::configuration::{Configuration, Given, SceneModesArgument, configurations, positive};
use crate::failure::{Error, exception, in_file};
use crate::outcome::Outcome;

/// A scene to be run in many configurations, and what their errors are taken against.
#[pyclass(frozen, module = "ffrf")]
pub struct Study {
    measure: Arc<Measure>,
    /// Scenes of so many modes and such terms, each composed when a run first asks for it.
    variants: Mutex<BTreeMap<(SceneModes, String), Arc<Variant>>>,
}

/// What another process makes the study of: scene, quantities, tolerance, reference and what it was taken of, as texts.
type Parts = (PathBuf, Vec<String>, f64, String, String);

impl Study {
    pub fn new(measure: Arc<Measure>) -> Self {
        Self { measure, variants: Mutex::default() }
    }

    fn variant(&self, Configuration(one): &Configuration) -> Result<Arc<Variant>, TradeoffError> {
        let key = (one.modes.clone(), one.fidelity.to_string());
        let mut variants = self.variants.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = variants.get(&key) {
            return Ok(Arc::clone(known));
        }
        let variant = Arc::new(self.measure.study.variant(&one.modes, &one.fidelity)?);
        variants.insert(key, Arc::clone(&variant));
        Ok(variant)
    }
}

/// What is swept, by the words of the command.
pub fn question(scene: PathBuf, quantity: &[String], reference_tolerance: f64) -> PyResult<Question> {
    let quantities = quantity.iter().map(|text| text.parse().map_err(Error::new_err));
    let quantities = quantities.collect::<PyResult<Vec<Quantity>>>()?;
    Ok(Question {
        scene,
        quantities,
        reference_tolerance: positive(reference_tolerance)?,
        reference_models: BTreeMap::new(),
    })
}

#[pymethods]
impl Study {
    #[new]
    #[pyo3(signature = (scene, *, quantity=Vec::new(), reference_tolerance=1e-10))]
    fn open(
        py: Python<'_>,
        scene: PathBuf,
        quantity: Vec<String>,
        reference_tolerance: f64,
    ) -> PyResult<Self> {
        let question = question(scene, &quantity, reference_tolerance)?;
        let measure = py.detach(|| question.measure()).map_err(|error| exception(&error))?;
        Ok(Self::new(Arc::new(measure)))
    }

    #[getter]
    fn scene(&self) -> PathBuf {
        self.measure.question.scene.clone()
    }

    #[getter]
    fn most_modes(&self) -> usize {
        self.measure.study.most_modes()
    }

    #[getter]
    fn flexible_bodies(&self) -> BTreeMap<String, usize> {
        let bodies = self.measure.study.flexible_bodies();
        bodies.into_iter().map(|(name, available)| (name.to_owned(), available)).collect()
    }

    #[getter]
    fn channels(&self) -> Vec<(String, &'static str)> {
        let channels = self.measure.reference.channels.iter();
        channels.map(|channel| (channel.name.clone(), channel.unit)).collect()
    }

    #[getter]
    fn scales<'py>(&self, py: Python<'py>) -> Array<'py> {
        let scales = &self.measure.reference.scales;
        array(py, [scales.len()], scales.iter().copied())
    }

    #[getter]
    fn own_errors<'py>(&self, py: Python<'py>) -> Array<'py> {
        let errors = &self.measure.reference.own_errors;
        array(py, [errors.len()], errors.iter().copied())
    }

    #[pyo3(signature = (*, modes=None, fidelity=None, scalar=None, integrator=None, step=None))]
    fn configurations(
        &self,
        modes: Option<Vec<SceneModesArgument>>,
        fidelity: Option<Vec<String>>,
        scalar: Option<Vec<String>>,
        integrator: Option<Vec<String>>,
        step: Option<Vec<f64>>,
    ) -> PyResult<Vec<Configuration>> {
        configurations(&self.measure.study, Given { modes, fidelity, scalar, integrator, step })
    }

    fn run(&self, py: Python<'_>, configuration: &Configuration) -> PyResult<Outcome> {
        let Measure { question, study, reference } = &*self.measure;
        let found = py.detach(|| {
            let variant = self.variant(configuration)?;
            Ok(run(study, &variant, reference, &configuration.0))
        });
        found.map(Outcome).map_err(|error: TradeoffError| in_file(&question.scene, error))
    }

    fn __repr__(&self) -> String {
        format!("<ffrf.Study of {}>", self.measure.question.scene.display())
    }

    #[classmethod]
    fn _restore(_: &Bound<'_, PyType>, py: Python<'_>, parts: Parts) -> PyResult<Self> {
        let (scene, quantity, tolerance, reference, asked) = parts;
        let question = question(scene, &quantity, tolerance)?;
        let asked: Asked = serde_json::from_str(&asked).map_err(|error| exception(&error.into()))?;
        let measure =
            py.detach(|| question.measure_with(&reference, &asked)).map_err(|error| exception(&error))?;
        Ok(Self::new(Arc::new(measure)))
    }

    /// To another process go the names of the files, the reference, and what it was taken of: other files are refused there.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (Parts,))> {
        let measure = &slf.get().measure;
        let question = &measure.question;
        let texts = || -> anyhow::Result<(String, String)> {
            let asked = question.asked(&measure.study)?;
            Ok((measure.reference_text()?, serde_json::to_string(&asked)?))
        };
        let (reference, asked) = texts().map_err(|error| exception(&error))?;
        let quantities = question.quantities.iter().map(ToString::to_string).collect();
        let parts = (question.scene.clone(), quantities, question.reference_tolerance, reference, asked);
        Ok((slf.get_type().getattr("_restore")?, (parts,)))
    }
}
