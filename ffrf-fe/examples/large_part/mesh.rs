//! Solid blocks of any size, regular hexahedra or irregular quadratic tetrahedra, with patches of nodes as interfaces.

use ffrf_fe::elements::{ElementError, Material, assemble, brick};
use ffrf_fe::{Element, ElementKind, FeModel, Nodes};
use ffrf_test_kit::random::Random;

/// Edge of an element. Units: m.
const EDGE: f64 = 0.01;
/// Corners of the irregular mesh move by at most this part of an edge along each axis: no tetrahedron turns over.
const JITTER: f64 = 0.15;

/// Elements along each edge of a block of the given proportions, so that its trilinear mesh has about `dofs` degrees of
/// freedom, or the quadratic one if `nodes_per_edge` is 2.
pub fn divisions(dofs: usize, proportions: [usize; 3], nodes_per_edge: usize) -> [usize; 3] {
    let volume: usize = proportions.iter().product();
    let scale = (dofs as f64 / (3 * volume) as f64).cbrt() / nodes_per_edge as f64;
    proportions.map(|part| ((part as f64 * scale).round() as usize).max(2))
}

/// Trilinear hexahedra of one centimetre.
pub fn hexahedra(divisions: [usize; 3]) -> Result<FeModel, ElementError> {
    brick(divisions.map(|count| EDGE * count as f64), divisions, &Material::STEEL)
}

/// Six ten-node tetrahedra in place of each hexahedron, corners moved at random.
pub fn tetrahedra(divisions: [usize; 3]) -> Result<FeModel, ElementError> {
    let counts = divisions.map(|division| 2 * division + 1);
    let row = |[i, j, k]: [usize; 3]| (k * counts[1] + j) * counts[0] + i;
    let mut positions = vec![[0.0; 3]; counts.iter().product()];
    let mut random = Random::new(1);
    for k in (0..counts[2]).step_by(2) {
        for j in (0..counts[1]).step_by(2) {
            for i in (0..counts[0]).step_by(2) {
                let at = [i, j, k];
                positions[row(at)] = [0, 1, 2].map(|axis| {
                    let is_inside = at[axis] > 0 && at[axis] + 1 < counts[axis];
                    let moved = JITTER * random.number() * f64::from(u8::from(is_inside));
                    EDGE * ((at[axis] / 2) as f64 + moved)
                });
            }
        }
    }
    let mut elements = Vec::with_capacity(6 * divisions.iter().product::<usize>());
    for k in 0..divisions[2] {
        for j in 0..divisions[1] {
            for i in 0..divisions[0] {
                for axes in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]] {
                    let nodes = tetrahedron([2 * i, 2 * j, 2 * k], axes);
                    for (middle, (a, b)) in EDGES.into_iter().enumerate() {
                        let (a, b) = (positions[row(nodes[a])], positions[row(nodes[b])]);
                        positions[row(nodes[4 + middle])] = [0, 1, 2].map(|axis| 0.5 * (a[axis] + b[axis]));
                    }
                    elements.push(Element {
                        kind: ElementKind::Tetrahedron10,
                        nodes: nodes.into_iter().map(row).collect(),
                    });
                }
            }
        }
    }
    let nodes = Nodes { ids: (1..=positions.len() as u64).collect(), positions, ..Nodes::default() };
    assemble(nodes, elements, &Material::STEEL)
}

/// Edges of a tetrahedron in the order of their middle nodes.
const EDGES: [(usize, usize); 6] = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)];

/// The ten nodes of the tetrahedron that a path along three axes spans, on the grid of half edges (Kuhn's subdivision).
fn tetrahedron(origin: [usize; 3], axes: [usize; 3]) -> [[usize; 3]; 10] {
    let mut corners = [origin; 4];
    for (step, &axis) in axes.iter().enumerate() {
        corners[step + 1] = corners[step];
        corners[step + 1][axis] += 2;
    }
    // An odd order of axes turns the tetrahedron over.
    if (axes[1] + 3 - axes[0]) % 3 == 2 {
        corners.swap(1, 2);
    }
    let middle = |(a, b): (usize, usize)| [0, 1, 2].map(|axis| (corners[a][axis] + corners[b][axis]) / 2);
    let [a, b, c, d] = corners;
    let [ab, bc, ca, ad, bd, cd] = EDGES.map(middle);
    [a, b, c, d, ab, bc, ca, ad, bd, cd]
}

/// Rows of the nodes of up to four patches: the two ends along x, and squares of half the width on the sides y = 0 and z = 0.
pub fn patches(model: &FeModel, count: usize) -> Vec<(&'static str, Vec<usize>)> {
    let positions = &model.nodes.positions;
    let far = [0, 1, 2].map(|axis| positions.iter().fold(0.0_f64, |far, x| far.max(x[axis])));
    let near = 1e-9 * far[0];
    let rows = |inside: &dyn Fn([f64; 3]) -> bool| -> Vec<usize> {
        (0..positions.len()).filter(|&row| inside(positions[row])).collect()
    };
    let middle = |x: f64, axis: usize| (x - 0.5 * far[axis]).abs() <= 0.25 * far[1].min(far[2]) + near;
    let all = [
        ("LEFT", rows(&|x| x[0] <= near)),
        ("RIGHT", rows(&|x| x[0] >= far[0] - near)),
        ("SIDE", rows(&|x| x[1] <= near && middle(x[0], 0) && middle(x[2], 2))),
        ("FLOOR", rows(&|x| x[2] <= near && middle(x[0], 0) && middle(x[1], 1) && x[1] > near)),
    ];
    all.into_iter().take(count).collect()
}
