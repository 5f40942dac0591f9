//! Numbers as NumPy arrays: NumPy is called as Python calls it, which needs no crate for its memory.

use pyo3::prelude::*;
use pyo3::types::PyByteArray;

/// A NumPy array.
pub type Array<'py> = PyResult<Bound<'py, PyAny>>;

/// A writable array of doubles of that shape, the last index fastest. Errors: the numbers do not fill it.
pub fn array<'py>(
    py: Python<'py>,
    shape: impl IntoIterator<Item = usize>,
    values: impl IntoIterator<Item = f64>,
) -> Array<'py> {
    let bytes: Vec<u8> = values.into_iter().flat_map(f64::to_ne_bytes).collect();
    let shape: Vec<usize> = shape.into_iter().collect();
    let numpy = py.import("numpy")?;
    // `frombuffer` refuses a buffer of nothing
    if bytes.is_empty() {
        return numpy.call_method1("zeros", (shape,));
    }
    let flat = numpy.call_method1("frombuffer", (PyByteArray::new(py, &bytes), "=f8"))?;
    flat.call_method1("reshape", (shape,))
}
