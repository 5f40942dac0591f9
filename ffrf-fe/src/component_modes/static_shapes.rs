//! Static displacements of given loads, the frame held as a reference condition says.

use faer::{Mat, MatRef};

use crate::{FeError, FeModel};

use super::coordinates::Coordinates;
use super::flexibility::{Flexibility, Supported};
use super::interface_motion::InterfaceMotion;
use super::reference_condition::{apply, balance};
use super::rigid_motion::RigidMotion;
use super::{Interface, ReferenceCondition};

/// Displacements of `loads` up to a rigid motion, with the nodes of rows `held` at rest. Shape: 3N x k, as that of `loads`.
///
/// A load of which balancing leaves less than the share `round_off` has no displacement.
/// Errors: no stiffness, one that is not positive definite, nodes or interfaces that do not exist.
pub(crate) fn static_shapes(
    model: &FeModel,
    held: &[usize],
    interfaces: &[Interface],
    reference: &ReferenceCondition,
    loads: MatRef<'_, f64>,
    round_off: f64,
) -> Result<Mat<f64>, FeError> {
    displacements(model, held, interfaces, loads, |flexibility, motion, forces| {
        let before = norms(&forces);
        let mut balanced = balance(reference, flexibility, motion, interfaces, forces)?;
        for (j, (after, before)) in norms(&balanced).into_iter().zip(before).enumerate() {
            if after <= round_off * before {
                balanced.col_as_slice_mut(j).fill(0.0);
            }
        }
        Ok(refined(flexibility, &balanced))
    })
}

/// Displacements of `forces` in the frame of the reference condition, supports taking what the forces do not balance; nodes of
/// rows `held` at rest. Shape: 3N x k, as that of `forces`.
///
/// Errors: as those of [`static_shapes`].
pub(crate) fn static_responses(
    model: &FeModel,
    held: &[usize],
    interfaces: &[Interface],
    reference: &ReferenceCondition,
    forces: MatRef<'_, f64>,
) -> Result<Mat<f64>, FeError> {
    displacements(model, held, interfaces, forces, |flexibility, motion, forces| {
        Ok(apply(reference, flexibility, motion, interfaces, refined(flexibility, &forces))?)
    })
}

/// What `solve` makes of loads in the coordinates of the model, as displacements of its nodes. Shape: 3N x k.
fn displacements(
    model: &FeModel,
    held: &[usize],
    interfaces: &[Interface],
    loads: MatRef<'_, f64>,
    solve: impl FnOnce(&Flexibility<'_>, &InterfaceMotion, Mat<f64>) -> Result<Mat<f64>, FeError>,
) -> Result<Mat<f64>, FeError> {
    let coordinates = Coordinates::held(model, interfaces, held)?;
    let motion = InterfaceMotion::new(&coordinates, interfaces)?;
    let rigid = RigidMotion::new(&coordinates)?;
    let (supported, stiffness) = Supported::new(&coordinates, &rigid)?;
    let flexibility = Flexibility::new(&coordinates, &rigid, &supported, stiffness, 1)?;
    let shapes = solve(&flexibility, &motion, coordinates.contract(loads))?;
    Ok(coordinates.expand(shapes.as_ref()))
}

/// Steps of refinement at most; slender parts take two or three.
const MOST_STEPS: usize = 8;

/// G F, refined with residuals of twice the digits until corrections are round-off or shrink no more: a slender part that is held
/// at one end is some 1e9 times softer in bending than its stiffest element, and a factor alone leaves as many fewer digits.
fn refined(flexibility: &Flexibility<'_>, forces: &Mat<f64>) -> Mat<f64> {
    let mut shapes = flexibility.supported(forces.as_ref());
    let mut last = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let rest = flexibility.coordinates.residual(forces.as_ref(), shapes.as_ref());
        let correction = flexibility.supported(rest.as_ref());
        let (corrections, lengths) = (norms(&correction), norms(&shapes));
        let share = corrections.into_iter().zip(lengths).map(|(c, s)| if c > 0.0 { c / s } else { 0.0 });
        let share = share.fold(0.0, f64::max);
        // A correction that does not shrink has nothing to say; so has one that is not a number.
        if share.is_nan() || share >= 0.5 * last {
            break;
        }
        shapes += correction;
        last = share;
        if share <= f64::EPSILON {
            break;
        }
    }
    shapes
}

fn norms(columns: &Mat<f64>) -> Vec<f64> {
    (0..columns.ncols()).map(|j| columns.col_as_slice(j).iter().map(|x| x * x).sum::<f64>().sqrt()).collect()
}
