//! One way to simulate a scene, by the names that the command uses.

use std::collections::BTreeMap;

use ffrf_cli::tradeoff::{parse_fidelity, parse_integrator, parse_scalar};
use ffrf_host::tradeoff::{Axes, Configuration as Host, Modes, SceneModes, Study};
use pyo3::prelude::*;
use pyo3::types::PyType;

use crate::failure::Error;

/// Modes, fidelity, scalar, integrator and step of a run.
#[pyclass(frozen, eq, hash, from_py_object, module = "ffrf")]
#[derive(Clone, PartialEq)]
pub struct Configuration(pub Host);

impl std::hash::Hash for Configuration {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.0.key().hash(state);
    }
}

/// The first so many modes, or a list of them from 0.
#[derive(FromPyObject, IntoPyObject)]
pub enum ModesArgument {
    First(usize),
    Listed(Vec<usize>),
}

impl From<ModesArgument> for Modes {
    fn from(given: ModesArgument) -> Self {
        match given {
            ModesArgument::First(count) => Self::first(count),
            ModesArgument::Listed(modes) => Self::listed(modes),
        }
    }
}

impl From<&Modes> for ModesArgument {
    fn from(modes: &Modes) -> Self {
        match modes.list() {
            None => Self::First(modes.count()),
            Some(list) => Self::Listed(list.to_vec()),
        }
    }
}

/// Modes of every flexible body, or of each by its name.
#[derive(FromPyObject, IntoPyObject)]
pub enum SceneModesArgument {
    Every(ModesArgument),
    Each(BTreeMap<String, ModesArgument>),
}

impl From<SceneModesArgument> for SceneModes {
    fn from(given: SceneModesArgument) -> Self {
        match given {
            SceneModesArgument::Every(modes) => Self::Every(modes.into()),
            SceneModesArgument::Each(each) => {
                Self::Each(each.into_iter().map(|(body, modes)| (body, modes.into())).collect())
            }
        }
    }
}

impl From<&SceneModes> for SceneModesArgument {
    fn from(modes: &SceneModes) -> Self {
        match modes {
            SceneModes::Every(modes) => Self::Every(modes.into()),
            SceneModes::Each(each) => {
                Self::Each(each.iter().map(|(body, modes)| (body.clone(), modes.into())).collect())
            }
        }
    }
}

/// What another process makes a configuration of.
type Parts = (SceneModesArgument, String, String, String, f64);

#[pymethods]
impl Configuration {
    #[new]
    #[pyo3(signature = (modes, fidelity, scalar, integrator, step))]
    fn new(
        modes: SceneModesArgument,
        fidelity: &str,
        scalar: &str,
        integrator: &str,
        step: f64,
    ) -> PyResult<Self> {
        Ok(Self(Host {
            modes: modes.into(),
            fidelity: parse_fidelity(fidelity).map_err(Error::new_err)?,
            scalar: parse_scalar(scalar).map_err(Error::new_err)?,
            integrator: parse_integrator(integrator).map_err(Error::new_err)?,
            step: positive(step)?,
        }))
    }

    #[getter]
    fn modes(&self) -> SceneModesArgument {
        (&self.0.modes).into()
    }

    #[getter]
    fn fidelity(&self) -> String {
        self.0.fidelity.to_string()
    }

    #[getter]
    fn scalar(&self) -> &str {
        self.0.scalar.name()
    }

    #[getter]
    fn integrator(&self) -> &str {
        self.0.integrator.name()
    }

    #[getter]
    fn step(&self) -> f64 {
        self.0.step
    }

    #[getter]
    fn key(&self) -> String {
        self.0.key()
    }

    #[getter]
    fn expected_effort(&self) -> f64 {
        self.0.expected_effort()
    }

    fn __repr__(&self) -> String {
        format!("<ffrf.Configuration {}>", self.0.key())
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyType>, Parts) {
        let one = slf.get();
        let names = (one.scalar().to_owned(), one.integrator().to_owned());
        (slf.get_type(), (one.modes(), one.fidelity(), names.0, names.1, one.step()))
    }
}

/// The grid of what is given, and of what is usual for the rest.
pub fn configurations(study: &Study, given: Given) -> PyResult<Vec<Configuration>> {
    let usual = Axes::usual(study);
    let axes = Axes {
        modes: match given.modes {
            Some(modes) => {
                let modes = modes.into_iter().map(|modes| study.canonical(modes.into()));
                modes.collect::<Result<_, _>>().map_err(|error| Error::new_err(error.to_string()))?
            }
            None => usual.modes,
        },
        fidelities: named(given.fidelity, usual.fidelities, parse_fidelity)?,
        scalars: named(given.scalar, usual.scalars, parse_scalar)?,
        integrators: named(given.integrator, usual.integrators, parse_integrator)?,
        steps: match given.step {
            Some(steps) => steps.into_iter().map(positive).collect::<PyResult<_>>()?,
            None => usual.steps,
        },
    };
    Ok(axes.configurations().into_iter().map(Configuration).collect())
}

/// The axes that a user names.
pub struct Given {
    pub modes: Option<Vec<SceneModesArgument>>,
    pub fidelity: Option<Vec<String>>,
    pub scalar: Option<Vec<String>>,
    pub integrator: Option<Vec<String>>,
    pub step: Option<Vec<f64>>,
}

/// What names name; where there are none, what is usual. Errors: a name is unknown.
pub fn named<T>(
    given: Option<Vec<String>>,
    usual: Vec<T>,
    parse: impl Fn(&str) -> Result<T, String>,
) -> PyResult<Vec<T>> {
    let Some(names) = given else { return Ok(usual) };
    names.iter().map(|name| parse(name).map_err(Error::new_err)).collect()
}

/// A step or an error that can be asked for.
pub fn positive(step: f64) -> PyResult<f64> {
    if step > 0.0 && step.is_finite() {
        Ok(step)
    } else {
        Err(Error::new_err(format!("expected a positive number, found {step}")))
    }
}
