//! What a reduced flexible body *is*: plain data, its file format and its consistency checks.
//!
//! [`ReducedBody`] is the one type that crosses from the finite-element side (`ffrf-fe`)
//! to the generator (`ffrf-codegen`). It holds numbers only and knows no linear-algebra library.
#![forbid(unsafe_code)]

mod body;
mod check;
mod derived;
mod eigenvalues;
mod error;
mod file;
mod geometric_stiffness;
mod independence;
mod inertia;
mod measured;
mod mode_selection;
mod numbers;
mod output;
mod second_order_terms;
mod section_marker;
mod shape;
mod stable_step;
mod text;
mod tolerances;
mod units;

pub use body::{
    InterfaceCoupling, Marker, Mode, ModeKind, Provenance, ReducedBody, SCHEMA_VERSION, SourceFile,
    StressMarker,
};
pub use check::{CheckReport, is_valid_marker_name};
pub use error::ModelError;
pub use geometric_stiffness::{GeometricStiffness, MarkerLoadStiffness};
pub use inertia::{Inertia, Matrix3, Vector3};
pub use measured::{Check, Limit};
pub use mode_selection::ModeSelection;
pub use output::write_file;
pub use second_order_terms::SecondOrderTerms;
pub use section_marker::SectionMarker;
pub use text::printable;
pub use units::{UNKNOWN_UNITS, Units, UnitsError};
