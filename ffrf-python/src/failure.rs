//! Errors of the libraries as exceptions of Python, with the text of the command.

use std::path::Path;

use pyo3::PyErr;
use pyo3::exceptions::PyException;

pyo3::create_exception!(ffrf, Error, PyException, "What ffrf refuses, in the words of the command.");

/// The exception of an error and its causes.
pub fn exception(error: &anyhow::Error) -> PyErr {
    Error::new_err(ffrf_cli::report::chain(error))
}

/// The exception of an error about a file, as the command shows it.
pub fn in_file(path: &Path, error: impl Into<anyhow::Error>) -> PyErr {
    exception(&error.into().context(path.display().to_string()))
}
