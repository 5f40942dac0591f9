//! What a mechanism is to the integrators: bodies, joints, loads and their numbers.

use nalgebra::RealField;

use super::{
    Connection, Energy, Equations, ImplicitTerms, JointFriction, Level, Momentum, Plan, Ports, Projected,
    Regularisation, SoftLink, Storage, Target,
};
use crate::integrators::{Forcing, LocalError, Tolerances, VectorSpace};

/// How constraints are kept while time advances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Treatment<T = f64> {
    /// Accelerations keep the constraints; after each step positions and velocities are projected back. The default.
    Projection {
        /// Most corrections of each level per step.
        iterations: usize,
        /// Residual that a step may be left with, else it is refused. Units: m or rad.
        tolerance: T,
    },
    /// Accelerations draw residuals back like damped springs; nothing is projected (Baumgarte, 1972).
    Baumgarte {
        /// Damping α. Units: 1/s.
        alpha: T,
        /// Stiffness β. Units: 1/s.
        beta: T,
    },
    /// The positions at the end of each step meet the constraints, nothing else is held (index 3). For implicit steps.
    Index3,
    /// Positions and velocities at the end of each step meet the constraints (index 2). For implicit steps.
    ///
    /// Source: Gear, Leimkuhler, Gupta, Automatic integration of Euler-Lagrange equations with constraints, J. Comp. Appl.
    /// Math. 12-13 (1985) 77-90.
    StabilisedIndex2,
}

impl<T: RealField + Copy> Treatment<T> {
    /// What accelerations do to the residuals. The default for all but Baumgarte's: to keep their rates as they are.
    pub(super) fn target(&self) -> Target<T> {
        let gains = match self {
            Self::Baumgarte { alpha, beta } => [*alpha + *alpha, *beta * *beta],
            _ => [T::zero(); 2],
        };
        Target::Acceleration { gains }
    }

    /// The default: projection with at most eight corrections; 1e-6 (1e-4 in single precision) may be left.
    pub fn projection() -> Self {
        let tolerance = if T::default_epsilon() < nalgebra::convert(1e-10) { 1e-6 } else { 1e-4 };
        Self::Projection { iterations: 8, tolerance: nalgebra::convert(tolerance) }
    }
}

/// A mechanism composed at compile time or read from a file.
pub trait Assembly<T: RealField + Copy> {
    /// The states of all bodies.
    type State: Clone;
    /// A change of all states.
    type Increment: VectorSpace<T>;
    /// The answers of all modes within one step size; `()` where they do not vibrate each on its own.
    type Modes;
    /// All bodies in one state.
    type Ports<'a>: Ports<T>
    where
        Self: 'a;

    /// Room for what the equations need of all bodies: one [`Room`](super::Room) for each, absent until there is a port.
    type Rooms;

    /// Room for the bodies of one evaluation.
    fn rooms(&self) -> Self::Rooms;
    /// The bodies in `state`, without forces. What was in their rooms is replaced.
    fn ports<'a>(
        &'a self,
        rooms: &'a mut Self::Rooms,
        state: Self::State,
        implicit: Option<ImplicitTerms<'a, Self::Increment, T>>,
    ) -> Self::Ports<'a>;
    /// The rates of `increment`, which has led to the state of `ports`, from the resulting accelerations.
    fn collect(&self, ports: &Self::Ports<'_>, increment: &Self::Increment) -> Self::Increment;
    /// What [`collect`](Self::collect) gives for `state`, to which `increment` has led, from code that holds the whole
    /// mechanism at once; `None` if there is none or it does not hold in this state: the general equations are then solved.
    ///
    /// Explicit evaluations ask for it, [`System::rates`](crate::integrators::System::rates); nothing else does.
    #[inline(always)]
    fn straight_rates(
        &self,
        time: T,
        state: &Self::State,
        increment: &Self::Increment,
    ) -> Option<Self::Increment> {
        let _ = (time, state, increment);
        None
    }
    /// What [`StiffSystem::implicit_rates`](crate::integrators::StiffSystem::implicit_rates) gives at `state`, to which
    /// `increment` has led, where joints are kept by [`Treatment::Projection`], from code that holds the whole mechanism at once;
    /// `None` as in [`straight_rates`](Self::straight_rates). `gamma_h`: s.
    ///
    /// Linearly implicit stages ask for it, and where joints are so kept corrections of implicit methods do.
    #[inline(always)]
    fn straight_implicit_rates(
        &self,
        time: T,
        state: &Self::State,
        increment: &Self::Increment,
        gamma_h: T,
        subtracted: Option<&Self::Increment>,
    ) -> Option<Self::Increment> {
        let _ = (time, state, increment, gamma_h, subtracted);
        None
    }
    /// What [`Constrained::correct_once`](super::Constrained::correct_once) makes of a state, from code that holds the whole
    /// mechanism at once; `None` as in [`straight_rates`](Self::straight_rates).
    ///
    /// Steps ask for it where joints are kept by [`Treatment::Projection`]. `gamma_h`: of linearly implicit stages (s), none of
    /// explicit ones.
    #[inline(always)]
    fn straight_projection(
        &self,
        time: T,
        state: &Self::State,
        gamma_h: Option<T>,
    ) -> Option<Projected<Self::State, T>> {
        let _ = (time, state, gamma_h);
        None
    }
    /// Applies the resulting motion of `ports` to their state: displacements, or changes of velocity.
    fn correct(&self, ports: &mut Self::Ports<'_>, level: Level);
    /// The state of `ports`.
    fn state(&self, ports: Self::Ports<'_>) -> Self::State;
    /// Numbers for one evaluation by these equations.
    fn with_storage<R>(&self, equations: Equations, use_it: impl FnOnce(&mut Storage<'_, T>) -> R) -> R;

    /// Where everything stands.
    fn plan(&self) -> Plan<'_>;
    /// Where everything stands in evaluations with soft rows: [`plan`](Self::plan) with soft links behind the joints.
    fn soft_plan(&self) -> Plan<'_> {
        self.plan()
    }
    /// Force elements that implicit steps take into their matrix, counted from zero without gaps.
    fn soft(&self, index: usize) -> Option<SoftLink<'_, T>> {
        let _ = index;
        None
    }
    /// The joints.
    fn connections(&self) -> &[Connection<T>];
    /// The name of a joint, for reports; empty where names come at run time.
    fn joint_name(&self, joint: usize) -> &'static str {
        let _ = joint;
        ""
    }
    /// Value, rate and acceleration of the drive of a joint; zeros for joints without one.
    fn drive(&self, joint: usize, time: T) -> [T; 3];
    /// Adds the forces at `time`.
    fn load(&self, time: T, ports: &mut Self::Ports<'_>);
    /// Friction that follows reactions, counted from zero without gaps.
    fn friction(&self, index: usize) -> Option<JointFriction<T>> {
        let _ = index;
        None
    }
    /// How constraints are kept.
    fn treatment(&self) -> Treatment<T>;
    /// How redundant rows are dealt with.
    fn regularisation(&self) -> Regularisation<T>;

    /// Energy in `state`; that of forces of the user's own is not known.
    fn energy(&self, state: &Self::State) -> Energy<T>;
    /// Momentum in `state`.
    fn momentum(&self, state: &Self::State) -> Momentum<T>;
    /// Whether every number of the state is finite.
    fn is_finite(&self, state: &Self::State) -> bool;
    /// No change of `state`.
    fn no_change(&self, state: &Self::State) -> Self::Increment;
    /// The state that `increment` leads to from `origin`.
    fn retract(&self, origin: &Self::State, increment: &Self::Increment) -> Self::State;
    /// See [`System::place_rates`](crate::integrators::System::place_rates).
    fn place_rates(&self, origin: &Self::State, increment: &Self::Increment) -> Self::Increment;
    /// See [`System::velocities_only`](crate::integrators::System::velocities_only).
    fn velocities_only(&self, increment: &Self::Increment) -> Self::Increment;
    /// See [`System::local_error`](crate::integrators::System::local_error).
    fn local_error(&self, difference: &Self::Increment) -> LocalError<T>;
    /// See [`System::weighted_error`](crate::integrators::System::weighted_error).
    fn weighted_error(
        &self,
        state: &Self::State,
        difference: &Self::Increment,
        tolerances: &Tolerances<T>,
    ) -> T;
    /// See [`System::largest_stable_step`](crate::integrators::System::largest_stable_step).
    fn largest_stable_step(&self) -> Option<T> {
        None
    }

    /// See [`ExponentialSystem::modes`](crate::integrators::ExponentialSystem::modes); `None` if modes do not vibrate each on
    /// its own, as where joints hold what they move. `step`: s.
    fn modes(&self, step: T) -> Option<Self::Modes> {
        let _ = step;
        None
    }
    /// See [`ExponentialSystem::vibration_rates`](crate::integrators::ExponentialSystem::vibration_rates); for those that have
    /// [`modes`](Self::modes).
    fn vibration_rates(&self, modes: &Self::Modes, state: &Self::State) -> Self::Increment {
        let _ = modes;
        self.no_change(state)
    }
    /// See [`ExponentialSystem::free_vibration`](crate::integrators::ExponentialSystem::free_vibration).
    fn free_vibration(&self, modes: &Self::Modes, state: &Self::State) -> Self::Increment {
        let _ = modes;
        self.no_change(state)
    }
    /// See [`ExponentialSystem::forced_vibration`](crate::integrators::ExponentialSystem::forced_vibration).
    fn forced_vibration(
        &self,
        modes: &Self::Modes,
        rates: &Self::Increment,
        forcing: Forcing,
    ) -> Self::Increment {
        let _ = (modes, forcing);
        rates.clone()
    }
}
