//! The other formulations that the floating frame of reference stands on, executable.
//!
//! The chain of Winkler & Gerstmayr (2018): absolute coordinates of the whole mesh (ACF, Sections 2-3)
//! → generalised component modes (GCMS, Sections 4-5) → constraints and their null space (Section 6)
//! → projection (Section 7) → floating frame (Section 8).
//! Every numbered equation that claims something checkable is a test in `tests/equations`.
//! The notation and a guide through the pages about each step: `docs/theory/README.md` of the repository.

pub mod constraints;
pub mod corotated;
mod error;
pub mod floating;
pub mod gcms;
pub mod null_space;
pub mod quadrature;
pub mod rotation;

pub use error::{ElementDefect, FormulationError};
