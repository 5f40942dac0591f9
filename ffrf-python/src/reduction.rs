//! `ffrf reduce`, by the words of its command line, without writing the body.

use std::ffi::OsString;

use anyhow::Result;
use ffrf_cli::reduce::{Listener, Progress, from_words};
use pyo3::prelude::*;

use crate::body::Body;
use crate::failure::exception;

/// Keeps what a reduction has to say.
#[derive(Default)]
struct Notebook {
    report: String,
    warnings: Vec<String>,
}

impl Listener for Notebook {
    fn say(&mut self, text: &str) -> Result<()> {
        self.report.push_str(text);
        Ok(())
    }

    fn warn(&mut self, text: &str) {
        self.warnings.push(text.trim_end().to_owned());
    }

    fn progress(&mut self, _: Progress) {}
}

/// The body, the report for people, and what was taken for granted or looks odd.
#[pyfunction]
pub fn reduce_words(py: Python<'_>, words: Vec<OsString>) -> PyResult<(Body, String, Vec<String>)> {
    let mut notebook = Notebook::default();
    let body = py.detach(|| from_words(words, &mut notebook)).map_err(|error| exception(&error))?;
    Ok((Body::from(body), notebook.report, notebook.warnings))
}
