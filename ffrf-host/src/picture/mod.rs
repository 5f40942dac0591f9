//! What bodies look like, for pictures: no number of a simulation depends on it.

mod points;
mod skeleton;

pub use points::{NamedPoint, model_points, named_points};
pub use skeleton::{model_skeleton, skeletons};

/// Triangles and how modes move them. Frame: body.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Shape {
    /// Points. Units: m.
    pub points: Vec<[f64; 3]>,
    /// Three points each, seen from outside against the clock.
    pub triangles: Vec<[u32; 3]>,
    /// Displacements of all points per unit of each modal coordinate. Shape: M x points x 3.
    pub modes: Vec<Vec<[f64; 3]>>,
    /// Ids of the points among the nodes of the finite-element model; empty where they are not known.
    pub nodes: Vec<u64>,
}
