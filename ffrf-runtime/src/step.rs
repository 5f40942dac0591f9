//! What a time step reports, and why it may refuse.

use core::fmt;

use nalgebra::RealField;

/// Estimate of the error that one step made, by kind of coordinate (largest component of each).
///
/// It is the difference to the embedded method of lower order and so overstates the error of the step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalError<T = f64> {
    /// Of the position of the frame origin. Units: m.
    pub position: T,
    /// Of the orientation. Units: rad.
    pub orientation: T,
    /// Of the modal coordinates. Units: those of the modes.
    pub modal_coordinates: T,
}

/// What one accepted step reports. An accepted step has a finite state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepReport<T = f64> {
    /// Estimate of the error of this step.
    pub local_error: LocalError<T>,
    /// |θ| - 1 after the step, before the quaternion was scaled back to unit norm. Units: 1.
    pub quaternion_norm_drift: T,
}

/// Why a step was refused. The body keeps the state and the time it had before.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum StepError {
    /// The step size is zero, negative or not finite.
    StepSize {
        /// The step size found. Units: s.
        found: f64,
    },
    /// The state before the step holds an infinity or is not a number.
    NonFiniteState,
    /// The state after the step would hold an infinity or not be a number: step too large, or bad loads.
    NonFiniteResult,
    /// The mass matrix, with the implicit terms, is not positive definite: invariants or state are unphysical.
    MassNotPositive,
}

impl fmt::Display for StepError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::StepSize { found } => {
                write!(formatter, "step size: expected a positive time, found {found} s")
            }
            Self::NonFiniteState => formatter.write_str("the state before the step is not finite"),
            Self::NonFiniteResult => {
                formatter.write_str("the state after the step is not finite: step too large, or bad loads")
            }
            Self::MassNotPositive => formatter.write_str("the mass matrix is not positive definite"),
        }
    }
}

impl core::error::Error for StepError {}

/// `step`, if time can advance by it.
pub(crate) fn checked_step_size<T: RealField + Copy>(step: T) -> Result<T, StepError> {
    if step > T::zero() && step.is_finite() {
        Ok(step)
    } else {
        Err(StepError::StepSize { found: nalgebra::try_convert(step).unwrap_or(f64::NAN) })
    }
}
