//! What a joint is: rows between two marker triads.

use nalgebra::RealField;

use crate::body::MarkerMotion;
use crate::relations::Rows;

/// A joint between two triads; where it has an axis, that is z.
pub trait Joint<T: RealField + Copy> {
    /// Adds the constraint rows in the motion of both triads. `drive`: value, rate and acceleration, for driven joints.
    fn push_rows(
        &self,
        rows: &mut Rows<T>,
        first: &MarkerMotion<T>,
        second: &MarkerMotion<T>,
        drive: &[T; 3],
    );

    /// The constraint rows alone, see [`push_rows`](Self::push_rows).
    fn rows(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>, drive: &[T; 3]) -> Rows<T> {
        let mut rows = Rows::none();
        self.push_rows(&mut rows, first, second, drive);
        rows
    }
}

/// A joint whose rows are known when compiling.
pub trait JointShape {
    /// What each row holds, for reports.
    const ROWS: &'static [&'static str];
}
