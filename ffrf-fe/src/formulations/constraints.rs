//! The constraints that turn generalised component modes into a floating frame (Section 6).

use faer::Mat;

use super::rotation::dot;

/// Three vectors: the columns of Q_rᵀ + I or of Q_f,μᵀ.
pub type Triad = [[f64; 3]; 3];

/// Orthonormality of the directors, C_r(q_r). Shape: 6. Source: (65).
pub fn rigid(d: &Triad) -> [f64; 6] {
    [
        0.5 * (dot(d[0], d[0]) - 1.0),
        0.5 * (dot(d[1], d[1]) - 1.0),
        0.5 * (dot(d[2], d[2]) - 1.0),
        dot(d[0], d[1]),
        dot(d[0], d[2]),
        dot(d[1], d[2]),
    ]
}

/// C_rr = ∂C_r/∂q_r. Shape: 6 x 9. Source: (66).
pub fn rigid_jacobian(d: &Triad) -> Mat<f64> {
    let terms = [(0, 0, 1.0), (1, 1, 1.0), (2, 2, 1.0), (3, 0, 1.0), (4, 0, 1.0), (5, 1, 1.0)];
    let mirrored = [(3, 1), (4, 2), (5, 2)];
    // Row r holds d_b in the block of d_a; rows 3 to 5 hold d_a in the block of d_b as well.
    let factors = [0, 1, 2, 1, 2, 2];
    let mut jacobian = Mat::zeros(6, 9);
    for (row, block, sign) in terms {
        put(&mut jacobian, row, block, sign, d[factors[row]]);
    }
    for ((row, block), factor) in mirrored.into_iter().zip([0, 0, 1]) {
        put(&mut jacobian, row, block, 1.0, d[factor]);
    }
    jacobian
}

/// Pairs (vector of d, vector of q_μ) of the first six rows of (69).
const OFF_DIAGONAL: [(usize, usize); 6] = [(1, 0), (2, 0), (0, 1), (2, 1), (0, 2), (1, 2)];

/// Co-rotation of one mode's nine coordinates, C_f,μ(q). Shape: 8. Source: (69).
pub fn flexible(d: &Triad, mode: &Triad) -> [f64; 8] {
    let mut values = [0.0; 8];
    for (value, (a, b)) in values.iter_mut().zip(OFF_DIAGONAL) {
        *value = dot(d[a], mode[b]);
    }
    values[6] = dot(d[0], mode[0]) - dot(d[1], mode[1]);
    values[7] = dot(d[0], mode[0]) - dot(d[2], mode[2]);
    values
}

/// C_ff,μ = ∂C_f,μ/∂q_f,μ. Shape: 8 x 9. Source: (70), first matrix.
pub fn flexible_jacobian_own(d: &Triad) -> Mat<f64> {
    bilinear_jacobian(|row| (OFF_DIAGONAL[row].1, d[OFF_DIAGONAL[row].0]), d)
}

/// C_fr,μ = ∂C_f,μ/∂q_r. Shape: 8 x 9. Source: (70), second matrix.
pub fn flexible_jacobian_rotation(mode: &Triad) -> Mat<f64> {
    bilinear_jacobian(|row| (OFF_DIAGONAL[row].0, mode[OFF_DIAGONAL[row].1]), mode)
}

fn bilinear_jacobian(off_diagonal: impl Fn(usize) -> (usize, [f64; 3]), other: &Triad) -> Mat<f64> {
    let mut jacobian = Mat::zeros(8, 9);
    for row in 0..6 {
        let (block, vector) = off_diagonal(row);
        put(&mut jacobian, row, block, 1.0, vector);
    }
    for (row, block) in [(6, 1), (7, 2)] {
        put(&mut jacobian, row, 0, 1.0, other[0]);
        put(&mut jacobian, row, block, -1.0, other[block]);
    }
    jacobian
}

/// The whole Jacobian C of [C_r; C_f,1; ...; C_f,M]. Shape: (6 + 8M) x (12 + 9M). Source: (72).
pub fn jacobian(d: &Triad, modes: &[Triad]) -> Mat<f64> {
    let mut whole = Mat::zeros(6 + 8 * modes.len(), 12 + 9 * modes.len());
    whole.as_mut().submatrix_mut(0, 3, 6, 9).copy_from(rigid_jacobian(d));
    for (mu, mode) in modes.iter().enumerate() {
        whole.as_mut().submatrix_mut(6 + 8 * mu, 3, 8, 9).copy_from(flexible_jacobian_rotation(mode));
        whole.as_mut().submatrix_mut(6 + 8 * mu, 12 + 9 * mu, 8, 9).copy_from(flexible_jacobian_own(d));
    }
    whole
}

fn put(matrix: &mut Mat<f64>, row: usize, block: usize, sign: f64, vector: [f64; 3]) {
    for i in 0..3 {
        matrix[(row, 3 * block + i)] = sign * vector[i];
    }
}
