//! Tests of whole imports: formats against each other, defects, real exports.

mod defects;
mod element_types;
mod exports;
mod formats;
mod held;
mod hostile;
mod materials;
mod mbdyn;
mod meshes;
mod nastran;
mod one_sided;
mod sid;

use std::path::PathBuf;

use super::{ModelFiles, NodeSource, read_model};
use crate::import::ImportError;
use crate::{FeModel, SparseMatrix};

/// A folder of small files.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new(files: &[(&str, &str)]) -> Self {
        let folder = Folder(tempfile::tempdir().unwrap());
        for (name, text) in files {
            std::fs::write(folder.path(name), text).unwrap();
        }
        folder
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Text nodes `x.txt`, mass `m.mtx` and, if there is one, stiffness `k.mtx`.
    fn plain(&self) -> Result<FeModel, ImportError> {
        self.with_nodes(NodeSource::Text(self.path("x.txt")))
    }

    fn with_nodes(&self, nodes: NodeSource) -> Result<FeModel, ImportError> {
        let stiffness = Some(self.path("k.mtx")).filter(|path| path.exists());
        read_model(&ModelFiles { nodes, mass: Some(self.path("m.mtx")), stiffness })
    }
}

/// Two nodes, joined by springs of 3, 4 and 5 N/m in x, y, z; mass 2 1; 1 2 per direction.
const NODES: &str = "0 0 0\n1 0 0\n";
const MASS: [[f64; 2]; 2] = [[2.0, 1.0], [1.0, 2.0]];

fn stiffness() -> Vec<Vec<f64>> {
    let sign = |i: usize, j: usize| if i / 3 == j / 3 { 1.0 } else { -1.0 };
    let entry = |i: usize, j: usize| if i % 3 == j % 3 { sign(i, j) * (3 + i % 3) as f64 } else { 0.0 };
    (0..6).map(|i| (0..6).map(|j| entry(i, j)).collect()).collect()
}

fn dense(matrix: &SparseMatrix) -> Vec<Vec<f64>> {
    let dense = matrix.to_dense();
    (0..dense.nrows()).map(|row| (0..dense.ncols()).map(|column| dense[(row, column)]).collect()).collect()
}

/// Lower, upper or both triangles of a matrix as `row col value` lines, zeros left out.
fn list(matrix: &[Vec<f64>], keep: impl Fn(usize, usize) -> bool) -> Vec<String> {
    let mut lines = Vec::new();
    for (i, row) in matrix.iter().enumerate() {
        for (j, &value) in row.iter().enumerate() {
            if value != 0.0 && keep(i, j) {
                lines.push(format!("{} {}  {value:.15e}", i + 1, j + 1));
            }
        }
    }
    lines
}

fn full_mass() -> Vec<Vec<f64>> {
    let entry = |i: usize, j: usize| if i % 3 == j % 3 { MASS[i / 3][j / 3] } else { 0.0 };
    (0..6).map(|i| (0..6).map(|j| entry(i, j)).collect()).collect()
}

fn assert_is_the_pair(model: &FeModel) {
    assert_eq!(model.nodes.len(), 2);
    assert_eq!(model.nodes.positions, [[0.0; 3], [1.0, 0.0, 0.0]]);
    assert_eq!(dense(&model.mass), MASS);
    assert_eq!(dense(model.stiffness.as_ref().unwrap()), stiffness());
    assert_eq!(model.mass_anisotropy, 0.0);
    assert!(model.fixed_dofs.is_empty());
}

#[track_caller]
fn assert_parts(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "`{message}` lacks `{part}`");
    }
}
