//! A mechanism with a load of its user's own.

use nalgebra::RealField;

use super::{
    Assembly, Connection, Energy, Equations, ImplicitTerms, JointFriction, Level, Momentum, Plan,
    Regularisation, SoftLink, Storage, Treatment,
};
use crate::integrators::{Forcing, LocalError, Tolerances};

/// A mechanism on which `load` acts besides the forces that it has; the same in everything else.
///
/// `load(mechanism, time, ports)` adds forces at `time` (s) to the bodies in `ports`, whose states it sees: all of them. It is
/// called a few times per step, also at states that no step accepts; with the same arguments it must add the same forces.
/// Closures may capture: what changes between steps is captured anew, or by reference.
///
/// ```ignore
/// let wind = Loaded::new(&model, |_: &Crane, time, ports: &mut CranePorts<'_>| ports.boom.push_at(&Boom::TIP, &gust(time)));
/// let (state, report) = step_rk4(&Constrained(&wind), &state, time, step)?;      // or Mechanism::new(wind, state)
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Loaded<'a, A, L> {
    /// The mechanism.
    pub assembly: &'a A,
    /// What acts on it.
    pub load: L,
}

impl<'a, A, L> Loaded<'a, A, L> {
    /// A mechanism with this load.
    pub fn new<T>(assembly: &'a A, load: L) -> Self
    where
        A: Assembly<T>,
        L: Fn(&A, T, &mut A::Ports<'_>),
        T: RealField + Copy,
    {
        Self { assembly, load }
    }
}

impl<A: Assembly<T>, L, T: RealField + Copy> Assembly<T> for Loaded<'_, A, L>
where
    L: Fn(&A, T, &mut A::Ports<'_>),
{
    type State = A::State;
    type Increment = A::Increment;
    type Modes = A::Modes;
    type Ports<'p>
        = A::Ports<'p>
    where
        Self: 'p;

    fn load(&self, time: T, ports: &mut A::Ports<'_>) {
        self.assembly.load(time, ports);
        (self.load)(self.assembly, time, ports);
    }

    type Rooms = A::Rooms;

    fn rooms(&self) -> A::Rooms {
        self.assembly.rooms()
    }

    fn ports<'p>(
        &'p self,
        rooms: &'p mut A::Rooms,
        state: A::State,
        implicit: Option<ImplicitTerms<'p, A::Increment, T>>,
    ) -> A::Ports<'p> {
        self.assembly.ports(rooms, state, implicit)
    }

    fn collect(&self, ports: &A::Ports<'_>, increment: &A::Increment) -> A::Increment {
        self.assembly.collect(ports, increment)
    }

    fn correct(&self, ports: &mut A::Ports<'_>, level: Level) {
        self.assembly.correct(ports, level);
    }

    fn state(&self, ports: A::Ports<'_>) -> A::State {
        self.assembly.state(ports)
    }

    fn with_storage<R>(&self, equations: Equations, use_it: impl FnOnce(&mut Storage<'_, T>) -> R) -> R {
        self.assembly.with_storage(equations, use_it)
    }

    fn plan(&self) -> Plan<'_> {
        self.assembly.plan()
    }

    fn soft_plan(&self) -> Plan<'_> {
        self.assembly.soft_plan()
    }

    fn soft(&self, index: usize) -> Option<SoftLink<'_, T>> {
        self.assembly.soft(index)
    }

    fn energy(&self, state: &A::State) -> Energy<T> {
        self.assembly.energy(state)
    }

    fn momentum(&self, state: &A::State) -> Momentum<T> {
        self.assembly.momentum(state)
    }

    fn connections(&self) -> &[Connection<T>] {
        self.assembly.connections()
    }

    fn joint_name(&self, joint: usize) -> &'static str {
        self.assembly.joint_name(joint)
    }

    fn drive(&self, joint: usize, time: T) -> [T; 3] {
        self.assembly.drive(joint, time)
    }

    fn friction(&self, index: usize) -> Option<JointFriction<T>> {
        self.assembly.friction(index)
    }

    fn treatment(&self) -> Treatment<T> {
        self.assembly.treatment()
    }

    fn regularisation(&self) -> Regularisation<T> {
        self.assembly.regularisation()
    }

    fn is_finite(&self, state: &A::State) -> bool {
        self.assembly.is_finite(state)
    }

    fn no_change(&self, state: &A::State) -> A::Increment {
        self.assembly.no_change(state)
    }

    fn retract(&self, origin: &A::State, increment: &A::Increment) -> A::State {
        self.assembly.retract(origin, increment)
    }

    fn place_rates(&self, origin: &A::State, increment: &A::Increment) -> A::Increment {
        self.assembly.place_rates(origin, increment)
    }

    fn velocities_only(&self, increment: &A::Increment) -> A::Increment {
        self.assembly.velocities_only(increment)
    }

    fn local_error(&self, difference: &A::Increment) -> LocalError<T> {
        self.assembly.local_error(difference)
    }

    fn weighted_error(&self, state: &A::State, difference: &A::Increment, tolerances: &Tolerances<T>) -> T {
        self.assembly.weighted_error(state, difference, tolerances)
    }

    fn largest_stable_step(&self) -> Option<T> {
        self.assembly.largest_stable_step()
    }

    fn modes(&self, step: T) -> Option<A::Modes> {
        self.assembly.modes(step)
    }

    fn vibration_rates(&self, modes: &A::Modes, state: &A::State) -> A::Increment {
        self.assembly.vibration_rates(modes, state)
    }

    fn free_vibration(&self, modes: &A::Modes, state: &A::State) -> A::Increment {
        self.assembly.free_vibration(modes, state)
    }

    fn forced_vibration(&self, modes: &A::Modes, rates: &A::Increment, forcing: Forcing) -> A::Increment {
        self.assembly.forced_vibration(modes, rates, forcing)
    }
}
