//! What an integrator needs of a system, whether that is one free body, several, or a mechanism.

use nalgebra::RealField;

use super::Departure;
use super::step::{Drift, LocalError, StepError, Tolerances, checked_step_size};

/// Changes of a state: a vector space.
pub trait VectorSpace<T>: Clone {
    /// Adds `factor * other`.
    fn add_scaled(&mut self, factor: T, other: &Self);
    /// Multiplies by `factor`.
    fn scale(&mut self, factor: T);
    /// The sum of the products of all components, each in its own unit.
    fn dot(&self, other: &Self) -> T;
}

/// A system of ordinary differential equations on a space with rotations.
///
/// A step works with increments, vectors in the chart about the state at its beginning: sums where the state is a vector,
/// the Cayley map where it is a rotation. In the chart the equations are plain differential equations, so every method
/// keeps its order, and a rotation stays a rotation.
pub trait System<T: RealField + Copy> {
    /// Where the system is and how it moves.
    type State: Clone;
    /// A change of the state, or the rate of one.
    type Increment: VectorSpace<T>;

    /// Whether every number of the state is finite.
    fn is_finite(&self, state: &Self::State) -> bool;
    /// No change of `state`.
    fn no_change(&self, state: &Self::State) -> Self::Increment;
    /// The state that `increment` leads to from `origin`.
    fn retract(&self, origin: &Self::State, increment: &Self::Increment) -> Self::State;
    /// The rate of the increment in the chart about `origin`, at the state that `increment` leads to.
    ///
    /// Errors: no accelerations exist there, see [`StepError`].
    fn rates(
        &self,
        time: T,
        origin: &Self::State,
        increment: &Self::Increment,
    ) -> Result<Self::Increment, StepError>;
    /// The rate of the places alone at the state that `increment` leads to: velocities, no forces; rates of velocities zero.
    fn place_rates(&self, origin: &Self::State, increment: &Self::Increment) -> Self::Increment;
    /// Takes the places out of a change of the state: what is left changes velocities alone.
    fn velocities_only(&self, increment: &Self::Increment) -> Self::Increment;
    /// The size of `difference` by kind of coordinate: an estimate of the error of a step.
    fn local_error(&self, difference: &Self::Increment) -> LocalError<T>;
    /// The root mean square of `difference` over the tolerance of each component; below one is within tolerance.
    fn weighted_error(
        &self,
        state: &Self::State,
        difference: &Self::Increment,
        tolerances: &Tolerances<T>,
    ) -> T;

    /// Meets the constraints again at the end of a step and says how far it was from them; free bodies have none.
    ///
    /// `gamma_h`: of the last stage of a linearly implicit step, whose metric the correction then has. Units: s.
    ///
    /// Errors: the constraints cannot be met from here.
    fn settle(
        &self,
        time: T,
        state: Self::State,
        gamma_h: Option<T>,
    ) -> Result<(Self::State, Drift<T>), StepError> {
        let _ = (time, gamma_h);
        Ok((state, Drift::none()))
    }

    /// Whether the state at the end of a step has left what was planned; see [`Watched`](super::Watched).
    fn departure(&self, state: &Self::State) -> Departure {
        let _ = state;
        Departure::default()
    }

    /// The largest step of [`step_rk4`](super::step_rk4) that keeps the vibration bounded, if it is known. Units: s.
    fn largest_stable_step(&self) -> Option<T> {
        None
    }

    /// Why a step from `state`, which is finite, has led to no finite state: asked then only, good steps cost nothing.
    ///
    /// [`StepError::NonFiniteResult`] if nothing is wrong before the step.
    fn refusal(&self, time: T, state: &Self::State) -> StepError {
        match self.rates(time, state, &self.no_change(state)) {
            Err(error) => error,
            Ok(rates) if self.is_finite(&self.retract(state, &self.velocities_only(&rates))) => {
                too_large(self.largest_stable_step())
            }
            Ok(_) => StepError::NonFiniteAcceleration,
        }
    }
}

/// A system whose stiff part, modal stiffness and damping, can be taken implicitly.
pub trait StiffSystem<T: RealField + Copy>: System<T> {
    /// One stage of a Rosenbrock method: k of (I - γ h J) k = f - `subtracted`, at the state that `increment` leads to.
    ///
    /// J holds the modal stiffness and damping at that state, nothing else; with constraints, k keeps their velocity level
    /// to second order. `gamma_h`: s.
    ///
    /// Errors: see [`StepError`].
    fn implicit_rates(
        &self,
        time: T,
        origin: &Self::State,
        increment: &Self::Increment,
        gamma_h: T,
        subtracted: Option<&Self::Increment>,
    ) -> Result<Self::Increment, StepError>;
}

/// A correction of the accelerations at the end of an implicit step, see [`ImplicitSystem::correction`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Correction<I> {
    /// To add to the accelerations, at the places of the velocities' rates.
    pub accelerations: I,
    /// To add to the places, so that they meet the constraints when velocities are held to them as well; in the chart.
    pub places: Option<I>,
}

/// A system whose equations at the end of a step can be solved for the accelerations there.
pub trait ImplicitSystem<T: RealField + Copy>: StiffSystem<T> {
    /// One quasi-Newton correction of `accelerations` at the end of a step, in the state that `increment` leads to.
    ///
    /// Takes away the residual f - M `accelerations` - Gᵀ λ and that of the constraints, with the matrix of a linearly
    /// implicit stage; places change by `gamma_h`² and velocities by about `gamma_h` times a change of the accelerations.
    /// `accelerations`: of all that moves, at the places of the velocities' rates; zero elsewhere. Units: `gamma_h` s.
    ///
    /// Errors: see [`StepError`].
    fn correction(
        &self,
        time: T,
        origin: &Self::State,
        increment: &Self::Increment,
        accelerations: &Self::Increment,
        gamma_h: T,
    ) -> Result<Correction<Self::Increment>, StepError> {
        let subtracted = elastic_at_rest(self, origin, increment, accelerations);
        let rates = self.implicit_rates(time, origin, increment, gamma_h, Some(&subtracted))?;
        Ok(Correction { accelerations: self.velocities_only(&rates), places: None })
    }
}

/// A system whose equations are known between two states, such that momentum and energy are kept.
pub trait ConservingSystem<T: RealField + Copy>: System<T> {
    /// The change of the places over a step from `begin` in which velocities change by `velocities`; rates zero.
    fn conserving_places(
        &self,
        begin: &Self::State,
        velocities: &Self::Increment,
        step: T,
    ) -> Self::Increment;

    /// One quasi-Newton correction of the change of the velocities over a step, at the places of the velocities; the change
    /// of the places that belongs to `velocities` as they are beside it.
    ///
    /// Errors: see [`StepError`].
    fn conserving_correction(
        &self,
        time: T,
        begin: &Self::State,
        velocities: &Self::Increment,
        step: T,
    ) -> Result<Self::Increment, StepError>;
}

/// What a linearly implicit stage has to subtract, so that its right-hand side is the residual of `accelerations`: with
/// the rates of the places beside them its elastic forces do not look ahead.
pub(crate) fn elastic_at_rest<S: System<T> + ?Sized, T: RealField + Copy>(
    system: &S,
    origin: &S::State,
    increment: &S::Increment,
    accelerations: &S::Increment,
) -> S::Increment {
    let mut subtracted = system.place_rates(origin, increment);
    subtracted.add_scaled(T::one(), accelerations);
    subtracted
}

/// The places that a change of velocities leads to in unit time.
pub(crate) fn displaced<S: System<T> + ?Sized, T: RealField + Copy>(
    system: &S,
    origin: &S::State,
    velocities: &S::Increment,
) -> S::Increment {
    let mut places = system.place_rates(origin, velocities);
    places.add_scaled(-T::one(), &system.place_rates(origin, &system.no_change(origin)));
    places
}

/// The first thing every step does: the step size, if time can advance by it from `state`.
pub(super) fn begin<S: System<T>, T: RealField + Copy>(
    system: &S,
    state: &S::State,
    step: T,
) -> Result<T, StepError> {
    let step = checked_step_size(step)?;
    if system.is_finite(state) { Ok(step) } else { Err(StepError::NonFiniteState) }
}

/// Nothing is wrong before a step that has led to no finite state.
pub(crate) fn too_large<T: RealField + Copy>(largest_stable_step: Option<T>) -> StepError {
    StepError::NonFiniteResult { largest_stable_step: largest_stable_step.and_then(nalgebra::try_convert) }
}

/// Why a step from `state` has led to no finite state; the stable step of explicit methods is no limit to `implicit` ones.
#[cold]
pub(super) fn refusal<S: System<T>, T: RealField + Copy>(
    system: &S,
    time: T,
    state: &S::State,
    implicit: bool,
) -> StepError {
    match system.refusal(time, state) {
        StepError::NonFiniteResult { .. } if implicit => too_large::<T>(None),
        why => why,
    }
}

/// What a stage of a step has `found`: a mass matrix that is not positive definite within a step, though it was before,
/// comes of the step.
pub(super) fn stage<S: System<T>, T: RealField + Copy, R>(
    system: &S,
    time: T,
    state: &S::State,
    implicit: bool,
    found: Result<R, StepError>,
) -> Result<R, StepError> {
    match found {
        Err(StepError::MassNotPositive | StepError::BodyNotPositive { .. }) => {
            Err(refusal(system, time, state, implicit))
        }
        found => found,
    }
}

/// The last thing every step does: the new state with its report, or why there is none.
pub(super) fn finish<S: System<T>, T: RealField + Copy>(
    system: &S,
    time: T,
    origin: &S::State,
    slope: &S::Increment,
    error: &S::Increment,
    gamma_h: Option<T>,
) -> Result<(S::State, super::StepReport<T>), StepError> {
    let mut state = origin.clone();
    let report = arrive(system, time, &mut state, slope, error, gamma_h)?;
    Ok((state, report))
}

/// [`finish`] that changes `state`, the one before the step, where it is. Errors leave it as it was.
pub(super) fn arrive<S: System<T>, T: RealField + Copy>(
    system: &S,
    time: T,
    state: &mut S::State,
    slope: &S::Increment,
    error: &S::Increment,
    gamma_h: Option<T>,
) -> Result<super::StepReport<T>, StepError> {
    let next = system.retract(state, slope);
    if !system.is_finite(&next) {
        return Err(refusal(system, time, state, gamma_h.is_some()));
    }
    let (next, drift) = system.settle(time, next, gamma_h)?;
    if !system.is_finite(&next) {
        return Err(refusal(system, time, state, gamma_h.is_some()));
    }
    let (local_error, departure) = (system.local_error(error), system.departure(&next));
    *state = next;
    Ok(super::StepReport { local_error, drift, iterations: 0, departure })
}
