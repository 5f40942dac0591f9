//! All free-free modes of a small mesh, mass-normalised: a complete basis with the mean-axis conditions.

use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use ffrf_fe::FeModel;

/// The first `count` of the 3N - 6 modes, in ascending frequency, and their circular frequencies in rad/s.
pub fn free_modes(model: &FeModel, count: usize) -> (Mat<f64>, Vec<f64>) {
    let size = 3 * model.nodes.len();
    let stiffness = model.stiffness.as_ref().expect("a stiffness") * Mat::<f64>::identity(size, size);
    let mass = Mat::from_fn(size, size, |i, j| {
        if i % 3 == j % 3 { model.mass.get(i / 3, j / 3).copied().unwrap_or(0.0) } else { 0.0 }
    });
    let factor = mass.llt(Side::Lower).expect("a positive mass");
    let l = factor.L();
    // L⁻¹ K L⁻ᵀ, by two triangular solves.
    let lower = l.partial_piv_lu();
    let half = lower.solve(&stiffness);
    let whole = lower.solve(half.transpose());
    let symmetric = Mat::from_fn(size, size, |i, j| 0.5 * (whole[(i, j)] + whole[(j, i)]));
    let eigen = symmetric.self_adjoint_eigen(Side::Lower).expect("eigenvalues converge");
    let shapes = l.transpose().to_owned().partial_piv_lu().solve(eigen.U());
    let frequencies = (0..count).map(|mu| eigen.S()[6 + mu].sqrt()).collect();
    (shapes.subcols(6, count).to_owned(), frequencies)
}
