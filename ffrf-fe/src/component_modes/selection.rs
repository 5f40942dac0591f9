//! Choosing nodes: by set, by id, or by where they are.

use std::fmt;

use ffrf_model::Vector3;

use crate::Nodes;

use super::ComponentModeError;
use super::small::{dot, norm, subtract};

/// Nodes on the border of a region belong to it if they are off by no more than this part of the size of the model.
const BORDER: f64 = 1e-6;

/// A way to choose nodes. Lengths in m, body frame.
#[derive(Debug, Clone, PartialEq)]
pub enum NodeSelection {
    /// A node set of the files; case does not matter.
    Set(String),
    /// Node ids of the files.
    Ids(Vec<u64>),
    /// All nodes within a box along the axes of the body frame, border included.
    Box {
        /// One corner.
        from: Vector3,
        /// The opposite corner.
        to: Vector3,
    },
    /// All nodes at a distance from an axis: on the wall of a bore or a shaft.
    Cylinder {
        /// A point of the axis.
        point: Vector3,
        /// Direction of the axis.
        axis: Vector3,
        /// Distance from the axis.
        radius: f64,
        /// How far nodes may be off the radius.
        tolerance: f64,
    },
    /// All nodes on a plane.
    Plane {
        /// A point of the plane.
        point: Vector3,
        /// Normal of the plane.
        normal: Vector3,
        /// How far nodes may be off the plane.
        tolerance: f64,
    },
}

impl NodeSelection {
    /// Rows of the chosen nodes, ascending.
    ///
    /// Errors: an unknown set or id, a direction without length, no node found.
    pub fn rows(&self, nodes: &Nodes) -> Result<Vec<usize>, ComponentModeError> {
        let rows = match self {
            Self::Set(name) => set(nodes, name)?.to_vec(),
            Self::Ids(ids) => {
                let mut rows = ids.iter().map(|&id| row(nodes, id)).collect::<Result<Vec<_>, _>>()?;
                rows.sort_unstable();
                rows.dedup();
                rows
            }
            Self::Box { from, to } => {
                let border = BORDER * extent(nodes);
                inside(nodes, |x| {
                    (0..3).all(|i| {
                        let (low, high) = (from[i].min(to[i]), from[i].max(to[i]));
                        x[i] >= low - border && x[i] <= high + border
                    })
                })
            }
            Self::Cylinder { point, axis, radius, tolerance } => {
                let axis = self.unit(*axis)?;
                let allowed = tolerance + BORDER * extent(nodes);
                inside(nodes, |x| {
                    let arm = subtract(x, *point);
                    let along = dot(arm, axis);
                    let across = norm([0, 1, 2].map(|i| arm[i] - along * axis[i]));
                    (across - radius).abs() <= allowed
                })
            }
            Self::Plane { point, normal, tolerance } => {
                let normal = self.unit(*normal)?;
                let allowed = tolerance + BORDER * extent(nodes);
                inside(nodes, |x| dot(subtract(x, *point), normal).abs() <= allowed)
            }
        };
        if rows.is_empty() {
            return Err(ComponentModeError::NothingSelected {
                selection: self.to_string(),
                nodes: nodes.len(),
            });
        }
        Ok(rows)
    }

    fn unit(&self, direction: Vector3) -> Result<Vector3, ComponentModeError> {
        let length = norm(direction);
        if length > 0.0 && length.is_finite() {
            return Ok(direction.map(|x| x / length));
        }
        let expected = "a direction with a length above 0".to_owned();
        Err(ComponentModeError::Number { what: self.to_string(), expected, found: length })
    }
}

impl fmt::Display for NodeSelection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let join = |x: &Vector3| format!("{},{},{}", x[0], x[1], x[2]);
        match self {
            Self::Set(name) => write!(f, "set:{name}"),
            Self::Ids(ids) => {
                let ids: Vec<String> = ids.iter().map(u64::to_string).collect();
                write!(f, "ids:{}", ids.join(","))
            }
            Self::Box { from, to } => write!(f, "box:{},{}", join(from), join(to)),
            Self::Cylinder { point, axis, radius, tolerance } => {
                write!(f, "cylinder:{},{},{radius},{tolerance}", join(point), join(axis))
            }
            Self::Plane { point, normal, tolerance } => {
                write!(f, "plane:{},{},{tolerance}", join(point), join(normal))
            }
        }
    }
}

fn set<'a>(nodes: &'a Nodes, name: &str) -> Result<&'a [usize], ComponentModeError> {
    let found = nodes.sets.get(name).or_else(|| {
        // Decks are not case-sensitive.
        nodes.sets.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, rows)| rows)
    });
    found.map(Vec::as_slice).ok_or_else(|| {
        let names: Vec<&str> = nodes.sets.keys().map(String::as_str).collect();
        let known = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
        ComponentModeError::UnknownSet { set: name.to_owned(), known }
    })
}

fn row(nodes: &Nodes, id: u64) -> Result<usize, ComponentModeError> {
    nodes.row_of(id).ok_or_else(|| ComponentModeError::UnknownNode {
        id,
        nodes: nodes.len(),
        first: nodes.ids.iter().copied().min().unwrap_or(0),
        last: nodes.ids.iter().copied().max().unwrap_or(0),
    })
}

fn inside(nodes: &Nodes, is_in: impl Fn(Vector3) -> bool) -> Vec<usize> {
    (0..nodes.len()).filter(|&row| is_in(nodes.positions[row])).collect()
}

/// Largest extent of the model along an axis.
fn extent(nodes: &Nodes) -> f64 {
    (0..3).fold(0.0_f64, |largest, i| {
        let values = || nodes.positions.iter().map(|position| position[i]);
        largest.max(values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min))
    })
}
