//! The projection P on the null space of the constraints, and its rate (Sections 6.3, 7.2, 7.3).

use faer::{Mat, MatRef};

use super::rotation::{directors, skew};

/// A configuration in which the constraints hold: rotation and modal coordinates, with their rates.
#[derive(Debug, Clone)]
pub struct FloatingState {
    /// Rotation A, body to inertial. Shape: 3 x 3.
    pub rotation: Mat<f64>,
    /// Angular velocity ω, inertial components. Units: rad/s.
    pub omega: [f64; 3],
    /// Modal coordinates q'. Shape: M.
    pub q: Vec<f64>,
    /// Modal rates q̇'. Shape: M.
    pub q_dot: Vec<f64>,
}

impl FloatingState {
    /// Generalised coordinates [q_r; q_f] that the state stands for; q_t is left to the caller.
    ///
    /// Shape: 9 + 9M. Source: (40), (46), (95).
    pub fn generalized_coordinates(&self) -> Mat<f64> {
        let d = directors(self.rotation.as_ref());
        Mat::from_fn(9 + 9 * self.q.len(), 1, |row, _| {
            let (group, i, j) = (row / 9, row % 9 / 3, row % 3);
            if group == 0 { d[i][j] - f64::from(u8::from(i == j)) } else { self.q[group - 1] * d[i][j] }
        })
    }
}

/// P_rr = [-d̃_1; -d̃_2; -d̃_3]. Shape: 9 x 3. Source: (75).
pub fn rotation_block(rotation: MatRef<'_, f64>) -> Mat<f64> {
    let d = directors(rotation).map(skew);
    Mat::from_fn(9, 3, |row, column| -d[row / 3][(row % 3, column)])
}

/// p_ff = [d_1; d_2; d_3]. Shape: 9 x 1. Source: (80).
pub fn flexible_block(rotation: MatRef<'_, f64>) -> Mat<f64> {
    Mat::from_fn(9, 1, |row, _| rotation[(row % 3, row / 3)])
}

/// P. Shape: (12 + 9M) x (6 + M). Source: (73), (79)-(81).
pub fn projection(state: &FloatingState) -> Mat<f64> {
    assemble(
        state,
        true,
        &rotation_block(state.rotation.as_ref()),
        &flexible_block(state.rotation.as_ref()),
        |q, p_rr, _| faer::Scale(q) * p_rr,
    )
}

/// Ṗ for the state's ω and q̇'. Shape: (12 + 9M) x (6 + M). Source: (102), (104), (106).
pub fn projection_rate(state: &FloatingState) -> Mat<f64> {
    let turning = skew(state.omega) * &state.rotation;
    let p_rr = rotation_block(state.rotation.as_ref());
    let p_rr_rate = rotation_block(turning.as_ref());
    assemble(state, false, &p_rr_rate, &flexible_block(turning.as_ref()), |q, rate, q_dot| {
        faer::Scale(q_dot) * &p_rr + faer::Scale(q) * rate
    })
}

fn assemble(
    state: &FloatingState,
    with_translation: bool,
    rotation: &Mat<f64>,
    flexible: &Mat<f64>,
    coupling: impl Fn(f64, &Mat<f64>, f64) -> Mat<f64>,
) -> Mat<f64> {
    let modes = state.q.len();
    let mut p = Mat::zeros(12 + 9 * modes, 6 + modes);
    if with_translation {
        for i in 0..3 {
            p[(i, i)] = 1.0;
        }
    }
    p.as_mut().submatrix_mut(3, 3, 9, 3).copy_from(rotation);
    for mu in 0..modes {
        let block = coupling(state.q[mu], rotation, state.q_dot[mu]);
        p.as_mut().submatrix_mut(12 + 9 * mu, 3, 9, 3).copy_from(block);
        p.as_mut().submatrix_mut(12 + 9 * mu, 6 + mu, 9, 1).copy_from(flexible);
    }
    p
}
