//! A mechanism whose bodies, joints and forces come at run time.

use ffrf_codegen::mechanism::{JointTopology, MechanismPlan, Topology, TopologyError};
use ffrf_runtime::mechanism::{
    Assembly, AttachedRow, BodyPort, Connection, ImplicitTerms, Level, Plan, Port, Ports, Regularisation,
    Storage, Treatment,
};
use ffrf_runtime::relations::Rows;
use ffrf_runtime::{
    FlexibleBody, Forcing, Increment, LocalError, Marker, MarkerMotion, ModalVector, Oscillators, State,
    Tolerances,
};
use nalgebra::{UnitQuaternion, Vector3};

use super::plan::OwnedPlan;
use super::{Drive, Element, HostIncrement, ScheduledActuator};
use crate::{HostBody, HostModal};

/// Forces of elements and users: sees the whole mechanism.
pub type Forces = dyn Fn(f64, &mut HostPorts<'_>) + Send + Sync;

/// A mechanism of run-time size.
pub struct HostMechanism {
    bodies: Vec<HostBody>,
    markers: Vec<Vec<Marker<HostModal, f64>>>,
    connections: Vec<Connection<f64>>,
    drives: Vec<Option<Drive>>,
    gravity: Vector3<f64>,
    elements: Vec<Element>,
    actuators: Vec<ScheduledActuator>,
    forces: Option<Box<Forces>>,
    plan: OwnedPlan,
    treatment: Treatment<f64>,
    regularisation: Regularisation<f64>,
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
            ends: [joint.first.body, joint.second.body],
        };
        let flexible: Vec<bool> = bodies.iter().map(|(body, _)| body.mode_count() > 0).collect();
        let topology = Topology {
            flexible: flexible.clone(),
            joints: joints.iter().map(|(joint, _)| shape(joint)).collect(),
        };
        let plan = OwnedPlan::new(&MechanismPlan::new(&topology)?);
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
            gravity,
            elements: Vec::new(),
            actuators: Vec::new(),
            forces: None,
            plan,
            treatment: Treatment::Projection { iterations: 8, tolerance: 1e-6 },
            regularisation,
        })
    }

    /// The same mechanism with these force elements.
    #[must_use]
    pub fn with_elements(mut self, elements: Vec<Element>) -> Self {
        self.elements = elements;
        self
    }

    /// The same mechanism with these actuators.
    #[must_use]
    pub fn with_actuators(mut self, actuators: Vec<ScheduledActuator>) -> Self {
        self.actuators = actuators;
        self
    }

    /// The same mechanism with these forces besides gravity and force elements.
    #[must_use]
    pub fn with_forces(mut self, forces: Box<Forces>) -> Self {
        self.forces = Some(forces);
        self
    }

    /// The same mechanism with another treatment of its constraints.
    #[must_use]
    pub fn with_treatment(mut self, treatment: Treatment<f64>) -> Self {
        self.treatment = treatment;
        self
    }

    /// The markers of each body.
    pub fn markers(&self) -> &[Vec<Marker<HostModal, f64>>] {
        &self.markers
    }

    /// The drive of each connection.
    pub fn drives(&self) -> &[Option<Drive>] {
        &self.drives
    }

    /// The force elements.
    pub fn elements(&self) -> &[Element] {
        &self.elements
    }

    /// The first joint at a marker that modes move.
    pub fn joint_on_modes(&self) -> Option<usize> {
        let moved = |marker: &Marker<HostModal, f64>| {
            marker.translation.iter().chain(&marker.rotation).any(|row| row.largest() > 0.0)
        };
        self.connections.iter().position(|joint| {
            let mut ends = [&joint.first, &joint.second].into_iter();
            ends.any(|end| end.body.is_some_and(|body| moved(&self.markers[body][end.marker])))
        })
    }

    /// Modes, each on its own, of every body; `None` if joints hold what modes move, or where matrices are dense.
    fn oscillators(&self) -> Option<Vec<Oscillators<HostModal>>> {
        match self.joint_on_modes() {
            Some(_) => None,
            None => self.bodies.iter().map(Oscillators::new).collect(),
        }
    }

    /// The bodies.
    pub fn bodies(&self) -> &[HostBody] {
        &self.bodies
    }

    /// Gravity. Shape: 3. Units: m/s². Frame: inertial.
    pub fn gravity(&self) -> Vector3<f64> {
        self.gravity
    }
}

/// The bodies of a mechanism in one state.
pub struct HostPorts<'a>(pub Vec<HostPort<'a>>);

/// One body of a mechanism in one state.
pub type HostPort<'a> = BodyPort<'a, HostBody, Vec<AttachedRow<HostModal>>, f64>;

impl Ports<f64> for HostPorts<'_> {
    fn port(&self, index: usize) -> Option<&dyn Port<f64>> {
        self.0.get(index).map(|port| port as &dyn Port<f64>)
    }

    fn port_mut(&mut self, index: usize) -> Option<&mut dyn Port<f64>> {
        self.0.get_mut(index).map(|port| port as &mut dyn Port<f64>)
    }
}

impl Assembly<f64> for HostMechanism {
    type State = Vec<State<HostModal>>;
    type Increment = HostIncrement;
    type Ports<'a> = HostPorts<'a>;

    fn ports<'a>(
        &'a self,
        state: Self::State,
        implicit: Option<ImplicitTerms<'a, HostIncrement, f64>>,
    ) -> HostPorts<'a> {
        let bodies = self.bodies.iter().zip(&self.markers).zip(state);
        let ports = bodies.enumerate().map(|(index, ((body, markers), state))| {
            let terms = implicit.map(|ImplicitTerms { gamma_h, subtracted }| ImplicitTerms {
                gamma_h,
                subtracted: subtracted.and_then(|all| all.0.get(index)),
            });
            let rows = vec![AttachedRow::empty(&body.undeformed()); self.plan.attached_rows[index]];
            BodyPort::new(body, markers.as_slice(), state, rows, terms)
        });
        HostPorts(ports.collect())
    }

    fn collect(&self, ports: &HostPorts<'_>, increment: &HostIncrement) -> HostIncrement {
        HostIncrement(
            ports.0.iter().zip(&increment.0).map(|(port, increment)| port.rate(increment)).collect(),
        )
    }

    fn correct(&self, ports: &mut HostPorts<'_>, level: Level) {
        for port in &mut ports.0 {
            match level {
                Level::Position => port.state.displace(&port.motion),
                Level::Velocity => port.state.push(&port.motion),
            }
        }
    }

    fn state(&self, ports: HostPorts<'_>) -> Self::State {
        ports.0.into_iter().map(|port| port.state).collect()
    }

    fn with_storage<R>(&self, use_it: impl FnOnce(&mut Storage<'_, f64>) -> R) -> R {
        let joints = self.connections.len();
        let still = MarkerMotion::fixed(Vector3::zeros(), UnitQuaternion::identity());
        let unknowns = || vec![0.0; self.plan.unknown_count];
        use_it(&mut Storage {
            values: &mut vec![0.0; self.plan.value_count],
            solution: &mut unknowns(),
            right: &mut unknowns(),
            shift: &mut unknowns(),
            rows: &mut vec![Rows::none(); joints],
            ends: &mut vec![[still; 2]; joints],
        })
    }

    fn plan(&self) -> Plan<'_> {
        self.plan.view()
    }

    fn connections(&self) -> &[Connection<f64>] {
        &self.connections
    }

    fn drive(&self, joint: usize, time: f64) -> [f64; 3] {
        self.drives.get(joint).and_then(Option::as_ref).map_or([0.0; 3], |drive| drive.at(time))
    }

    fn load(&self, time: f64, ports: &mut HostPorts<'_>) {
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

    fn treatment(&self) -> Treatment<f64> {
        self.treatment
    }

    fn regularisation(&self) -> Regularisation<f64> {
        self.regularisation
    }

    fn is_finite(&self, state: &Self::State) -> bool {
        state.iter().all(State::is_finite)
    }

    fn no_change(&self, state: &Self::State) -> HostIncrement {
        HostIncrement(state.iter().map(|state| Increment::zeros(&state.modal_coordinates)).collect())
    }

    fn retract(&self, origin: &Self::State, increment: &HostIncrement) -> Self::State {
        origin.iter().zip(&increment.0).map(|(state, increment)| state.retract(increment)).collect()
    }

    fn place_rates(&self, origin: &Self::State, increment: &HostIncrement) -> HostIncrement {
        let rates =
            origin.iter().zip(&increment.0).map(|(state, part)| part.place_rate(&state.retract(part)));
        HostIncrement(rates.collect())
    }

    fn velocities_only(&self, increment: &HostIncrement) -> HostIncrement {
        HostIncrement(increment.0.iter().map(Increment::velocities_only).collect())
    }

    fn local_error(&self, difference: &HostIncrement) -> LocalError {
        let none = LocalError { position: 0.0, orientation: 0.0, modal_coordinates: 0.0 };
        difference.0.iter().fold(none, |error, body| error.or(body.local_error()))
    }

    fn weighted_error(
        &self,
        state: &Self::State,
        difference: &HostIncrement,
        tolerances: &Tolerances,
    ) -> f64 {
        let squares =
            state.iter().zip(&difference.0).map(|(state, part)| part.weighted_squares(state, tolerances));
        let (sum, count) = squares.fold((0.0, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1));
        if count > 0.0 { (sum / count).sqrt() } else { 0.0 }
    }

    fn largest_stable_step(&self) -> Option<f64> {
        self.bodies.iter().filter_map(FlexibleBody::largest_stable_step).reduce(f64::min)
    }

    fn vibration_rates(&self, state: &Self::State) -> Option<HostIncrement> {
        let modes = self.oscillators()?;
        Some(HostIncrement(modes.iter().zip(state).map(|(modes, state)| modes.rates(state)).collect()))
    }

    fn free_vibration(&self, state: &Self::State, step: f64) -> Option<HostIncrement> {
        let modes = self.oscillators()?;
        Some(HostIncrement(modes.iter().zip(state).map(|(modes, state)| modes.free(state, step)).collect()))
    }

    fn forced_vibration(&self, rates: &HostIncrement, step: f64, forcing: Forcing) -> Option<HostIncrement> {
        let modes = self.oscillators()?;
        let parts = modes.iter().zip(&rates.0);
        Some(HostIncrement(parts.map(|(modes, rates)| modes.forced(rates, step, forcing)).collect()))
    }
}
