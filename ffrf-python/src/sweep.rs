//! A sweep in its folder, as `ffrf tradeoff` has it.

use std::path::PathBuf;
use std::sync::Arc;

use ffrf_cli::tradeoff::{Sweep as Folder, cores};
use ffrf_host::tradeoff::Configuration as Host;
use pyo3::prelude::*;

use crate::configuration::Configuration;
use crate::failure::{exception, in_file};
use crate::interrupt::Interrupt;
use crate::outcome::Outcome;
use crate::study::{Study, question};

/// A folder of outcomes, where a sweep that was interrupted goes on.
#[pyclass(frozen, module = "ffrf")]
pub struct Sweep {
    folder: Folder,
    path: PathBuf,
    study: Py<Study>,
}

fn plain(configurations: &[Configuration]) -> Vec<Host> {
    configurations.iter().map(|one| one.0.clone()).collect()
}

#[pymethods]
impl Sweep {
    #[new]
    #[pyo3(signature = (scene, folder, *, quantity=Vec::new(), reference_tolerance=1e-10))]
    fn open(
        py: Python<'_>,
        scene: PathBuf,
        folder: PathBuf,
        quantity: Vec<String>,
        reference_tolerance: f64,
    ) -> PyResult<Self> {
        let question = question(scene, &quantity, reference_tolerance)?;
        let opened = py.detach(|| Folder::open(question, &folder, || ()));
        let opened = opened.map_err(|error| exception(&error))?;
        let study = Py::new(py, Study::new(Arc::clone(opened.measure())))?;
        Ok(Self { folder: opened, path: folder, study })
    }

    #[getter]
    fn study(&self, py: Python<'_>) -> Py<Study> {
        self.study.clone_ref(py)
    }

    #[getter]
    fn folder(&self) -> PathBuf {
        self.path.clone()
    }

    fn missing(&self, py: Python<'_>, configurations: Vec<Configuration>) -> PyResult<Vec<Configuration>> {
        let known = py.detach(|| self.folder.known(&plain(&configurations)));
        let known = known.map_err(|error| exception(&error))?;
        Ok(configurations.into_iter().filter(|one| !known.contains_key(&one.0.key())).collect())
    }

    #[pyo3(signature = (*outcomes))]
    fn keep(&self, py: Python<'_>, outcomes: Vec<Outcome>) -> PyResult<()> {
        let outcomes: Vec<_> = outcomes.into_iter().map(|outcome| outcome.0).collect();
        py.detach(|| self.folder.keep(&outcomes)).map_err(|error| in_file(&self.path, error))
    }

    fn outcomes(&self, py: Python<'_>, configurations: Vec<Configuration>) -> PyResult<Vec<Outcome>> {
        let known = py.detach(|| self.folder.known(&plain(&configurations)));
        let mut known = known.map_err(|error| exception(&error))?;
        Ok(configurations.iter().filter_map(|one| known.remove(&one.0.key())).map(Outcome).collect())
    }

    #[pyo3(signature = (configurations, *, threads=None))]
    fn run(
        &self,
        py: Python<'_>,
        configurations: Vec<Configuration>,
        threads: Option<usize>,
    ) -> PyResult<Vec<Outcome>> {
        let configurations = plain(&configurations);
        let mut interrupt = Interrupt::new();
        let found = py.detach(|| {
            let known = self.folder.known(&configurations)?;
            let threads = threads.unwrap_or_else(cores);
            self.folder.run(&configurations, &known, threads, &mut |_| interrupt.look())
        });
        let outcomes = interrupt.settle(found.map_err(|error| exception(&error)))?;
        Ok(outcomes.into_iter().map(Outcome).collect())
    }

    fn write(&self, py: Python<'_>, outcomes: Vec<Outcome>) -> PyResult<PathBuf> {
        let outcomes: Vec<_> = outcomes.into_iter().map(|outcome| outcome.0).collect();
        py.detach(|| self.folder.write(&outcomes)).map_err(|error| exception(&error))
    }

    fn __repr__(&self) -> String {
        format!("<ffrf.Sweep in {}>", self.path.display())
    }
}
