//! The classical Runge-Kutta method of order four with a fixed step.

use nalgebra::RealField;

use super::system::{begin, finish, stage};
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
    let h = begin(system, state, step)?;
    let half = h * nalgebra::convert(0.5);
    let third = h / nalgebra::convert(3.0);
    let sixth = h / nalgebra::convert(6.0);
    let scaled = |rates: &S::Increment, factor: T| {
        let mut increment = rates.clone();
        increment.scale(factor);
        increment
    };

    let rates = |after: T, increment: &S::Increment| {
        stage(system, time, state, false, system.rates(time + after, state, increment))
    };
    let k1 = system.rates(time, state, &system.no_change(state))?;
    let k2 = rates(half, &scaled(&k1, half))?;
    let k3 = rates(half, &scaled(&k2, half))?;
    let k4 = rates(h, &scaled(&k3, h))?;

    let mut slope = scaled(&k1, sixth);
    slope.add_scaled(third, &k2);
    slope.add_scaled(third, &k3);
    slope.add_scaled(sixth, &k4);
    let mut error = slope.clone();
    error.add_scaled(-h, &k2);
    finish(system, time + h, state, &slope, &error, None)
}
