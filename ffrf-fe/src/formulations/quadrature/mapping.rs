//! Quadrature points of an element in space.

use super::rules;
use crate::elements::shapes::{self, ShapeFunctions};
use crate::formulations::rotation::{cross, dot};
use crate::formulations::{ElementDefect, FormulationError};
use crate::{Element, ElementKind};

/// A quadrature point: shape functions, and weight times Jacobian determinant.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// N_a, one per node of the element. Source: (32).
    pub shape: Vec<f64>,
    /// Volume that the point stands for. Units: m³.
    pub volume: f64,
}

/// Quadrature points of one element; `number` is only for errors.
///
/// Errors: [`FormulationError::Element`].
pub fn element_points(
    positions: &[[f64; 3]],
    element: &Element,
    number: usize,
) -> Result<Vec<Point>, FormulationError> {
    let defect = |defect| FormulationError::Element { element: number, defect };
    let (rule, functions, expected): (_, ShapeFunctions, _) = match element.kind {
        ElementKind::Tetrahedron4 => (rules::tetrahedron(), shapes::tetrahedron4, 4),
        ElementKind::Tetrahedron10 => (rules::tetrahedron(), shapes::tetrahedron10, 10),
        ElementKind::Hexahedron8 => (rules::hexahedron(), shapes::hexahedron8, 8),
        ElementKind::Hexahedron20 => (rules::hexahedron(), shapes::hexahedron20, 20),
        kind => return Err(defect(ElementDefect::Unsupported { kind })),
    };
    if element.nodes.len() != expected {
        return Err(defect(ElementDefect::NodeCount { expected, found: element.nodes.len() }));
    }
    if let Some(&row) = element.nodes.iter().find(|&&row| row >= positions.len()) {
        return Err(defect(ElementDefect::UnknownNode { row, nodes: positions.len() }));
    }
    rule.into_iter()
        .map(|(at, weight)| {
            let values = functions(at);
            // Rows ∂x/∂ξ_i.
            let tangent = [0, 1, 2].map(|i| {
                [0, 1, 2].map(|k| {
                    values
                        .iter()
                        .zip(&element.nodes)
                        .map(|((_, gradient), &row)| gradient[i] * positions[row][k])
                        .sum::<f64>()
                })
            });
            let determinant = dot(tangent[0], cross(tangent[1], tangent[2]));
            if determinant.is_nan() || determinant <= 0.0 {
                return Err(defect(ElementDefect::Jacobian { determinant }));
            }
            Ok(Point { shape: values.into_iter().map(|(n, _)| n).collect(), volume: weight * determinant })
        })
        .collect()
}
