//! Forces of unit body forces, uniform and linear in the position.

use faer::Mat;
use ffrf_model::{Matrix3, Vector3};

use crate::FeModel;
use crate::modes::mass_times_full;

/// Number of unit loads.
pub(super) const COUNT: usize = 12;

/// Axes i and j of the loads ρ (xⁱ e_j + xʲ e_i): one for each entry of a symmetric matrix, then one for each axis of rotation.
const SYMMETRIC: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
const ANTISYMMETRIC: [(usize, usize); 3] = [(0, 1), (0, 2), (1, 2)];

/// Nodal forces of the body forces ρ e_j (3), ρ (xⁱ e_j + xʲ e_i) / 2 (6) and ρ (xⁱ e_j - xʲ e_i) / 2 (3). Shape: 3N x 12.
///
/// Symmetric and antisymmetric loads apart, because in mean axes the latter, which are those of an angular acceleration, are
/// balanced by the inertia of the part.
pub(super) fn unit_loads(model: &FeModel) -> Mat<f64> {
    let positions = &model.nodes.positions;
    let mut fields = Mat::zeros(3 * positions.len(), COUNT);
    for (node, x) in positions.iter().enumerate() {
        for j in 0..3 {
            fields[(3 * node + j, j)] = 1.0;
        }
        for (k, (i, j)) in SYMMETRIC.into_iter().enumerate() {
            fields[(3 * node + j, 3 + k)] += 0.5 * x[i];
            fields[(3 * node + i, 3 + k)] += 0.5 * x[j];
        }
        for (k, (i, j)) in ANTISYMMETRIC.into_iter().enumerate() {
            fields[(3 * node + j, 9 + k)] += 0.5 * x[i];
            fields[(3 * node + i, 9 + k)] -= 0.5 * x[j];
        }
    }
    mass_times_full(&model.mass, &fields)
}

/// What belongs to the body forces ρ e_j and ρ xⁱ e_j, from what belongs to the unit loads.
pub(super) fn by_load(values: &[f64; COUNT]) -> (Vector3, Matrix3) {
    let mut linear = [[0.0; 3]; 3];
    for (k, (i, j)) in SYMMETRIC.into_iter().enumerate() {
        linear[i][j] = values[3 + k];
        linear[j][i] = values[3 + k];
    }
    for (k, (i, j)) in ANTISYMMETRIC.into_iter().enumerate() {
        linear[i][j] += values[9 + k];
        linear[j][i] -= values[9 + k];
    }
    ([values[0], values[1], values[2]], linear)
}
