//! The co-rotated force: gradient of its energy, frames and their derivatives.

use faer::Mat;
use ffrf_fe::formulations::corotated::{CorotatedModel, ElasticState, Frame};
use ffrf_fe::formulations::rotation::{cross, skew};

use crate::beam::{beam, deformation, placed};
use crate::tolerances::DIFFERENCE;

fn cases() -> Vec<(&'static str, CorotatedModel, Frame, Mat<f64>)> {
    let model = beam([3, 1, 1]);
    let body = CorotatedModel::absolute(&model).expect("a model with stiffness");
    let bent = placed(&body, &deformation(&model, 0.2));
    let three = Frame::three_points(body.reference.as_ref(), [0, 3, 9]).expect("nodes not on a line");
    let modes = Mat::from_fn(3 * model.nodes.len(), 2, |row, mu| {
        let [x, y, z] = model.nodes.positions[row / 3];
        [[-2.0 * x * y, x * x, 0.0], [0.0, -x * z, x * y + 0.2 * x * x]][mu][row % 3]
    });
    let reduced = CorotatedModel::generalized(&model, modes.as_ref()).expect("modes of the mesh");
    let coordinates = Mat::from_fn(3 * reduced.triples(), 1, |row, _| {
        reduced.reference[(row, 0)] + 0.2 * (1.7 * row as f64).sin()
    });
    vec![
        ("mean rotation", body.clone(), body.mean_frame(), bent.clone()),
        ("three points", body, three, bent),
        ("generalised modes, directors", reduced.clone(), reduced.director_frame(), coordinates.clone()),
        ("generalised modes, mean rotation", reduced.clone(), reduced.mean_frame(), coordinates),
    ]
}

fn slope(at: &Mat<f64>, along: &Mat<f64>, f: impl Fn(&Mat<f64>) -> Mat<f64>) -> Mat<f64> {
    let h = 1e-6;
    let shift = |h: f64| f(&(at + faer::Scale(h) * along));
    faer::Scale(0.5 / h) * (shift(h) - shift(-h))
}

fn directions(size: usize) -> Vec<Mat<f64>> {
    (1..6).map(|k| Mat::from_fn(size, 1, |i, _| (1.3 * (k * (i + 2)) as f64).sin())).collect()
}

#[test]
fn equation_012_force_is_the_gradient_of_the_energy() {
    for (name, body, frame, at) in cases() {
        let state = ElasticState::at(&body, &frame, &at).expect("a frame");
        let force = state.inertial_force();
        let nonlinear = (&state.force - &state.linear_force).norm_max() / state.force.norm_max();
        println!("{name}: nonlinear term {nonlinear:e} of the force");
        assert!(nonlinear > 1e-3, "the small nonlinear term shows at this deformation");
        let mut without_is_wrong = false;
        for along in directions(at.nrows()) {
            let work = slope(&at, &along, |r| {
                let energy = ElasticState::at(&body, &frame, r).expect("a frame").energy;
                Mat::from_fn(1, 1, |_, _| energy)
            })[(0, 0)];
            let scale = force.norm_l2() * along.norm_l2();
            let off = (work - (force.transpose() * &along)[(0, 0)]).abs() / scale;
            assert!(off < DIFFERENCE, "{name}: {off:e}");
            let linear = body.from_body_frame(state.linear_force.as_ref(), state.rotation.as_ref());
            let missing = (work - (linear.transpose() * &along)[(0, 0)]).abs() / scale;
            without_is_wrong |= missing > 100.0 * DIFFERENCE;
        }
        assert!(without_is_wrong, "{name}: without f_nl the force is no gradient");
    }
}

#[test]
fn equation_007_frames_turn_with_the_body_and_know_their_rate() {
    for (name, _, frame, at) in cases() {
        let position = frame.at(at.as_ref()).expect("a frame");
        let a = &position.rotation;
        assert!((a.transpose() * a - Mat::<f64>::identity(3, 3)).norm_max() < 1e-14, "{name}: orthogonal");
        for along in directions(at.nrows()) {
            let rate = slope(&at, &along, |r| frame.at(r.as_ref()).expect("a frame").rotation);
            // δA = A δθ̄~ with δθ̄ = Γ̄ A_bdᵀ δr.
            let back = Mat::from_fn(at.nrows(), 1, |row, _| {
                (0..3).map(|j| a[(j, row % 3)] * along[(row - row % 3 + j, 0)]).sum::<f64>()
            });
            let spin = position.spin.transpose() * back;
            let expected = a * skew([0, 1, 2].map(|i| spin[(i, 0)]));
            let off = (&rate - &expected).norm_max() / expected.norm_max();
            assert!(off < DIFFERENCE, "{name}: {off:e}");
        }
    }
}

#[test]
fn no_resultant_and_no_moment_from_the_elastic_force() {
    let (_, body, frame, at) = cases().swap_remove(0);
    let force = ElasticState::at(&body, &frame, &at).expect("a frame").inertial_force();
    let (mut resultant, mut moment) = ([0.0; 3], [0.0; 3]);
    for node in 0..body.triples() {
        let vector = |of: &Mat<f64>| [0, 1, 2].map(|i| of[(3 * node + i, 0)]);
        let turned = cross(vector(&at), vector(&force));
        for i in 0..3 {
            resultant[i] += vector(&force)[i];
            moment[i] += turned[i];
        }
    }
    let largest = |v: [f64; 3]| v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    assert!(largest(resultant) < 1e-10 * force.norm_max(), "{resultant:?}");
    assert!(largest(moment) < 1e-10 * force.norm_max() * at.norm_max(), "{moment:?}");
}
