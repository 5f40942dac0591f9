//! Isoparametric solid elements: quadrature, stiffness and consistent mass.

use faer::Mat;

use crate::ElementKind;

use super::{ElementError, Material, hexahedron8, tetrahedron4};

/// A point of a quadrature rule on the reference element.
#[derive(Clone, Copy)]
pub(super) struct ReferencePoint {
    pub at: [f64; 3],
    pub weight: f64,
}

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
    let (rule, expected) = match kind {
        ElementKind::Hexahedron8 => (hexahedron8::rule(), 8),
        ElementKind::Tetrahedron4 => (tetrahedron4::rule(), 4),
        _ => return Err(ElementError::Unsupported { kind }),
    };
    if corners.len() != expected {
        return Err(ElementError::NodeCount { kind, expected, found: corners.len() });
    }
    rule.into_iter()
        .map(|point| {
            let (shape, local) = match kind {
                ElementKind::Hexahedron8 => {
                    (hexahedron8::shape_functions(point.at), hexahedron8::shape_gradients(point.at))
                }
                _ => (tetrahedron4::shape_functions(point.at), tetrahedron4::shape_gradients()),
            };
            let (gradient, determinant) = space_gradients(corners, &local)?;
            Ok(QuadraturePoint { shape, gradient, volume: point.weight * determinant })
        })
        .collect()
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
