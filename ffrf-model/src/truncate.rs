//! Using fewer modes than a body has.

use crate::{ModelError, ReducedBody};

impl ReducedBody {
    /// The body with its first `count` modes only.
    ///
    /// What it loses is the motion in the other modes; the numbers that stay are the same bits.
    ///
    /// Errors: [`ModelError::TooFewModes`]; `Length` if the body's lists do not fit together. Panics: never.
    pub fn with_modes(&self, count: usize) -> Result<Self, ModelError> {
        self.check_shape()?;
        if count > self.mode_count() {
            return Err(ModelError::TooFewModes { requested: count, available: self.mode_count() });
        }
        let mut body = self.clone();
        body.modes.truncate(count);
        body.inertia.modal_first_moment.truncate(count);
        body.inertia.position_mode_moment.truncate(count);
        truncate_square(&mut body.inertia.mode_mode_moment, count);
        truncate_square(&mut body.stiffness, count);
        truncate_square(&mut body.damping, count);
        for marker in &mut body.markers {
            marker.translation.truncate(count);
            marker.rotation.truncate(count);
        }
        Ok(body)
    }
}

fn truncate_square<T>(matrix: &mut Vec<Vec<T>>, count: usize) {
    matrix.truncate(count);
    for row in matrix {
        row.truncate(count);
    }
}
