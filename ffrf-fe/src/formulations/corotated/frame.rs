//! The co-rotated frame: a rotation matrix as a function of the coordinates, and its derivative.

use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef};

use crate::formulations::FormulationError;
use crate::formulations::rotation::{cross, dot, skew};

/// How the rotation A follows from the coordinates.
#[derive(Debug, Clone)]
pub enum Frame {
    /// Polar rotation of F = Σ r_n Y_nᵀ. A translation must not change F: Σ Y_n = 0 for nodes.
    MeanRotation {
        /// Y_n. Shape: N vectors.
        weights: Vec<[f64; 3]>,
    },
    /// Gram-Schmidt on P2 - P1 and P3 - P1, relative to the same triad of the undeformed body.
    ThreePoints {
        /// Nodes P1, P2, P3.
        nodes: [usize; 3],
        /// Triad of the undeformed body, columns orthonormal. Shape: 3 x 3.
        reference: Mat<f64>,
    },
}

/// The rotation at given coordinates.
#[derive(Debug, Clone)]
pub struct FramePosition {
    /// A, body to inertial. Shape: 3 x 3.
    pub rotation: Mat<f64>,
    /// Γ̄ᵀ with δθ̄ = Γ̄ A_bdᵀ δr, δA = A δθ̄~ (body components). Shape: 3N x 3.
    pub spin: Mat<f64>,
}

impl Frame {
    /// Frame by three nodes of the undeformed body. Source: Section 3, (7).
    ///
    /// Errors: unknown nodes, nodes on a line.
    pub fn three_points(reference: MatRef<'_, f64>, nodes: [usize; 3]) -> Result<Self, FormulationError> {
        let count = reference.nrows() / 3;
        if let Some(&node) = nodes.iter().find(|&&node| node >= count) {
            return Err(FormulationError::UnknownNode { node, nodes: count });
        }
        let (triad, ..) = gram_schmidt(reference, nodes)?;
        Ok(Self::ThreePoints { nodes, reference: triad })
    }

    /// Rotation and its derivative at the coordinates r. Shape of `coordinates`: 3N.
    ///
    /// Errors: [`FormulationError::DegenerateFrame`].
    pub fn at(&self, coordinates: MatRef<'_, f64>) -> Result<FramePosition, FormulationError> {
        match self {
            Self::MeanRotation { weights } => mean_rotation(coordinates, weights),
            Self::ThreePoints { nodes, reference } => three_points(coordinates, *nodes, reference),
        }
    }
}

/// From F Aᵀ symmetric: (tr S I - S) δθ̄ = Σ Y_n × δr̄_n with S = Aᵀ F.
fn mean_rotation(r: MatRef<'_, f64>, weights: &[[f64; 3]]) -> Result<FramePosition, FormulationError> {
    let f = Mat::from_fn(3, 3, |i, j| {
        weights.iter().enumerate().map(|(n, y)| r[(3 * n + i, 0)] * y[j]).sum::<f64>()
    });
    let size = f.norm_max();
    let svd = f.svd().map_err(|_| FormulationError::DegenerateFrame { extent: f64::NAN })?;
    let (u, v) = (svd.U(), svd.V());
    let reflected = (u * v.transpose()).determinant() < 0.0;
    let flip = Mat::from_fn(3, 3, |i, j| match i == j {
        true if i == 2 && reflected => -1.0,
        true => 1.0,
        false => 0.0,
    });
    let rotation = u * flip * v.transpose();
    let s = rotation.transpose() * &f;
    let trace = s[(0, 0)] + s[(1, 1)] + s[(2, 2)];
    let h = Mat::from_fn(3, 3, |i, j| if i == j { trace } else { 0.0 } - 0.5 * (s[(i, j)] + s[(j, i)]));
    let sum_of_smallest = svd.S()[1] + if reflected { -svd.S()[2] } else { svd.S()[2] };
    if sum_of_smallest.is_nan() || sum_of_smallest <= 1e-12 * size {
        return Err(FormulationError::DegenerateFrame { extent: sum_of_smallest });
    }
    let inverse = h.partial_piv_lu().solve(Mat::<f64>::identity(3, 3));
    // Γ̄_n = H⁻¹ Ỹ_n, so Γ̄_nᵀ = -Ỹ_n H⁻¹.
    let stacked = Mat::from_fn(r.nrows(), 3, |row, j| -skew(weights[row / 3])[(row % 3, j)]);
    Ok(FramePosition { rotation, spin: stacked * inverse })
}

type Vector = [f64; 3];

/// Triad, edges P2 - P1 and P3 - P1, their lengths along d_1 and across it.
fn gram_schmidt(
    r: MatRef<'_, f64>,
    nodes: [usize; 3],
) -> Result<(Mat<f64>, Vector, f64, f64), FormulationError> {
    let point = |k: usize| [0, 1, 2].map(|i| r[(3 * nodes[k] + i, 0)]);
    let edge = |k: usize| [0, 1, 2].map(|i| point(k)[i] - point(0)[i]);
    let (first, second) = (edge(1), edge(2));
    let length = dot(first, first).sqrt();
    let d1 = first.map(|x| x / length);
    let along = dot(second, d1);
    let across = [0, 1, 2].map(|i| second[i] - along * d1[i]);
    let width = dot(across, across).sqrt();
    if width.is_nan() || width <= 1e-9 * length {
        return Err(FormulationError::DegenerateFrame { extent: width });
    }
    let d2 = across.map(|x| x / width);
    let d = [d1, d2, cross(d1, d2)];
    Ok((Mat::from_fn(3, 3, |i, j| d[j][i]), second, length, width))
}

/// ω·d_3 = d_2·ḋ_1, ω·d_2 = -d_3·ḋ_1, ω·d_1 = d_3·ḋ_2, with ḋ_1 and ḋ_2 from the rates of the edges.
fn three_points(
    r: MatRef<'_, f64>,
    nodes: [usize; 3],
    reference: &Mat<f64>,
) -> Result<FramePosition, FormulationError> {
    let (triad, second, length, width) = gram_schmidt(r, nodes)?;
    let rotation = &triad * reference.transpose();
    let d = [0, 1, 2].map(|j| [0, 1, 2].map(|i| triad[(i, j)]));
    let along = dot(second, d[0]);
    // Rows of δθ in the triad's components per unit change of each edge, inertial components.
    let by_first =
        [d[2].map(|x| -along * x / (length * width)), d[2].map(|x| -x / length), d[1].map(|x| x / length)];
    let by_second = [d[2].map(|x| x / width), [0.0; 3], [0.0; 3]];
    let mut spin = Mat::zeros(r.nrows(), 3);
    for (k, by_edge) in [(1, by_first), (2, by_second)] {
        // δθ̄ = Aᵀ D (rows · δe), and δe = A δē: Γ̄ = reference · rows · A.
        let rows = Mat::from_fn(3, 3, |i, j| by_edge[i][j]);
        let gamma = reference * rows * &rotation;
        for i in 0..3 {
            for j in 0..3 {
                spin[(3 * nodes[k] + j, i)] += gamma[(i, j)];
                spin[(3 * nodes[0] + j, i)] -= gamma[(i, j)];
            }
        }
    }
    Ok(FramePosition { rotation, spin })
}
