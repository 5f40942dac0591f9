//! Stiff force elements in implicit steps: order, any stiffness and damping, and the joint in the limit, with flexible bodies
//! and joints in the loop.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use ffrf_host::HostMechanism;
use ffrf_host::mechanism::{Element, ElementKind};
use ffrf_runtime::forces::{Bushing, Effort, Friction, Spring, TorsionSpring};
use ffrf_runtime::joints::{Fixed, JointKind};
use ffrf_runtime::mechanism::{Assembly, Attachment, Connection, Constrained, Treatment};
use ffrf_runtime::{
    FreeBody, GeneralisedAlpha, RadauIIA, State, Tolerances, step_dormand_prince, step_linearly_implicit,
    step_linearly_implicit_euler,
};
use nalgebra::Vector3;

use crate::convergence::problem::{
    Blocks, DURATION, PROJECTION, SLOPE, States, differences, double_pendulum, on, run,
};

/// The pivot of the pendulum's upper body, on the ground.
fn ground() -> Attachment<f64> {
    Attachment { body: None, ..on(0, 0) }
}

/// Springs, a torsion spring, a bushing and friction, each with this stiffness and damping, on and in the pendulum; lengths
/// without force as they are in `states`.
fn elements(mechanism: &HostMechanism, states: &States, [stiffness, damping]: [f64; 2]) -> Vec<Element<f64>> {
    let mut rooms = mechanism.rooms();
    let ports = mechanism.ports(&mut rooms, states.clone(), None);
    let anchor = Attachment { position: Vector3::new(0.7, -0.4, 0.9), ..ground() };
    let spring = |first: Attachment<f64>, second: Attachment<f64>| Element {
        kind: ElementKind::Spring(Spring {
            stiffness,
            damping,
            rest_length: (second.motion(&ports).position - first.motion(&ports).position).norm(),
        }),
        first,
        second,
    };
    let coil = TorsionSpring { stiffness, damping, rest_angle: 0.0 };
    let bushing = Bushing { stiffness: [stiffness; 6], damping: [damping; 6] };
    let friction = Friction { effort: Effort::About, limit: damping, speed: 1.0, viscous: damping };
    let (pivot, tip, root) = (on(0, 1), on(0, 0), on(1, 1));
    vec![
        spring(anchor, on(1, 0)),
        spring(anchor, tip),
        Element { kind: ElementKind::TorsionSpring(coil), first: ground(), second: pivot },
        Element { kind: ElementKind::Bushing(bushing), first: tip, second: root },
        Element { kind: ElementKind::Friction(friction), first: tip, second: root },
    ]
}

fn pendulum(treatment: Treatment<f64>, resistance: [f64; 2]) -> (HostMechanism, States) {
    let (mechanism, states) = double_pendulum(treatment, true);
    let elements = elements(&mechanism, &states, resistance);
    (mechanism.with_elements(elements), states)
}

/// Places, velocities and reactions converge to those of explicit steps of order five with this order.
fn assert_order(
    name: &str,
    treatment: Treatment<f64>,
    first: usize,
    expected: f64,
    end: impl Fn(&HostMechanism, States, usize) -> Blocks,
) {
    let resistance = [30.0, 0.4];
    let (mechanism, state) = pendulum(PROJECTION, resistance);
    let system = Constrained(&mechanism);
    let reference =
        run(&mechanism, state, 1600, &mut |state, time, h| step_dormand_prince(&system, state, time, h));
    let errors: Vec<[f64; 3]> = (0..3)
        .map(|k| {
            let (mechanism, state) = pendulum(treatment, resistance);
            differences(&end(&mechanism, state, first << k), &reference)
        })
        .collect();
    for (block, what) in ["places", "velocities", "reactions"].into_iter().enumerate() {
        let slopes: Vec<f64> =
            errors.windows(2).map(|pair| (pair[0][block] / pair[1][block]).log2()).collect();
        eprintln!(
            "{name}, {what}: errors {:?}, orders {slopes:.2?}",
            errors.iter().map(|e| e[block]).collect::<Vec<_>>()
        );
        assert!((slopes[1] - expected).abs() < SLOPE, "{name}, {what}: {slopes:?}");
    }
}

fn alpha(mechanism: &HostMechanism, state: States, steps: usize) -> Blocks {
    let tolerances = Tolerances { relative: 1e-13, absolute: 1e-14 };
    let method = GeneralisedAlpha { iterations: 40, tolerances, ..GeneralisedAlpha::new() };
    let system = Constrained(mechanism);
    let mut memory = method.start(&system, &state, 0.0, DURATION / steps as f64).unwrap();
    run(mechanism, state, steps, &mut |state, time, h| method.step(&system, &mut memory, state, time, h))
}

#[test]
fn the_linearly_implicit_method_has_order_two_with_soft_rows() {
    assert_order("ROS2", PROJECTION, 400, 2.0, |mechanism, state, steps| {
        let system = Constrained(mechanism);
        run(mechanism, state, steps, &mut |state, time, h| step_linearly_implicit(&system, state, time, h))
    });
}

#[test]
fn linearly_implicit_euler_has_order_one_with_soft_rows() {
    assert_order("linearly implicit Euler", PROJECTION, 800, 1.0, |mechanism, state, steps| {
        let system = Constrained(mechanism);
        run(mechanism, state, steps, &mut |state, time, h| {
            step_linearly_implicit_euler(&system, state, time, h)
        })
    });
}

#[test]
fn radau_methods_have_orders_five_and_seven_with_soft_rows() {
    let tolerances = Tolerances { relative: 1e-14, absolute: 1e-15 };
    assert_order("Radau IIA, 3 stages", PROJECTION, 40, 5.0, |mechanism, state, steps| {
        let system = Constrained(mechanism);
        let method = RadauIIA { tolerances, iterations: 40, ..RadauIIA::order_five() };
        run(mechanism, state, steps, &mut |state, time, h| method.step(&system, state, time, h))
    });
    assert_order("Radau IIA, 4 stages", PROJECTION, 20, 7.0, |mechanism, state, steps| {
        let system = Constrained(mechanism);
        let method = RadauIIA { tolerances, iterations: 40, ..RadauIIA::order_seven() };
        run(mechanism, state, steps, &mut |state, time, h| method.step(&system, state, time, h))
    });
}

#[test]
fn generalised_alpha_has_order_two_with_soft_rows() {
    for treatment in [PROJECTION, Treatment::Index3, Treatment::StabilisedIndex2] {
        assert_order(&format!("generalised-α, {treatment:?}"), treatment, 400, 2.0, alpha);
    }
}

/// The pendulum as it stands without deformation, with elements that store nothing there; it moves.
fn undeformed_pendulum(resistance: [f64; 2]) -> (HostMechanism, States) {
    let (mechanism, mut states) = double_pendulum(PROJECTION, true);
    for (state, body) in states.iter_mut().zip(mechanism.bodies()) {
        let still = State::at_rest(body);
        state.orientation = still.orientation;
        state.modal_coordinates = still.modal_coordinates;
    }
    let system = Constrained(&mechanism);
    let states = system.assemble(0.0, states.clone(), 1e-12).unwrap().0;
    let elements = elements(&mechanism, &states, resistance);
    (mechanism.with_elements(elements), states)
}

/// Energy of bodies, elements and gravity. Units: J.
fn energy(mechanism: &HostMechanism, states: &States) -> f64 {
    let bodies = mechanism.bodies().iter().zip(states).map(|(body, state)| {
        let free = FreeBody::new(body.clone()).with_state(state.clone());
        free.kinetic_energy() + free.elastic_energy() + free.potential_energy(&mechanism.gravity())
    });
    let mut rooms = mechanism.rooms();
    let ports = mechanism.ports(&mut rooms, states.clone(), None);
    bodies.sum::<f64>() + mechanism.elements().iter().map(|element| element.energy(&ports)).sum::<f64>()
}

/// From nothing to far beyond what an explicit step survives. Units: those of stiffness and damping.
const RESISTANCES: [f64; 6] = [0.0, 1.0, 1e3, 1e6, 1e9, 1e12];

#[test]
fn a_fixed_step_is_stable_for_every_stiffness_and_damping() {
    const STEP: f64 = 1e-4;
    const STEPS: usize = 400;
    for stiffness in RESISTANCES {
        for damping in RESISTANCES {
            let (mechanism, start) = undeformed_pendulum([stiffness, damping]);
            let system = Constrained(&mechanism);
            let before = energy(&mechanism, &start);
            for (name, method) in [("ROS2", true), ("Euler", false)] {
                let mut state = start.clone();
                let mut largest = 0.0_f64;
                for k in 0..STEPS {
                    let time = k as f64 * STEP;
                    let next = match method {
                        true => step_linearly_implicit(&system, &state, time, STEP),
                        false => step_linearly_implicit_euler(&system, &state, time, STEP),
                    };
                    state = next
                        .unwrap_or_else(|error| {
                            panic!("{name}, {stiffness:e}, {damping:e}, step {k}: {error}")
                        })
                        .0;
                    // the first steps take away what the state stores against stiff elements
                    if k >= 10 {
                        largest = largest.max(energy(&mechanism, &state));
                    }
                }
                eprintln!(
                    "{name}, k {stiffness:e}, d {damping:e}: energy {before:.3e}, then at most {largest:.3e}"
                );
                assert!(
                    largest.is_finite() && largest < 2.0 * before,
                    "{name}, {stiffness:e}, {damping:e}: {largest:e}"
                );
            }
        }
    }
}

/// The pendulum with its lower body held by a bushing of this stiffness, or by a fixed joint.
fn held(stiffness: Option<f64>) -> HostMechanism {
    let (mechanism, _) = double_pendulum(PROJECTION, true);
    let bodies = mechanism.bodies().iter().cloned().zip(mechanism.markers().iter().cloned()).collect();
    let (first, second) = (on(0, 0), on(1, 1));
    let mut joints = vec![(*mechanism.connection(0).unwrap(), None)];
    if stiffness.is_none() {
        joints.push((Connection { kind: JointKind::Fixed(Fixed), first, second }, None));
    }
    let bushings = stiffness.into_iter().map(|stiffness| {
        let bushing = Bushing { stiffness: [stiffness; 6], damping: [0.0; 6] };
        Element { kind: ElementKind::Bushing(bushing), first, second }
    });
    HostMechanism::new(bodies, joints, mechanism.gravity()).unwrap().with_elements(bushings.collect())
}

#[test]
fn a_stiff_bushing_tends_to_the_fixed_joint() {
    let fixed = held(None);
    let (_, start) = double_pendulum(PROJECTION, true);
    let start = Constrained(&fixed).assemble(0.0, start, 1e-10).unwrap().0;
    let end = |mechanism: &HostMechanism, steps: usize| {
        let system = Constrained(mechanism);
        let (mut state, h) = (start.clone(), 0.1 / steps as f64);
        for k in 0..steps {
            state = step_linearly_implicit(&system, &state, k as f64 * h, h).unwrap().0;
        }
        state.iter().flat_map(State::numbers).collect::<Vec<f64>>()
    };
    let expected = end(&fixed, 4000);
    let apart = |stiffness: f64, steps: usize| {
        let soft = held(Some(stiffness));
        let found = end(&soft, steps);
        let apart = found.iter().zip(&expected).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        eprintln!("stiffness {stiffness:e}, {steps} steps: {apart:.2e}");
        apart
    };
    // what a bushing gives way falls with its stiffness, until the error of steps is left
    let [loose, firm] = [1e6, 1e9].map(|stiffness| apart(stiffness, 2000));
    assert!(firm < 0.01 * loose, "{firm:e} {loose:e}");
    // the error of steps, of order one at least: stages meet curved motion to first order only
    let errors = [500, 1000, 2000].map(|steps| apart(1e12, steps));
    assert!(errors[0] < 1e-4 && errors.windows(2).all(|pair| pair[1] < 0.6 * pair[0]), "{errors:?}");
}
