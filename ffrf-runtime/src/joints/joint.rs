//! What a joint is: rows between two marker triads.

use nalgebra::RealField;

use crate::body::MarkerMotion;
use crate::relations::Rows;

/// A joint between two triads; where it has an axis, that is z.
pub trait Joint<T: RealField + Copy> {
    /// The constraint rows in the motion of both triads. `drive`: value, rate and acceleration, for driven joints.
    fn rows(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>, drive: &[T; 3]) -> Rows<T>;
}

/// A joint whose rows are known when compiling.
pub trait JointShape {
    /// What each row holds, for reports.
    const ROWS: &'static [&'static str];
}
