//! The appendix: the stiffness matrix of three nodes and two bars, (218) to (222).

use faer::Mat;
use ffrf_fe::formulations::rotation::skew;

use crate::bodies::{Body, Part, truss};
use crate::check::{column, different, equal, largest, outer, scaled, vanishes};
use crate::s7_elastic::tilde_identity;

struct Bars {
    body: Body,
    t: [[f64; 3]; 2],
    k: [f64; 2],
}

fn bars() -> Bars {
    let body = truss();
    let along = |n: usize| {
        let difference = [0, 1, 2].map(|i| body.positions[n][i] - body.positions[n + 1][i]);
        let length = difference.iter().map(|x| x * x).sum::<f64>().sqrt();
        difference.map(|x| x / length)
    };
    Bars { t: [along(0), along(1)], k: [300.0, 220.0], body }
}

/// (218) with a factor on its first block.
fn stiffness(bars: &Bars, factor: f64) -> Mat<f64> {
    let [first, second] = [0, 1].map(|b| scaled(bars.k[b], &outer(bars.t[b], bars.t[b])));
    let zero = Mat::zeros(3, 3);
    let blocks = [
        [scaled(factor, &first), scaled(-1.0, &first), zero.clone()],
        [scaled(-1.0, &first), &first + &second, scaled(-1.0, &second)],
        [zero, scaled(-1.0, &second), second.clone()],
    ];
    Mat::from_fn(9, 9, |i, j| blocks[i / 3][j / 3][(i % 3, j % 3)])
}

fn dense_stiffness(body: &Body) -> Mat<f64> {
    &body.stiffness * Mat::<f64>::identity(9, 9)
}

#[test]
fn equation_218_stiffness_of_two_bars() {
    let bars = bars();
    equal(&stiffness(&bars, 1.0), &dense_stiffness(&bars.body));
    // The printed [1.4] is a spacing instruction; read as a factor it breaks translational invariance.
    different(&stiffness(&bars, 1.4), &dense_stiffness(&bars.body));
    let pushed = bars.body.modes.translation().transpose() * stiffness(&bars, 1.4);
    assert!(largest(&pushed) > 0.1 * largest(&dense_stiffness(&bars.body)));
}

#[test]
fn equation_219_translation_is_free() {
    let body = bars().body;
    let scale = largest(&dense_stiffness(&body));
    vanishes(&(body.modes.translation().transpose() * dense_stiffness(&body)), scale);
    for part in [Part::T, Part::R, Part::F] {
        vanishes(&body.k_block(Part::T, part), scale);
    }
}

#[test]
fn equation_220_linearised_rotations() {
    let body = bars().body;
    let expected = Mat::from_fn(3, 9, |i, j| skew(body.positions[j / 3])[(i, j % 3)]);
    equal(&(tilde_identity() * body.modes.rotation().transpose()), &expected);
}

#[test]
fn equation_221_moment_of_the_bar_forces() {
    let bars = bars();
    let found = tilde_identity() * bars.body.modes.rotation().transpose() * dense_stiffness(&bars.body);
    let r = |n: usize| skew(bars.body.positions[n]);
    let moment = |b: usize, sign: f64| {
        let lever = scaled(sign * bars.k[b], &(r(b) - r(b + 1)));
        lever * outer(bars.t[b], bars.t[b])
    };
    let columns = [moment(0, 1.0), moment(0, -1.0) + moment(1, 1.0), moment(1, -1.0)];
    let expected = Mat::from_fn(3, 9, |i, j| columns[j / 3][(i, j % 3)]);
    let scale = bars.k[0] * bars.body.positions.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
    vanishes(&(found - &expected), scale);
    // Each factor (r̃_1 - r̃_2) t_1 is t_1 × t_1.
    for b in 0..2 {
        vanishes(&((r(b) - r(b + 1)) * column(&bars.t[b])), 1.0);
    }
}

#[test]
fn equation_222_no_moment_from_any_deformation() {
    let body = bars().body;
    let k_rf =
        tilde_identity() * body.modes.rotation().transpose() * dense_stiffness(&body) * body.modes.flexible();
    vanishes(&k_rf, largest(&dense_stiffness(&body)) * largest(&body.shapes) * 9.0);
}
