//! The inertia invariants (206-208) as one Gram matrix.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};
use ffrf_model::Inertia;

use crate::FeModel;
use crate::modes::entries;

/// Inertia invariants of a mode basis Ψ (3N x M) about the frame origin.
///
/// With M_FE = M_s ⊗ I3 they are the products FᵀM_sF of the scalar nodal fields F = [1, xⁱ, φ_μⁱ].
pub(crate) fn inertia_of(model: &FeModel, shapes: &Mat<f64>) -> Inertia {
    let fields = scalar_fields(model, shapes);
    let gram = gram_matrix(model, &fields);
    let modes = shapes.ncols();
    let position = |i: usize| 1 + i;
    let mode = |mu: usize, i: usize| 4 + 3 * mu + i;
    let block = |row: &dyn Fn(usize) -> usize, column: &dyn Fn(usize) -> usize| {
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| gram[(row(i), column(j))]))
    };
    Inertia {
        mass: gram[(0, 0)],
        first_moment: [0, 1, 2].map(|i| gram[(0, position(i))]),
        modal_first_moment: (0..modes).map(|mu| [0, 1, 2].map(|i| gram[(0, mode(mu, i))])).collect(),
        second_moment: block(&position, &position),
        position_mode_moment: (0..modes).map(|mu| block(&position, &|j| mode(mu, j))).collect(),
        mode_mode_moment: (0..modes)
            .map(|mu| (0..modes).map(|nu| block(&|i| mode(mu, i), &|j| mode(nu, j))).collect())
            .collect(),
    }
}

/// F = [1, x, y, z, φ_1^x, φ_1^y, φ_1^z, φ_2^x, ...]. Shape: N x (4 + 3M).
fn scalar_fields(model: &FeModel, shapes: &Mat<f64>) -> Mat<f64> {
    let positions = &model.nodes.positions;
    Mat::from_fn(positions.len(), 4 + 3 * shapes.ncols(), |node, field| match field {
        0 => 1.0,
        1..=3 => positions[node][field - 1],
        _ => shapes[(3 * node + (field - 4) % 3, (field - 4) / 3)],
    })
}

/// FᵀM_sF, symmetrised to the bit.
fn gram_matrix(model: &FeModel, fields: &Mat<f64>) -> Mat<f64> {
    let mut weighted = Mat::<f64>::zeros(fields.nrows(), fields.ncols());
    for field in 0..fields.ncols() {
        let source = fields.col_as_slice(field);
        let target = weighted.col_as_slice_mut(field);
        for node in 0..fields.nrows() {
            let factor = source[node];
            for (row, value) in entries(&model.mass, node) {
                target[row] += value * factor;
            }
        }
    }
    let mut gram = Mat::<f64>::zeros(fields.ncols(), fields.ncols());
    // One thread: the result must not depend on the number of threads.
    matmul(&mut gram, Accum::Replace, fields.transpose(), &weighted, 1.0, Par::Seq);
    Mat::from_fn(gram.nrows(), gram.ncols(), |i, j| 0.5 * (gram[(i, j)] + gram[(j, i)]))
}
