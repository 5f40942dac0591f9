//! A mechanism as a system that integrators advance.

use nalgebra::RealField;

use super::{
    Assembly, Constraints, Equations, ImplicitTerms, Level, Phase, Plan, Ports, Storage, Target, Treatment,
};
use crate::integrators::{
    ConservingSystem, Correction, Drift, ExponentialSystem, Forcing, ImplicitSystem, LocalError, StepError,
    StiffSystem, System, Tolerances, displaced, elastic_at_rest,
};

/// A mechanism as a system that integrators advance.
#[derive(Debug, Clone, Copy)]
pub struct Constrained<'a, A>(pub &'a A);

/// What an evaluation is asked for.
#[derive(Clone, Copy)]
enum Asked<'e, T> {
    /// Motion and reactions.
    All,
    /// The motion alone.
    Motion,
    /// The motion with friction that was found before; what is subtracted would take its share out of the reactions.
    MotionWith(&'e [T]),
}

/// Which equations a mechanism has with its soft links, or without.
#[inline(always)]
pub(super) fn equations<A: Assembly<T>, T: RealField + Copy>(assembly: &A, soft: bool) -> Equations {
    if soft { Equations::SoftRows } else { assembly.plan().equations() }
}

/// The joints of a mechanism on its bodies in one state. `supported`: whether bodies may stand on their supports.
pub(super) fn constraints<'a, 's, A: Assembly<T>, T: RealField + Copy>(
    assembly: &'a A,
    ports: &'a mut A::Ports<'_>,
    storage: &'a mut Storage<'s, T>,
    equations: Equations,
    supported: bool,
) -> Constraints<'a, 's, T> {
    let plan = match equations {
        Equations::SoftRows => Plan { branches: &[], ..assembly.soft_plan() },
        Equations::Tree => assembly.plan(),
        Equations::Rows => Plan { branches: &[], ..assembly.plan() },
    };
    Constraints {
        plan,
        connections: assembly.connections(),
        ports,
        storage,
        regularisation: assembly.regularisation(),
        // soft rows are those of bodies that move freely
        supported: supported && equations == Equations::Rows,
    }
}

impl<A> Constrained<'_, A> {
    /// Evaluates bodies, loads, joints and accelerations in one state and hands all of it to `read`.
    ///
    /// Errors: no accelerations exist.
    pub fn evaluate<T, R>(
        &self,
        time: T,
        state: A::State,
        implicit: Option<ImplicitTerms<'_, A::Increment, T>>,
        read: impl FnOnce(&A::Ports<'_>, &Storage<'_, T>) -> R,
    ) -> Result<R, StepError>
    where
        A: Assembly<T>,
        T: RealField + Copy,
    {
        let target = self.0.treatment().target();
        self.solve(time, state, implicit, target, Asked::All, |ports, storage| read(ports, storage))
    }

    /// [`evaluate`](Self::evaluate) for a target, with everything still open for further right-hand sides.
    ///
    /// `asked`: see [`Asked`].
    fn solve<T, R>(
        &self,
        time: T,
        state: A::State,
        implicit: Option<ImplicitTerms<'_, A::Increment, T>>,
        target: Target<T>,
        asked: Asked<'_, T>,
        read: impl FnOnce(&mut A::Ports<'_>, &mut Storage<'_, T>) -> R,
    ) -> Result<R, StepError>
    where
        A: Assembly<T>,
        T: RealField + Copy,
    {
        let assembly = self.0;
        let soft = implicit.filter(|terms| terms.chart.is_some()).map(|terms| terms.gamma_h);
        let mut rooms = assembly.rooms();
        let mut ports = assembly.ports(&mut rooms, state, implicit);
        assembly.load(time, &mut ports);
        let equations = equations(assembly, soft.is_some());
        // friction asks for reactions
        let supported = matches!(asked, Asked::Motion) && assembly.friction(0).is_none();
        assembly.with_storage(equations, |storage| {
            let mut constraints = constraints(assembly, &mut ports, storage, equations, supported);
            constraints.evaluate(&|joint| assembly.drive(joint, time));
            if let Some(gamma_h) = soft {
                constraints.soften(assembly, gamma_h);
            }
            constraints.factor()?;
            if let Asked::MotionWith(efforts) = asked {
                constraints.rub_as(assembly, efforts);
                constraints.accelerate(target);
            } else {
                constraints.accelerate(target);
                constraints.rub(assembly, target, T::one())?;
            }
            Ok(read(&mut ports, storage))
        })
    }

    /// [`StiffSystem::implicit_rates`] by the general equations, at `state`, to which `increment` has led.
    ///
    /// Errors: see [`StepError`].
    pub fn implicit_rates_at<T>(
        &self,
        time: T,
        state: A::State,
        increment: &A::Increment,
        gamma_h: T,
        subtracted: Option<&A::Increment>,
    ) -> Result<A::Increment, StepError>
    where
        A: Assembly<T>,
        T: RealField + Copy,
    {
        let chart = self.0.soft(0).map(|_| increment);
        let implicit = Some(ImplicitTerms { gamma_h, subtracted, chart });
        let target = self.0.treatment().target();
        if self.0.friction(0).is_none() {
            return self.solve(time, state, implicit, target, Asked::Motion, |ports, _| {
                self.0.collect(ports, increment)
            });
        }
        // multipliers of what is left after a subtraction are no reactions: those of the whole are found first, of this
        // stage and of one half as long, which tells them at the state itself
        let whole = |gamma_h| Some(ImplicitTerms { gamma_h, subtracted: None, chart });
        let half: T = nalgebra::convert(0.5);
        self.solve(time, state.clone(), whole(gamma_h), target, Asked::All, |_, far| {
            self.solve(time, state.clone(), whole(gamma_h * half), target, Asked::All, |_, near| {
                for (near, far) in near.efforts.iter_mut().zip(far.efforts.iter()) {
                    *near = extrapolated(*near, *far);
                }
                let efforts = Asked::MotionWith(near.efforts);
                self.solve(time, state, implicit, target, efforts, |ports, _| {
                    self.0.collect(ports, increment)
                })
            })?
        })?
    }

    /// The bodies in a step of the energy-momentum method.
    fn in_step<'a, T>(
        &'a self,
        rooms: &'a mut A::Rooms,
        begin: &A::State,
        velocities: &'a A::Increment,
        step: T,
    ) -> A::Ports<'a>
    where
        A: Assembly<T>,
        T: RealField + Copy,
    {
        let gamma_h = step * nalgebra::convert(0.5);
        let implicit = Some(ImplicitTerms { gamma_h, subtracted: Some(velocities), chart: None });
        let mut ports = self.0.ports(rooms, begin.clone(), implicit);
        for index in 0..self.0.plan().bodies.len() {
            if let Some(port) = ports.port_mut(index) {
                port.conserve(Phase::Mean);
            }
        }
        ports
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
        if let Some(rates) = self.0.straight_rates(time, &state, increment) {
            return Ok(rates);
        }
        let target = self.0.treatment().target();
        self.solve(time, state, None, target, Asked::Motion, |ports, _| self.0.collect(ports, increment))
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
                if let Some(projected) = self.projected_straight(time, &state, gamma_h, iterations)
                    && projected.meets(tolerance)
                {
                    let [position, velocity] = projected.before;
                    return Ok((projected.state, Drift { position, velocity }));
                }
                self.project(time, state, gamma_h, iterations, tolerance)
            }
            Treatment::Baumgarte { .. } | Treatment::Index3 | Treatment::StabilisedIndex2 => {
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

/// Friction at a state, from that of a stage of half the length and that of the whole one: to second order where modes are
/// resolved, at most twice as much where they are not, and never in the direction of the motion.
fn extrapolated<T: RealField + Copy>(near: T, far: T) -> T {
    let effort = near + (near - far);
    if effort * near > T::zero() { effort } else { T::zero() }
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
        if let Some(rates) = self.0.straight_implicit_rates(time, &state, increment, gamma_h, subtracted) {
            return Ok(rates);
        }
        self.implicit_rates_at(time, state, increment, gamma_h, subtracted)
    }
}

impl<A: Assembly<T>, T: RealField + Copy> ImplicitSystem<T> for Constrained<'_, A> {
    fn correction(
        &self,
        time: T,
        origin: &Self::State,
        increment: &Self::Increment,
        accelerations: &Self::Increment,
        gamma_h: T,
    ) -> Result<Correction<Self::Increment>, StepError> {
        let assembly = self.0;
        let state = assembly.retract(origin, increment);
        let subtracted = elastic_at_rest(self, origin, increment, accelerations);
        let treatment = assembly.treatment();
        if let Treatment::Projection { .. } = treatment
            && let Some(rates) =
                assembly.straight_implicit_rates(time, &state, increment, gamma_h, Some(&subtracted))
        {
            return Ok(Correction { accelerations: assembly.velocities_only(&rates), places: None });
        }
        let chart = assembly.soft(0).map(|_| increment);
        let implicit = Some(ImplicitTerms { gamma_h, subtracted: Some(&subtracted), chart });
        let target = match treatment {
            Treatment::Index3 => Target::Position { share: gamma_h * gamma_h },
            Treatment::StabilisedIndex2 => Target::Velocity { share: gamma_h },
            Treatment::Projection { .. } | Treatment::Baumgarte { .. } => treatment.target(),
        };
        self.solve(time, state, implicit, target, Asked::Motion, |ports, storage| {
            let supported = assembly.friction(0).is_none();
            let accelerations = assembly.velocities_only(&assembly.collect(ports, increment));
            let places = matches!(treatment, Treatment::StabilisedIndex2).then(|| {
                let mut constraints =
                    constraints(assembly, ports, storage, equations(assembly, chart.is_some()), supported);
                constraints.correct(Level::Position);
                let moved = assembly.velocities_only(&assembly.collect(ports, increment));
                displaced(self, origin, &moved)
            });
            Correction { accelerations, places }
        })
    }
}

impl<A: Assembly<T>, T: RealField + Copy> ConservingSystem<T> for Constrained<'_, A> {
    fn conserving_places(
        &self,
        begin: &Self::State,
        velocities: &Self::Increment,
        step: T,
    ) -> Self::Increment {
        let mut rooms = self.0.rooms();
        let ports = self.in_step(&mut rooms, begin, velocities, step);
        self.0.collect(&ports, velocities)
    }

    fn conserving_correction(
        &self,
        time: T,
        begin: &Self::State,
        velocities: &Self::Increment,
        step: T,
    ) -> Result<Self::Increment, StepError> {
        let assembly = self.0;
        let half = step * nalgebra::convert(0.5);
        let mut rooms = self.0.rooms();
        let mut ports = self.in_step(&mut rooms, begin, velocities, step);
        assembly.with_storage(Equations::Rows, |storage| {
            for phase in [Phase::End, Phase::Mean] {
                for index in 0..assembly.plan().bodies.len() {
                    if let Some(port) = ports.port_mut(index) {
                        port.conserve(phase);
                    }
                }
                if phase == Phase::Mean {
                    assembly.load(time + half, &mut ports);
                }
                let mut constraints = constraints(assembly, &mut ports, storage, Equations::Rows, false);
                constraints.plan.elimination.of_instant = false;
                let moment = if phase == Phase::End { step } else { half };
                constraints.evaluate(&|joint| assembly.drive(joint, time + moment));
                match phase {
                    Phase::End => constraints.aim(half),
                    Phase::Mean => {
                        constraints.take_aim();
                        constraints.factor()?;
                        constraints.accelerate(Target::Aimed);
                        constraints.rub(assembly, Target::Aimed, T::one() / step)?;
                    }
                }
            }
            Ok(assembly.collect(&ports, velocities))
        })
    }
}

impl<A: Assembly<T>, T: RealField + Copy> ExponentialSystem<T> for Constrained<'_, A> {
    type Modes = A::Modes;

    fn modes(&self, step: T) -> Result<A::Modes, StepError> {
        self.0.modes(step).ok_or(StepError::ModesNotSeparate)
    }

    fn vibration_rates(&self, modes: &A::Modes, state: &Self::State) -> Self::Increment {
        self.0.vibration_rates(modes, state)
    }

    fn free_vibration(&self, modes: &A::Modes, state: &Self::State) -> Self::Increment {
        self.0.free_vibration(modes, state)
    }

    fn forced_vibration(
        &self,
        modes: &A::Modes,
        rates: &Self::Increment,
        forcing: Forcing,
    ) -> Self::Increment {
        self.0.forced_vibration(modes, rates, forcing)
    }
}
