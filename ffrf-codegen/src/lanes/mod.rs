//! The strategy for many modes: the loops of `ffrf_runtime::lanes` instead of statements, over constant tables or over
//! the fields of a body whose invariants come at run time.
//!
//! ```text
//! BodyExpressions (constants) --choose--> LaneTables --text--> static items and one-line functions
//! ```

mod choice;
mod kernels_text;
mod moment_tables;
mod parameters;
mod table;
mod tables;
mod text;

pub(crate) use choice::choose;
pub use choice::tables_of;
pub use moment_tables::MomentTables;
pub(crate) use parameters::{LaneParameters, choose_parameters};
pub use table::{ModalFactors, ModalMatrix, Table};
pub use tables::LaneTables;
pub use text::IN_LANES;
pub(crate) use text::{functions, trait_method};
