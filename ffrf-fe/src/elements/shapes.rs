//! Shape functions and their gradients on the reference elements, node order of Abaqus and CalculiX (C3D4, C3D8, ...).

/// Value and gradient of one shape function.
pub(crate) type Shape = (f64, [f64; 3]);

/// The shape functions of an element kind at a reference point, one per node.
pub(crate) type ShapeFunctions = fn([f64; 3]) -> Vec<Shape>;

/// Gradients of the volume coordinates L = [1 - ξ - η - ζ, ξ, η, ζ].
const VOLUME_GRADIENTS: [[f64; 3]; 4] =
    [[-1.0, -1.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Ends of the edges whose middles are nodes 5 to 10.
const TETRAHEDRON_EDGES: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];

fn volume_coordinates(at: [f64; 3]) -> [f64; 4] {
    [1.0 - at[0] - at[1] - at[2], at[0], at[1], at[2]]
}

/// N = L.
pub(crate) fn tetrahedron4(at: [f64; 3]) -> Vec<Shape> {
    volume_coordinates(at).into_iter().zip(VOLUME_GRADIENTS).collect()
}

/// N = L (2 L - 1) at the corners, 4 L_a L_b on the edges.
pub(crate) fn tetrahedron10(at: [f64; 3]) -> Vec<Shape> {
    let l = volume_coordinates(at);
    let corners =
        l.iter().zip(VOLUME_GRADIENTS).map(|(&l, g)| (l * (2.0 * l - 1.0), g.map(|x| (4.0 * l - 1.0) * x)));
    let edges = TETRAHEDRON_EDGES.map(|[a, b]| {
        let (ga, gb) = (VOLUME_GRADIENTS[a], VOLUME_GRADIENTS[b]);
        (4.0 * l[a] * l[b], [0, 1, 2].map(|i| 4.0 * (l[a] * gb[i] + l[b] * ga[i])))
    });
    corners.chain(edges).collect()
}

/// Reference coordinates of the eight corners, then of the middles of the edges.
pub(super) const HEXAHEDRON: [[f64; 3]; 20] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
    [0.0, -1.0, -1.0],
    [1.0, 0.0, -1.0],
    [0.0, 1.0, -1.0],
    [-1.0, 0.0, -1.0],
    [0.0, -1.0, 1.0],
    [1.0, 0.0, 1.0],
    [0.0, 1.0, 1.0],
    [-1.0, 0.0, 1.0],
    [-1.0, -1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 1.0, 0.0],
    [-1.0, 1.0, 0.0],
];

/// Π (1 + ξ ξ_a) with 1 - ξ² where ξ_a = 0, and its gradient.
fn product(at: [f64; 3], node: [f64; 3]) -> Shape {
    let factor = |i: usize| if node[i] == 0.0 { 1.0 - at[i] * at[i] } else { 1.0 + at[i] * node[i] };
    let slope = |i: usize| if node[i] == 0.0 { -2.0 * at[i] } else { node[i] };
    let f = [factor(0), factor(1), factor(2)];
    (f[0] * f[1] * f[2], [slope(0) * f[1] * f[2], f[0] * slope(1) * f[2], f[0] * f[1] * slope(2)])
}

fn times(shape: Shape, factor: f64) -> Shape {
    (factor * shape.0, shape.1.map(|x| factor * x))
}

/// Trilinear.
pub(crate) fn hexahedron8(at: [f64; 3]) -> Vec<Shape> {
    HEXAHEDRON[..8].iter().map(|&node| times(product(at, node), 0.125)).collect()
}

/// Serendipity: the corners' product times (ξ ξ_a + η η_a + ζ ζ_a - 2) / 8, the edges' product / 4.
pub(crate) fn hexahedron20(at: [f64; 3]) -> Vec<Shape> {
    HEXAHEDRON
        .iter()
        .map(|&node| {
            let shape = product(at, node);
            if node.contains(&0.0) {
                return times(shape, 0.25);
            }
            let sum = at[0] * node[0] + at[1] * node[1] + at[2] * node[2] - 2.0;
            let gradient = [0, 1, 2].map(|i| 0.125 * (shape.1[i] * sum + shape.0 * node[i]));
            (0.125 * shape.0 * sum, gradient)
        })
        .collect()
}

/// Linear in a triangle of nodes 1 to 3 (ζ = -1) and 4 to 6 (ζ = 1), times linear in ζ.
pub(crate) fn wedge6(at: [f64; 3]) -> Vec<Shape> {
    const TRIANGLE: [[f64; 2]; 3] = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];
    let area = [1.0 - at[0] - at[1], at[0], at[1]];
    [-1.0, 1.0]
        .into_iter()
        .flat_map(|end| {
            let height = 0.5 * (1.0 + end * at[2]);
            area.into_iter()
                .zip(TRIANGLE)
                .map(move |(l, [x, y])| (l * height, [x * height, y * height, 0.5 * end * l]))
        })
        .collect()
}
