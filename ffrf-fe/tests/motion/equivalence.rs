//! One pendulum in all formulations: they move alike, up to the terms that they neglect.

use faer::Mat;
use ffrf_fe::FeModel;
use ffrf_fe::formulations::corotated::{CorotatedModel, Frame, GroundJoint, Midpoint, Motion};
use ffrf_fe::formulations::floating::{FloatingBody, FloatingMotion, Pin, RungeKutta};

use crate::beam::beam;
use crate::modes::free_modes;
use crate::tolerances::SAME_SPAN;

const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];
/// The pinned node and the node observed, opposite corners of the beam.
const HELD: usize = 0;

/// Tip at the end, floating frame with `modes` modes. The frame starts at the reference position.
fn floating(model: &FeModel, modes: usize, time: f64, steps: usize) -> [f64; 3] {
    let (shapes, _) = free_modes(model, modes);
    let body = FloatingBody::new(model, shapes.as_ref()).expect("a model with stiffness");
    let rows = |node: usize| shapes.as_ref().subrows(3 * node, 3).to_owned();
    let pin = Pin { position: model.nodes.positions[HELD], shapes: rows(HELD) };
    let rule = RungeKutta { body: &body, gravity: GRAVITY, pin: Some(pin) };
    let mut motion = FloatingMotion {
        time: 0.0,
        origin: [0.0; 3],
        theta: [1.0, 0.0, 0.0, 0.0],
        q: vec![0.0; modes],
        velocity: [0.0; 3],
        omega: [0.0; 3],
        q_dot: vec![0.0; modes],
    };
    for _ in 0..steps {
        rule.advance(&mut motion, time / steps as f64);
    }
    let tip = model.nodes.len() - 1;
    motion.point(model.nodes.positions[tip], rows(tip).as_ref())
}

fn corotated(
    body: &CorotatedModel,
    frame: Frame,
    joints: [GroundJoint; 2],
    time: f64,
    steps: usize,
) -> [f64; 3] {
    let [held, tip] = joints;
    let mut rule = Midpoint::new(body, frame, &[held], time / steps as f64).expect("positive definite");
    rule.load = body.gravity(GRAVITY);
    let velocity = Mat::zeros(3 * body.triples(), 1);
    let mut motion = Motion { time: 0.0, position: body.reference.clone(), velocity };
    for _ in 0..steps {
        rule.advance(&mut motion).expect("converges");
    }
    tip.point(&motion.position)
}

fn absolute(model: &FeModel, nonlinear_term: bool, time: f64, steps: usize) -> [f64; 3] {
    let mut body = CorotatedModel::absolute(model).expect("a model with stiffness");
    body.nonlinear_term = nonlinear_term;
    let joints = [GroundJoint::node(HELD), GroundJoint::node(model.nodes.len() - 1)];
    corotated(&body, body.mean_frame(), joints, time, steps)
}

/// Generalised modes, frame by their mean deformation (all modes, orthonormal) or by the directors (60).
fn generalized(model: &FeModel, modes: usize, directors: bool, time: f64, steps: usize) -> [f64; 3] {
    let (shapes, _) = free_modes(model, modes);
    let body = CorotatedModel::generalized(model, shapes.as_ref()).expect("a model with stiffness");
    let joint = |node: usize| GroundJoint::generalized(model.nodes.positions[node], shapes.as_ref(), node);
    let joints = [joint(HELD), joint(model.nodes.len() - 1)];
    if directors {
        return corotated(&body, body.director_frame(), joints, time, steps);
    }
    let (body, combined) = body.orthonormal().expect("eigenvalues converge");
    println!("{modes} modes: {} coordinates of {}", 3 * body.triples(), 12 + 9 * modes);
    corotated(&body, body.mean_frame(), joints.map(|joint| combined.joint(&joint)), time, steps)
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn absolute_coordinates_converge_to_the_floating_frame_with_all_modes() {
    let model = beam([2, 1, 1]);
    let all = 3 * model.nodes.len() - 6;
    let time = 0.5;
    let truth = floating(&model, all, time, 4000);
    let finer = floating(&model, all, time, 2000);
    let own = distance(truth, finer);
    let errors = [1600, 3200].map(|steps| distance(truth, absolute(&model, true, time, steps)));
    println!("floating frame against itself {own:e}; absolute coordinates {errors:?}");
    assert!(truth[2] < -0.5, "the motion is large: {truth:?}");
    assert!(own < 1e-7);
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((1.8..2.2).contains(&order), "second order in the step, found {order}");
    }
    // Without the nonlinear term there is a limit that smaller steps do not remove.
    let without = distance(truth, absolute(&model, false, time, 3200));
    println!("without the nonlinear term {without:e}");
    assert!(without > 3.0 * errors[1], "{without:e} against {:e}", errors[1]);
}

#[test]
fn generalised_modes_of_a_complete_basis_are_the_mesh() {
    let model = beam([2, 1, 1]);
    let all = 3 * model.nodes.len() - 6;
    let (time, steps) = (0.3, 200);
    let off = distance(absolute(&model, true, time, steps), generalized(&model, all, false, time, steps));
    println!("{off:e}");
    assert!(off < SAME_SPAN, "{off:e}");
}

#[test]
fn reduced_models_converge_with_the_number_of_modes() {
    let model = beam([6, 1, 1]);
    let (time, steps) = (0.4, 400);
    let truth = absolute(&model, true, time, steps);
    let general = [1, 4, 8].map(|modes| distance(truth, generalized(&model, modes, false, time, steps)));
    let directors = [1, 2].map(|modes| distance(truth, generalized(&model, modes, true, time, 4 * steps)));
    let reduced = [2, 8, 30].map(|modes| distance(truth, floating(&model, modes, time, 4 * steps)));
    println!("generalised modes {general:?}, by directors {directors:?}, floating frame {reduced:?}");
    assert!(general[2] < 0.5 * general[0] && reduced[2] < 0.5 * reduced[0]);
}
