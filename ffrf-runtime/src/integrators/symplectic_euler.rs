//! The symplectic (semi-implicit) Euler method.

use nalgebra::RealField;

use super::system::{begin, finish};
use super::{StepError, StepReport, System, VectorSpace};

/// One step of the symplectic Euler method, order 1: velocities from the forces, then places from the new velocities.
///
/// One evaluation of the accelerations; no allocation, bounded work. Stable for h ω_max < 2 undamped, where it keeps an
/// energy near the true one; symplectic only where forces do not depend on velocities. The error estimate is the
/// difference to the explicit Euler method. Source: Hairer, Lubich, Wanner, Geometric Numerical Integration, I.1.2.
///
/// Units: `time`, `step` s. Errors: see [`StepError`].
pub fn step_symplectic_euler<S: System<T>, T: RealField + Copy>(
    system: &S,
    state: &S::State,
    time: T,
    step: T,
) -> Result<(S::State, StepReport<T>), StepError> {
    let h = begin(system, state, step)?;
    let mut explicit = system.rates(time, state, &system.no_change(state))?;
    explicit.scale(h);
    let mut slope = system.velocities_only(&explicit);
    slope.add_scaled(h, &system.place_rates(state, &slope));
    let mut error = slope.clone();
    error.add_scaled(-T::one(), &explicit);
    finish(system, time + h, state, &slope, &error, None)
}
