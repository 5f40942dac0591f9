//! Volume of the elements of a model, from their corner nodes.

use crate::{ElementKind, FeModel};

/// Tetrahedra (corner numbers from 0) that fill an element.
type Split = &'static [[usize; 4]];

const TETRAHEDRON: Split = &[[0, 1, 2, 3]];
const WEDGE: Split = &[[0, 1, 2, 3], [1, 2, 3, 4], [2, 3, 4, 5]];
const HEXAHEDRON: Split = &[[0, 1, 3, 4], [1, 2, 3, 6], [1, 3, 4, 6], [1, 4, 5, 6], [3, 4, 6, 7]];

/// Sum of the volumes of all elements, curved edges taken as straight. Units: those of the nodes, cubed. `None`
/// without elements.
pub(super) fn of_elements(model: &FeModel) -> Option<f64> {
    if model.elements.is_empty() {
        return None;
    }
    let mut volume = 0.0;
    for element in &model.elements {
        for corners in split(element.kind) {
            let corner =
                |k: usize| element.nodes.get(corners[k]).and_then(|&row| model.nodes.positions.get(row));
            let [Some(a), Some(b), Some(c), Some(d)] = [0, 1, 2, 3].map(corner) else { return None };
            let edge = |to: &[f64; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
            let (u, v, w) = (edge(b), edge(c), edge(d));
            let triple = u[0] * (v[1] * w[2] - v[2] * w[1])
                + u[1] * (v[2] * w[0] - v[0] * w[2])
                + u[2] * (v[0] * w[1] - v[1] * w[0]);
            volume += triple.abs() / 6.0;
        }
    }
    Some(volume)
}

fn split(kind: ElementKind) -> Split {
    match kind {
        ElementKind::Tetrahedron4 | ElementKind::Tetrahedron10 => TETRAHEDRON,
        ElementKind::Wedge6 => WEDGE,
        ElementKind::Hexahedron8 | ElementKind::Hexahedron20 => HEXAHEDRON,
    }
}

/// Edges of the box around all nodes.
pub(super) fn box_edges(model: &FeModel) -> [f64; 3] {
    std::array::from_fn(|axis| {
        let coordinates = || model.nodes.positions.iter().map(|position| position[axis]);
        let least = coordinates().fold(f64::INFINITY, f64::min);
        (coordinates().fold(f64::NEG_INFINITY, f64::max) - least).max(0.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tetrahedra_fill_a_unit_cube_and_half_of_it() {
        let corner = |k: usize| {
            let (x, y) = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)][k % 4];
            [x, y, if k < 4 { 0.0 } else { 1.0 }]
        };
        let sum = |split: Split, corner: &dyn Fn(usize) -> [f64; 3]| -> f64 {
            let volume = |corners: &[usize; 4]| {
                let [a, b, c, d] = corners.map(corner);
                let edge = |to: [f64; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
                let (u, v, w) = (edge(b), edge(c), edge(d));
                let cross = [v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]];
                (0..3).map(|i| u[i] * cross[i]).sum::<f64>().abs() / 6.0
            };
            split.iter().map(volume).sum()
        };
        assert!((sum(HEXAHEDRON, &corner) - 1.0).abs() < 1e-15);
        let wedge = |k: usize| [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]][k % 3];
        let wedge = |k: usize| [wedge(k)[0], wedge(k)[1], if k < 3 { 0.0 } else { 1.0 }];
        assert!((sum(WEDGE, &wedge) - 0.5).abs() < 1e-15);
    }
}
