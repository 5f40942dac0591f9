//! The motions that the equations of a scene lead to.

use super::accelerations::{check, trace_accelerations};
use super::arguments::Arguments;
use super::{Motions, StraightLineError};
use crate::scene::Scene;

impl Motions {
    /// Those that the equations lead to from the initial state of the scene.
    ///
    /// What is zero there and has an acceleration of zero, whatever the other numbers are, stays so: places out of the plane of
    /// a planar mechanism, and modes that nothing excites. That it is exactly zero is what the equations themselves would find.
    ///
    /// Errors: see [`StraightLineError`].
    pub fn of(scene: &Scene) -> Result<Self, StraightLineError> {
        check(scene)?;
        let mut motions = Self::starting(scene, |number| number != 0.0);
        loop {
            let arguments = Arguments::of(scene, &motions);
            let (accelerations, tape) = trace_accelerations(scene, &arguments)?;
            let before = motions.clone();
            motions.follow(&accelerations, &tape.graph);
            if motions == before {
                return Ok(motions);
            }
        }
    }
}
