//! A tree of bodies in coordinates of its joints: nothing can drift, because only what a joint leaves free is state.
//!
//! The state of each body is its motion relative to the body before it, at the joint between them: place and velocities of
//! the child's triad in the parent's, of which those that the joint holds stay zero, and the modes. It is a choice of state
//! only: bodies are placed by forward kinematics, accelerations come from the same constrained solve as in absolute
//! coordinates, and are projected on what the joint leaves free. The differences of marker accelerations are exact, so
//! every explicit integrator keeps its order.
//! Source: Featherstone, Rigid Body Dynamics Algorithms (2008), sections 3.5 and 4.4 (motion of a tree by its joints).

use ffrf_runtime::joints::JointKind;
use ffrf_runtime::mechanism::{Assembly, Constrained, Port};
use ffrf_runtime::{
    FlexibleBody, LocalError, MarkerMotion, Motion, PlacedMarker, State, StepError, System, Tolerances,
};
use nalgebra::{UnitQuaternion, Vector3};
use thiserror::Error;

use super::{HostIncrement, HostMechanism, HostPorts};
use crate::HostModal;

/// Why a mechanism has no joint coordinates; joints are counted as its connections are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum TreeError {
    /// A joint whose free motion is not along or about axes of its triads, or a drive.
    #[error(
        "joint {joint} is neither fixed, revolute, prismatic, cylindrical, spherical nor planar, or it is driven"
    )]
    Unsupported {
        /// The joint.
        joint: usize,
    },
    /// A joint that closes a loop.
    #[error("joint {joint} closes a loop")]
    Loop {
        /// The joint.
        joint: usize,
    },
}

/// A body and the joint towards the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Branch {
    body: usize,
    /// The joint, and which of its ends is on this body; none for bodies that move freely.
    joint: Option<(usize, usize)>,
    /// Which components of the relative motion are free: translations in the parent's triad, rotations in the child's.
    free: [[f64; 3]; 2],
}

/// A mechanism without loops as a system in the coordinates of its joints.
#[derive(Clone)]
pub struct JointCoordinates<'a> {
    mechanism: &'a HostMechanism,
    /// Parents come before their children.
    branches: Vec<Branch>,
}

const ALL: [f64; 3] = [1.0; 3];
const NONE: [f64; 3] = [0.0; 3];
const ALONG: [f64; 3] = [0.0, 0.0, 1.0];
const ACROSS: [f64; 3] = [1.0, 1.0, 0.0];

/// What a joint leaves free: translations and rotations.
fn freedom(kind: &JointKind<f64>) -> Option<[[f64; 3]; 2]> {
    match kind {
        JointKind::Fixed(_) => Some([NONE, NONE]),
        JointKind::Revolute(_) => Some([NONE, ALONG]),
        JointKind::Prismatic(_) => Some([ALONG, NONE]),
        JointKind::Cylindrical(_) => Some([ALONG, ALONG]),
        JointKind::Spherical(_) => Some([NONE, ALL]),
        JointKind::Planar(_) => Some([ACROSS, ALONG]),
        _ => None,
    }
}

impl<'a> JointCoordinates<'a> {
    /// The tree of a mechanism. Errors: see [`TreeError`].
    pub fn new(mechanism: &'a HostMechanism) -> Result<Self, TreeError> {
        let connections = mechanism.connections();
        for (joint, connection) in connections.iter().enumerate() {
            if freedom(&connection.kind).is_none() || mechanism.drives()[joint].is_some() {
                return Err(TreeError::Unsupported { joint });
            }
        }
        let count = mechanism.bodies().len();
        let (mut branches, mut used) = (Vec::with_capacity(count), vec![false; connections.len()]);
        let mut reached = vec![false; count];
        // from the ground first; what the ground does not reach begins with a body that moves freely
        let mut roots = (0..count).map(Some).collect::<Vec<_>>();
        roots.insert(0, None);
        for root in roots {
            if let Some(body) = root {
                if reached[body] {
                    continue;
                }
                reached[body] = true;
                branches.push(Branch { body, joint: None, free: [ALL, ALL] });
            }
            let mut open = vec![root];
            while let Some(parent) = open.pop() {
                for (joint, connection) in connections.iter().enumerate() {
                    let ends = [connection.first.body, connection.second.body];
                    let Some(side) = ends.iter().position(|end| *end == parent).filter(|_| !used[joint])
                    else {
                        continue;
                    };
                    used[joint] = true;
                    let child = 1 - side;
                    let Some(body) = ends[child].filter(|body| !reached[*body]) else {
                        return Err(TreeError::Loop { joint });
                    };
                    reached[body] = true;
                    let free = freedom(&connection.kind).unwrap_or([NONE, NONE]);
                    branches.push(Branch { body, joint: Some((joint, child)), free });
                    open.push(Some(body));
                }
            }
        }
        Ok(Self { mechanism, branches })
    }

    /// The relative motion of each body; what joints hold is left out.
    pub fn relative(&self, absolute: &[State<HostModal>]) -> Vec<State<HostModal>> {
        let mut relative = absolute.to_vec();
        for branch in &self.branches {
            let Some((joint, child)) = branch.joint else { continue };
            let (parent, own) = self.ends(joint, child, absolute);
            let state = &mut relative[branch.body];
            let arm = own.position - parent.position;
            let carried = parent.velocity + parent.angular_velocity.cross(&arm);
            let to_parent = parent.orientation.inverse();
            state.position = masked(&(to_parent * arm), &branch.free[0]);
            state.velocity = masked(&(to_parent * (own.velocity - carried)), &branch.free[0]);
            let turn = to_parent * own.orientation;
            let kept = masked(&turn.imag(), &branch.free[1]);
            let turn = nalgebra::Quaternion::from_parts(turn.w, kept);
            state.orientation = UnitQuaternion::new_normalize(turn);
            let spin = own.angular_velocity - parent.angular_velocity;
            state.angular_velocity =
                masked(&own.orientation.inverse_transform_vector(&spin), &branch.free[1]);
        }
        relative
    }

    /// The states of the bodies in space, by forward kinematics.
    pub fn absolute(&self, relative: &[State<HostModal>]) -> Vec<State<HostModal>> {
        let mut absolute = relative.to_vec();
        for branch in &self.branches {
            let Some((joint, child)) = branch.joint else { continue };
            let parent = self.end(joint, 1 - child, &absolute);
            let state = &relative[branch.body];
            let arm = parent.orientation * state.position;
            let orientation = parent.orientation * state.orientation;
            let velocity =
                parent.velocity + parent.angular_velocity.cross(&arm) + parent.orientation * state.velocity;
            let angular_velocity = parent.angular_velocity + orientation * state.angular_velocity;
            // the triad as the modes have it in a body frame at rest
            let mut still = State::at_rest(&self.mechanism.bodies()[branch.body]);
            still.modal_coordinates = state.modal_coordinates.clone();
            still.modal_rates = state.modal_rates.clone();
            let at = &mut absolute[branch.body];
            *at = still;
            let local = self.end(joint, child, &absolute);
            let at = &mut absolute[branch.body];
            at.orientation = orientation * local.orientation.inverse();
            let [place, shift, spin] = [local.position, local.velocity, local.angular_velocity]
                .map(|vector| at.orientation * vector);
            let turning = angular_velocity - spin;
            at.position = parent.position + arm - place;
            at.velocity = velocity - turning.cross(&place) - shift;
            at.angular_velocity = at.orientation.inverse_transform_vector(&turning);
        }
        absolute
    }

    /// The triads of parent and child.
    fn ends(&self, joint: usize, child: usize, states: &[State<HostModal>]) -> (MarkerMotion, MarkerMotion) {
        (self.end(joint, 1 - child, states), self.end(joint, child, states))
    }

    fn end(&self, joint: usize, side: usize, states: &[State<HostModal>]) -> MarkerMotion {
        let connection = &self.mechanism.connections()[joint];
        let end = if side == 0 { &connection.first } else { &connection.second };
        match end.body {
            None => MarkerMotion::fixed(end.position, end.orientation),
            Some(body) => PlacedMarker::new(&self.mechanism.markers()[body][end.marker], &states[body])
                .motion(&states[body])
                .turned(&end.orientation),
        }
    }

    /// Accelerations of the relative motion of a branch, in the child's triad.
    fn acceleration(
        &self,
        branch: &Branch,
        state: &State<HostModal>,
        ports: &HostPorts<'_>,
    ) -> Motion<HostModal> {
        let port = &ports.0[branch.body];
        let Some((joint, child)) = branch.joint else { return port.motion.clone() };
        let connection = &self.mechanism.connections()[joint];
        let of = |side: usize| {
            let end = if side == 0 { &connection.first } else { &connection.second };
            let motion = end.motion(ports);
            let found =
                end.body.map_or([Vector3::zeros(); 2], |body| ports.0[body].resulting_twist(end.marker));
            let linear = motion.acceleration_bias + found[0];
            let angular = motion.angular_acceleration_bias + found[1];
            (motion, linear, angular)
        };
        let (parent, linear, angular) = of(1 - child);
        let (own, own_linear, own_angular) = of(child);
        let omega = &parent.angular_velocity;
        let arm = parent.orientation * state.position;
        let moving = parent.orientation * state.velocity;
        let carried = linear + angular.cross(&arm) + omega.cross(&(omega.cross(&arm) + moving * 2.0));
        let travel = parent.orientation.inverse_transform_vector(&(own_linear - carried));
        let spin = own.orientation * state.angular_velocity;
        let turn = own.orientation.inverse_transform_vector(&(own_angular - angular - omega.cross(&spin)));
        Motion {
            linear: state.to_body(&masked(&travel, &branch.free[0])),
            angular: masked(&turn, &branch.free[1]),
            modal: port.motion.modal.clone(),
        }
    }
}

fn masked(vector: &Vector3<f64>, free: &[f64; 3]) -> Vector3<f64> {
    vector.component_mul(&Vector3::from(*free))
}

impl System<f64> for JointCoordinates<'_> {
    type State = Vec<State<HostModal>>;
    type Increment = HostIncrement;

    fn is_finite(&self, state: &Self::State) -> bool {
        self.mechanism.is_finite(state)
    }

    fn no_change(&self, state: &Self::State) -> HostIncrement {
        self.mechanism.no_change(state)
    }

    fn retract(&self, origin: &Self::State, increment: &HostIncrement) -> Self::State {
        self.mechanism.retract(origin, increment)
    }

    fn rates(
        &self,
        time: f64,
        origin: &Self::State,
        increment: &HostIncrement,
    ) -> Result<HostIncrement, StepError> {
        let relative = self.retract(origin, increment);
        let absolute = self.absolute(&relative);
        Constrained(self.mechanism).evaluate(time, absolute, None, |ports, _| {
            let mut rates = increment.clone();
            for branch in &self.branches {
                let state = &relative[branch.body];
                let accelerations = self.acceleration(branch, state, ports);
                rates.0[branch.body] = increment.0[branch.body].rate(state, accelerations);
            }
            rates
        })
    }

    fn place_rates(&self, origin: &Self::State, increment: &HostIncrement) -> HostIncrement {
        self.mechanism.place_rates(origin, increment)
    }

    fn velocities_only(&self, increment: &HostIncrement) -> HostIncrement {
        self.mechanism.velocities_only(increment)
    }

    fn local_error(&self, difference: &HostIncrement) -> LocalError {
        self.mechanism.local_error(difference)
    }

    fn weighted_error(
        &self,
        state: &Self::State,
        difference: &HostIncrement,
        tolerances: &Tolerances,
    ) -> f64 {
        self.mechanism.weighted_error(state, difference, tolerances)
    }

    fn largest_stable_step(&self) -> Option<f64> {
        self.mechanism.bodies().iter().filter_map(FlexibleBody::largest_stable_step).reduce(f64::min)
    }
}
