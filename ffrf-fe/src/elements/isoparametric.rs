//! Isoparametric solid elements: quadrature, stiffness and consistent mass.

use faer::Mat;

use crate::ElementKind;

use super::shapes::{self, ShapeFunctions};
use super::{ElementError, Material, rules};

/// A quadrature point of an element in space.
#[derive(Debug, Clone, PartialEq)]
pub struct QuadraturePoint {
    /// Shape functions N_a, one per node.
    pub shape: Vec<f64>,
    /// Gradients ∂N_a/∂x. Units: 1/m.
    pub gradient: Vec<[f64; 3]>,
    /// Weight times Jacobian determinant. Units: m³.
    pub volume: f64,
}

/// Stiffness and mass of one element.
#[derive(Debug, Clone)]
pub struct ElementMatrices {
    /// Stiffness. Shape: 3n x 3n, dofs x, y, z node by node. Units: N/m.
    pub stiffness: Mat<f64>,
    /// Consistent scalar mass. Shape: n x n. Units: kg.
    pub mass: Mat<f64>,
}

/// Quadrature points of an element with nodes at `corners`.
///
/// Errors: [`ElementError`]: unsupported kind, wrong number of nodes, Jacobian not positive.
pub fn quadrature(kind: ElementKind, corners: &[[f64; 3]]) -> Result<Vec<QuadraturePoint>, ElementError> {
    let (rule, functions, expected): (_, ShapeFunctions, _) = match kind {
        ElementKind::Hexahedron8 => (rules::hexahedron8(), shapes::hexahedron8, 8),
        ElementKind::Hexahedron20 => (rules::hexahedron20(), shapes::hexahedron20, 20),
        ElementKind::Tetrahedron4 => (rules::tetrahedron4(), shapes::tetrahedron4, 4),
        ElementKind::Tetrahedron10 => (rules::tetrahedron10(), shapes::tetrahedron10, 10),
        ElementKind::Wedge6 => (rules::wedge6(), shapes::wedge6, 6),
    };
    check_count(kind, expected, corners)?;
    rule.into_iter()
        .map(|point| {
            let (shape, local): (Vec<f64>, Vec<[f64; 3]>) = functions(point.at).into_iter().unzip();
            let (gradient, determinant) = space_gradients(corners, &local)?;
            Ok(QuadraturePoint { shape, gradient, volume: point.weight * determinant })
        })
        .collect()
}

fn check_count(kind: ElementKind, expected: usize, corners: &[[f64; 3]]) -> Result<(), ElementError> {
    let found = corners.len();
    if found == expected { Ok(()) } else { Err(ElementError::NodeCount { kind, expected, found }) }
}

/// ∂N_a/∂x at a reference point.
pub(super) fn gradients_at(
    kind: ElementKind,
    corners: &[[f64; 3]],
    at: [f64; 3],
) -> Result<Vec<[f64; 3]>, ElementError> {
    let (functions, expected): (ShapeFunctions, _) = match kind {
        ElementKind::Hexahedron8 => (shapes::hexahedron8, 8),
        ElementKind::Hexahedron20 => (shapes::hexahedron20, 20),
        ElementKind::Tetrahedron4 => (shapes::tetrahedron4, 4),
        ElementKind::Tetrahedron10 => (shapes::tetrahedron10, 10),
        ElementKind::Wedge6 => (shapes::wedge6, 6),
    };
    check_count(kind, expected, corners)?;
    let local: Vec<[f64; 3]> = functions(at).into_iter().map(|(_, gradient)| gradient).collect();
    Ok(space_gradients(corners, &local)?.0)
}

/// Stiffness ∫ BᵀDB and consistent mass ∫ ρ N_a N_b of an isotropic element.
///
/// Errors: as [`quadrature`].
pub fn element_matrices(
    kind: ElementKind,
    corners: &[[f64; 3]],
    material: &Material,
) -> Result<ElementMatrices, ElementError> {
    let nodes = corners.len();
    let (lambda, mu) = (material.lame_lambda(), material.shear_modulus());
    let (mut stiffness, mut mass) = (Mat::zeros(3 * nodes, 3 * nodes), Mat::zeros(nodes, nodes));
    for point in quadrature(kind, corners)? {
        for a in 0..nodes {
            for b in 0..nodes {
                mass[(a, b)] += material.density * point.volume * (point.shape[a] * point.shape[b]);
                let (ga, gb) = (point.gradient[a], point.gradient[b]);
                let inner: f64 = (0..3).map(|k| ga[k] * gb[k]).sum();
                for i in 0..3 {
                    for j in 0..3 {
                        // K_ab^ij = ∫ λ ∂_i N_a ∂_j N_b + μ (∂_j N_a ∂_i N_b + δ_ij ∇N_a·∇N_b)
                        let shear = ga[j] * gb[i] + if i == j { inner } else { 0.0 };
                        stiffness[(3 * a + i, 3 * b + j)] +=
                            point.volume * (lambda * (ga[i] * gb[j]) + mu * shear);
                    }
                }
            }
        }
    }
    Ok(ElementMatrices { stiffness, mass })
}

/// ∂N/∂x = J⁻ᵀ ∂N/∂ξ and det J.
fn space_gradients(corners: &[[f64; 3]], local: &[[f64; 3]]) -> Result<(Vec<[f64; 3]>, f64), ElementError> {
    // Rows are ∂x/∂ξ_i.
    let tangent = [0, 1, 2]
        .map(|i| [0, 1, 2].map(|k| corners.iter().zip(local).map(|(x, g)| x[k] * g[i]).sum::<f64>()));
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
    };
    let normal = [0, 1, 2].map(|i| cross(tangent[(i + 1) % 3], tangent[(i + 2) % 3]));
    let determinant: f64 = (0..3).map(|k| tangent[0][k] * normal[0][k]).sum();
    if determinant.is_nan() || determinant <= 0.0 {
        return Err(ElementError::Jacobian { determinant });
    }
    let gradient = local
        .iter()
        .map(|g| [0, 1, 2].map(|k| (0..3).map(|i| normal[i][k] * g[i]).sum::<f64>() / determinant))
        .collect();
    Ok((gradient, determinant))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Round-off of sums over 24 products of order one.
    const ROUND_OFF: f64 = 1e-13;

    const HEXAHEDRON: [[f64; 3]; 8] = [
        [0.0, 0.1, 0.0],
        [1.1, 0.0, 0.0],
        [1.0, 1.2, 0.1],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 0.9],
        [1.0, 0.1, 1.0],
        [1.2, 1.0, 1.1],
        [-0.1, 1.0, 1.0],
    ];
    const WEDGE: [[f64; 3]; 6] = [
        [0.0, 0.0, 0.0],
        [1.0, 0.1, 0.0],
        [0.2, 0.9, 0.1],
        [0.1, 0.0, 1.0],
        [1.1, 0.1, 0.9],
        [0.2, 1.0, 1.2],
    ];
    const TETRAHEDRON: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.1, 0.0], [0.2, 0.9, 0.1], [0.0, 0.2, 1.1]];

    /// A linear displacement field u = G x has the energy ½ V (λ tr² ε + 2 μ ε:ε), and rotations have none.
    #[test]
    fn linear_fields_have_the_energy_of_uniform_strain() {
        let material = Material { youngs_modulus: 1.0, poisson_ratio: 0.3, density: 2.0 };
        let gradients = [
            [[0.0, -0.3, 0.2], [0.3, 0.0, -0.1], [-0.2, 0.1, 0.0]],
            [[0.1, 0.2, -0.3], [0.0, 0.4, 0.1], [0.2, -0.1, -0.2]],
        ];
        let middle = |corners: &[[f64; 3]], [a, b]: [usize; 2]| {
            [0, 1, 2].map(|i| 0.5 * (corners[a][i] + corners[b][i]))
        };
        let edges = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];
        let quadratic = [&TETRAHEDRON[..], &edges.map(|edge| middle(&TETRAHEDRON, edge))].concat();
        let edges =
            [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];
        let serendipity = [&HEXAHEDRON[..], &edges.map(|edge| middle(&HEXAHEDRON, edge))].concat();
        for (kind, corners) in [
            (ElementKind::Hexahedron8, &HEXAHEDRON[..]),
            (ElementKind::Hexahedron20, &serendipity),
            (ElementKind::Tetrahedron4, &TETRAHEDRON[..]),
            (ElementKind::Tetrahedron10, &quadratic),
            (ElementKind::Wedge6, &WEDGE[..]),
        ] {
            let points = quadrature(kind, corners).expect("a sound element");
            let volume: f64 = points.iter().map(|point| point.volume).sum();
            let matrices = element_matrices(kind, corners, &material).expect("a sound element");
            let mass: f64 = (0..corners.len()).flat_map(|j| matrices.mass.col_as_slice(j)).sum();
            assert!((mass - 2.0 * volume).abs() < ROUND_OFF, "{kind:?}: mass {mass}, volume {volume}");
            for gradient in gradients {
                let displacement: Vec<f64> = corners
                    .iter()
                    .flat_map(|x| gradient.map(|row| (0..3).map(|k| row[k] * x[k]).sum::<f64>()))
                    .collect();
                let size = displacement.len();
                let energy: f64 = (0..size * size)
                    .map(|k| {
                        0.5 * displacement[k % size]
                            * matrices.stiffness[(k % size, k / size)]
                            * displacement[k / size]
                    })
                    .sum();
                let strain = |i: usize, j: usize| 0.5 * (gradient[i][j] + gradient[j][i]);
                let trace: f64 = (0..3).map(|i| strain(i, i)).sum();
                let square: f64 = (0..9).map(|k| strain(k / 3, k % 3).powi(2)).sum();
                let expected = volume
                    * (0.5 * material.lame_lambda() * trace * trace + material.shear_modulus() * square);
                assert!(
                    (energy - expected).abs() < ROUND_OFF,
                    "{kind:?}: energy {energy}, expected {expected}"
                );
            }
        }
    }

    #[test]
    fn elements_inside_out_are_refused_with_their_determinant() {
        let mut corners = TETRAHEDRON;
        corners.swap(0, 1);
        let error = quadrature(ElementKind::Tetrahedron4, &corners).expect_err("inside out");
        assert!(matches!(error, ElementError::Jacobian { determinant } if determinant < 0.0), "{error}");
    }
}
