//! The native half of the Python package `ffrf`: what the host libraries and the command do, on NumPy arrays.
//!
//! Nothing is computed here. `python/ffrf/_native.pyi` says what each item is in the words of Python; `docs/python.md` shows how
//! it is used. The interpreter is let go while Rust computes, and looks for Ctrl-C ([`interrupt`]).
#![forbid(unsafe_code)]

mod arrays;
mod body;
mod configuration;
mod failure;
mod interrupt;
mod outcome;
mod plan;
mod reduction;
mod simulation;
mod study;
mod sweep;

/// The module `ffrf._native`.
#[pyo3::pymodule]
mod _native {
    #[pymodule_export]
    use crate::body::{Body, Marker, StressMarker, load_model};
    #[pymodule_export]
    use crate::configuration::Configuration;
    #[pymodule_export]
    use crate::failure::Error;
    #[pymodule_export]
    use crate::outcome::Outcome;
    #[pymodule_export]
    use crate::plan::{Plan, plan};
    #[pymodule_export]
    use crate::reduction::reduce_words;
    #[pymodule_export]
    use crate::simulation::simulate;
    #[pymodule_export]
    use crate::study::Study;
    #[pymodule_export]
    use crate::sweep::Sweep;
}
