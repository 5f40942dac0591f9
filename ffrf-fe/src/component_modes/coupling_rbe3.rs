//! Coupling by weighted average (RBE3): the reference point follows the nodes and stiffens nothing.

use ffrf_model::{Matrix3, Vector3};

use super::small::{cross_matrix, inverse, multiply, subtract};

/// Motion of the reference point as a linear map of the nodal displacements.
///
/// The reference point moves as the rigid motion (v, ω) that fits the nodal displacements best,
/// Σ w |v + ω × r - u|² = min. By duality a force and moment at the reference point act on the nodes as the
/// smallest weighted forces with that resultant.
/// Shape: one 6 x 3 block per node; rows are translation and small rotation of the reference point.
/// `None` if the nodes lie on one line.
pub(crate) fn averaging_rows(
    positions: &[Vector3],
    weights: &[f64],
    reference: Vector3,
) -> Option<Vec<[[f64; 3]; 6]>> {
    let total: f64 = weights.iter().sum();
    let mut centre = [0.0; 3];
    for (position, weight) in positions.iter().zip(weights) {
        for i in 0..3 {
            centre[i] += weight * position[i] / total;
        }
    }
    // About the weighted centre the fits of translation and rotation are independent.
    let mut moment = [[0.0; 3]; 3];
    for (position, weight) in positions.iter().zip(weights) {
        let r = subtract(*position, centre);
        let square: f64 = r.iter().map(|x| x * x).sum();
        for i in 0..3 {
            moment[i][i] += weight * square;
            for j in 0..3 {
                moment[i][j] -= weight * r[i] * r[j];
            }
        }
    }
    let inverse = inverse(&moment)?;
    // Velocity of the reference point: that of the centre and ω × d = -d̃ ω.
    let offset = cross_matrix(subtract(reference, centre));
    let rows = positions.iter().zip(weights).map(|(position, weight)| {
        let arm = cross_matrix(subtract(*position, centre));
        let rotation: Matrix3 = multiply(&inverse, &arm).map(|row| row.map(|x| weight * x));
        let carried = multiply(&offset, &rotation);
        let mut block = [[0.0; 3]; 6];
        for i in 0..3 {
            for j in 0..3 {
                let mean = if i == j { weight / total } else { 0.0 };
                block[i][j] = mean - carried[i][j];
                block[3 + i][j] = rotation[i][j];
            }
        }
        block
    });
    Some(rows.collect())
}
