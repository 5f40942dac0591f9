//! The classical Runge-Kutta method of order four with a fixed step.

use nalgebra::RealField;

use super::system::{arrive, begin, stage};
use super::{StepError, StepReport, System, VectorSpace};

/// One step of the classical Runge-Kutta method, order 4, explicit: stable for h ω_max < 2.78 undamped.
///
/// Four evaluations of the accelerations and of the loads; no allocation, bounded work.
/// The error estimate is the difference to the midpoint rule that the same stages hold (order 2).
/// Source: Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, table II.1.2.
///
/// Units: `time`, `step` s. Errors: see [`StepError`].
pub fn step_rk4<S: System<T>, T: RealField + Copy>(
    system: &S,
    state: &S::State,
    time: T,
    step: T,
) -> Result<(S::State, StepReport<T>), StepError> {
    let mut next = state.clone();
    let report = advance_rk4(system, &mut next, time, step)?;
    Ok((next, report))
}

/// [`step_rk4`] that changes `state` where it is: nothing large is handed over by value. Errors leave it as it was.
pub(crate) fn advance_rk4<S: System<T>, T: RealField + Copy>(
    system: &S,
    state: &mut S::State,
    time: T,
    step: T,
) -> Result<StepReport<T>, StepError> {
    let h = begin(system, state, step)?;
    let half = h * nalgebra::convert(0.5);
    let third = h / nalgebra::convert(3.0);
    let sixth = h / nalgebra::convert(6.0);

    // in a loop, so that there is one place that evaluates accelerations: a body's kernels then become part of it
    let stages = [(T::zero(), sixth), (half, third), (half, third), (h, sixth)];
    let mut increment = system.no_change(state);
    let (mut slope, mut second) = (increment.clone(), increment.clone());
    for (number, (after, weight)) in stages.into_iter().enumerate() {
        if size_of::<S::Increment>() > LARGEST_IN_ONE_FRAME {
            evaluate_apart(system, time, state, after, &mut increment)?;
        } else {
            evaluate(system, time, state, after, &mut increment)?;
        }
        slope.add_scaled(weight, &increment);
        if number == 1 {
            second = increment.clone();
        }
    }
    let mut error = slope.clone();
    error.add_scaled(-h, &second);
    arrive(system, time + h, state, &slope, &error, None)
}

/// The largest increment that shares a stack frame with the kernels. Units: bytes.
///
/// A Cortex-M reaches 1020 bytes of floating-point numbers from one register. With four modes the numbers of a step and of the
/// kernels lie within, and a frame of their own would cost 3 % of the instructions; with eight modes in f64 they do not, and one
/// frame for all would cost 10 %.
const LARGEST_IN_ONE_FRAME: usize = 192;

/// Turns the rates of one stage into those of the next, which lies `after` the beginning.
#[inline(always)]
fn evaluate<S: System<T>, T: RealField + Copy>(
    system: &S,
    time: T,
    state: &S::State,
    after: T,
    increment: &mut S::Increment,
) -> Result<(), StepError> {
    increment.scale(after);
    *increment = stage(system, time, state, false, system.rates(time + after, state, increment))?;
    Ok(())
}

/// [`evaluate`] with a stack frame of its own.
#[inline(never)]
fn evaluate_apart<S: System<T>, T: RealField + Copy>(
    system: &S,
    time: T,
    state: &S::State,
    after: T,
    increment: &mut S::Increment,
) -> Result<(), StepError> {
    evaluate(system, time, state, after, increment)
}
