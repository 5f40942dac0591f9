//! What implicit steps take into their matrix of a force element.

use nalgebra::RealField;

use crate::body::Wrench;
use crate::relations::Row;

/// A direction in which a force element resists like a spring and a damper: a change of its ends by δx and δv changes the
/// force along `second` by -(k g δx + d g δv), g being this gradient.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoftRow<T = f64> {
    /// Gradient of the elongation to the motion of the first end. Frame: inertial.
    pub first: Wrench<T>,
    /// Gradient to the motion of the second end. Frame: inertial.
    pub second: Wrench<T>,
    /// k. Units: N/m or N m/rad.
    pub stiffness: T,
    /// d. Units: N s/m or N m s/rad.
    pub damping: T,
}

impl<T: RealField + Copy> SoftRow<T> {
    /// The gradient times √c, c = γ h d + γ² h² k, with γ h k / c in the place of the residual: see
    /// [`SoftLink`](crate::mechanism::SoftLink). Without stiffness and damping, and where they are negative, a row of zeros.
    pub(crate) fn in_stage(&self, gamma_h: T) -> Row<T> {
        let (stiffness, damping) = (self.stiffness.max(T::zero()), self.damping.max(T::zero()));
        let whole = gamma_h * (damping + gamma_h * stiffness);
        if whole <= T::zero() {
            return Row::zero();
        }
        let root = whole.sqrt();
        let scaled = |wrench: &Wrench<T>| Wrench { force: wrench.force * root, moment: wrench.moment * root };
        Row {
            residual: stiffness / (damping + gamma_h * stiffness),
            first: scaled(&self.first),
            second: scaled(&self.second),
            ..Row::zero()
        }
    }
}
