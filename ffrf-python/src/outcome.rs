//! What came of a run.

use ffrf_cli::tradeoff::{outcome_from_json, outcome_to_json};
use ffrf_host::tradeoff::{Finding, INSTRUCTIONS_PER_OPERATION, Measured, Outcome as Host};
use pyo3::prelude::*;
use pyo3::types::PyType;

use crate::arrays::array;
use crate::configuration::Configuration;
use crate::failure::exception;

/// A configuration and what came of it.
#[pyclass(frozen, eq, from_py_object, module = "ffrf")]
#[derive(Clone, PartialEq)]
pub struct Outcome(pub Host);

impl Outcome {
    fn of<T>(&self, what: impl Fn(&Measured) -> T) -> Option<T> {
        self.0.measured().map(what)
    }
}

#[pymethods]
impl Outcome {
    #[classmethod]
    fn from_json(_: &Bound<'_, PyType>, text: &str) -> PyResult<Self> {
        outcome_from_json(text).map(Self).map_err(|error| exception(&error))
    }

    fn to_json(&self) -> PyResult<String> {
        outcome_to_json(&self.0).map_err(|error| exception(&error.into()))
    }

    #[getter]
    fn configuration(&self) -> Configuration {
        Configuration(self.0.configuration.clone())
    }

    #[getter]
    fn failure(&self) -> Option<&str> {
        match &self.0.finding {
            Finding::Failed(reason) => Some(reason),
            Finding::Finished(_) => None,
        }
    }

    #[getter]
    fn error(&self) -> Option<f64> {
        self.of(Measured::error)
    }

    #[getter]
    fn errors<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let errors = self.0.measured().map(|measured| &measured.errors);
        errors.map(|errors| array(py, [errors.len()], errors.iter().copied())).transpose()
    }

    #[getter]
    fn step(&self) -> Option<f64> {
        self.of(|measured| measured.step)
    }

    #[getter]
    fn steps(&self) -> Option<u64> {
        self.of(|measured| measured.steps)
    }

    #[getter]
    fn evaluations_per_step(&self) -> Option<f64> {
        self.of(|measured| measured.evaluations)
    }

    #[getter]
    fn time_per_second(&self) -> Option<f64> {
        self.of(|measured| measured.time)
    }

    #[getter]
    fn operations_per_step(&self) -> Option<f64> {
        self.of(Measured::operations_per_step)
    }

    #[getter]
    fn operations_per_second(&self) -> Option<f64> {
        self.of(Measured::operations_per_second)
    }

    #[getter]
    fn instructions_per_step_estimated(&self) -> Option<f64> {
        self.of(|measured| INSTRUCTIONS_PER_OPERATION * measured.operations_per_step())
    }

    #[getter]
    fn data_bytes(&self) -> Option<usize> {
        self.0.data_bytes()
    }

    #[getter]
    fn stack_bytes_estimated(&self) -> Option<usize> {
        self.0.stack_bytes()
    }

    fn __repr__(&self) -> String {
        let key = self.0.configuration.key();
        match &self.0.finding {
            Finding::Finished(measured) => format!("<ffrf.Outcome {key}: error {:.2e}>", measured.error()),
            Finding::Failed(reason) => format!("<ffrf.Outcome {key}: {}>", ffrf_model::printable(reason)),
        }
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (String,))> {
        Ok((slf.get_type().getattr("from_json")?, (slf.get().to_json()?,)))
    }
}
