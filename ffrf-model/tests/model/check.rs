//! Consistency checks: a sound body passes, and each fault is seen and measured.
#![allow(clippy::unwrap_used)]

use crate::sample;
use ffrf_model::{CheckReport, ReducedBody};

fn report(body: &ReducedBody) -> CheckReport {
    body.check().unwrap()
}

/// Asserts that exactly one check fails and that its text holds `subject`.
fn assert_fails(body: &ReducedBody, subject: &str) {
    let report = report(body);
    let failed: Vec<String> = report.failures().map(ToString::to_string).collect();
    assert!(failed.iter().any(|text| text.contains(subject)), "{subject} is not among {failed:?}");
    let verdict = report.verdict().unwrap_err().to_string();
    assert!(verdict.contains(subject), "{verdict}");
}

#[test]
fn a_sound_body_passes() {
    for modes in [0, 1, 2, 5] {
        let report = report(&sample::body(modes));
        report.verdict().unwrap();
    }
}

#[test]
fn negative_mass_is_seen() {
    let mut body = sample::body(2);
    body.inertia.mass = -1.0;
    assert_fails(&body, "mass: -1.000e0, must be above 0e0");
}

#[test]
fn asymmetry_is_measured() {
    let mut body = sample::body(2);
    body.stiffness[0][1] += 2.0;
    assert_fails(&body, "asymmetry of the stiffness K_ff: 1.000e-4");
    let mut body = sample::body(2);
    body.damping[1][0] = 0.01;
    assert_fails(&body, "asymmetry of the damping D_ff: 5.000e-2");
    let mut body = sample::body(2);
    body.inertia.second_moment[0][2] += 1.0;
    assert_fails(&body, "asymmetry of the second moment T");
    let mut body = sample::body(2);
    body.inertia.mode_mode_moment[0][1][0][1] += 1.0;
    assert_fails(&body, "deviation of T_νμ from the transpose of T_μν");
}

#[test]
fn a_transposed_mode_mode_block_is_seen() {
    let mut body = sample::body(2);
    let block = body.inertia.mode_mode_moment[0][1];
    body.inertia.mode_mode_moment[0][1] = body.inertia.mode_mode_moment[1][0];
    assert_ne!(block, body.inertia.mode_mode_moment[0][1]);
    assert_fails(&body, "deviation of T_νμ");
}

#[test]
fn impossible_inertia_is_seen() {
    // Scaling the second moment down leaves a centre of mass outside of what the inertia allows.
    let mut body = sample::body(2);
    for mu in 0..2 {
        for i in 0..3 {
            body.inertia.mode_mode_moment[mu][mu][i][i] *= 0.2;
        }
    }
    assert_fails(&body, "Gram matrix");
}

#[test]
fn round_off_in_a_direction_without_motion_is_no_fault() {
    let mut points = sample::points(2);
    for point in &mut points {
        point.shapes[1][2] *= 1e-17;
    }
    let mut body = sample::body(2);
    body.inertia = sample::inertia(&points);
    // As large as round-off of the mode's other components, and far larger than its own.
    body.inertia.position_mode_moment[1][0][2] = 1e-16;
    report(&body).verdict().unwrap();
}

#[test]
fn a_mode_that_is_a_rigid_motion_is_seen() {
    let mut points = sample::points(2);
    for point in &mut points {
        // Translation along z plus a rotation about x.
        point.shapes[1] = [0.0, -0.3 * point.position[2], 2.0 + 0.3 * point.position[1]];
    }
    let mut body = sample::body(2);
    body.inertia = sample::inertia(&points);
    assert_fails(&body, "independence of the modes from rigid motion");
    assert_fails(&body, "(counted from 1, mode 2 is a rigid motion)");
}

#[test]
fn equal_modes_are_seen() {
    let mut points = sample::points(2);
    for point in &mut points {
        point.shapes[1] = point.shapes[0].map(|entry| 3.0 * entry);
    }
    let mut body = sample::body(2);
    body.inertia = sample::inertia(&points);
    assert_fails(&body, "from each other (counted from 1, mode 2 repeats mode 1)");
}

#[test]
fn every_dependent_mode_is_named_with_what_it_repeats() {
    let mut points = sample::points(9);
    for point in &mut points {
        let [x, y, z] = point.position;
        // Mode 4 of modes 1 and 3; mode 6 of a rotation and mode 2; mode 8 is a translation; mode 9 does not move.
        point.shapes[3] = [0, 1, 2].map(|i| point.shapes[0][i] - 2.0 * point.shapes[2][i]);
        point.shapes[5] = [0, 1, 2].map(|i| [-y, x, 0.0 * z][i] + point.shapes[1][i]);
        point.shapes[7] = [0.0, 1e-3, 0.0];
        point.shapes[8] = [0.0; 3];
    }
    let mut body = sample::body(9);
    body.inertia = sample::inertia(&points);
    let expected = "(counted from 1, mode 4 is a combination of modes 1, 3; mode 6 is a combination of rigid motion and \
                    mode 2; mode 8 is a rigid motion; mode 9 moves no mass)";
    assert_fails(&body, expected);
}

#[test]
fn long_lists_of_dependent_modes_are_cut() {
    let mut points = sample::points(20);
    for point in &mut points {
        for mu in 10..20 {
            point.shapes[mu] = point.shapes[mu - 10];
        }
    }
    let mut body = sample::body(20);
    body.inertia = sample::inertia(&points);
    assert_fails(&body, "mode 16 repeats mode 6; and modes 17, 18, 19, 20)");
}

#[test]
fn modes_that_are_dependent_only_together_are_named() {
    // Modes 3 and 4 are made of the first two and a share of their own. The share at which the check starts to fail
    // leaves each by itself enough, but not both together.
    let failure = |share: f64| {
        let mut points = sample::points(4);
        for point in &mut points {
            for (mu, sign) in [(2, 1.0), (3, -1.0)] {
                let combined = |i: usize| point.shapes[0][i] + sign * point.shapes[1][i];
                point.shapes[mu] = [0, 1, 2].map(|i| combined(i) + share * point.shapes[mu][i]);
            }
        }
        let mut body = sample::body(4);
        body.inertia = sample::inertia(&points);
        let report = report(&body);
        report.failures().map(ToString::to_string).next()
    };
    assert_eq!(failure(1e-3), None);
    let first = (0..200).find_map(|k| failure(1e-3 * 0.95_f64.powi(k))).unwrap();
    // The last one may hold a share of the one before as well.
    assert!(first.contains(" is a combination of modes 1, 2"), "{first}");
}

#[test]
fn all_mass_on_a_line_is_seen() {
    let mut points = sample::points(1);
    for point in &mut points {
        point.position = [point.position[0], 0.0, 0.0];
    }
    let mut body = sample::body(1);
    body.inertia = sample::inertia(&points);
    assert_fails(&body, "rotational inertia of the undeformed body about its least axis");
}

#[test]
fn negative_stiffness_and_damping_are_seen() {
    let mut body = sample::body(2);
    body.stiffness[0][0] = -1.0;
    assert_fails(&body, "smallest eigenvalue of K_ff");
    let mut body = sample::body(2);
    body.damping[1][1] = -1e-3;
    assert_fails(&body, "smallest eigenvalue of D_ff");
}

#[test]
fn marker_names_are_checked() {
    let mut body = sample::body(1);
    body.markers.push(body.markers[0].clone());
    assert_fails(&body, "repeated marker names ([\"tip\"])");
    for name in ["", "left end", "1st", "Spitze-ü", "_"] {
        body.markers[1].name = name.to_owned();
        assert_fails(&body, "marker names other than letters");
    }
    body.markers[1].name = "Tip_2".to_owned();
    report(&body).verdict().unwrap();
}
