//! `ffrf plan`.

use std::path::PathBuf;

use ffrf_cli::plan::{Planned, make};
use ffrf_cli::tradeoff::{parse_integrator, parse_scalar};
use ffrf_host::tradeoff::PlanOptions;
use pyo3::prelude::*;

use crate::configuration::{Configuration, named, positive};
use crate::failure::{Error, exception};
use crate::outcome::Outcome;

/// A configuration for an error that is allowed, and what it rests on.
#[pyclass(frozen, module = "ffrf")]
pub struct Plan(Planned);

/// Plans a scene.
#[pyfunction]
#[pyo3(signature = (scene, *, error, quantity=Vec::new(), integrator=None, scalar=None, measure=false))]
pub fn plan(
    py: Python<'_>,
    scene: PathBuf,
    error: f64,
    quantity: Vec<String>,
    integrator: Option<Vec<String>>,
    scalar: Option<Vec<String>>,
    measure: bool,
) -> PyResult<Plan> {
    let usual = PlanOptions::usual(positive(error)?);
    let quantities = quantity.iter().map(|text| text.parse().map_err(Error::new_err));
    let options = PlanOptions {
        quantities: quantities.collect::<PyResult<_>>()?,
        integrators: named(integrator, usual.integrators, parse_integrator)?,
        scalars: named(scalar, usual.scalars, parse_scalar)?,
        error: usual.error,
    };
    py.detach(|| make(&scene, &options, measure)).map(Plan).map_err(|error| exception(&error))
}

#[pymethods]
impl Plan {
    #[getter]
    fn configuration(&self) -> Configuration {
        Configuration(self.0.plan.configuration.clone())
    }

    #[getter]
    fn predicted_error(&self) -> f64 {
        self.0.plan.predicted_error
    }

    #[getter]
    fn predicted_parts(&self) -> (f64, f64, f64, f64) {
        self.0.plan.parts.into()
    }

    #[getter]
    fn operations_per_step(&self) -> f64 {
        self.0.plan.operations[0]
    }

    #[getter]
    fn operations_per_second(&self) -> f64 {
        self.0.plan.operations[1]
    }

    #[getter]
    fn measured(&self) -> Option<Outcome> {
        self.0.measured.clone().map(Outcome)
    }

    #[getter]
    fn macro_calls(&self) -> &str {
        &self.0.macro_calls
    }

    fn __str__(&self) -> &str {
        &self.0.text
    }

    fn __repr__(&self) -> String {
        let plan = &self.0.plan;
        format!("<ffrf.Plan {}: predicted error {:.2e}>", plan.configuration.key(), plan.predicted_error)
    }
}
