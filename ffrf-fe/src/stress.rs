//! Stress recovery: what each mode does to the stress at nodes.

use std::collections::BTreeSet;

use faer::MatRef;
use ffrf_model::{StressMarker, Vector3};

pub use crate::error::StressError;

use crate::elements::nodal_gradients;
use crate::{FeError, FeModel, ModeBasis, PartElasticity};

/// A place where stress is observed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StressRequest {
    /// Name of the marker.
    pub name: String,
    /// Rows of the nodes over which the stress is averaged.
    pub nodes: Vec<usize>,
}

/// The stress at nodes per unit modal coordinate.
///
/// At each node the mean over its elements, each extrapolated from its points of best accuracy, as finite-element programs print
/// it; then the mean over the nodes.
/// Errors: no node, a node that does not exist or that belongs to no element, an element that is not usable.
pub fn stress_marker(
    model: &FeModel,
    basis: &ModeBasis,
    elasticity: &PartElasticity,
    request: &StressRequest,
) -> Result<StressMarker, FeError> {
    let count = model.nodes.len();
    let rows: Vec<usize> = request.nodes.iter().copied().collect::<BTreeSet<_>>().into_iter().collect();
    if rows.is_empty() {
        return Err(StressError::Empty { marker: request.name.clone() }.into());
    }
    if let Some(&row) = rows.iter().find(|&&row| row >= count) {
        return Err(StressError::UnknownNode { marker: request.name.clone(), row, nodes: count }.into());
    }
    let modes = basis.shapes.ncols();
    let mut sum = vec![[0.0; 6]; modes];
    for &row in &rows {
        let at_node = nodal_stress(model, basis.shapes.as_ref(), elasticity, row)?.ok_or_else(|| {
            StressError::NoElement { marker: request.name.clone(), node: model.nodes.ids[row] }
        })?;
        for (sum, stress) in sum.iter_mut().zip(at_node) {
            for (entry, component) in sum.iter_mut().zip(stress) {
                *entry += component / rows.len() as f64;
            }
        }
    }
    let mean = |axis: usize| -> f64 {
        rows.iter().map(|&row| model.nodes.positions[row][axis]).sum::<f64>() / rows.len() as f64
    };
    let position: Vector3 = [mean(0), mean(1), mean(2)];
    let nodes = rows.iter().map(|&row| model.nodes.ids[row]).collect();
    Ok(StressMarker { name: request.name.clone(), nodes, position, stress: sum })
}

/// Mean stress over the elements at a node, a column of `fields` each; `None` for a node without element.
///
/// Each element has the stress of its own material: at a node between two materials, where some components jump, it is their mean.
/// Components: xx, yy, zz, xy, xz, yz. Errors: an element that is not usable.
pub fn nodal_stress(
    model: &FeModel,
    fields: MatRef<'_, f64>,
    elasticity: &PartElasticity,
    row: usize,
) -> Result<Option<Vec<[f64; 6]>>, FeError> {
    let mut stresses = vec![[0.0; 6]; fields.ncols()];
    let mut elements = 0;
    for (number, element) in model.elements.iter().enumerate() {
        let Some(place) = element.nodes.iter().position(|&node| node == row) else { continue };
        let corners: Vec<[f64; 3]> = element.nodes.iter().map(|&node| model.nodes.positions[node]).collect();
        let gradients = nodal_gradients(element.kind, &corners)?;
        let elasticity = elasticity.of(number)?;
        for (j, sum) in stresses.iter_mut().enumerate() {
            let mut slope = [[0.0; 3]; 3];
            for (&node, gradient) in element.nodes.iter().zip(&gradients[place]) {
                for (i, line) in slope.iter_mut().enumerate() {
                    for (entry, g) in line.iter_mut().zip(gradient) {
                        *entry += fields[(3 * node + i, j)] * g;
                    }
                }
            }
            for (entry, component) in sum.iter_mut().zip(elasticity.stress(&slope)) {
                *entry += component;
            }
        }
        elements += 1;
    }
    stresses.iter_mut().flatten().for_each(|entry| *entry /= f64::from(elements.max(1)));
    Ok((elements > 0).then_some(stresses))
}
