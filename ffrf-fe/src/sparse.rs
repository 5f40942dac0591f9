//! The sparse matrix that readers fill and solvers use.

use faer::sparse::SparseColMat;

/// Compressed-column matrix in double precision; symmetric matrices store both triangles.
pub type SparseMatrix = SparseColMat<usize, f64>;
