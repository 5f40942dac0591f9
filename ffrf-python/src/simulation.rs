//! Scenes through time: columns of numbers, as `ffrf simulate` writes them.

use std::path::PathBuf;

use ffrf_host::scene::Scene;
use ffrf_host::simulate::{SavedState, SimulationError, Summary, header, simulate as run};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::array;
use crate::failure::{Error, in_file};
use crate::interrupt::Interrupt;

/// What a simulation gives: names and columns, what happened, and the state at the end as JSON.
type Simulated<'py> = (Vec<(String, Bound<'py, PyAny>)>, Bound<'py, PyDict>, String);

/// Simulates a scene file from its initial state, or from a saved one (JSON).
#[pyfunction]
#[pyo3(signature = (scene, state=None))]
pub fn simulate<'py>(py: Python<'py>, scene: PathBuf, state: Option<&str>) -> PyResult<Simulated<'py>> {
    let saved: Option<SavedState> = state
        .map(serde_json::from_str)
        .transpose()
        .map_err(|error| Error::new_err(format!("saved state: {error}")))?;
    let mut interrupt = Interrupt::new();
    let result = py.detach(|| columns(&scene, saved.as_ref(), &mut interrupt));
    let (names, columns, summary) = interrupt.settle(result)?;
    let end = serde_json::to_string(&summary.end).map_err(|error| in_file(&scene, error))?;
    let named = names.into_iter().zip(columns);
    let arrays = named.map(|(name, column)| Ok((name, array(py, [column.len()], column)?)));
    Ok((arrays.collect::<PyResult<_>>()?, describe(py, &summary)?, end))
}

type Columns = (Vec<String>, Vec<Vec<f64>>, Summary);

fn columns(
    path: &std::path::Path,
    saved: Option<&SavedState>,
    interrupt: &mut Interrupt,
) -> PyResult<Columns> {
    let scene = Scene::read(path).map_err(|error| in_file(path, error))?;
    let names = header(&scene);
    let mut columns = vec![Vec::new(); names.len()];
    let summary = run(
        &scene,
        saved,
        |sample| {
            let row = std::iter::once(&sample.time).chain(&sample.values);
            columns.iter_mut().zip(row).for_each(|(column, value)| column.push(*value));
            interrupt.look()
        },
        |_| {},
    );
    let summary = summary.map_err(|error: SimulationError| in_file(path, error))?;
    Ok((names, columns, summary))
}

/// What the command reports, as a dictionary.
fn describe<'py>(py: Python<'py>, summary: &Summary) -> PyResult<Bound<'py, PyDict>> {
    let advance = &summary.advance;
    let about = PyDict::new(py);
    about.set_item("steps", advance.steps)?;
    about.set_item("side_steps", advance.side_steps)?;
    about.set_item("refused", advance.refused)?;
    about.set_item("iterations", advance.iterations)?;
    about.set_item("drift", (advance.drift.position, advance.drift.velocity))?;
    about.set_item("initial_residuals", summary.initial_residuals.to_vec())?;
    let events: Vec<_> = summary.events.iter().map(|event| (&event.name, event.time, event.rising)).collect();
    about.set_item("events", events)?;
    let warnings: Vec<String> = summary.spin.iter().map(ToString::to_string).collect();
    about.set_item("warnings", warnings)?;
    Ok(about)
}
