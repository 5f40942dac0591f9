//! Ground joints: a point of the body held in space by Lagrange multipliers.

use faer::{Mat, MatRef};

/// Holds Σ w_n r_n, a node or the mean of nodes, at its place. C = Σ w_n r_n - c = 0 is linear in the coordinates.
#[derive(Debug, Clone, PartialEq)]
pub struct GroundJoint {
    /// Triple numbers and weights w_n.
    pub weights: Vec<(usize, f64)>,
}

impl GroundJoint {
    /// Holds one node of a mesh.
    pub fn node(node: usize) -> Self {
        Self { weights: vec![(node, 1.0)] }
    }

    /// Holds the mean of several nodes of a mesh.
    pub fn mean_of(nodes: &[usize]) -> Self {
        let weight = 1.0 / nodes.len().max(1) as f64;
        Self { weights: nodes.iter().map(|&node| (node, weight)).collect() }
    }

    /// Holds one node in generalised coordinates: its row of Φ, [1, xⁱ, φ_μⁱ].
    pub fn generalized(position: [f64; 3], mode_shapes: MatRef<'_, f64>, node: usize) -> Self {
        let mut weights = vec![(0, 1.0)];
        weights.extend((0..3).map(|i| (1 + i, position[i])));
        for mu in 0..mode_shapes.ncols() {
            weights.extend((0..3).map(|i| (4 + 3 * mu + i, mode_shapes[(3 * node + i, mu)])));
        }
        Self { weights }
    }

    /// The held point. Units: m.
    pub fn point(&self, coordinates: &Mat<f64>) -> [f64; 3] {
        [0, 1, 2].map(|i| self.weights.iter().map(|&(n, w)| w * coordinates[(3 * n + i, 0)]).sum())
    }
}

/// Cᵀ of all joints. Shape: 3N x 3J.
pub(super) fn constraint_columns(joints: &[GroundJoint], triples: usize) -> Mat<f64> {
    let mut columns = Mat::zeros(3 * triples, 3 * joints.len());
    for (j, joint) in joints.iter().enumerate() {
        for &(n, w) in &joint.weights {
            for i in 0..3 {
                columns[(3 * n + i, 3 * j + i)] += w;
            }
        }
    }
    columns
}
