//! The triads of joints: how an axis and a pair of orientations become them.

use nalgebra::{Quaternion, RealField, UnitQuaternion, Vector3};

use super::{Connection, Ports};
use crate::joints::JointKind;

/// The rotation that takes z to an axis; none for z itself and for a vector without direction.
pub fn along_axis<T: RealField + Copy>(axis: &Vector3<T>) -> UnitQuaternion<T> {
    let length = axis.norm();
    if length <= T::zero() {
        return UnitQuaternion::identity();
    }
    let across = axis.x * axis.x + axis.y * axis.y;
    // without cancellation near the opposite direction
    let along = if axis.z < T::zero() { across / (length - axis.z) } else { length + axis.z };
    // the product of what is halfway with z: exact along x and y, where an angle and its functions are not
    let halfway = Quaternion::new(along, -axis.y, axis.x, T::zero());
    // opposite to z no rotation is nearest: half a turn about x is one
    UnitQuaternion::try_new(halfway, T::zero()).unwrap_or_else(|| {
        UnitQuaternion::new_unchecked(Quaternion::new(T::zero(), T::one(), T::zero(), T::zero()))
    })
}

/// The second triad of a joint, in the orientation of its second end, from how both ends are turned now.
///
/// The joint's z axes agree. About them, the angle from the first to the second triad is the turn about the axis between
/// both ends; joints that hold this rotation begin without it. `along_axis`: the first triad in that of its end.
pub fn second_triad<T: RealField + Copy>(
    kind: &JointKind<T>,
    ends: [&UnitQuaternion<T>; 2],
    along_axis: &UnitQuaternion<T>,
) -> UnitQuaternion<T> {
    let relative = ends[0].inverse() * ends[1];
    let turn = match kind {
        JointKind::Fixed(_)
        | JointKind::Prismatic(_)
        | JointKind::ConstantOrientation(_)
        | JointKind::Generic(_) => T::zero(),
        _ => turn_about(&relative, along_axis),
    };
    relative.inverse() * along_axis * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), turn)
}

/// The part of a rotation that turns about an axis, the z axis of `along_axis`. Units: rad.
pub fn turn_about<T: RealField + Copy>(relative: &UnitQuaternion<T>, along_axis: &UnitQuaternion<T>) -> T {
    let two: T = nalgebra::convert(2.0);
    let seen = along_axis.inverse() * relative * along_axis;
    two * seen.k.atan2(seen.w)
}

impl<T: RealField + Copy> Connection<T> {
    /// The same joint with its second triad placed so that the joint is met in the orientations of `ports`.
    ///
    /// Universal joints and joints of two points have no such choice: they stay as they are.
    #[must_use]
    pub fn met_in(mut self, ports: &dyn Ports<T>) -> Self {
        if matches!(self.kind, JointKind::Universal(_)) {
            return self;
        }
        let along_axis = self.first.orientation;
        let bare = |mut attachment: super::Attachment<T>| {
            attachment.orientation = UnitQuaternion::identity();
            attachment.motion(ports).orientation
        };
        let ends = [bare(self.first), bare(self.second)];
        self.second.orientation = second_triad(&self.kind, [&ends[0], &ends[1]], &along_axis);
        self
    }
}
