//! Generalised component mode synthesis: 12 + 9M modes that span every rotated deformation (Section 5).

use faer::{Mat, MatRef};

use crate::sparse::SparseMatrix;

/// The generalised component modes Φ = [Φ_t Φ_r Φ_f]. Shape: 3N x (12 + 9M). Source: (34), (35), (52)-(55).
#[derive(Debug, Clone)]
pub struct GeneralizedModes {
    /// All columns.
    pub shapes: Mat<f64>,
    /// Number of flexible modes M.
    pub mode_count: usize,
}

impl GeneralizedModes {
    /// Modes of a mesh with node `positions` and mode shapes Ψ (3N x M).
    ///
    /// Column 3 + 3 i + j moves node n by x_nⁱ along j, column 12 + 9 μ + 3 i + j by φ_μⁱ(n) along j.
    pub fn new(positions: &[[f64; 3]], mode_shapes: MatRef<'_, f64>) -> Self {
        let mode_count = mode_shapes.ncols();
        let shapes = Mat::from_fn(3 * positions.len(), 12 + 9 * mode_count, |row, column| {
            let (node, direction) = (row / 3, row % 3);
            if column % 3 != direction {
                return 0.0;
            }
            match column / 3 {
                0 => 1.0,
                group @ 1..=3 => positions[node][group - 1],
                group => mode_shapes[(3 * node + (group - 4) % 3, (group - 4) / 3)],
            }
        });
        Self { shapes, mode_count }
    }

    /// Φ_t. Shape: 3N x 3. Source: (34).
    pub fn translation(&self) -> MatRef<'_, f64> {
        self.shapes.subcols(0, 3)
    }

    /// Φ_r. Shape: 3N x 9. Source: (35).
    pub fn rotation(&self) -> MatRef<'_, f64> {
        self.shapes.subcols(3, 9)
    }

    /// Φ_f. Shape: 3N x 9M. Source: (53).
    pub fn flexible(&self) -> MatRef<'_, f64> {
        self.shapes.subcols(12, 9 * self.mode_count)
    }

    /// Φ_f,μ. Shape: 3N x 9. Source: (52).
    pub fn flexible_mode(&self, mode: usize) -> MatRef<'_, f64> {
        self.shapes.subcols(12 + 9 * mode, 9)
    }

    /// Constant reduced mass matrix M̄ = Φᵀ M Φ. Shape: (12 + 9M) square. Units: kg. Source: (56).
    pub fn reduced_mass(&self, scalar_mass: &SparseMatrix) -> Mat<f64> {
        self.shapes.transpose() * apply_mass(scalar_mass, self.shapes.as_ref())
    }

    /// Reduced stiffness K̄ = Φᵀ K Φ of the unrotated body. Shape: (12 + 9M) square. Units: N/m. Source: (57).
    pub fn reduced_stiffness(&self, stiffness: &SparseMatrix) -> Mat<f64> {
        self.shapes.transpose() * (stiffness * &self.shapes)
    }
}

/// (M_s ⊗ I3) X for columns X. Shape: 3N x c.
pub fn apply_mass(scalar_mass: &SparseMatrix, columns: MatRef<'_, f64>) -> Mat<f64> {
    let nodes = scalar_mass.nrows();
    let width = columns.ncols();
    // The three directions are three times as many columns of an N-row problem.
    let stacked =
        Mat::from_fn(nodes, 3 * width, |node, c| columns[(3 * node + c / width.max(1), c % width.max(1))]);
    let product = scalar_mass * &stacked;
    Mat::from_fn(3 * nodes, width, |row, c| product[(row / 3, (row % 3) * width + c)])
}

/// Gram matrix of the scalar fields {1, xⁱ, φ_μⁱ} with M_s: M̄ = Gram ⊗ I3, and all inertia invariants in one table.
///
/// Row 0 is the constant field, rows 1 to 3 the coordinates, rows 4 + 3 μ + i the components of the modes.
/// Shape: (4 + 3M) square. Units: kg times those of the fields. Source: (56), (108)-(132).
pub fn gram_matrix(
    positions: &[[f64; 3]],
    mode_shapes: MatRef<'_, f64>,
    scalar_mass: &SparseMatrix,
) -> Mat<f64> {
    let fields = Mat::from_fn(positions.len(), 4 + 3 * mode_shapes.ncols(), |node, field| match field {
        0 => 1.0,
        1..=3 => positions[node][field - 1],
        _ => mode_shapes[(3 * node + (field - 4) % 3, (field - 4) / 3)],
    });
    fields.transpose() * (scalar_mass * &fields)
}
