//! The shortest quadrature rules that are exact for stiffness and mass of elements with straight edges.

use super::shapes;

/// A point of a quadrature rule on the reference element.
#[derive(Clone, Copy)]
pub(super) struct ReferencePoint {
    pub at: [f64; 3],
    pub weight: f64,
}

/// 2 x 2 x 2 Gauss points: exact for stiffness and mass of a parallelepiped.
pub(super) fn hexahedron8() -> Vec<ReferencePoint> {
    let abscissa = 1.0 / 3.0_f64.sqrt();
    let points = shapes::HEXAHEDRON[..8]
        .iter()
        .map(|corner| ReferencePoint { at: corner.map(|x| x * abscissa), weight: 1.0 });
    points.collect()
}

/// Four points of degree 2 (Hammer and Stroud 1956): exact for stiffness and mass.
pub(super) fn tetrahedron4() -> Vec<ReferencePoint> {
    let near = (5.0 - 5.0_f64.sqrt()) / 20.0;
    let far = (5.0 + 3.0 * 5.0_f64.sqrt()) / 20.0;
    [[near, near, near], [far, near, near], [near, far, near], [near, near, far]]
        .map(|at| ReferencePoint { at, weight: 1.0 / 24.0 })
        .to_vec()
}
