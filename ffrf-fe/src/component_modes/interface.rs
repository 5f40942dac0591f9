//! An interface: nodes that a joint or a force takes hold of together, and the point that stands for them.

use std::collections::BTreeSet;

use faer::Mat;
use ffrf_model::{Vector3, is_valid_marker_name};

use crate::FeModel;
use crate::modes::{entries, symmetric_eigen};
use crate::tolerances::SPREAD;

use super::ComponentModeError;
use super::small::subtract;

/// How the nodes of an interface are tied to its reference point.
#[derive(Debug, Clone, PartialEq)]
pub enum Coupling {
    /// RBE2: the nodes follow the reference point as one rigid body. For parts bolted to, or turning on, something
    /// much stiffer than themselves.
    Rigid,
    /// RBE3: the reference point follows the weighted mean of the nodes, and its force is spread over them. Adds no
    /// stiffness.
    Average {
        /// One positive weight per node, in the order of [`Interface::nodes`]. Only their ratios matter.
        weights: Vec<f64>,
    },
}

/// A named node set with a reference point that joints and forces take hold of.
///
/// Its six motions are the translations of the reference point along x, y, z (m) and its small rotations about
/// x, y, z (rad), in the body frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Interface {
    pub(crate) name: String,
    pub(crate) nodes: Vec<usize>,
    pub(crate) reference_point: Vector3,
    pub(crate) coupling: Coupling,
}

impl Interface {
    /// An interface of these node rows, with the mean position of the nodes as reference point.
    ///
    /// Rows given twice count once.
    /// Errors: a name that no marker may have, an unknown row, a node without mass and stiffness, fewer than three
    /// nodes off one line.
    pub fn rigid(model: &FeModel, name: &str, nodes: &[usize]) -> Result<Self, ComponentModeError> {
        let refuse =
            |row| ComponentModeError::Row { interface: name.to_owned(), row, nodes: model.nodes.len() };
        if !is_valid_marker_name(name) {
            return Err(ComponentModeError::Name { interface: name.to_owned() });
        }
        let nodes: Vec<usize> = nodes.iter().copied().collect::<BTreeSet<_>>().into_iter().collect();
        if let Some(&row) = nodes.iter().find(|&&row| row >= model.nodes.len()) {
            return Err(refuse(row));
        }
        if let Some(&row) = nodes.iter().find(|&&row| is_loose(model, row)) {
            return Err(ComponentModeError::Loose { interface: name.to_owned(), node: model.nodes.ids[row] });
        }
        let positions: Vec<Vector3> = nodes.iter().map(|&row| model.nodes.positions[row]).collect();
        let reference_point = mean(&positions);
        let spread = spread(&positions, reference_point);
        if spread.is_nan() || spread < SPREAD {
            let (interface, nodes) = (name.to_owned(), nodes.len());
            return Err(ComponentModeError::Collinear { interface, nodes, spread, least: SPREAD });
        }
        Ok(Self { name: name.to_owned(), nodes, reference_point, coupling: Coupling::Rigid })
    }

    /// The same nodes coupled by their mean, each with the same weight.
    pub fn averaged(mut self) -> Self {
        self.coupling = Coupling::Average { weights: vec![1.0; self.nodes.len()] };
        self
    }

    /// The same nodes coupled by their mean with one weight per node, for instance the area that a node stands for.
    /// The reference point moves to the weighted mean position.
    ///
    /// Errors: weights that are not as many as nodes, not positive or not finite.
    pub fn weighted(mut self, model: &FeModel, weights: Vec<f64>) -> Result<Self, ComponentModeError> {
        let refuse = |found: String| ComponentModeError::Weights {
            interface: self.name.clone(),
            nodes: self.nodes.len(),
            found,
        };
        if weights.len() != self.nodes.len() {
            return Err(refuse(format!("{} weights", weights.len())));
        }
        if let Some(weight) = weights.iter().find(|weight| !(weight.is_finite() && **weight > 0.0)) {
            return Err(refuse(format!("{weight}")));
        }
        let total: f64 = weights.iter().sum();
        self.reference_point = [0, 1, 2].map(|i| {
            let moment =
                self.nodes.iter().zip(&weights).map(|(&row, weight)| weight * model.nodes.positions[row][i]);
            moment.sum::<f64>() / total
        });
        self.coupling = Coupling::Average { weights };
        Ok(self)
    }

    /// The same interface with another reference point. Units: m. Frame: body.
    ///
    /// Errors: coordinates that are not finite.
    pub fn at(mut self, reference_point: Vector3) -> Result<Self, ComponentModeError> {
        if reference_point.iter().any(|x| !x.is_finite()) {
            return Err(ComponentModeError::ReferencePoint { interface: self.name, found: reference_point });
        }
        self.reference_point = reference_point;
        Ok(self)
    }

    /// Name, which becomes that of a marker.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Rows of its nodes in the node table, ascending.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// Reference point in the body frame. Units: m.
    pub fn reference_point(&self) -> Vector3 {
        self.reference_point
    }

    /// How the nodes are tied to the reference point.
    pub fn coupling(&self) -> &Coupling {
        &self.coupling
    }

    pub(crate) fn is_rigid(&self) -> bool {
        self.coupling == Coupling::Rigid
    }
}

fn mean(positions: &[Vector3]) -> Vector3 {
    [0, 1, 2].map(|i| positions.iter().map(|position| position[i]).sum::<f64>() / positions.len() as f64)
}

/// Extent across the line that fits the positions best, over the extent along it; 0 for fewer than three.
fn spread(positions: &[Vector3], centre: Vector3) -> f64 {
    let mut moment = Mat::<f64>::zeros(3, 3);
    for &position in positions {
        let r = subtract(position, centre);
        for i in 0..3 {
            for j in 0..3 {
                moment[(i, j)] += r[i] * r[j];
            }
        }
    }
    match symmetric_eigen(moment.as_ref()) {
        Ok((values, _)) if values[2] > 0.0 => (values[1].max(0.0) / values[2]).sqrt(),
        _ => 0.0,
    }
}

/// True for a node that neither matrix knows.
fn is_loose(model: &FeModel, row: usize) -> bool {
    let stiffness = model.stiffness.as_ref();
    let stiff = |dof| stiffness.is_some_and(|matrix| entries(matrix, dof).any(|(_, value)| value != 0.0));
    !(3 * row..3 * row + 3).any(stiff) && entries(&model.mass, row).all(|(_, value)| value == 0.0)
}
