//! Attachment modes of the unsupported part: normal modes and static shapes of unit interface forces, balanced by the
//! inertia of the rigid acceleration that they cause (inertia relief).
//!
//! Source: R. R. Craig, A. J. Kurdila, Fundamentals of structural dynamics (2006), sections 17.4 and 17.5.

use ffrf_model::ModeKind;

use crate::FeError;

use super::condition::Condition;
use super::flexibility::Flexibility;
use super::interface_motion::InterfaceMotion;
use super::normal_modes::{NormalModes, normal_modes};
use super::shapes::Shapes;

/// [G_e Bᵀ, Φ_free], and the free modes. G_e is the elastic flexibility in mean axes.
pub(crate) fn shapes(
    flexibility: &Flexibility<'_>,
    motion: &InterfaceMotion,
    count: usize,
    progress: &mut dyn FnMut(usize),
) -> Result<(Shapes, NormalModes), FeError> {
    let attachment = flexibility.elastic_refined(motion.forces(flexibility.coordinates));
    let modes = normal_modes(Condition::Free(flexibility), count, progress)?;
    let normal = Shapes::normal(&modes, ModeKind::FreeFree);
    Ok((Shapes::of_kind(attachment, ModeKind::Attachment).and(normal), modes))
}
