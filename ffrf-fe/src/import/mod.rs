//! Readers: files of FE codes to [`FeModel`](crate::FeModel).
//!
//! Stages: a file's bytes (`source`, hashed while read) -> numbers (`short` for ordinary
//! lines, `scan` for all) -> entries as listed
//! (`entries`, one reader per format) -> sorted lines (`lines`) -> symmetric sparse matrix (`symmetric`) -> checked model (`model`).
//!
//! | Source | Nodes | Matrices |
//! |---|---|---|
//! | plain | text `x y z` | Matrix Market, NumPy `.npy`/`.npz` (dense or `scipy.sparse.save_npz`), lists |
//! | Abaqus | `.inp`: `*Node`, `*Part`, `*Instance`, `*Nset`, `*Element` | `*MATRIX GENERATE`: `row col value` or `node, dof, node, dof, value` |
//! | CalculiX | `.inp` | `.sti`, `.mas`, `.dof` of `*FREQUENCY, SOLVER=MATRIXSTORAGE` |
//! | ANSYS | table `id x y z` | Matrix Market of `*SMAT`/`*DMAT` with a node mapping vector |
//!
//! The format of a matrix file is told by its first bytes, so any matrix format goes with any node source. A file
//! that is not there is looked for with `.gz` after its name.
//!
//! Boundary conditions in an export: degrees of freedom with 1e36 on the diagonal (Abaqus), or whose rows a list
//! leaves out (Abaqus, CalculiX), go to [`FeModel::fixed_dofs`](crate::FeModel::fixed_dofs); the mass of a node is
//! then taken from its free directions, and refused if there is none.
//!
//! # Current limitations
//! Three displacement degrees of freedom per node; no constraint equations (`*EQUATION`, `*TIE`, `*MPC`): their
//! matrices have fewer rows than the mesh and are refused for their size.

mod ansys;
mod calculix;
mod chunk;
mod compressed;
mod decimal;
mod deck;
mod definiteness;
mod digits;
mod entries;
mod large_definiteness;
mod lines;
mod listed_matrix;
mod mass;
mod matrix_file;
mod matrix_market;
mod mirror;
mod mode_shapes;
mod model;
mod model_files;
mod node_table;
mod npz_archive;
mod numpy;
mod provenance;
mod raw_matrix;
mod scan;
mod short;
mod source;
mod symmetric;
mod text_table;

pub use matrix_file::read_matrix;
pub use mode_shapes::{read_mode_shapes, read_square_matrix};
pub use model_files::{ModelFiles, NodeSource, read_model};
pub use provenance::source_file;

#[cfg(test)]
mod tests;
