//! Ctrl-C while Rust computes without the interpreter.

use std::io;
use std::time::{Duration, Instant};

use pyo3::{PyErr, PyResult, Python};

/// How often Python is asked: soon for a person, seldom for a computation.
const INTERVAL: Duration = Duration::from_millis(50);

/// Asks Python now and then whether a signal came; only its main thread ever hears of one.
pub struct Interrupt {
    last: Instant,
    raised: Option<PyErr>,
}

impl Interrupt {
    /// From now on.
    pub fn new() -> Self {
        Self { last: Instant::now(), raised: None }
    }

    /// Asks, if it is time. Errors: a handler of Python raised; [`Self::settle`] hands over what.
    pub fn look(&mut self) -> io::Result<()> {
        if self.last.elapsed() < INTERVAL {
            return Ok(());
        }
        self.last = Instant::now();
        Python::attach(|py| py.check_signals()).map_err(|raised| {
            self.raised = Some(raised);
            io::ErrorKind::Interrupted.into()
        })
    }

    /// What came of a computation, or what a handler raised during it.
    pub fn settle<T>(self, result: PyResult<T>) -> PyResult<T> {
        match self.raised {
            Some(raised) => Err(raised),
            None => result,
        }
    }
}
