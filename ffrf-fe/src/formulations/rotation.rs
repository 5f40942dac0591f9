//! Vectors, antisymmetric matrices and Euler parameters in the dense matrix type of this crate.

use faer::{Mat, MatRef};

/// Cross-product matrix w̃ with w̃ u = w × u. Source: (76).
pub fn skew(w: [f64; 3]) -> Mat<f64> {
    let [x, y, z] = w;
    let rows = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    Mat::from_fn(3, 3, |i, j| rows[i][j])
}

/// Axial vector of the antisymmetric part of a 3 x 3 matrix, w_i = -½ ε_ijk W_jk.
///
/// Source: (77), (78); the factor ½ is missing in print.
pub fn axial(matrix: MatRef<'_, f64>) -> [f64; 3] {
    [
        0.5 * (matrix[(2, 1)] - matrix[(1, 2)]),
        0.5 * (matrix[(0, 2)] - matrix[(2, 0)]),
        0.5 * (matrix[(1, 0)] - matrix[(0, 1)]),
    ]
}

/// u × v.
pub fn cross(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

/// u · v.
pub fn dot(u: [f64; 3], v: [f64; 3]) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

/// Columns d_1, d_2, d_3 of a rotation matrix. Source: (7).
pub fn directors(rotation: MatRef<'_, f64>) -> [[f64; 3]; 3] {
    [0, 1, 2].map(|j| [rotation[(0, j)], rotation[(1, j)], rotation[(2, j)]])
}

/// G(θ) with ω = G θ̇ in the inertial frame; θ scalar first. Shape: 3 x 4. Source: (211).
pub fn inertial_rate_matrix(theta: [f64; 4]) -> Mat<f64> {
    rate_matrix(theta, 1.0)
}

/// Ḡ(θ) with ω = Ḡ θ̇ in the body frame; θ scalar first. Shape: 3 x 4. Source: (212).
pub fn body_rate_matrix(theta: [f64; 4]) -> Mat<f64> {
    rate_matrix(theta, -1.0)
}

fn rate_matrix(theta: [f64; 4], sign: f64) -> Mat<f64> {
    let tilde = skew([theta[1], theta[2], theta[3]]);
    Mat::from_fn(3, 4, |i, j| match j {
        0 => -2.0 * theta[i + 1],
        _ => 2.0 * (if i + 1 == j { theta[0] } else { 0.0 } + sign * tilde[(i, j - 1)]),
    })
}

/// Rotation matrix A(θ) = ¼ G Ḡᵀ for unit θ, scalar first; maps body to inertial components. Source: (213).
pub fn rotation_matrix(theta: [f64; 4]) -> Mat<f64> {
    faer::Scale(0.25) * (inertial_rate_matrix(theta) * body_rate_matrix(theta).transpose())
}

/// The same 3 x 3 matrix `count` times along the diagonal, A_bd of (12).
pub fn block_diagonal(block: MatRef<'_, f64>, count: usize) -> Mat<f64> {
    let (rows, columns) = (block.nrows(), block.ncols());
    Mat::from_fn(rows * count, columns * count, |i, j| {
        if i / rows == j / columns { block[(i % rows, j % columns)] } else { 0.0 }
    })
}
