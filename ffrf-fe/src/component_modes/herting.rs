//! Herting's basis: constraint modes, inertia-relief modes, and free normal modes relative to their interfaces.
//!
//! Source: D. N. Herting, A general purpose, multi-stage, component modal synthesis method, Finite Elements in
//! Analysis and Design 1 (1985).

use faer::Par;
use ffrf_model::ModeKind;

use crate::FeError;
use crate::modes::subtract_product;

use super::condition::Condition;
use super::constrained::Constrained;
use super::normal_modes::{NormalModes, normal_modes};
use super::shapes::Shapes;

/// [Ψ_c, G_c M R, Φ_free - Ψ_c B Φ_free], and the free modes. G_c is the flexibility with the interfaces at rest.
pub(crate) fn shapes(
    constrained: &Constrained<'_>,
    count: usize,
    progress: &mut dyn FnMut(usize),
) -> Result<(Shapes, NormalModes), FeError> {
    let flexibility = constrained.flexibility;
    let constraint = constrained.constraint_modes();
    let relief = constrained.clamped(flexibility.rigid.mass_shapes.as_ref());
    let modes = normal_modes(Condition::Free(flexibility), count, progress)?;
    let at_interfaces = constrained.motion.of(flexibility.coordinates, modes.shapes.as_ref());
    let mut normal = Shapes::normal(&modes, ModeKind::FreeFree);
    subtract_product(normal.columns.as_mut(), constraint.as_ref(), at_interfaces.as_ref(), Par::Seq);
    let shapes = Shapes::of_kind(constraint, ModeKind::Constraint)
        .and(Shapes::of_kind(relief, ModeKind::Attachment))
        .and(normal);
    Ok((shapes, modes))
}
