//! Readers: files of FE codes to [`FeModel`](crate::FeModel).
//!
//! Rooms, each using those before it: `text` (bytes of a file, hashed while read, and the numbers in them), `nodes`,
//! `matrix` (entries as listed -> sorted lines -> symmetric matrix -> scalar mass, definiteness), `formats` (one
//! reader per format), `model` (the parts put together and checked).
//!
//! | Source | Nodes | Matrices |
//! |---|---|---|
//! | plain | text `x y z` | Matrix Market, NumPy `.npy`/`.npz` (dense or `scipy.sparse.save_npz`), lists |
//! | Abaqus | `.inp`: `*Node`, `*Part`, `*Instance`, `*Nset`, `*Element` | `*MATRIX GENERATE`: `row col value` or `node, dof, node, dof, value` |
//! | CalculiX | `.inp` | `.sti`, `.mas`, `.dof` of `*FREQUENCY, SOLVER=MATRIXSTORAGE` |
//! | ANSYS | table `id x y z` | Matrix Market of `*SMAT`/`*DMAT` with a node mapping vector |
//! | Nastran | deck: `GRID`, solids, `MAT1`, `SET1` | `DMIG` of a punch file, `OUTPUT4` (text, binary) |
//! | gmsh, VTK | `.msh` 4.1 and 2.2, `.vtu` | assembled of the solids, with a material for all or for each group |
//!
//! A reduced body comes from a data file of MBDyn's modal joint ([`read_mbdyn`]) or from standard input data ([`read_sid`]), which
//! [`crate::export`] writes.
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

mod error;
mod formats;
mod matrix;
mod model;
mod model_files;
mod nodes;
mod note;
mod options;
mod solids_material;
mod text;

pub use error::ImportError;
pub use formats::{read_matrix, read_mbdyn, read_mode_shapes, read_sid, read_square_matrix};
pub use model_files::{Import, ModelFiles, NodeSource, read_model, read_model_with};
pub use note::{Note, Weight};
pub use options::{INFLATED_LIMIT, ImportOptions, MassForm};
pub use solids_material::SolidsMaterial;
pub use text::source_file;

#[cfg(test)]
mod tests;
