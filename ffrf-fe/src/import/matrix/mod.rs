//! From listed entries to checked symmetric matrices.

mod chunk;
pub(crate) mod definiteness;
pub(crate) mod entries;
mod large_definiteness;
pub(crate) mod line;
pub(crate) mod raw_matrix;
pub(crate) mod scalar_mass;
pub(crate) mod sparse_lines;
pub(crate) mod symmetric;
mod triangles;
