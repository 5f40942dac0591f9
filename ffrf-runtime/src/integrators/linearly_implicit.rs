//! A linearly implicit step of order two for systems with stiff modes.
//!
//! The method is ROS2, a Rosenbrock-W method with two stages. For y' = f(t, y),
//!
//! ```text
//! (I - γ h J) k1 = f(t, y)
//! (I - γ h J) k2 = f(t + h, y + h k1) - 2 k1
//! y_new = y + 3/2 h k1 + 1/2 h k2,        γ = 1 - 1/√2
//! ```
//!
//! It has order two for *any* matrix J, also where J differs by O(h) between the stages, and is L-stable when J is the
//! Jacobian of a linear f. Here J holds what is stiff, the elastic and damping forces, at the state of each stage, and
//! nothing else:
//!
//! ```text
//! q'                = q̇
//! M(q) [α; ω̇; q̈]    = -[0; 0; K_ff q + D_ff q̇]
//! ```
//!
//! so that a stage, with residual r_q for q and r for [α; ω̇; q̈], is one symmetric positive definite system:
//!
//! ```text
//! (M(q) + diag(0, 0, γ h D_ff + γ² h² K_ff)) k = M(q) r - γ h [0; 0; K_ff r_q]
//! k_q = r_q + γ h k_f
//! ```
//!
//! Mechanisms have force elements between markers in J as well, as soft rows of their constrained solve, see
//! [`SoftLink`](crate::mechanism::SoftLink); then k_x = r_x + γ h k_v for every place.
//!
//! Modes with h ω >> 1 are damped away, not resolved: that is the point. Modes with h ω of order one lose
//! amplitude; what must ring for long needs a step that resolves it (h ω < 0.1), or the explicit method.
//!
//! Source: Verwer, Spee, Blom, Hundsdorfer, A second-order Rosenbrock method applied to photochemical
//! dispersion problems, SIAM J. Sci. Comput. 20 (1999) 1456-1480.

use nalgebra::RealField;

use super::system::{arrive, begin, stage};
use super::{StepError, StepReport, StiffSystem, VectorSpace};

/// One step of ROS2 with the modal stiffness and damping implicit: order 2, stable for any h ω_max.
///
/// Two evaluations of the loads and two factorisations with the modes eliminated first (six where friction follows
/// reactions); no allocation, bounded work. The error estimate is the difference to the embedded method of order one.
/// Source: see the module's text, Verwer et al. (1999).
///
/// Units: `time`, `step` s. Errors: see [`StepError`].
pub fn step_linearly_implicit<S: StiffSystem<T>, T: RealField + Copy>(
    system: &S,
    state: &S::State,
    time: T,
    step: T,
) -> Result<(S::State, StepReport<T>), StepError> {
    let mut next = state.clone();
    let report = advance_linearly_implicit(system, &mut next, time, step)?;
    Ok((next, report))
}

/// [`step_linearly_implicit`] that changes `state` where it is: nothing large is handed over by value. Errors leave it as it was.
pub(crate) fn advance_linearly_implicit<S: StiffSystem<T>, T: RealField + Copy>(
    system: &S,
    state: &mut S::State,
    time: T,
    step: T,
) -> Result<StepReport<T>, StepError> {
    let h = begin(system, state, step)?;
    let half: T = nalgebra::convert(0.5);
    let two: T = nalgebra::convert(2.0);
    // γ = 1 - 1/√2: the L-stable choice with the smaller error constant
    let gamma_h = (T::one() - half.sqrt()) * h;

    let k1 = system.implicit_rates(time, state, &system.no_change(state), gamma_h, None)?;
    let mut whole = k1.clone();
    whole.scale(h);
    let mut twice = k1.clone();
    twice.scale(two);
    let k2 = system.implicit_rates(time + h, state, &whole, gamma_h, Some(&twice));
    let k2 = stage(system, time, state, true, k2)?;

    let mut slope = whole.clone();
    slope.scale(T::one() + half);
    slope.add_scaled(h * half, &k2);
    let mut error = slope.clone();
    error.add_scaled(-T::one(), &whole);
    arrive(system, time + h, state, &slope, &error, Some(gamma_h))
}
