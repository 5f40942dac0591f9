//! Displacement gradients at the nodes of an element, extrapolated from the points where they are most accurate.
//!
//! Gradients of displacement elements are best at the points of a rule that is just exact for the stiffness of their lower
//! order (Barlow's points): a polynomial through these points gives the nodes. Tetrahedra of 4 nodes have one gradient.
//! Source: J. Barlow, Optimal stress locations in finite element models, Int. J. Numer. Methods Eng. 10 (1976) 243-251;
//! E. Hinton, J. S. Campbell, ibid. 8 (1974) 461-480.

use crate::ElementKind;

use super::ElementError;
use super::isoparametric::gradients_at;
use super::rules;
use super::shapes::{self, HEXAHEDRON};

/// ∂N_a/∂x at each node of an element: at `[node][a]`. Units: 1/m.
///
/// Errors: as those of [`quadrature`](super::quadrature).
pub fn nodal_gradients(kind: ElementKind, corners: &[[f64; 3]]) -> Result<Vec<Vec<[f64; 3]>>, ElementError> {
    let at = |rule: Vec<rules::ReferencePoint>| rule.into_iter().map(|point| point.at).collect();
    let rule: Vec<[f64; 3]> = match kind {
        ElementKind::Hexahedron8 | ElementKind::Hexahedron20 => at(rules::hexahedron8()),
        ElementKind::Tetrahedron4 | ElementKind::Tetrahedron10 => at(rules::tetrahedron4()),
        ElementKind::Wedge6 => [-1.0, 1.0].map(|z| [1.0 / 3.0, 1.0 / 3.0, z / 3.0_f64.sqrt()]).to_vec(),
    };
    let points = rule.iter().map(|point| gradients_at(kind, corners, *point));
    let points = points.collect::<Result<Vec<_>, _>>()?;
    let nodes = reference_nodes(kind).into_iter().take(corners.len());
    Ok(nodes
        .map(|at| {
            let weights = weights(kind, at);
            (0..corners.len())
                .map(|a| {
                    let mut sum = [0.0; 3];
                    for (weight, gradients) in weights.iter().zip(&points) {
                        for (entry, gradient) in sum.iter_mut().zip(gradients[a]) {
                            *entry += weight * gradient;
                        }
                    }
                    sum
                })
                .collect()
        })
        .collect())
}

/// Values at a reference point of the polynomials that are one at one point of the rule and zero at the others.
fn weights(kind: ElementKind, at: [f64; 3]) -> Vec<f64> {
    match kind {
        // The points of the rule are the corners of a cube that is smaller by √3.
        ElementKind::Hexahedron8 | ElementKind::Hexahedron20 => {
            let scaled = at.map(|x| x * 3.0_f64.sqrt());
            shapes::hexahedron8(scaled).into_iter().map(|(value, _)| value).collect()
        }
        ElementKind::Tetrahedron4 => vec![0.25; 4],
        ElementKind::Tetrahedron10 => {
            let near = (5.0 - 5.0_f64.sqrt()) / 20.0;
            let volume = [1.0 - at[0] - at[1] - at[2], at[0], at[1], at[2]];
            volume.iter().map(|l| (l - near) / (1.0 - 4.0 * near)).collect()
        }
        ElementKind::Wedge6 => {
            let height = 3.0_f64.sqrt() * at[2];
            vec![0.5 * (1.0 - height), 0.5 * (1.0 + height)]
        }
    }
}

/// Reference coordinates of the nodes.
fn reference_nodes(kind: ElementKind) -> Vec<[f64; 3]> {
    const TETRAHEDRON: [[f64; 3]; 10] = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.5, 0.0, 0.0],
        [0.5, 0.5, 0.0],
        [0.0, 0.5, 0.0],
        [0.0, 0.0, 0.5],
        [0.5, 0.0, 0.5],
        [0.0, 0.5, 0.5],
    ];
    match kind {
        ElementKind::Hexahedron8 | ElementKind::Hexahedron20 => HEXAHEDRON.to_vec(),
        ElementKind::Tetrahedron4 | ElementKind::Tetrahedron10 => TETRAHEDRON.to_vec(),
        ElementKind::Wedge6 => {
            [-1.0, 1.0].iter().flat_map(|&z| [[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]]).collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sums of a few dozen products of order one.
    const ROUND_OFF: f64 = 1e-12;

    fn corners(kind: ElementKind) -> Vec<[f64; 3]> {
        // An affine element: x = A ξ + b.
        let map = |[x, y, z]: [f64; 3]| [1.0 + 2.0 * x + 0.3 * y, 0.5 * y - 0.2 * z, 0.1 * x + 0.7 * z];
        let count = match kind {
            ElementKind::Hexahedron8 => 8,
            ElementKind::Tetrahedron4 => 4,
            _ => reference_nodes(kind).len(),
        };
        reference_nodes(kind).into_iter().take(count).map(map).collect()
    }

    /// Linear fields have their gradient everywhere, quadratic ones theirs at the nodes where the element holds them.
    #[test]
    fn gradients_of_fields_that_the_element_holds_are_exact() {
        for kind in [
            ElementKind::Hexahedron8,
            ElementKind::Hexahedron20,
            ElementKind::Tetrahedron4,
            ElementKind::Tetrahedron10,
            ElementKind::Wedge6,
        ] {
            let corners = corners(kind);
            let gradients = nodal_gradients(kind, &corners).expect("a sound element");
            let of = |node: usize, field: &dyn Fn([f64; 3]) -> f64| -> [f64; 3] {
                [0, 1, 2].map(|k| {
                    corners.iter().zip(&gradients[node]).map(|(x, gradient)| field(*x) * gradient[k]).sum()
                })
            };
            let is_quadratic = matches!(kind, ElementKind::Hexahedron20 | ElementKind::Tetrahedron10);
            for node in 0..corners.len() {
                let linear = of(node, &|[x, y, z]| 0.3 * x - 0.7 * y + 1.1 * z);
                for (found, expected) in linear.iter().zip([0.3, -0.7, 1.1]) {
                    assert!((found - expected).abs() < ROUND_OFF, "{kind:?}, node {node}: {linear:?}");
                }
                if is_quadratic {
                    let [x, y, z] = corners[node];
                    let found = of(node, &|[x, y, z]| x * x - 2.0 * y * z + x * z);
                    for (found, expected) in found.iter().zip([2.0 * x + z, -2.0 * z, x - 2.0 * y]) {
                        assert!((found - expected).abs() < ROUND_OFF, "{kind:?}, node {node}: {found}");
                    }
                }
            }
        }
    }
}
