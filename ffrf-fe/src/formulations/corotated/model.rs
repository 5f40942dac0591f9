//! The constant data of a co-rotated body.

use faer::sparse::Triplet;
use faer::{Mat, MatRef};

use super::Frame;
use crate::formulations::FormulationError;
use crate::formulations::gcms::{apply_mass, gram_matrix};
use crate::{FeModel, SparseMatrix};

/// A body in coordinates that come in triples: nodal positions (ACF) or generalised modes (GCMS).
#[derive(Debug, Clone)]
pub struct CorotatedModel {
    /// Coordinates of the undeformed body at the origin. Shape: 3N. Units: m for nodes, 1 for directors.
    pub reference: Mat<f64>,
    /// Scalar mass matrix M_s with M = M_s ⊗ I3. Shape: N x N.
    pub scalar_mass: SparseMatrix,
    /// Stiffness K of the unrotated body. Shape: 3N x 3N.
    pub stiffness: SparseMatrix,
    /// What a unit translation does to each triple: ones for nodes, [1, 0, 0, ...] for generalised modes. Shape: N.
    pub translation: Vec<f64>,
    /// Whether the small term f_nl of (12), (61) is part of the force. Without it the force is no gradient.
    pub nonlinear_term: bool,
}

impl CorotatedModel {
    /// The whole mesh, coordinates are nodal positions. Source: (3), (12).
    ///
    /// Errors: [`FormulationError::MissingStiffness`].
    pub fn absolute(model: &FeModel) -> Result<Self, FormulationError> {
        let stiffness = model.stiffness.clone().ok_or(FormulationError::MissingStiffness)?;
        let positions = &model.nodes.positions;
        Ok(Self {
            reference: Mat::from_fn(3 * positions.len(), 1, |row, _| positions[row / 3][row % 3]),
            scalar_mass: model.mass.clone(),
            stiffness,
            translation: vec![1.0; positions.len()],
            nonlinear_term: true,
        })
    }

    /// The generalised component modes of a mesh: 4 + 3M triples, one for translation, three directors, and the
    /// nine coordinates of each mode. Source: (56), (57), (59).
    ///
    /// M̄ = Φᵀ M Φ is Gram ⊗ I3, where Gram is that of the scalar fields {1, xⁱ, φ_μⁱ}.
    /// Errors: [`FormulationError`] for a missing stiffness or mode shapes of another size.
    pub fn generalized(model: &FeModel, mode_shapes: MatRef<'_, f64>) -> Result<Self, FormulationError> {
        let stiffness = model.stiffness.as_ref().ok_or(FormulationError::MissingStiffness)?;
        let positions = &model.nodes.positions;
        if mode_shapes.nrows() != 3 * positions.len() {
            let (expected, found) = (3 * positions.len(), mode_shapes.nrows());
            return Err(FormulationError::Size { what: "the matrix of mode shapes", expected, found });
        }
        let modes = crate::formulations::gcms::GeneralizedModes::new(positions, mode_shapes);
        let triples = 4 + 3 * modes.mode_count;
        let gram = gram_matrix(positions, mode_shapes, &model.mass);
        let mut translation = vec![0.0; triples];
        translation[0] = 1.0;
        Ok(Self {
            // d_i = e_i: row 3 + 3 i + i.
            reference: Mat::from_fn(3 * triples, 1, |row, _| {
                if (3..12).contains(&row) && (row - 3).is_multiple_of(4) { 1.0 } else { 0.0 }
            }),
            scalar_mass: dense_as_sparse(&gram)?,
            stiffness: dense_as_sparse(&modes.reduced_stiffness(stiffness))?,
            translation,
            nonlinear_term: true,
        })
    }

    /// Number of triples N.
    pub fn triples(&self) -> usize {
        self.translation.len()
    }

    /// Mass and reference centre of mass.
    pub fn centre_of_mass(&self) -> (f64, [f64; 3]) {
        let weighted = self.mass_times(self.translations().as_ref());
        let mass = (self.translations().transpose() * &weighted)[(0, 0)];
        let moment = weighted.transpose() * &self.reference;
        (mass, [0, 1, 2].map(|i| moment[(i, 0)] / mass))
    }

    /// Constant mass matrix times columns. Shape: 3N x c.
    pub fn mass_times(&self, columns: MatRef<'_, f64>) -> Mat<f64> {
        apply_mass(&self.scalar_mass, columns)
    }

    /// Unit translations, Φ_t. Shape: 3N x 3.
    pub fn translations(&self) -> Mat<f64> {
        Mat::from_fn(
            3 * self.triples(),
            3,
            |row, i| if row % 3 == i { self.translation[row / 3] } else { 0.0 },
        )
    }

    /// Frame by the polar decomposition of the mass-weighted mean deformation F = Σ M_nk r_n (x_k - c)ᵀ.
    ///
    /// This is the mean-axis frame: displacements relative to it have no linearised angular momentum, so that it
    /// agrees with the frame of free-free modes.
    pub fn mean_frame(&self) -> Frame {
        let (_, centre) = self.centre_of_mass();
        let centred = Mat::from_fn(3 * self.triples(), 1, |row, _| {
            self.reference[(row, 0)] - self.translation[row / 3] * centre[row % 3]
        });
        let weighted = self.mass_times(centred.as_ref());
        let weights = (0..self.triples()).map(|n| [0, 1, 2].map(|i| weighted[(3 * n + i, 0)])).collect();
        Frame::MeanRotation { weights }
    }

    /// Frame by orthogonalising I + Q_rᵀ = [d_1 d_2 d_3]; generalised modes only. Source: (60).
    pub fn director_frame(&self) -> Frame {
        let mut weights = vec![[0.0; 3]; self.triples()];
        for i in 0..3.min(self.triples().saturating_sub(1)) {
            weights[1 + i][i] = 1.0;
        }
        Frame::MeanRotation { weights }
    }

    /// The undeformed body turned by `rotation` and moved by `translation`.
    pub fn placed(&self, rotation: MatRef<'_, f64>, translation: [f64; 3]) -> Mat<f64> {
        self.from_body_frame(self.reference.as_ref(), rotation)
            + self.translations() * Mat::from_fn(3, 1, |i, _| translation[i])
    }

    /// A_bd times a vector. Shape: 3N.
    pub fn from_body_frame(&self, vector: MatRef<'_, f64>, rotation: MatRef<'_, f64>) -> Mat<f64> {
        turned(vector, rotation)
    }

    /// Kinetic energy ½ ṙᵀ M ṙ. Units: J.
    pub fn kinetic_energy(&self, velocity: &Mat<f64>) -> f64 {
        0.5 * (velocity.transpose() * self.mass_times(velocity.as_ref()))[(0, 0)]
    }

    /// Constant force of uniform gravity, M Φ_t g. Shape: 3N. Units: N.
    pub fn gravity(&self, acceleration: [f64; 3]) -> Mat<f64> {
        self.mass_times((self.translations() * Mat::from_fn(3, 1, |i, _| acceleration[i])).as_ref())
    }

    /// 4/h² M + K, the constant matrix of the implicit midpoint rule in the rotated frame.
    pub(super) fn step_matrix(&self, step: f64) -> Result<SparseMatrix, FormulationError> {
        let factor = 4.0 / (step * step);
        let mut entries: Vec<Triplet<usize, usize, f64>> =
            self.stiffness.triplet_iter().map(|t| Triplet::new(t.row, t.col, *t.val)).collect();
        for t in self.scalar_mass.triplet_iter() {
            entries.extend((0..3).map(|i| Triplet::new(3 * t.row + i, 3 * t.col + i, factor * *t.val)));
        }
        let size = 3 * self.triples();
        SparseMatrix::try_new_from_triplets(size, size, &entries)
            .map_err(|_| FormulationError::NotPositiveDefinite)
    }
}

/// A_bd times each column. Shape: as the argument.
pub(super) fn turned(columns: MatRef<'_, f64>, rotation: MatRef<'_, f64>) -> Mat<f64> {
    Mat::from_fn(columns.nrows(), columns.ncols(), |row, c| {
        let start = row - row % 3;
        (0..3).map(|j| rotation[(row % 3, j)] * columns[(start + j, c)]).sum()
    })
}

pub(super) fn dense_as_sparse(matrix: &Mat<f64>) -> Result<SparseMatrix, FormulationError> {
    let entries: Vec<_> = (0..matrix.ncols())
        .flat_map(|j| (0..matrix.nrows()).map(move |i| (i, j)))
        .filter(|&ij| matrix[ij] != 0.0)
        .map(|(i, j)| Triplet::new(i, j, matrix[(i, j)]))
        .collect();
    SparseMatrix::try_new_from_triplets(matrix.nrows(), matrix.ncols(), &entries)
        .map_err(|_| FormulationError::NotPositiveDefinite)
}
