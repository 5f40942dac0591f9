//! The strategy for many modes: constant tables for the loops of `ffrf_runtime::lanes` instead of statements.
//!
//! ```text
//! BodyExpressions (constants) --choose--> LaneTables --text--> static items and one-line functions
//! ```

mod choice;
mod compliance;
mod moment_tables;
mod table;
mod tables;
mod text;

pub(crate) use choice::choose;
pub use choice::tables_of;
pub use moment_tables::MomentTables;
pub use table::{Diagonal, Table};
pub use tables::LaneTables;
pub use text::IN_LANES;
pub(crate) use text::{functions, trait_method};
