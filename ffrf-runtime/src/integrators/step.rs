//! What a time step reports, and why it may refuse.

use core::fmt;

use nalgebra::RealField;

use super::Departure;

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

impl<T: RealField + Copy> LocalError<T> {
    /// The larger of each component.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        Self {
            position: self.position.max(other.position),
            orientation: self.orientation.max(other.orientation),
            modal_coordinates: self.modal_coordinates.max(other.modal_coordinates),
        }
    }
}

/// How far a state was from its constraints before a step met them again (largest residual of each level).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drift<T = f64> {
    /// Of the positions. Units: m or rad.
    pub position: T,
    /// Of the velocities. Units: m/s or rad/s.
    pub velocity: T,
}

impl<T: RealField + Copy> Drift<T> {
    /// No drift.
    pub fn none() -> Self {
        Self { position: T::zero(), velocity: T::zero() }
    }
}

/// What one accepted step reports. An accepted step has a finite state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepReport<T = f64> {
    /// Estimate of the error of this step.
    pub local_error: LocalError<T>,
    /// How far the step had led from the constraints; zero for free bodies.
    pub drift: Drift<T>,
    /// Iterations of an implicit step; zero for methods that need none.
    pub iterations: usize,
    /// Whether the state has left what was planned; nothing where nobody looks, see [`Watched`](super::Watched).
    pub departure: Departure,
}

/// What errors are measured by: a component of size x may be off by `absolute + relative |x|`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerances<T = f64> {
    /// Units: 1.
    pub relative: T,
    /// Units: those of each component.
    pub absolute: T,
}

/// Why a step was refused. The system keeps the state and the time it had before.
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
    /// The accelerations before the step hold an infinity or are not a number, though its state is finite: a load, a drive or
    /// an invariant is to blame, or steps before it, if the state is absurd.
    NonFiniteAcceleration,
    /// The state after the step would hold an infinity or not be a number, though loads are finite before it: the step is too
    /// large, or those before it were and the motion has grown absurd.
    NonFiniteResult {
        /// The largest stable step of the classical Runge-Kutta method by the modes alone, for explicit steps of bodies that know
        /// it; force elements and large motion can ask for less. Units: s.
        largest_stable_step: Option<f64>,
    },
    /// The mass matrix, with the implicit terms, is not positive definite: invariants are unphysical, beyond what the number
    /// type resolves, or the state before the step is already absurd.
    MassNotPositive,
    /// The mass matrix of one body of a mechanism, with the implicit terms, is not positive definite: what
    /// [`MassNotPositive`](Self::MassNotPositive) says, and of whom.
    BodyNotPositive {
        /// The body, counted from zero.
        body: usize,
        /// Its largest modal coordinate; zero for rigid bodies. Units: those of the modes.
        amplitude: f64,
    },
    /// The equations of an implicit step were not solved within the iterations that it is allowed.
    NotConverged {
        /// Iterations done.
        iterations: usize,
        /// The last correction over what was tolerated: root mean square over the state. Units: 1.
        residual: f64,
    },
    /// The exponential step does not go with this system: a joint or a dense modal matrix couples its modes.
    ModesNotSeparate,
    /// The constraints could not be met again.
    ConstraintsNotMet {
        /// The joint with the largest residual, counted from zero.
        joint: usize,
        /// Its residual. Units: m or rad.
        residual: f64,
    },
}

impl StepError {
    /// The iterations of an implicit step have ended with this correction over what was tolerated.
    pub(crate) fn not_converged<T: RealField + Copy>(iterations: usize, residual: T) -> Self {
        Self::NotConverged { iterations, residual: nalgebra::try_convert(residual).unwrap_or(f64::NAN) }
    }
}

impl fmt::Display for StepError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::StepSize { found } => {
                write!(formatter, "step size: expected a positive time, found {found} s")
            }
            Self::NonFiniteState => formatter.write_str("the state before the step is not finite"),
            Self::NonFiniteResult { largest_stable_step } => {
                formatter.write_str("the state after the step is not finite: the step is too large, or steps before it were")?;
                match largest_stable_step {
                    Some(limit) => write!(
                        formatter,
                        "; the highest mode allows explicit steps of at most {limit:.3e} s, stiff force elements less"
                    ),
                    None => Ok(()),
                }
            }
            Self::NonFiniteAcceleration => formatter.write_str(
                "the accelerations before the step are not finite: a load, a drive or a number of a body is not, or the motion has \
                 grown absurd (explicit steps that are too large)",
            ),
            Self::MassNotPositive => formatter.write_str(
                "the mass matrix is not positive definite: no body has these invariants, the number type does not resolve them, \
                 or the deformation has grown absurd (explicit steps that are too large)",
            ),
            Self::BodyNotPositive { body, amplitude } => write!(
                formatter,
                "the mass matrix of body {body} is not positive definite at modal coordinates of up to {amplitude:.3e}: no body has \
                 these invariants, the number type does not resolve them, or the deformation has grown absurd (explicit steps that \
                 are too large)"
            ),
            Self::NotConverged { iterations, residual } => write!(
                formatter,
                "the step is not solved after {iterations} iterations: the last correction is {residual:.3e} times the tolerance"
            ),
            Self::ModesNotSeparate => formatter.write_str(
                "the modes do not vibrate each on its own: the exponential step needs diagonal modal mass, stiffness and damping, \
                 and joints at points that the modes do not move",
            ),
            Self::ConstraintsNotMet { joint, residual } => write!(
                formatter,
                "the constraints are not met: joint {joint} is off by {residual:.3e} (m or rad)"
            ),
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
