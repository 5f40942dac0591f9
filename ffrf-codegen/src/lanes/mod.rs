//! The strategy for many modes: the loops of `ffrf_runtime::lanes` instead of statements, over constant tables or over
//! the fields of a body whose invariants come at run time. Here is what the loops read; the text is made in `emit`.
//!
//! ```text
//! BodyExpressions (constants) --choice--> LaneTables --emit--> static items and one-line functions
//! ```

mod choice;
mod moment_tables;
mod parameters;
mod strategy;
mod table;
mod tables;

pub(crate) use choice::Lanes;
pub use choice::tables_of;
pub use moment_tables::MomentTables;
pub(crate) use parameters::LaneParameters;
pub use table::{ModalFactors, ModalMatrix, Table};
pub use tables::LaneTables;
