//! Consistency checks: a sound body passes, and each fault is seen and measured.
#![allow(clippy::unwrap_used)]

mod sample;

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
}

#[test]
fn equal_modes_are_seen() {
    let mut points = sample::points(2);
    for point in &mut points {
        point.shapes[1] = point.shapes[0].map(|entry| 3.0 * entry);
    }
    let mut body = sample::body(2);
    body.inertia = sample::inertia(&points);
    assert_fails(&body, "from each other");
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
