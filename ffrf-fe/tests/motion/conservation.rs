//! Conservation laws of the implicit midpoint rule in absolute and generalised coordinates.

use faer::Mat;
use ffrf_fe::formulations::corotated::{CorotatedModel, GroundJoint, Midpoint, Motion};
use ffrf_fe::formulations::rotation::{cross, skew};

use crate::beam::{beam, deformation, placed};
use crate::tolerances::CONSERVED;

/// Spinning and vibrating start.
fn start(position: Mat<f64>) -> Motion {
    let spin = skew([0.8, -0.5, 2.0]);
    let velocity = Mat::from_fn(position.nrows(), 1, |row, _| {
        let start = row - row % 3;
        (0..3).map(|j| spin[(row % 3, j)] * position[(start + j, 0)]).sum::<f64>()
    });
    Motion { time: 0.0, position, velocity }
}

fn momenta(body: &CorotatedModel, motion: &Motion) -> [f64; 6] {
    let momentum = body.mass_times(motion.velocity.as_ref());
    let mut sums = [0.0; 6];
    for node in 0..body.triples() {
        let at = |of: &Mat<f64>| [0, 1, 2].map(|i| of[(3 * node + i, 0)]);
        let turned = cross(at(&motion.position), at(&momentum));
        for i in 0..3 {
            sums[i] += at(&momentum)[i];
            sums[3 + i] += turned[i];
        }
    }
    sums
}

#[test]
fn a_free_body_keeps_momentum_exactly_and_energy_to_second_order() {
    let model = beam([4, 1, 1]);
    let body = CorotatedModel::absolute(&model).expect("a model with stiffness");
    let drift = |step: f64| {
        let mut motion = start(placed(&body, &deformation(&model, 0.1)));
        let rule = Midpoint::new(&body, body.mean_frame(), &[], step).expect("positive definite");
        let (energy, before) = (rule.energy(&motion).expect("a frame"), momenta(&body, &motion));
        let (mut worst, mut iterations) = (0.0_f64, 0);
        for _ in 0..(0.4 / step).round() as usize {
            iterations = iterations.max(rule.advance(&mut motion).expect("converges").iterations);
            worst = worst.max((rule.energy(&motion).expect("a frame") / energy - 1.0).abs());
        }
        let scale = before.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        for (now, then) in momenta(&body, &motion).iter().zip(before) {
            assert!((now - then).abs() < CONSERVED * scale, "{now} was {then}");
        }
        println!("h = {step}: energy {worst:e}, at most {iterations} iterations");
        assert!(iterations <= 8, "Newton's iteration sees the turning frame: {iterations} iterations");
        worst
    };
    let (coarse, fine) = (drift(4e-3), drift(2e-3));
    assert!(fine < 2e-2 && fine < 0.35 * coarse, "{coarse:e} {fine:e}: second order");
}

#[test]
fn a_pendulum_keeps_its_point_and_its_energy() {
    let model = beam([4, 1, 1]);
    let body = CorotatedModel::absolute(&model).expect("a model with stiffness");
    for joint in [GroundJoint::node(0), GroundJoint::mean_of(&[0, 5, 10, 15])] {
        let mut motion = Motion {
            time: 0.0,
            position: body.reference.clone(),
            velocity: Mat::zeros(3 * body.triples(), 1),
        };
        let mut rule = Midpoint::new(&body, body.mean_frame(), std::slice::from_ref(&joint), 2e-3)
            .expect("positive definite");
        rule.load = body.gravity([0.0, 0.0, -9.81]);
        let (point, energy) = (joint.point(&motion.position), rule.energy(&motion).expect("a frame"));
        let (mass, centre) = body.centre_of_mass();
        let swing = mass * 9.81 * centre[0];
        let mut reaction = [0.0; 3];
        for _ in 0..150 {
            reaction = rule.advance(&mut motion).expect("converges").reactions[0];
            let off = rule.energy(&motion).expect("a frame") - energy;
            assert!(off.abs() < 2e-2 * swing, "energy {off:e} of {swing:e}");
            for (now, then) in joint.point(&motion.position).iter().zip(point) {
                assert!((now - then).abs() < 1e-10, "the joint holds: {now} was {then}");
            }
        }
        assert!(motion.position[(3 * 4 + 2, 0)] < -0.2, "it swings down");
        assert!(reaction[2] > 0.0, "the joint carries the beam: {reaction:?}");
    }
}
