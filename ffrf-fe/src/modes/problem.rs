//! The eigenproblem K φ = λ M φ on the degrees of freedom that may move.

use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use faer::{Mat, MatRef};

use crate::{FeModel, SparseMatrix};

use super::ModeError;
use super::Support;

const NOT_FREE: usize = usize::MAX;

/// The free degrees of freedom of a model, and products with its matrices restricted to them.
pub(crate) struct Problem<'a> {
    /// Positions, mass and sets.
    pub model: &'a FeModel,
    /// Stiffness of all degrees of freedom.
    pub stiffness: &'a SparseMatrix,
    /// Full number of each free degree of freedom, ascending.
    pub free: Vec<usize>,
    /// Degrees of freedom held by the support or by the export's boundary conditions, ascending.
    pub held: Vec<usize>,
    /// Degrees of freedom without mass and without stiffness: they are left out and stay at rest.
    pub loose: Vec<usize>,
    /// Number of free degrees of freedom whose node has mass: there are no more eigenpairs than that.
    pub massive: usize,
    /// Number among the free degrees of freedom, or `NOT_FREE`.
    compact: Vec<usize>,
    /// 1 to work with one thread only.
    pub threads: usize,
}

impl<'a> Problem<'a> {
    /// Sorts the degrees of freedom into free, held and loose.
    ///
    /// Errors: [`ModeError::MissingStiffness`], [`ModeError::UnknownNodeRow`], [`ModeError::NothingFree`].
    pub fn new(model: &'a FeModel, support: &Support, threads: usize) -> Result<Self, ModeError> {
        let stiffness = model.stiffness.as_ref().ok_or(ModeError::MissingStiffness)?;
        let nodes = model.nodes.len();
        let total = 3 * nodes;
        check_size("stiffness", stiffness, total)?;
        check_size("mass", &model.mass, nodes)?;
        let mut is_held = vec![false; total];
        for &dof in &model.fixed_dofs {
            *is_held.get_mut(dof).ok_or(ModeError::UnknownNodeRow { row: dof / 3, nodes })? = true;
        }
        if let Support::Clamped { nodes: rows } = support {
            if rows.is_empty() {
                return Err(ModeError::EmptyNodeSet { purpose: "the clamp".to_owned() });
            }
            for &row in rows {
                if row >= nodes {
                    return Err(ModeError::UnknownNodeRow { row, nodes });
                }
                is_held[3 * row..3 * row + 3].fill(true);
            }
        }
        let has_mass: Vec<bool> = (0..nodes).map(|node| has_entries(&model.mass, node)).collect();
        let (mut free, mut held, mut loose) = (Vec::new(), Vec::new(), Vec::new());
        for dof in 0..total {
            if is_held[dof] {
                held.push(dof);
            } else if has_mass[dof / 3] || has_entries(stiffness, dof) {
                free.push(dof);
            } else {
                loose.push(dof);
            }
        }
        if free.is_empty() {
            return Err(ModeError::NothingFree { held: held.len() });
        }
        let massive = free.iter().filter(|&&dof| has_mass[dof / 3]).count();
        let mut compact = vec![NOT_FREE; total];
        for (number, &dof) in free.iter().enumerate() {
            compact[dof] = number;
        }
        Ok(Self { model, stiffness, free, held, loose, massive, compact, threads })
    }

    /// Number of free degrees of freedom.
    pub fn dimension(&self) -> usize {
        self.free.len()
    }

    /// Rows of `full` (3N x b) that are free.
    pub fn restrict(&self, full: MatRef<'_, f64>) -> Mat<f64> {
        Mat::from_fn(self.free.len(), full.ncols(), |i, j| full[(self.free[i], j)])
    }

    /// Shapes on all 3N degrees of freedom, zero where they are not free.
    pub fn expand(&self, shapes: MatRef<'_, f64>) -> Mat<f64> {
        let mut full = Mat::zeros(self.compact.len(), shapes.ncols());
        for j in 0..shapes.ncols() {
            for (i, &dof) in self.free.iter().enumerate() {
                full[(dof, j)] = shapes[(i, j)];
            }
        }
        full
    }

    /// As [`Self::expand`], without a copy where every degree of freedom is free.
    pub fn expand_all(&self, shapes: Mat<f64>) -> Mat<f64> {
        if self.free.len() == self.compact.len() { shapes } else { self.expand(shapes.as_ref()) }
    }

    /// |K| |x|, relative to which a residual K x is round-off.
    pub fn absolute_stiffness_times(&self, shape: &[f64]) -> Vec<f64> {
        let mut result = vec![0.0; self.free.len()];
        for (k, &dof) in self.free.iter().enumerate() {
            for (row, value) in entries(self.stiffness, dof) {
                if self.compact[row] != NOT_FREE {
                    result[self.compact[row]] += (value * shape[k]).abs();
                }
            }
        }
        result
    }

    /// Lower triangle of K - σ M on the free degrees of freedom; every diagonal entry is present.
    ///
    pub fn shifted_lower(&self, shift: f64) -> Result<SparseColMat<u32, f64>, ModeError> {
        let size = self.free.len();
        let mut column_starts = Vec::with_capacity(size + 1);
        column_starts.push(0_u32);
        let capacity = self.stiffness.compute_nnz() / 2 + size;
        let mut rows: Vec<u32> = Vec::with_capacity(capacity);
        let mut values: Vec<f64> = Vec::with_capacity(capacity);
        let mut column: Vec<(u32, f64)> = Vec::new();
        for (number, &dof) in self.free.iter().enumerate() {
            column.clear();
            column.push((number as u32, 0.0));
            let stiffness = entries(self.stiffness, dof);
            let direction = dof % 3;
            let mass = entries(&self.model.mass, dof / 3)
                .map(|(node, value)| (3 * node + direction, -shift * value));
            for (row, value) in stiffness.chain(mass) {
                let row = self.compact[row];
                if row != NOT_FREE && row >= number {
                    column.push((row as u32, value));
                }
            }
            column.sort_by_key(|&(row, _)| row);
            let start = rows.len();
            for &(row, value) in &column {
                match values.last_mut() {
                    Some(last) if rows.len() > start && rows.last() == Some(&row) => *last += value,
                    _ => {
                        rows.push(row);
                        values.push(value);
                    }
                }
            }
            column_starts.push(rows.len() as u32);
        }
        let pattern = SymbolicSparseColMat::new_checked(size, size, column_starts, None, rows);
        Ok(SparseColMat::new(pattern, values))
    }

    /// Dense K and M on the free degrees of freedom.
    pub fn dense(&self) -> (Mat<f64>, Mat<f64>) {
        let size = self.free.len();
        let (mut stiffness, mut mass) = (Mat::zeros(size, size), Mat::zeros(size, size));
        for (number, &dof) in self.free.iter().enumerate() {
            for (row, value) in entries(self.stiffness, dof) {
                if self.compact[row] != NOT_FREE {
                    stiffness[(self.compact[row], number)] += value;
                }
            }
            for (node, value) in entries(&self.model.mass, dof / 3) {
                let row = self.compact[3 * node + dof % 3];
                if row != NOT_FREE {
                    mass[(row, number)] += value;
                }
            }
        }
        (stiffness, mass)
    }
}

/// M_FE X with M_FE = M_s ⊗ I3, on all 3N degrees of freedom.
pub(crate) fn mass_times_full(mass: &SparseMatrix, shapes: &Mat<f64>) -> Mat<f64> {
    let mut result = Mat::zeros(shapes.nrows(), shapes.ncols());
    for j in 0..shapes.ncols() {
        let (source, _) = shapes.col_as_slice(j).as_chunks::<3>();
        let (target, _) = result.col_as_slice_mut(j).as_chunks_mut::<3>();
        for node in 0..mass.ncols() {
            // M_s is symmetric: its column is its row.
            let mut sum = [0.0; 3];
            for (row, value) in entries(mass, node) {
                for i in 0..3 {
                    sum[i] += value * source[row][i];
                }
            }
            target[node] = sum;
        }
    }
    result
}

/// Row numbers and values of one column.
pub(crate) fn entries(matrix: &SparseMatrix, column: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
    matrix.row_idx_of_col(column).zip(matrix.val_of_col(column).iter().copied())
}

fn has_entries(matrix: &SparseMatrix, column: usize) -> bool {
    matrix.val_of_col(column).iter().any(|&value| value != 0.0)
}

fn check_size(what: &str, matrix: &SparseMatrix, expected: usize) -> Result<(), ModeError> {
    if matrix.nrows() == expected && matrix.ncols() == expected {
        return Ok(());
    }
    Err(ModeError::MatrixSize {
        what: what.to_owned(),
        expected,
        rows: matrix.nrows(),
        columns: matrix.ncols(),
    })
}
