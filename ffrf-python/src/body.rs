//! Reduced bodies: what a model file holds, as arrays.

use std::path::PathBuf;

use ffrf_model::{ReducedBody, write_file};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyType};

use crate::arrays::{Array, array};
use crate::failure::{exception, in_file};

/// A flexible body, reduced to its modes.
#[pyclass(frozen, module = "ffrf")]
pub struct Body(ReducedBody);

/// A point of a body where forces act and where motion is observed.
#[pyclass(frozen, module = "ffrf")]
pub struct Marker(ffrf_model::Marker);

/// A place of a body where stress is observed.
#[pyclass(frozen, module = "ffrf")]
pub struct StressMarker(ffrf_model::StressMarker);

/// Stress stiffness of uniform and of linear loads.
type GeometricArrays<'py> = (Bound<'py, PyAny>, Bound<'py, PyAny>);

/// Reads a model file (`*.ffrf.json`) and checks it.
#[pyfunction]
pub fn load_model(py: Python<'_>, path: PathBuf) -> PyResult<Body> {
    let body = py.detach(|| ReducedBody::read(&path));
    body.map(Body::from).map_err(|error| exception(&error.into()))
}

impl From<ReducedBody> for Body {
    fn from(body: ReducedBody) -> Self {
        Self(body)
    }
}

#[pymethods]
impl Body {
    #[classmethod]
    fn from_json(_: &Bound<'_, PyType>, text: &str) -> PyResult<Self> {
        ReducedBody::from_json(text).map(Self::from).map_err(|error| exception(&error.into()))
    }

    fn to_json(&self) -> PyResult<String> {
        self.0.to_json().map_err(|error| exception(&error.into()))
    }

    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let text = self.to_json()?;
        py.detach(|| write_file(&path, text.as_bytes())).map_err(|error| in_file(&path, error))
    }

    #[getter]
    fn title(&self) -> &str {
        &self.0.title
    }

    #[getter]
    fn units(&self) -> &str {
        &self.0.units
    }

    #[getter]
    fn notes(&self) -> Vec<String> {
        self.0.provenance.notes.clone()
    }

    #[getter]
    fn mode_count(&self) -> usize {
        self.0.mode_count()
    }

    #[getter]
    fn mode_kinds(&self) -> PyResult<Vec<String>> {
        let kinds = self.0.modes.iter().map(|mode| serde_json::to_value(mode.kind));
        let names = kinds.map(|kind| kind.map(|kind| kind.as_str().unwrap_or_default().to_owned()));
        names.collect::<Result<_, _>>().map_err(|error| exception(&error.into()))
    }

    #[getter]
    fn frequencies<'py>(&self, py: Python<'py>) -> Array<'py> {
        let frequencies = self.0.modes.iter().map(|mode| mode.frequency_hz.unwrap_or(f64::NAN));
        array(py, [self.mode_count()], frequencies)
    }

    #[getter]
    fn mass(&self) -> f64 {
        self.0.inertia.mass
    }

    #[getter]
    fn first_moment<'py>(&self, py: Python<'py>) -> Array<'py> {
        array(py, [3], self.0.inertia.first_moment)
    }

    #[getter]
    fn modal_first_moment<'py>(&self, py: Python<'py>) -> Array<'py> {
        array(py, [self.mode_count(), 3], self.0.inertia.modal_first_moment.as_flattened().iter().copied())
    }

    #[getter]
    fn second_moment<'py>(&self, py: Python<'py>) -> Array<'py> {
        array(py, [3, 3], self.0.inertia.second_moment.as_flattened().iter().copied())
    }

    #[getter]
    fn position_mode_moment<'py>(&self, py: Python<'py>) -> Array<'py> {
        let values = self.0.inertia.position_mode_moment.as_flattened().as_flattened();
        array(py, [self.mode_count(), 3, 3], values.iter().copied())
    }

    #[getter]
    fn mode_mode_moment<'py>(&self, py: Python<'py>) -> Array<'py> {
        let rows = self.0.inertia.mode_mode_moment.iter();
        let values = rows.flat_map(|row| row.as_flattened().as_flattened().iter().copied());
        array(py, [self.mode_count(), self.mode_count(), 3, 3], values)
    }

    #[getter]
    fn stiffness<'py>(&self, py: Python<'py>) -> Array<'py> {
        square(py, &self.0.stiffness)
    }

    #[getter]
    fn damping<'py>(&self, py: Python<'py>) -> Array<'py> {
        square(py, &self.0.damping)
    }

    #[getter]
    fn geometric_stiffness<'py>(&self, py: Python<'py>) -> PyResult<Option<GeometricArrays<'py>>> {
        let Some(stiffness) = &self.0.geometric_stiffness else { return Ok(None) };
        let modes = self.mode_count();
        let uniform = stiffness.uniform_load.iter().flat_map(|row| row.as_flattened());
        let linear = stiffness.linear_load.iter().flat_map(|row| row.as_flattened().as_flattened());
        let uniform = array(py, [modes, modes, 3], uniform.copied())?;
        Ok(Some((uniform, array(py, [modes, modes, 3, 3], linear.copied())?)))
    }

    #[getter]
    fn markers<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let markers = PyDict::new(py);
        for marker in &self.0.markers {
            markers.set_item(&marker.name, Marker(marker.clone()))?;
        }
        Ok(markers)
    }

    #[getter]
    fn stress_markers<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let markers = PyDict::new(py);
        for marker in &self.0.stress_markers {
            markers.set_item(&marker.name, StressMarker(marker.clone()))?;
        }
        Ok(markers)
    }

    fn __repr__(&self) -> String {
        format!("<ffrf.Body {:?}: {} modes, {} kg>", self.0.title, self.mode_count(), self.mass())
    }

    /// A body goes to another process as its file.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (String,))> {
        Ok((slf.get_type().getattr("from_json")?, (slf.get().to_json()?,)))
    }
}

fn square<'py>(py: Python<'py>, rows: &[Vec<f64>]) -> Array<'py> {
    array(py, [rows.len(), rows.len()], rows.iter().flatten().copied())
}

#[pymethods]
impl Marker {
    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    #[getter]
    fn nodes(&self) -> Vec<u64> {
        self.0.nodes.clone()
    }

    #[getter]
    fn position<'py>(&self, py: Python<'py>) -> Array<'py> {
        array(py, [3], self.0.position)
    }

    #[getter]
    fn translation<'py>(&self, py: Python<'py>) -> Array<'py> {
        array(py, [self.0.translation.len(), 3], self.0.translation.as_flattened().iter().copied())
    }

    #[getter]
    fn rotation<'py>(&self, py: Python<'py>) -> Array<'py> {
        array(py, [self.0.rotation.len(), 3], self.0.rotation.as_flattened().iter().copied())
    }

    /// How an interface holds its nodes: "rigid" (RBE2) or "average" (RBE3); None for a marker that only follows them.
    #[getter]
    fn coupling(&self) -> Option<&'static str> {
        self.0.coupling.map(|coupling| match coupling {
            ffrf_model::InterfaceCoupling::Rigid => "rigid",
            ffrf_model::InterfaceCoupling::Average => "average",
        })
    }

    fn __repr__(&self) -> String {
        format!("<ffrf.Marker {} at {:?}>", self.0.name, self.0.position)
    }
}

#[pymethods]
impl StressMarker {
    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    #[getter]
    fn nodes(&self) -> Vec<u64> {
        self.0.nodes.clone()
    }

    #[getter]
    fn position<'py>(&self, py: Python<'py>) -> Array<'py> {
        array(py, [3], self.0.position)
    }

    #[getter]
    fn stress<'py>(&self, py: Python<'py>) -> Array<'py> {
        array(py, [self.0.stress.len(), 6], self.0.stress.as_flattened().iter().copied())
    }

    fn __repr__(&self) -> String {
        format!("<ffrf.StressMarker {} at {:?}>", self.0.name, self.0.position)
    }
}
