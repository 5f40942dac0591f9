//! How the part is held while inertial loads strain it, and the displacements that they cause.

use faer::{Mat, MatRef};

use crate::component_modes::{Interface, ReferenceCondition, static_responses, static_shapes};
use crate::{FeError, FeModel};

/// How the part is held while inertial loads strain it: as the frame of its modes is.
///
/// The acceleration of the frame loads the part; what holds the frame balances the load. Forces at interfaces that do not hold the
/// frame are loads of their own, which are not in here.
#[derive(Debug, Clone, PartialEq)]
pub enum PrestressSupport {
    /// By its own inertia: mean axes of free-free modes. Accelerations of the frame leave no stress, centrifugal forces do.
    MeanAxes,
    /// At the nodes of these rows, which the modes leave at rest.
    Clamped {
        /// Row numbers of the node table.
        nodes: Vec<usize>,
    },
    /// By interfaces that component modes were made for, in the frame of these modes.
    Interfaces {
        /// The interfaces; rigid ones stiffen the part.
        interfaces: Vec<Interface>,
        /// What the frame is tied to.
        reference: ReferenceCondition,
    },
}

/// Share of a load that may be left after balancing without meaning more than round-off.
const BALANCED: f64 = 1e-9;

/// Displacements of `loads` in the supported part, zero for a load that the support balances entirely. Shape: 3N x k.
///
/// Errors: no stiffness, one that is not positive definite on the support, unknown nodes or interfaces.
pub(super) fn displacements(
    model: &FeModel,
    support: &PrestressSupport,
    loads: MatRef<'_, f64>,
) -> Result<Mat<f64>, FeError> {
    let (held, interfaces, reference) = support.parts();
    static_shapes(model, held, interfaces, reference, loads, BALANCED)
}

/// Displacements of `forces` measured in the frame that the support holds: what [`displacements`] is the transpose of.
///
/// Errors: as those of [`displacements`].
pub(super) fn responses(
    model: &FeModel,
    support: &PrestressSupport,
    forces: MatRef<'_, f64>,
) -> Result<Mat<f64>, FeError> {
    let (held, interfaces, reference) = support.parts();
    static_responses(model, held, interfaces, reference, forces)
}

impl PrestressSupport {
    fn parts(&self) -> (&[usize], &[Interface], &ReferenceCondition) {
        match self {
            Self::MeanAxes => (&[], &[], &ReferenceCondition::MeanAxes),
            Self::Clamped { nodes } => (nodes, &[], &ReferenceCondition::MeanAxes),
            Self::Interfaces { interfaces, reference } => (&[], interfaces, reference),
        }
    }
}
