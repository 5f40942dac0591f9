//! What a mechanism is to the integrators: bodies, joints, loads and their numbers.

use nalgebra::RealField;

use super::{Connection, Constraints, ImplicitTerms, Level, Plan, Ports, Regularisation, Storage};
use crate::integrators::{Drift, LocalError, StepError, StiffSystem, System, Tolerances, VectorSpace};

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
}

impl<T: RealField + Copy> Treatment<T> {
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
    /// All bodies in one state.
    type Ports<'a>: Ports<T>
    where
        Self: 'a;

    /// The bodies in `state`, without forces.
    fn ports<'a>(
        &'a self,
        state: Self::State,
        implicit: Option<ImplicitTerms<'a, Self::Increment, T>>,
    ) -> Self::Ports<'a>;
    /// The rates of `increment`, which has led to the state of `ports`, from the resulting accelerations.
    fn collect(&self, ports: &Self::Ports<'_>, increment: &Self::Increment) -> Self::Increment;
    /// Applies the resulting motion of `ports` to their state: displacements, or changes of velocity.
    fn correct(&self, ports: &mut Self::Ports<'_>, level: Level);
    /// The state of `ports`.
    fn state(&self, ports: Self::Ports<'_>) -> Self::State;
    /// Numbers for one evaluation.
    fn with_storage<R>(&self, use_it: impl FnOnce(&mut Storage<'_, T>) -> R) -> R;

    /// Where everything stands.
    fn plan(&self) -> Plan<'_>;
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
    /// How constraints are kept.
    fn treatment(&self) -> Treatment<T>;
    /// How redundant rows are dealt with.
    fn regularisation(&self) -> Regularisation<T>;

    /// Whether every number of the state is finite.
    fn is_finite(&self, state: &Self::State) -> bool;
    /// No change of `state`.
    fn no_change(&self, state: &Self::State) -> Self::Increment;
    /// The state that `increment` leads to from `origin`.
    fn retract(&self, origin: &Self::State, increment: &Self::Increment) -> Self::State;
    /// See [`System::place_rates`].
    fn place_rates(&self, origin: &Self::State, increment: &Self::Increment) -> Self::Increment;
    /// See [`System::velocities_only`].
    fn velocities_only(&self, increment: &Self::Increment) -> Self::Increment;
    /// See [`System::local_error`].
    fn local_error(&self, difference: &Self::Increment) -> LocalError<T>;
    /// See [`System::weighted_error`].
    fn weighted_error(
        &self,
        state: &Self::State,
        difference: &Self::Increment,
        tolerances: &Tolerances<T>,
    ) -> T;
    /// See [`System::largest_stable_step`].
    fn largest_stable_step(&self) -> Option<T> {
        None
    }
}

/// A mechanism as a system that integrators advance.
#[derive(Debug, Clone, Copy)]
pub struct Constrained<'a, A>(pub &'a A);

impl<A> Constrained<'_, A> {
    /// Evaluates bodies, loads, joints and accelerations in one state and hands all of it to `read`.
    ///
    /// Errors: no accelerations exist.
    pub fn evaluate<T, R>(
        &self,
        time: T,
        state: A::State,
        implicit: Option<ImplicitTerms<'_, A::Increment, T>>,
        read: impl FnOnce(&A::Ports<'_>, &Storage<'_, T>, T) -> R,
    ) -> Result<R, StepError>
    where
        A: Assembly<T>,
        T: RealField + Copy,
    {
        let assembly = self.0;
        let gains = match assembly.treatment() {
            Treatment::Projection { .. } => [T::zero(); 2],
            Treatment::Baumgarte { alpha, beta } => [alpha + alpha, beta * beta],
        };
        let mut ports = assembly.ports(state, implicit);
        assembly.load(time, &mut ports);
        assembly.with_storage(|storage| {
            let mut constraints = Constraints {
                plan: assembly.plan(),
                connections: assembly.connections(),
                ports: &mut ports,
                storage,
                regularisation: assembly.regularisation(),
            };
            constraints.evaluate(&|joint| assembly.drive(joint, time));
            let pivot = constraints.factor()?;
            constraints.accelerate(gains);
            Ok(read(&ports, storage, pivot))
        })
    }

    /// Projects positions, then velocities, on the constraints; the drift is what was found before.
    ///
    /// One factorisation; the corrections are repeated with it, at most as often as the treatment says. After a linearly
    /// implicit step they must be measured by the matrix of its stages (`gamma_h`): measured by the mass matrix alone they
    /// push stiff modes, and the next step pushes back, without end. Errors: a residual is left.
    pub fn project<T>(
        &self,
        time: T,
        state: A::State,
        gamma_h: Option<T>,
        iterations: usize,
        tolerance: T,
    ) -> Result<(A::State, Drift<T>), StepError>
    where
        A: Assembly<T>,
        T: RealField + Copy,
    {
        let assembly = self.0;
        if assembly.connections().is_empty() {
            return Ok((state, Drift::none()));
        }
        let round_off: T = T::default_epsilon() * nalgebra::convert(16.0);
        let implicit = gamma_h.map(|gamma_h| ImplicitTerms { gamma_h, subtracted: None });
        let mut ports = assembly.ports(state, implicit);
        let drift = assembly.with_storage(|storage| {
            let drive = |joint| assembly.drive(joint, time);
            let mut drift = None;
            let mut left = ([T::zero(); 2], 0);
            for level in [Level::Position, Level::Velocity] {
                for iteration in 0..=iterations {
                    let mut constraints = Constraints {
                        plan: assembly.plan(),
                        connections: assembly.connections(),
                        ports: &mut ports,
                        storage: &mut *storage,
                        regularisation: assembly.regularisation(),
                    };
                    constraints.evaluate(&drive);
                    let residuals = constraints.residuals();
                    if drift.is_none() {
                        drift = Some(Drift { position: residuals.0[0], velocity: residuals.0[1] });
                        constraints.factor()?;
                    }
                    left = residuals;
                    let open = if level == Level::Position { left.0[0] } else { left.0[1] };
                    if open <= round_off || iteration == iterations {
                        break;
                    }
                    constraints.correct(level);
                    assembly.correct(&mut ports, level);
                }
            }
            if left.0[0] <= tolerance {
                Ok(drift.unwrap_or(Drift::none()))
            } else {
                let residual = nalgebra::try_convert(left.0[0]).unwrap_or(f64::NAN);
                Err(StepError::ConstraintsNotMet { joint: left.1, residual })
            }
        })?;
        Ok((assembly.state(ports), drift))
    }
}

impl<A: Assembly<T>, T: RealField + Copy> System<T> for Constrained<'_, A> {
    type State = A::State;
    type Increment = A::Increment;

    fn is_finite(&self, state: &Self::State) -> bool {
        self.0.is_finite(state)
    }

    fn no_change(&self, state: &Self::State) -> Self::Increment {
        self.0.no_change(state)
    }

    fn retract(&self, origin: &Self::State, increment: &Self::Increment) -> Self::State {
        self.0.retract(origin, increment)
    }

    fn rates(
        &self,
        time: T,
        origin: &Self::State,
        increment: &Self::Increment,
    ) -> Result<Self::Increment, StepError> {
        let state = self.0.retract(origin, increment);
        self.evaluate(time, state, None, |ports, _, _| self.0.collect(ports, increment))
    }

    fn place_rates(&self, origin: &Self::State, increment: &Self::Increment) -> Self::Increment {
        self.0.place_rates(origin, increment)
    }

    fn velocities_only(&self, increment: &Self::Increment) -> Self::Increment {
        self.0.velocities_only(increment)
    }

    fn local_error(&self, difference: &Self::Increment) -> LocalError<T> {
        self.0.local_error(difference)
    }

    fn weighted_error(
        &self,
        state: &Self::State,
        difference: &Self::Increment,
        tolerances: &Tolerances<T>,
    ) -> T {
        self.0.weighted_error(state, difference, tolerances)
    }

    fn settle(
        &self,
        time: T,
        state: Self::State,
        gamma_h: Option<T>,
    ) -> Result<(Self::State, Drift<T>), StepError> {
        match self.0.treatment() {
            Treatment::Projection { iterations, tolerance } => {
                self.project(time, state, gamma_h, iterations, tolerance)
            }
            Treatment::Baumgarte { .. } => {
                // nothing is corrected: the drift is reported
                let drift =
                    self.project(time, state.clone(), gamma_h, 0, T::max_value().unwrap_or(T::one()))?.1;
                Ok((state, drift))
            }
        }
    }

    fn largest_stable_step(&self) -> Option<T> {
        self.0.largest_stable_step()
    }
}

impl<A: Assembly<T>, T: RealField + Copy> StiffSystem<T> for Constrained<'_, A> {
    fn implicit_rates(
        &self,
        time: T,
        origin: &Self::State,
        increment: &Self::Increment,
        gamma_h: T,
        subtracted: Option<&Self::Increment>,
    ) -> Result<Self::Increment, StepError> {
        let state = self.0.retract(origin, increment);
        let implicit = Some(ImplicitTerms { gamma_h, subtracted });
        self.evaluate(time, state, implicit, |ports, _, _| self.0.collect(ports, increment))
    }
}
