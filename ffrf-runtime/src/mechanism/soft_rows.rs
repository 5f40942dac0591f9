//! Force elements in the matrix of implicit steps: soft rows of the constrained solve.
//!
//! A spring and damper that resists an elongation with gradient g (its rate is g v) by -(k e + d ġ) adds -gᵀ k g and -gᵀ d g to
//! the derivatives of forces by places and velocities. A linearly implicit stage (I - γ h J) k = r with these in J, and with
//! x' = v for *every* place, frames among them, is
//!
//! ```text
//! k_x = r_x + γ h k_v
//! (M̂ + Σ c gᵀ g) k_v = M r_v - γ h K r_q - Σ γ h k gᵀ g r_x,      c = γ h d + γ² h² k
//! ```
//!
//! where M̂ has the modes' own terms (see [`step_linearly_implicit`](crate::step_linearly_implicit)). With ν = √c g k_v + γ h k /
//! √c g r_x that is one more row per direction beside those of the joints, of compliance 1/c, and scaled by √c:
//!
//! ```text
//! [ M̂      Gᵀ   √c gᵀ ] [k_v]   [M r_v - γ h K r_q      ]
//! [ G      0    0     ] [ λ ] = [bias of the joints     ]
//! [ √c g   0    -1    ] [ ν ]   [-(γ h k / c) √c g r_x  ]
//! ```
//!
//! The scaled matrix is quasi-definite for every c: c = 0 is a row without effect, and c → ∞ holds the elongation like a joint
//! does. Flexible bodies take part through the same 6 x 6 blocks as at joints. r_x is the velocity of a stage's state less what
//! the stage subtracts from the rates of places, both as twists: the chart of the step is undone by its own derivative. So both
//! sides have the same J, and order 2 of the method, which any J leaves as it is, stays. In generalised-α the places of an
//! iterate follow from its velocities: r_x is zero, and soft rows complete the matrix of its Newton iteration.
//!
//! Explicit steps take these elements as forces, and have neither the rows nor their place in the elimination.

use nalgebra::RealField;

use super::{Attachment, EvaluatedJoint, JointPlace, Ports};
use crate::forces::ForceElement;
use crate::relations::add_powers;
use crate::six::{Square, block_at, products, scaled, six_times, transpose};

/// A force element that implicit steps take into their matrix, as soft rows of the constrained solve.
///
/// Of a row of gradient g, stiffness k and damping d a stage with γ h has √c g, c = γ h d + γ² h² k, with -1 on the diagonal: the
/// compliance 1/c, scaled. c = 0 is a row without effect, c → ∞ one that holds like a joint. The right-hand side is
/// -(γ h k / c) √c g r_x, where r_x is the rate of places that the stage starts from.
#[derive(Clone, Copy)]
pub struct SoftLink<'a, T: RealField + Copy> {
    /// What acts.
    pub element: &'a dyn ForceElement<T>,
    /// Where.
    pub ends: [&'a Attachment<T>; 2],
}

/// Sets the blocks of soft rows.
pub(super) fn attach_soft_rows<T: RealField + Copy>(
    places: &[JointPlace],
    links: &[Option<EvaluatedJoint<T>>],
    markers: &[[usize; 2]],
    ports: &mut dyn Ports<T>,
    blocks: &mut [Option<Square<T>>],
) {
    for ((place, link), markers) in places.iter().zip(links).zip(markers) {
        let Some(EvaluatedJoint { rows, .. }) = link else { continue };
        if let Some(block) = block_at(blocks, place.diagonal) {
            six_times!(K: { block[K][K] = -T::one(); });
        }
        for ((end, marker), gradients) in place.ends.iter().zip(markers).zip(rows.gradients()) {
            let Some(end) = end else { continue };
            let Some(port) = ports.port_mut(end.body) else { continue };
            let Some(block) = block_at(blocks, end.block.index) else { continue };
            port.attach(end.slot, *marker, rows.len(), gradients, block, None);
            if end.block.transposed {
                transpose(block);
            }
            if let Some(block) = block_at(blocks, place.diagonal) {
                port.subtract_compliance(end.slot, end.slot, block);
            }
        }
    }
}

/// Sets the right-hand sides of soft rows.
pub(super) fn pull_soft_rows<T: RealField + Copy>(
    places: &[JointPlace],
    links: &[Option<EvaluatedJoint<T>>],
    markers: &[[usize; 2]],
    ports: &dyn Ports<T>,
    right: &mut [[T; 6]],
) {
    for ((place, link), markers) in places.iter().zip(links).zip(markers) {
        let Some(EvaluatedJoint { rows, ends }) = link else { continue };
        let Some(right) = right.get_mut(place.node) else { continue };
        let mut moved = rows.velocities(ends);
        for ((end, marker), gradients) in place.ends.iter().zip(markers).zip(rows.gradients()) {
            let Some(port) = end.and_then(|end| ports.port(end.body)) else { continue };
            if let Some([linear, angular]) = port.subtracted_displacement(*marker) {
                add_powers(&mut moved, gradients, &-linear, &-angular);
            }
        }
        let mut wanted = scaled(-T::one(), &products(rows.residuals(), &moved));
        for end in place.ends.iter().flatten() {
            if let Some(port) = ports.port(end.body) {
                port.subtract_modal_accelerations(end.slot, &mut wanted);
            }
        }
        *right = wanted;
    }
}
