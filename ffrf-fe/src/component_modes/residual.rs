//! Rubin's basis: free normal modes and what they leave of the interface flexibility.
//!
//! Source: S. Rubin, Improved component-mode representation for structural dynamic analysis, AIAA J. 13 (1975);
//! R. H. MacNeal, A hybrid method of component mode synthesis, Computers & Structures 1 (1971). MacNeal gives the
//! residual shapes no mass; Rubin keeps it, and so does this basis: a body needs a mass for every coordinate.

use faer::{Mat, Par};
use ffrf_model::ModeKind;

use crate::FeError;
use crate::modes::{gram, subtract_product};

use super::condition::Condition;
use super::flexibility::Flexibility;
use super::interface_motion::InterfaceMotion;
use super::normal_modes::{NormalModes, normal_modes};
use super::shapes::Shapes;

/// [Φ_free, (G_e - Φ Λ⁻¹ Φᵀ) Bᵀ], and the free modes. G_e is the elastic flexibility in mean axes.
pub(crate) fn shapes(
    flexibility: &Flexibility<'_>,
    motion: &InterfaceMotion,
    count: usize,
    progress: &mut dyn FnMut(usize),
) -> Result<(Shapes, NormalModes), FeError> {
    let forces = motion.forces(flexibility.coordinates);
    let modes = normal_modes(Condition::Free(flexibility), count, progress)?;
    let mut residual = flexibility.elastic_refined(forces.clone());
    let participation = gram(modes.shapes.as_ref(), forces.as_ref(), Par::Seq);
    let factors = Mat::from_fn(participation.nrows(), participation.ncols(), |i, j| {
        participation[(i, j)] / modes.values[i]
    });
    subtract_product(residual.as_mut(), modes.shapes.as_ref(), factors.as_ref(), Par::Seq);
    let normal = Shapes::normal(&modes, ModeKind::FreeFree);
    Ok((normal.and(Shapes::of_kind(residual, ModeKind::Attachment)), modes))
}
