//! Hurty-Craig-Bampton basis: constraint modes and normal modes with the interfaces at rest.
//!
//! Source: W. C. Hurty, Dynamic analysis of structural systems using component modes, AIAA J. 3 (1965);
//! R. R. Craig, M. C. C. Bampton, Coupling of substructures for dynamic analyses, AIAA J. 6 (1968).

use ffrf_model::ModeKind;

use crate::FeError;

use super::condition::Condition;
use super::constrained::Constrained;
use super::normal_modes::{NormalModes, normal_modes};
use super::shapes::Shapes;

/// [Ψ_c, Φ_clamped], and the clamped modes.
///
/// Ψ_c: static shapes of a unit motion of each interface coordinate. Together they hold every rigid motion exactly.
pub(crate) fn shapes(
    constrained: &Constrained<'_>,
    count: usize,
    progress: &mut dyn FnMut(usize),
) -> Result<(Shapes, NormalModes), FeError> {
    let constraint = Shapes::of_kind(constrained.constraint_modes(), ModeKind::Constraint);
    let modes = normal_modes(Condition::Clamped(constrained), count, progress)?;
    let normal = Shapes::normal(&modes, ModeKind::Clamped);
    Ok((constraint.and(normal), modes))
}
