//! Weights of nodes by the surface that they stand for, for interfaces by weighted mean.

use std::collections::BTreeMap;

use ffrf_model::Vector3;

use crate::{Element, ElementKind, FeModel};

use super::ComponentModeError;
use super::small::{cross, norm, subtract};

const TETRAHEDRON_FACES: [&[usize]; 4] = [&[0, 1, 2], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]];
const TETRAHEDRON_EDGES: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];
const WEDGE_FACES: [&[usize]; 5] = [&[0, 1, 2], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]];
const HEXAHEDRON_FACES: [&[usize]; 6] =
    [&[0, 1, 2, 3], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]];
const HEXAHEDRON_EDGES: [[usize; 2]; 12] =
    [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];

/// Area of the surface of the part that each node stands for. Units: m².
///
/// The surface is made of the element faces that belong to one element only and all of whose nodes are among
/// `nodes`. A face is cut into triangles from its middle to its edges; each gives half of its area to both ends.
/// Shape: one per node, in the order of `nodes`.
/// Errors: a model without elements, a node that no such face touches.
pub fn area_weights(model: &FeModel, nodes: &[usize]) -> Result<Vec<f64>, ComponentModeError> {
    let place: BTreeMap<usize, usize> = nodes.iter().enumerate().map(|(i, &row)| (row, i)).collect();
    let mut areas = vec![0.0; nodes.len()];
    for face in surface(&model.elements) {
        if !face.iter().all(|row| place.contains_key(row)) {
            continue;
        }
        let points: Vec<Vector3> = face.iter().map(|&row| model.nodes.positions[row]).collect();
        let middle = [0, 1, 2].map(|i| points.iter().map(|x| x[i]).sum::<f64>() / points.len() as f64);
        for i in 0..face.len() {
            let next = (i + 1) % face.len();
            let area = 0.5 * norm(cross(subtract(points[i], middle), subtract(points[next], middle)));
            for row in [face[i], face[next]] {
                areas[place[&row]] += 0.5 * area;
            }
        }
    }
    match areas.iter().position(|&area| area <= 0.0) {
        None => Ok(areas),
        Some(i) => Err(ComponentModeError::Number {
            what: format!(
                "area of the surface around node {} within the interface",
                model.nodes.ids[nodes[i]]
            ),
            expected: "more than 0 (do the files have elements, and does the set hold whole element faces?)"
                .to_owned(),
            found: areas[i],
        }),
    }
}

/// Outer faces as rings of node rows, corners and middles of edges in turn.
fn surface(elements: &[Element]) -> Vec<Vec<usize>> {
    let mut seen: BTreeMap<Vec<usize>, (usize, Vec<usize>)> = BTreeMap::new();
    for ring in elements.iter().flat_map(faces) {
        let mut key = ring.clone();
        key.sort_unstable();
        seen.entry(key).or_insert((0, ring)).0 += 1;
    }
    seen.into_values().filter(|(count, _)| *count == 1).map(|(_, ring)| ring).collect()
}

fn faces(element: &Element) -> Vec<Vec<usize>> {
    let (faces, edges, corners): (&[&[usize]], &[[usize; 2]], usize) = match element.kind {
        ElementKind::Tetrahedron4 => (&TETRAHEDRON_FACES, &[], 4),
        ElementKind::Tetrahedron10 => (&TETRAHEDRON_FACES, &TETRAHEDRON_EDGES, 4),
        ElementKind::Wedge6 => (&WEDGE_FACES, &[], 6),
        ElementKind::Hexahedron8 => (&HEXAHEDRON_FACES, &[], 8),
        ElementKind::Hexahedron20 => (&HEXAHEDRON_FACES, &HEXAHEDRON_EDGES, 8),
    };
    let ring = |face: &&[usize]| {
        let mut ring = Vec::new();
        for i in 0..face.len() {
            let (a, b) = (face[i], face[(i + 1) % face.len()]);
            ring.push(a);
            if let Some(edge) = edges.iter().position(|edge| *edge == [a, b] || *edge == [b, a]) {
                ring.push(corners + edge);
            }
        }
        ring.into_iter().filter_map(|local| element.nodes.get(local).copied()).collect()
    };
    faces.iter().map(ring).collect()
}
