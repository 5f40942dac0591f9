//! One step of the integrator that a scene names, in any number type.

use ffrf_runtime::mechanism::Constrained;
use ffrf_runtime::{
    AlphaMemory, EnergyMomentum, GeneralisedAlpha, RadauIIA, State, StepError, StepReport, System,
    Tolerances, step_dormand_prince, step_exponential, step_linearly_implicit, step_linearly_implicit_euler,
    step_rk4, step_symplectic_euler,
};

use nalgebra::{RealField, convert};

use crate::mechanism::HostIncrement;
use crate::scene::{Integrator, Settings};
use crate::{HostMechanism, HostModal};

/// The states of all bodies.
pub type States<T = f64> = Vec<State<HostModal<T>, T>>;

/// Absolute tolerance of a component over the relative one, in units of that component (m, rad, m/s, ...).
const ABSOLUTE_SHARE: f64 = 1e-2;

/// The tolerances of an error-controlled integrator, from the relative one of a scene.
pub(crate) fn tolerances<T: RealField + Copy>(relative: f64) -> Tolerances<T> {
    Tolerances { relative: convert(relative), absolute: convert(relative * ABSOLUTE_SHARE) }
}

/// One step of a fixed size in absolute coordinates. `memory`: what the generalised-α method remembers of its last step.
///
/// Errors: see [`StepError`].
pub(crate) fn step_in_space<T: RealField + Copy>(
    mechanism: &HostMechanism<T>,
    settings: &Settings,
    memory: &mut Option<AlphaMemory<HostIncrement<T>>>,
    state: &States<T>,
    time: T,
    step: T,
) -> Result<(States<T>, StepReport<T>), StepError> {
    let system = &Constrained(mechanism);
    match settings.integrator {
        Integrator::SymplecticEuler | Integrator::Rk4 | Integrator::Dopri5 => {
            explicit_step(settings.integrator, system, state, time, step)
        }
        Integrator::LinearlyImplicit => step_linearly_implicit(system, state, time, step),
        Integrator::LinearlyImplicitEuler => step_linearly_implicit_euler(system, state, time, step),
        Integrator::GeneralizedAlpha => {
            let spectral_radius = convert(settings.spectral_radius);
            let method = GeneralisedAlpha { spectral_radius, ..GeneralisedAlpha::new() };
            let memory = match memory {
                Some(memory) => memory,
                none => none.insert(method.start(system, state, time, step)?),
            };
            method.step(system, memory, state, time, step)
        }
        Integrator::EnergyMomentum => EnergyMomentum::new().step(system, state, time, step),
        Integrator::Exponential => step_exponential(system, state, time, step),
        Integrator::Radau5 => RadauIIA::order_five().step(system, state, time, step),
        Integrator::Radau7 => RadauIIA::order_seven().step(system, state, time, step),
    }
}

/// One step of an explicit integrator; the classical Runge-Kutta method for all that are not named here.
///
/// Errors: see [`StepError`].
pub(super) fn explicit_step<T: RealField + Copy, S: System<T>>(
    integrator: Integrator,
    system: &S,
    state: &S::State,
    time: T,
    step: T,
) -> Result<(S::State, StepReport<T>), StepError> {
    match integrator {
        Integrator::SymplecticEuler => step_symplectic_euler(system, state, time, step),
        Integrator::Dopri5 => step_dormand_prince(system, state, time, step),
        _ => step_rk4(system, state, time, step),
    }
}
