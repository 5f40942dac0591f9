//! Standard input data (SID), which hold a reduced body: `text` finds the blocks of a file, `taylor` is one expansion in the modal
//! coordinates, `integrals` are inertia invariants from the matrices, `read` makes the body.

mod integrals;
mod read;
mod taylor;
mod text;

pub use read::read_sid;
