//! The trilinear hexahedron with eight nodes, in the node order of Abaqus and CalculiX (C3D8).

use super::isoparametric::ReferencePoint;

/// Reference coordinates of the nodes.
const CORNERS: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

/// 2 x 2 x 2 Gauss points: exact for stiffness and mass of a parallelepiped.
pub(super) fn rule() -> Vec<ReferencePoint> {
    let abscissa = 1.0 / 3.0_f64.sqrt();
    CORNERS.iter().map(|corner| ReferencePoint { at: corner.map(|x| x * abscissa), weight: 1.0 }).collect()
}

/// N_a = (1 + ξξ_a)(1 + ηη_a)(1 + ζζ_a) / 8.
pub(super) fn shape_functions(at: [f64; 3]) -> Vec<f64> {
    CORNERS.iter().map(|corner| (0..3).map(|i| 1.0 + at[i] * corner[i]).product::<f64>() / 8.0).collect()
}

/// ∂N_a / ∂ξ_i.
pub(super) fn shape_gradients(at: [f64; 3]) -> Vec<[f64; 3]> {
    CORNERS
        .iter()
        .map(|corner| {
            let factor = |i: usize| 1.0 + at[i] * corner[i];
            [0, 1, 2].map(|i| corner[i] * factor((i + 1) % 3) * factor((i + 2) % 3) / 8.0)
        })
        .collect()
}
