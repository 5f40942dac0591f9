//! The classical Runge-Kutta method of order four with a fixed step.

use nalgebra::RealField;

use crate::phase::{Phase, rates};
use crate::step::checked_step_size;
use crate::{FlexibleBody, Load, State, StepError, StepReport};

/// One step of the classical Runge-Kutta method, order 4, explicit: stable for h ω_max < 2.83 undamped.
///
/// Four evaluations of `forward_dynamics` and of the load; no allocation, bounded work.
/// The error estimate is the difference to the midpoint rule that the same stages hold (order 2).
/// Source: Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, table II.1.2.
///
/// Units: `time`, `step` s. Errors: see [`StepError`]. Panics: never.
pub fn step_rk4<B, L, const M: usize, const N: usize, T>(
    body: &B,
    state: &State<M, T>,
    time: T,
    step: T,
    load: &L,
) -> Result<(State<M, T>, StepReport<T>), StepError>
where
    B: FlexibleBody<M, N, T>,
    L: Load<B, M, N, T>,
    T: RealField + Copy,
{
    let h = checked_step_size(step)?;
    if !state.is_finite() {
        return Err(StepError::NonFiniteState);
    }
    let half = h * nalgebra::convert(0.5);
    let third = h / nalgebra::convert(3.0);
    let sixth = h / nalgebra::convert(6.0);

    let y = Phase::of(state);
    let k1 = rates(body, load, time, &y)?;
    let k2 = rates(body, load, time + half, &y.plus(half, &k1))?;
    let k3 = rates(body, load, time + half, &y.plus(half, &k2))?;
    let k4 = rates(body, load, time + h, &y.plus(h, &k3))?;

    let slope = k1.scaled(sixth).plus(third, &k2).plus(third, &k3).plus(sixth, &k4);
    y.plus(T::one(), &slope).accept(&slope.plus(-h, &k2))
}
