//! The linear tetrahedron with four nodes (C3D4).

use super::isoparametric::ReferencePoint;

/// Four points of degree 2 (Hammer and Stroud 1956): exact for stiffness and mass.
pub(super) fn rule() -> Vec<ReferencePoint> {
    let near = (5.0 - 5.0_f64.sqrt()) / 20.0;
    let far = (5.0 + 3.0 * 5.0_f64.sqrt()) / 20.0;
    [[near, near, near], [far, near, near], [near, far, near], [near, near, far]]
        .map(|at| ReferencePoint { at, weight: 1.0 / 24.0 })
        .to_vec()
}

/// N = [1 - ξ - η - ζ, ξ, η, ζ].
pub(super) fn shape_functions(at: [f64; 3]) -> Vec<f64> {
    vec![1.0 - at[0] - at[1] - at[2], at[0], at[1], at[2]]
}

/// ∂N_a / ∂ξ_i.
pub(super) fn shape_gradients() -> Vec<[f64; 3]> {
    vec![[-1.0, -1.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
}
