//! A flexible double pendulum: two bodies of random nodes on revolute joints at markers that their modes move and turn.

use ffrf_host::{HostBody, HostMechanism, HostModal};
use ffrf_runtime::joints::{JointKind, Revolute};
use ffrf_runtime::mechanism::{Assembly, Attachment, Connection, Constrained, Treatment};
use ffrf_runtime::{Marker, ModalVector, State, StepError, StepReport};
use ffrf_test_kit::random_body::{Modes, random_body};
use nalgebra::{DVector, UnitQuaternion, Vector3};

/// Modes of each body.
const MODES: usize = 3;

/// How much stiffer the bodies are than random ones, so that their frequencies are some 40 rad/s and more.
const STIFFNESS: f64 = 40.0;

/// What is compared: places, velocities and reactions of everything.
pub type Blocks = [Vec<f64>; 3];

fn body(seed: u64, damped: bool) -> (HostBody, Vec<Marker<HostModal>>) {
    let mut model = random_body(seed, MODES, Modes::Normalised);
    for row in model.stiffness.iter_mut().flatten() {
        *row *= STIFFNESS;
    }
    for (row, stiffness) in model.damping.iter_mut().flatten().zip(model.stiffness.iter().flatten()) {
        *row = if damped { 1e-3 * stiffness } else { 0.0 };
    }
    (HostBody::new(&model, &ffrf_codegen::fidelity::Fidelity::Full), HostBody::markers(&model))
}

pub fn on(body: usize, marker: usize) -> Attachment<f64> {
    Attachment {
        body: Some(body),
        marker,
        position: Vector3::zeros(),
        // joints about an axis that is special to no body
        orientation: UnitQuaternion::from_euler_angles(0.4, -0.3, 0.2),
    }
}

/// The mechanism and a state that moves and meets the joints to round-off.
pub fn double_pendulum(treatment: Treatment<f64>, damped: bool) -> (HostMechanism, Vec<State<HostModal>>) {
    let (tip, root) = (0, 1);
    let (upper, lower) = (body(3, damped), body(8, damped));
    let mut ground = on(0, 0);
    ground.body = None;
    let mut states = vec![State::at_rest(&upper.0), State::at_rest(&lower.0)];
    states[0].position = -upper.1[root].position;
    states[1].position = states[0].position + upper.1[tip].position - lower.1[root].position;
    // about parallel axes, at rates that differ
    let axis = ground.orientation * Vector3::z();
    for (state, rate) in states.iter_mut().zip([1.5, -0.8]) {
        state.angular_velocity = axis * rate;
        state.modal_coordinates = HostModal(DVector::from_element(MODES, 0.01));
    }
    let revolute = |first, second| (Connection { kind: JointKind::Revolute(Revolute), first, second }, None);
    let joints = vec![revolute(ground, on(0, root)), revolute(on(0, tip), on(1, root))];
    let gravity = Vector3::new(1.0, -9.0, 3.0);
    let mechanism = HostMechanism::new(vec![upper, lower], joints, gravity).unwrap();
    for _ in 0..5 {
        states = Constrained(&mechanism).project(0.0, states, None, 3, f64::MAX).unwrap().0;
    }
    states = Constrained(&mechanism).project(0.0, states, None, 8, 1e-14).unwrap().0;
    (mechanism.with_treatment(treatment), states)
}

/// Places, velocities and reactions of a state.
pub fn blocks(mechanism: &HostMechanism, state: &[State<HostModal>], time: f64) -> Blocks {
    let (mut places, mut velocities) = (Vec::new(), Vec::new());
    for body in state {
        places.extend_from_slice(body.position.as_slice());
        places.extend_from_slice(body.orientation.coords.as_slice());
        places.extend_from_slice(body.modal_coordinates.as_slice());
        velocities.extend_from_slice(body.velocity.as_slice());
        velocities.extend_from_slice(body.angular_velocity.as_slice());
        velocities.extend_from_slice(body.modal_rates.as_slice());
    }
    let reactions = Constrained(mechanism).evaluate(time, state.to_vec(), None, |_, storage| {
        let joints = mechanism.plan().joints.iter();
        joints.flat_map(|joint| storage.solution[joint.node][..joint.rows].to_vec()).collect()
    });
    [places, velocities, reactions.unwrap()]
}

/// The largest difference of each block, relative to its largest number.
pub fn differences(found: &Blocks, expected: &Blocks) -> [f64; 3] {
    core::array::from_fn(|block| {
        let size = expected[block].iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        let pairs = found[block].iter().zip(&expected[block]);
        pairs.fold(0.0_f64, |worst, (found, expected)| worst.max((found - expected).abs())) / size
    })
}

/// The states of all bodies.
pub type States = Vec<State<HostModal>>;

/// Simulated time: some turns of the slow modes, so that errors of phase show. Units: s.
pub const DURATION: f64 = 0.4;

/// Deviation of a measured order from the theoretical one: the next power still shows, 0.29 at order five.
pub const SLOPE: f64 = 0.35;

/// Projection to places and velocities that is solved to the end.
pub const PROJECTION: Treatment<f64> = Treatment::Projection { iterations: 8, tolerance: 1e-9 };

/// A method that may remember something from step to step.
pub type Stepper<'a> = dyn FnMut(&States, f64, f64) -> Result<(States, StepReport), StepError> + 'a;

/// The end of a run of `steps` equal steps.
pub fn run(mechanism: &HostMechanism, mut state: States, steps: usize, step: &mut Stepper<'_>) -> Blocks {
    let h = DURATION / steps as f64;
    for k in 0..steps {
        state =
            step(&state, k as f64 * h, h).unwrap_or_else(|error| panic!("step {k} of {steps}: {error}")).0;
    }
    blocks(mechanism, &state, DURATION)
}
