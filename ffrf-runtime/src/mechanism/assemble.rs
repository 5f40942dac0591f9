//! Bringing a state to where the joints are met, before the first step.

use nalgebra::RealField;

use super::{Assembly, Constrained};
use crate::integrators::{Drift, StepError};

/// Factorisations while assembling: each pass factors anew, so that a state far from the joints is drawn in by Newton's
/// method.
const PASSES: usize = 20;

/// Corrections of each level with one factorisation.
const CORRECTIONS: usize = 2;

/// How strongly deformation is resisted, as a step of a linearly implicit method. Units: s.
///
/// With the mass matrix alone, a modal coordinate moves as easily as the body: parts would be deformed to meet their joints.
/// With D γ h + K γ² h² added they are moved as a whole, and give way only where nothing else meets the joints.
const GAMMA_H: f64 = 1.0;

/// Corrections in the last pass.
const LAST_CORRECTIONS: usize = 8;

impl<A> Constrained<'_, A> {
    /// The state with the joints met, and how far `state` was from them.
    ///
    /// Positions, then velocities, move as little as possible, measured by the mass matrix and the stiffness of the modes;
    /// bounded work.
    /// `tolerance`: the residual that may be left. Units: m or rad.
    /// Errors: [`StepError::ConstraintsNotMet`] with the joint that is farthest off.
    pub fn assemble<T>(
        &self,
        time: T,
        state: A::State,
        tolerance: T,
    ) -> Result<(A::State, Drift<T>), StepError>
    where
        A: Assembly<T>,
        T: RealField + Copy,
    {
        // force elements do not resist: they stand as the state says
        let gamma_h = [Some(nalgebra::convert(GAMMA_H)), None];
        let anything = T::max_value().unwrap_or(T::one());
        let (mut state, first) =
            self.project_against(time, state, gamma_h, (CORRECTIONS, anything), false)?;
        for _ in 1..PASSES {
            state = self.project_against(time, state, gamma_h, (CORRECTIONS, anything), false)?.0;
        }
        let (state, _) = self.project_against(time, state, gamma_h, (LAST_CORRECTIONS, tolerance), false)?;
        Ok((state, first))
    }
}
