//! Scalar relations between two markers, from which joints are composed; one file each.

mod aligned;
mod angle;
mod coincident;
mod distance;
mod in_line;
mod in_plane;
mod parallel;
mod perpendicular;
mod row;

pub use aligned::aligned;
pub use angle::angle;
pub use coincident::coincident;
pub use distance::distance;
pub use in_line::in_line;
pub use in_plane::in_plane;
pub use parallel::parallel;
pub use perpendicular::perpendicular;
pub use row::{MOST_ROWS, Row, Rows};

pub(crate) use row::{add_powers, axes};
