//! Cuts through a body, where the force that it transmits is observed.

use serde::{Deserialize, Serialize};

use crate::Vector3;

/// A cut through a body, with the force and moment that the deformation transmits through it.
///
/// What the part on the side of the normal exerts on the rest: along the normal a pull is positive. It is that of the modes: what
/// they do not hold is not in it, and neither is damping.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SectionMarker {
    /// Name, unique among all markers of the body; letters, digits and underscores.
    pub name: String,
    /// A point of the cut, which moments are about, in the reference configuration. Units: m. Frame: body.
    pub position: Vector3,
    /// Unit normal of the cut. Frame: body.
    pub normal: Vector3,
    /// Force x, y, z and moment x, y, z per unit modal coordinate. Shape: M x 6. Units: N and N m for unit modes. Frame: body.
    pub force: Vec<[f64; 6]>,
}
