//! The outer faces of a finite-element model.

use std::collections::BTreeMap;

use anyhow::{Result, bail};
use ffrf_fe::{Element, ElementKind, FeModel, ModeBasis};

use ffrf_host::picture::Shape;

use super::Surface;

/// Faces of elements in the order of Abaqus and CalculiX, corner nodes, seen from outside against the clock.
const TETRAHEDRON: &[&[usize]] = &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]];
const HEXAHEDRON: &[&[usize]] =
    &[&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]];
const WEDGE: &[&[usize]] = &[&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]];

/// The surface of a model with the displacements of its modes: faces that one element alone has, between corner nodes.
///
/// Errors: the model has no elements, or some without faces.
pub fn skin(model: &FeModel, basis: &ModeBasis) -> Result<Surface> {
    if model.elements.is_empty() {
        bail!("--surface needs elements: give the deck, --calculix or --abaqus, that has them");
    }
    let mut faces: BTreeMap<Vec<usize>, (usize, Vec<usize>)> = BTreeMap::new();
    for element in &model.elements {
        for face in faces_of(element)? {
            let nodes: Vec<usize> =
                face.iter().filter_map(|place| element.nodes.get(*place).copied()).collect();
            let mut key = nodes.clone();
            key.sort_unstable();
            faces.entry(key).or_insert((0, nodes)).0 += 1;
        }
    }
    let outer: Vec<Vec<usize>> =
        faces.into_values().filter(|(count, _)| *count == 1).map(|(_, nodes)| nodes).collect();
    let mut places: BTreeMap<usize, u32> = BTreeMap::new();
    for node in outer.iter().flatten() {
        places.insert(*node, 0);
    }
    for (place, point) in places.values_mut().zip(0..) {
        *place = point;
    }
    let point = |node: &usize| places.get(node).copied().unwrap_or(0);
    let triangles = outer.iter().flat_map(|nodes| {
        // a fan: one triangle of three corners, two of four
        (2..nodes.len())
            .map(|k| [point(&nodes[0]), point(&nodes[k - 1]), point(&nodes[k])])
            .collect::<Vec<_>>()
    });
    let nodes: Vec<usize> = places.keys().copied().collect();
    let moved = |mode: usize| {
        nodes.iter().map(|node| [0, 1, 2].map(|axis| basis.shapes[(3 * node + axis, mode)])).collect()
    };
    Ok(Surface(Shape {
        points: nodes.iter().map(|node| model.nodes.positions[*node]).collect(),
        triangles: triangles.collect(),
        modes: (0..basis.modes.len()).map(moved).collect(),
        nodes: nodes.iter().map(|node| model.nodes.ids[*node]).collect(),
    }))
}

fn faces_of(element: &Element) -> Result<&'static [&'static [usize]]> {
    Ok(match element.kind {
        ElementKind::Tetrahedron4 | ElementKind::Tetrahedron10 => TETRAHEDRON,
        ElementKind::Hexahedron8 | ElementKind::Hexahedron20 => HEXAHEDRON,
        ElementKind::Wedge6 => WEDGE,
        other => bail!("--surface: elements of kind {other:?} have no faces here"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Volume by the divergence theorem: positive if every face is seen from outside against the clock.
    fn volume(corners: &[[f64; 3]], faces: &[&[usize]]) -> f64 {
        let triangles =
            faces.iter().flat_map(|face| (2..face.len()).map(|k| [face[0], face[k - 1], face[k]]));
        triangles
            .map(|[a, b, c]| {
                let [a, b, c] = [corners[a], corners[b], corners[c]];
                let cross = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
                (a[0] * cross(1, 2) + a[1] * cross(2, 0) + a[2] * cross(0, 1)) / 6.0
            })
            .sum()
    }

    #[test]
    fn faces_enclose_the_volume_of_their_element() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let cube: Vec<[f64; 3]> = [0.0, 1.0].iter().flat_map(|z| square.map(|[x, y]| [x, y, *z])).collect();
        assert!((volume(&cube, HEXAHEDRON) - 1.0).abs() < 1e-15);
        let wedge: Vec<[f64; 3]> =
            [0.0, 1.0].iter().flat_map(|z| [[0.0, 0.0, *z], [1.0, 0.0, *z], [0.0, 1.0, *z]]).collect();
        assert!((volume(&wedge, WEDGE) - 0.5).abs() < 1e-15);
        let tetrahedron = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert!((volume(&tetrahedron, TETRAHEDRON) - 1.0 / 6.0).abs() < 1e-15);
    }
}
