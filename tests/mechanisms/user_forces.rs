//! Loads of the user's own see the whole mechanism: states of all bodies, time and controls.

use ffrf::mechanism;
use ffrf::mechanism::{Constrained, Loaded, Mechanism};
use ffrf::nalgebra::Vector3;
use ffrf::{Marker, Wrench, step_linearly_implicit, step_rk4};

use crate::bodies::{BIG_END, Rod, SMALL_END};

/// Order of operations: the same force, summed elsewhere.
const SAME: f64 = 1e-12;

mechanism! {
    /// Two rods in a row with a spring between their far ends, of the runtime or of the user's own.
    pub struct Pair {
        bodies: { rods: [Rod; 2] },
        gravity: [0.0, -9.81, 0.0],
        joints: {
            root: revolute(ground, rods[0].BIG_END, axis: z),
            knee: revolute(rods[0].SMALL_END, rods[1].BIG_END, axis: z),
        },
        controls: { stiffness: 0.0, push: 0.0 },
        forces: {
            spring: spring(rods[0].BIG_END, rods[1].SMALL_END, stiffness: 0.0, damping: 0.0, rest_length: 0.2),
            own: user(own_spring),
            pulse: user(|model: &Pair, time: f64, ports: &mut PairPorts<'_>| {
                let force = Vector3::y() * (model.push * (50.0 * time).sin());
                ports.rods[1].push_at(&Rod::SMALL_END, &Wrench { force, moment: Vector3::zeros() });
            }),
        },
    }
}

/// Sees both bodies and a control.
fn own_spring(model: &Pair, _: f64, ports: &mut PairPorts<'_>) {
    let [first, second] = &mut ports.rods;
    let between = second.motion_of(&Rod::SMALL_END).position - first.motion_of(&Rod::BIG_END).position;
    let pull = between.normalize() * (model.stiffness * (between.norm() - 0.2));
    let moment = Vector3::zeros();
    first.push_at(&Rod::BIG_END, &Wrench { force: pull, moment });
    second.push_at(&Rod::SMALL_END, &Wrench { force: -pull, moment });
}

fn level(model: &Pair) -> PairState {
    let mut state = model.at_rest();
    for (k, rod) in state.rods.iter_mut().enumerate() {
        rod.position.x = k as f64 * (SMALL_END - BIG_END) - BIG_END;
    }
    state
}

fn apart(one: &PairState, other: &PairState) -> f64 {
    let (one, other) = (one.to_array(), other.to_array());
    one.iter().zip(&other).fold(0.0_f64, |most, (one, other)| most.max((one - other).abs()))
}

/// What the error of a step of 1e-4 s may be of what the spring does: (h ω)² is 1e-3 for its 300 rad/s.
const ORDER_TWO: f64 = 0.05;

#[test]
fn a_spring_of_the_users_own_is_the_spring() {
    let mut built_in = Pair::new([Rod; 2]);
    built_in.spring.kind.stiffness = 2e4;
    let mut own = Pair::new([Rod; 2]);
    own.stiffness = 2e4;
    let (mut one, mut two) = (built_in.in_motion(level(&built_in)), own.in_motion(level(&own)));
    let mut none = Pair::new([Rod; 2]).in_motion(level(&own));
    for _ in 0..50 {
        one.step_rk4(5e-6).unwrap();
        two.step_rk4(5e-6).unwrap();
        none.step_rk4(5e-6).unwrap();
    }
    assert!(apart(&one.state, &two.state) < SAME, "{:.2e}", apart(&one.state, &two.state));
    for _ in 0..20 {
        one.step_linearly_implicit(1e-4).unwrap();
        two.step_linearly_implicit(1e-4).unwrap();
        none.step_linearly_implicit(1e-4).unwrap();
    }
    // implicit steps have the element in their matrix, and the user's own as a force: both are of order two
    let (differ, effect) = (apart(&one.state, &two.state), apart(&one.state, &none.state));
    assert!(differ < ORDER_TWO * effect, "{differ:.2e} of {effect:.2e}");
    assert!(apart(&one.state, &none.state) > 1e-4, "the spring does something");
}

#[test]
fn a_closure_that_captures_is_a_load_of_a_step() {
    let mut model = Pair::new([Rod; 2]);
    model.push = 30.0;
    let mut with_function = model.in_motion(level(&model));
    model.push = 0.0;
    let size = 30.0;
    let pulse = Loaded::new(&model, |_, time, ports| {
        let force = Vector3::y() * (size * (50.0_f64 * time).sin());
        ports.rods[1].push_at(&Rod::SMALL_END, &Wrench { force, moment: Vector3::zeros() });
    });
    let mut with_closure = Mechanism::new(pulse, level(&model));
    for _ in 0..40 {
        with_function.step_rk4(5e-6).unwrap();
        with_closure.step_rk4(5e-6).unwrap();
        with_function.step_with(1e-4, step_linearly_implicit).unwrap();
        with_closure.step_with(1e-4, step_linearly_implicit).unwrap();
    }
    assert!(apart(&with_function.state, &with_closure.state) < SAME);
    let mut alone = model.in_motion(level(&model));
    for _ in 0..40 {
        alone.step_rk4(5e-6).unwrap();
        alone.step_linearly_implicit(1e-4).unwrap();
    }
    assert!(apart(&alone.state, &with_closure.state) > 1e-4, "the load does something");
}

#[test]
fn any_point_of_a_body_can_be_pushed() {
    let model = Pair::new([Rod; 2]);
    let point = Marker::rigid(Vector3::new(0.02, 0.01, 0.0), &Rod::SMALL_END.translation[0]);
    let pushed = Loaded::new(&model, |_, _, ports| {
        let up = Vector3::y() * 5.0;
        ports.rods[0].push_at(&point, &Wrench { force: up, moment: Vector3::zeros() });
        assert!(ports.rods[0].state.position.x > 0.0 && ports.rods[1].state.position.x > 0.1);
    });
    let start = level(&model);
    let (pushed, _) = step_rk4(&Constrained(&pushed), &start, 0.0, 5e-6).unwrap();
    let (alone, _) = step_rk4(&Constrained(&model), &start, 0.0, 5e-6).unwrap();
    // about the hinge, upwards
    assert!(pushed.rods[0].angular_velocity.z > alone.rods[0].angular_velocity.z);
}
