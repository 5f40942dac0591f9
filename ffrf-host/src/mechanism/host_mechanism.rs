//! A mechanism whose bodies, joints and forces come at run time.

mod cast;

use ffrf_codegen::mechanism::{JointTopology, Topology, TopologyError};
use ffrf_runtime::mechanism::{
    Assembly, BodyPort, Connection, Energy, Equations, ImplicitTerms, JointFriction, KeptModes, Level,
    Momentum, Plan, Port, Regularisation, SoftLink, Storage, Treatment,
};
use ffrf_runtime::{
    FlexibleBody, Forcing, Increment, LocalError, Marker, ModalVector, Oscillators, State, Tolerances,
};
use nalgebra::{RealField, Vector3, convert, try_convert};

use super::plan::{OwnedPlan, keeping};
use super::ports::{HostPorts, HostRoom, terms_of};
use super::{Drive, Element, HostIncrement, ScheduledActuator};
use crate::{HostBody, HostModal};

/// Forces of elements and users: sees the whole mechanism.
pub type Forces<T = f64> = dyn Fn(T, &mut HostPorts<'_, T>) + Send + Sync;

/// A mechanism of run-time size; made in f64, and [`cast`](HostMechanism::cast) to number types that carry derivatives.
pub struct HostMechanism<T: RealField + Copy = f64> {
    bodies: Vec<HostBody<T>>,
    markers: Vec<Vec<Marker<HostModal<T>, T>>>,
    connections: Vec<Connection<T>>,
    drives: Vec<Option<Drive>>,
    /// Value, rate and acceleration of each drive where they do not come from it.
    drive_values: Option<Vec<[T; 3]>>,
    gravity: Vector3<T>,
    elements: Vec<Element<T>>,
    actuators: Vec<ScheduledActuator<T>>,
    frictions: Vec<JointFriction<T>>,
    forces: Option<Box<Forces<T>>>,
    topology: Topology,
    /// The bodies that keep their modes as unknowns.
    keeping: Vec<usize>,
    plan: OwnedPlan,
    /// The plan with soft rows, and the elements that have them.
    soft: Option<(OwnedPlan, Vec<usize>)>,
    treatment: Treatment<T>,
    regularisation: Regularisation<T>,
}

impl HostMechanism {
    /// A mechanism of bodies with their markers and of joints, with a drive where a joint is driven.
    ///
    /// Positions and velocities are projected after each step. Errors: see [`TopologyError`].
    pub fn new(
        bodies: Vec<(HostBody, Vec<Marker<HostModal, f64>>)>,
        joints: Vec<(Connection<f64>, Option<Drive>)>,
        gravity: Vector3<f64>,
    ) -> Result<Self, TopologyError> {
        let shape = |joint: &Connection<f64>| JointTopology {
            rows: joint.kind.row_count(),
            holds_point: joint.kind.holds_point(),
            ends: [joint.first.body, joint.second.body],
        };
        let modes: Vec<usize> = bodies.iter().map(|(body, _)| body.mode_count()).collect();
        let flexible: Vec<bool> = modes.iter().map(|modes| *modes > 0).collect();
        let topology = Topology {
            flexible: flexible.clone(),
            joints: joints.iter().map(|(joint, _)| shape(joint)).collect(),
        };
        let (keeping, kept) = keeping(&topology, &modes);
        let plan = OwnedPlan::of(&topology, &keeping, &kept)?.swept(&topology, &modes);
        // redundant rows need loops, which a drive beside its joint does not close
        let undriven = joints.iter().filter(|(_, drive)| drive.is_none());
        let undriven = Topology { flexible, joints: undriven.map(|(joint, _)| shape(joint)).collect() };
        let regularisation =
            if undriven.has_loops() { Regularisation::of_loops() } else { Regularisation::of_trees() };
        let (bodies, markers) = bodies.into_iter().unzip();
        let (connections, drives) = joints.into_iter().unzip();
        Ok(Self {
            bodies,
            markers,
            connections,
            drives,
            drive_values: None,
            gravity,
            elements: Vec::new(),
            actuators: Vec::new(),
            frictions: Vec::new(),
            forces: None,
            topology,
            keeping,
            plan,
            soft: None,
            treatment: Treatment::projection(),
            regularisation,
        })
    }

    /// Puts a body with as many modes in the place of one, with its first markers.
    pub(crate) fn replace_body(
        &mut self,
        index: usize,
        body: HostBody,
        markers: Vec<Marker<HostModal, f64>>,
    ) {
        if let (Some(place), Some(all)) = (self.bodies.get_mut(index), self.markers.get_mut(index)) {
            *place = body;
            for (place, marker) in all.iter_mut().zip(markers) {
                *place = marker;
            }
        }
    }
}

impl<T: RealField + Copy> HostMechanism<T> {
    /// The same mechanism with these force elements.
    #[must_use]
    pub fn with_elements(mut self, elements: Vec<Element<T>>) -> Self {
        self.elements = elements;
        // elements that connect two things that move relative to each other; the rest stays a force
        let (numbers, links): (Vec<usize>, Vec<JointTopology>) = self
            .elements
            .iter()
            .enumerate()
            .filter_map(|(number, element)| {
                let rows = element.kind.soft_row_count()?;
                let ends = [element.first.body, element.second.body];
                (ends[0] != ends[1]).then_some((number, JointTopology { rows, holds_point: false, ends }))
            })
            .unzip();
        let whole = self.topology.with_soft_links(links);
        // soft rows too are many on a hub: one choice for steps with them and without
        let modes: Vec<usize> = self.bodies.iter().map(HostBody::mode_count).collect();
        let (keeping, kept) = keeping(&whole, &modes);
        let plan = OwnedPlan::of(&self.topology, &keeping, &kept).unwrap_or(self.plan);
        self.plan = plan.swept(&self.topology, &modes);
        let soft = OwnedPlan::of(&whole, &keeping, &kept).ok().filter(|_| !numbers.is_empty());
        self.soft = soft.map(|plan| (plan, numbers));
        self.keeping = keeping;
        self
    }

    /// The same mechanism with these actuators.
    #[must_use]
    pub fn with_actuators(mut self, actuators: Vec<ScheduledActuator<T>>) -> Self {
        self.actuators = actuators;
        self
    }

    /// Lets an actuator follow another input from now on; nothing happens if there is none of that number.
    pub fn set_actuator_input(&mut self, actuator: usize, input: Drive) {
        if let Some(actuator) = self.actuators.get_mut(actuator) {
            actuator.input = input;
        }
    }

    /// The same mechanism with friction that follows the reactions of joints.
    #[must_use]
    pub fn with_frictions(mut self, frictions: Vec<JointFriction<T>>) -> Self {
        self.frictions = frictions;
        self
    }

    /// The same mechanism with these forces besides gravity and force elements.
    #[must_use]
    pub fn with_forces(mut self, forces: Box<Forces<T>>) -> Self {
        self.forces = Some(forces);
        self
    }

    /// The same mechanism with another treatment of its constraints.
    #[must_use]
    pub fn with_treatment(mut self, treatment: Treatment<T>) -> Self {
        self.treatment = treatment;
        self
    }

    /// The same mechanism with another drive of a connection.
    #[must_use]
    pub fn with_drive(mut self, connection: usize, drive: Drive) -> Self {
        if let Some(place) = self.drives.get_mut(connection) {
            *place = Some(drive);
        }
        self
    }

    /// The same mechanism with these values, rates and accelerations of the drive of each connection, at any time.
    #[must_use]
    pub fn with_drive_values(mut self, values: Vec<[T; 3]>) -> Self {
        self.drive_values = Some(values);
        self
    }

    /// The joint or drive `index`.
    pub fn connection(&self, index: usize) -> Option<&Connection<T>> {
        self.connections.get(index)
    }

    /// The connection that each constraint row belongs to.
    pub fn row_connections(&self) -> impl Iterator<Item = usize> + '_ {
        let rows = self.connections.iter().map(|connection| connection.kind.row_count());
        rows.enumerate().flat_map(|(index, count)| std::iter::repeat_n(index, count))
    }

    /// The markers of each body.
    pub fn markers(&self) -> &[Vec<Marker<HostModal<T>, T>>] {
        &self.markers
    }

    /// The drive of each connection.
    pub fn drives(&self) -> &[Option<Drive>] {
        &self.drives
    }

    /// The actuators.
    pub fn actuators(&self) -> &[ScheduledActuator<T>] {
        &self.actuators
    }

    /// The force elements.
    pub fn elements(&self) -> &[Element<T>] {
        &self.elements
    }

    /// The first joint at a marker that modes move.
    pub fn joint_on_modes(&self) -> Option<usize> {
        let moved = |marker: &Marker<HostModal<T>, T>| {
            marker.translation.iter().chain(&marker.rotation).any(|row| row.largest() > T::zero())
        };
        self.connections.iter().position(|joint| {
            let mut ends = [&joint.first, &joint.second].into_iter();
            ends.any(|end| end.body.is_some_and(|body| moved(&self.markers[body][end.marker])))
        })
    }

    /// Multiply-adds of factoring the constrained equations, and the numbers that the solve keeps.
    pub fn solve_cost(&self) -> (f64, usize) {
        (self.plan.multiply_adds(), 36 * self.plan.block_count + 3 * 6 * self.plan.node_count)
    }

    /// Constraint rows on each body.
    pub fn attached_row_counts(&self) -> Vec<usize> {
        let mut counts = vec![0; self.bodies.len()];
        for connection in &self.connections {
            for body in [&connection.first, &connection.second].into_iter().filter_map(|end| end.body) {
                if let Some(count) = counts.get_mut(body) {
                    *count += connection.kind.row_count();
                }
            }
        }
        counts
    }

    /// The bodies.
    pub fn bodies(&self) -> &[HostBody<T>] {
        &self.bodies
    }

    /// Gravity. Shape: 3. Units: m/s². Frame: inertial.
    pub fn gravity(&self) -> Vector3<T> {
        self.gravity
    }
}

impl<T: RealField + Copy> Assembly<T> for HostMechanism<T> {
    type State = Vec<State<HostModal<T>, T>>;
    type Increment = HostIncrement<T>;
    type Modes = Vec<Oscillators<HostModal<T>, T>>;
    type Ports<'a>
        = HostPorts<'a, T>
    where
        Self: 'a;

    type Rooms = Vec<Option<HostRoom<T>>>;

    fn rooms(&self) -> Self::Rooms {
        self.bodies.iter().map(|_| None).collect()
    }

    fn ports<'a>(
        &'a self,
        rooms: &'a mut Self::Rooms,
        state: Self::State,
        implicit: Option<ImplicitTerms<'a, HostIncrement<T>, T>>,
    ) -> HostPorts<'a, T> {
        let bodies = self.bodies.iter().zip(&self.markers).zip(state).zip(rooms);
        let attached_ends = match (&self.soft, implicit) {
            (Some((plan, _)), Some(ImplicitTerms { .. })) => &plan.attached_ends,
            _ => &self.plan.attached_ends,
        };
        let ports = bodies.enumerate().map(|(index, (((body, markers), state), room))| {
            let terms = implicit.map(|terms| terms_of(&terms, index));
            let kept = self.keeping.contains(&index).then(|| KeptModes::empty(&body.undeformed()));
            BodyPort::new(body, markers, state, terms, (vec![None; attached_ends[index]], kept), room)
        });
        HostPorts(ports.collect())
    }

    fn collect(&self, ports: &HostPorts<'_, T>, increment: &HostIncrement<T>) -> HostIncrement<T> {
        HostIncrement(
            ports.0.iter().zip(&increment.0).map(|(port, increment)| port.rate(increment)).collect(),
        )
    }

    fn correct(&self, ports: &mut HostPorts<'_, T>, level: Level) {
        ports.0.iter_mut().for_each(|port| port.correct(level));
    }

    fn state(&self, ports: HostPorts<'_, T>) -> Self::State {
        ports.0.into_iter().map(|port| port.state).collect()
    }

    fn with_storage<R>(&self, equations: Equations, use_it: impl FnOnce(&mut Storage<'_, T>) -> R) -> R {
        let (plan, links) = match &self.soft {
            Some((plan, elements)) if equations == Equations::SoftRows => (plan, elements.len()),
            _ => (&self.plan, 0),
        };
        let is_tree = equations == Equations::Tree;
        let [blocks, limbs, freedoms] = if is_tree { plan.tree_counts() } else { [plan.block_count, 0, 0] };
        let unknowns = || vec![[T::zero(); 6]; plan.node_count];
        use_it(&mut Storage {
            blocks: &mut vec![None; blocks],
            solution: &mut unknowns(),
            right: &mut unknowns(),
            shift: &mut if is_tree { Vec::new() } else { unknowns() },
            efforts: &mut vec![T::zero(); self.frictions.len()],
            joints: &mut vec![None; self.connections.len() + links],
            soft_markers: &mut vec![[0; 2]; links],
            limbs: &mut vec![None; limbs],
            freedoms: &mut vec![None; freedoms],
        })
    }

    fn energy(&self, state: &Self::State) -> Energy<T> {
        let mut sum = Energy::of(self.bodies.iter().zip(state), &self.gravity);
        if !self.elements.is_empty() {
            let mut rooms = self.rooms();
            let ports = self.ports(&mut rooms, state.clone(), None);
            self.elements.iter().for_each(|element| sum.potential += element.energy(&ports));
        }
        sum
    }

    fn momentum(&self, state: &Self::State) -> Momentum<T> {
        Momentum::of(self.bodies.iter().zip(state))
    }

    fn plan(&self) -> Plan<'_> {
        self.plan.view()
    }

    fn soft_plan(&self) -> Plan<'_> {
        self.soft.as_ref().map_or_else(|| self.plan.view(), |(plan, _)| plan.view())
    }

    fn soft(&self, index: usize) -> Option<SoftLink<'_, T>> {
        let (_, elements) = self.soft.as_ref()?;
        self.elements.get(*elements.get(index)?).map(Element::soft)
    }

    fn connections(&self) -> &[Connection<T>] {
        &self.connections
    }

    fn drive(&self, joint: usize, time: T) -> [T; 3] {
        if let Some(values) = &self.drive_values {
            return values.get(joint).copied().unwrap_or([T::zero(); 3]);
        }
        // time is a plain number in every type: nothing is differentiated by it
        let time = try_convert(time).unwrap_or(f64::NAN);
        let drive = self.drives.get(joint).and_then(Option::as_ref);
        drive.map_or([T::zero(); 3], |drive| drive.at(time).map(convert))
    }

    fn load(&self, time: T, ports: &mut HostPorts<'_, T>) {
        for port in &mut ports.0 {
            port.weigh(&self.gravity);
        }
        for element in &self.elements {
            element.apply(ports);
        }
        for actuator in &self.actuators {
            actuator.apply(time, ports);
        }
        if let Some(forces) = &self.forces {
            forces(time, ports);
        }
    }

    fn friction(&self, index: usize) -> Option<JointFriction<T>> {
        self.frictions.get(index).copied()
    }

    fn treatment(&self) -> Treatment<T> {
        self.treatment
    }

    fn regularisation(&self) -> Regularisation<T> {
        self.regularisation
    }

    fn is_finite(&self, state: &Self::State) -> bool {
        state.iter().all(State::is_finite)
    }

    fn no_change(&self, state: &Self::State) -> HostIncrement<T> {
        HostIncrement(state.iter().map(|state| Increment::zeros(&state.modal_coordinates)).collect())
    }

    fn retract(&self, origin: &Self::State, increment: &HostIncrement<T>) -> Self::State {
        origin.iter().zip(&increment.0).map(|(state, increment)| state.retract(increment)).collect()
    }

    fn place_rates(&self, origin: &Self::State, increment: &HostIncrement<T>) -> HostIncrement<T> {
        let rates =
            origin.iter().zip(&increment.0).map(|(state, part)| part.place_rate(&state.retract(part)));
        HostIncrement(rates.collect())
    }

    fn velocities_only(&self, increment: &HostIncrement<T>) -> HostIncrement<T> {
        HostIncrement(increment.0.iter().map(Increment::velocities_only).collect())
    }

    fn local_error(&self, difference: &HostIncrement<T>) -> LocalError<T> {
        let none = LocalError { position: T::zero(), orientation: T::zero(), modal_coordinates: T::zero() };
        difference.0.iter().fold(none, |error, body| error.or(body.local_error()))
    }

    fn weighted_error(
        &self,
        state: &Self::State,
        difference: &HostIncrement<T>,
        tolerances: &Tolerances<T>,
    ) -> T {
        let squares =
            state.iter().zip(&difference.0).map(|(state, part)| part.weighted_squares(state, tolerances));
        let (sum, count) = squares.fold((T::zero(), T::zero()), |sum, part| (sum.0 + part.0, sum.1 + part.1));
        if count > T::zero() { (sum / count).sqrt() } else { T::zero() }
    }

    fn largest_stable_step(&self) -> Option<T> {
        self.bodies.iter().filter_map(FlexibleBody::largest_stable_step).reduce(T::min)
    }

    fn modes(&self, step: T) -> Option<Self::Modes> {
        match self.joint_on_modes() {
            Some(_) => None,
            None => self.bodies.iter().map(|body| Oscillators::new(body, step)).collect(),
        }
    }

    fn vibration_rates(&self, modes: &Self::Modes, state: &Self::State) -> HostIncrement<T> {
        HostIncrement(modes.iter().zip(state).map(|(modes, state)| modes.rates(state)).collect())
    }

    fn free_vibration(&self, modes: &Self::Modes, state: &Self::State) -> HostIncrement<T> {
        HostIncrement(modes.iter().zip(state).map(|(modes, state)| modes.free(state)).collect())
    }

    fn forced_vibration(
        &self,
        modes: &Self::Modes,
        rates: &HostIncrement<T>,
        forcing: Forcing,
    ) -> HostIncrement<T> {
        let parts = modes.iter().zip(&rates.0);
        HostIncrement(parts.map(|(modes, rates)| modes.forced(rates, forcing)).collect())
    }
}
