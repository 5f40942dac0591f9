//! The linearly implicit Euler method: the cheapest step that stiff modes do not limit.

use nalgebra::RealField;

use super::system::{begin, finish};
use super::{StepError, StepReport, StiffSystem, VectorSpace};

/// One linearly implicit Euler step with the modal stiffness and damping implicit: order 1, stable for any h ω_max.
///
/// (I - h J) k = f(t, y), with the J of [`step_linearly_implicit`](super::step_linearly_implicit); then every place moves
/// with its new velocity, which for the modes is the same and for rigid motion the symplectic Euler method. One evaluation
/// of the loads and one factorisation; no allocation, bounded work. Modes with h ω >> 1 are damped away, slower ones lose
/// h ω² / 2 of their amplitude per second. The error estimate is the difference to places that move with the old
/// velocities. Source: Deuflhard, Recent progress in extrapolation methods for ordinary differential equations, SIAM
/// Review 27 (1985) 505-535.
///
/// Units: `time`, `step` s. Errors: see [`StepError`].
pub fn step_linearly_implicit_euler<S: StiffSystem<T>, T: RealField + Copy>(
    system: &S,
    state: &S::State,
    time: T,
    step: T,
) -> Result<(S::State, StepReport<T>), StepError> {
    let h = begin(system, state, step)?;
    let rates = system.implicit_rates(time, state, &system.no_change(state), h, None)?;
    let mut velocities = system.velocities_only(&rates);
    velocities.scale(h);
    let mut slope = system.place_rates(state, &velocities);
    slope.scale(h);
    let mut error = slope.clone();
    error.add_scaled(-h, &system.place_rates(state, &system.no_change(state)));
    slope.add_scaled(T::one(), &velocities);
    finish(system, time + h, state, &slope, &error, Some(h))
}
