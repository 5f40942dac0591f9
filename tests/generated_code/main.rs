//! Generated code that is committed, Rust and C: it is up to date, it compiles, and it computes what the equations say.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

#[path = "../golden/bodies.rs"]
mod bodies;
mod c;
mod c_mechanism;
mod c_program;
mod c_step;
mod committed;
mod jacobians;
mod loaded_markers;
#[rustfmt::skip]
#[path = "../golden/constant_m2.rs"]
mod constant_m2;
#[rustfmt::skip]
#[path = "../golden/free_free_m3.rs"]
mod free_free_m3;
#[rustfmt::skip]
#[path = "../golden/general_m2.rs"]
mod general_m2;
#[rustfmt::skip]
#[path = "../golden/generic_m2.rs"]
mod generic_m2;
#[rustfmt::skip]
#[path = "../golden/jacobians_m2.rs"]
mod jacobians_m2;
#[rustfmt::skip]
#[path = "../golden/normalised_m3.rs"]
mod normalised_m3;
#[rustfmt::skip]
#[path = "../golden/rigid.rs"]
mod rigid;
#[rustfmt::skip]
#[path = "../golden/single_m3.rs"]
mod single_m3;
#[rustfmt::skip]
#[path = "../golden/stiffened_lanes_m3.rs"]
mod stiffened_lanes_m3;
#[rustfmt::skip]
#[path = "../golden/stiffened_m2.rs"]
mod stiffened_m2;

use std::path::Path;

use bodies::all;
use committed::Committed;
use ffrf_codegen::{Kernels, generate};
use ffrf_test_kit::random_body::{Modes, random_body};
use ffrf_test_kit::witness;

#[test]
fn committed_code_is_what_the_generator_prints() {
    let mut committed = Committed::default();
    for (name, body, options) in all() {
        let text = generate(&body, &options).unwrap().text;
        // A second run prints the same bytes.
        assert_eq!(text, generate(&body, &options).unwrap().text);
        let text = format!("//! Generated code, committed: see tests/generated_code/main.rs.\n\n{text}");
        committed.compare(&format!("{name}.rs"), &text);
    }
    // The model that tests/macro_bodies/models.rs names.
    let model = random_body(11, 4, Modes::Random);
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/models/random_m4.ffrf.json");
    let is_current = ffrf_model::ReducedBody::read(&path).ok().as_ref() == Some(&model);
    committed.note("random_m4", is_current, || model.write(&path).unwrap());
    committed.assert_current();
}

#[test]
fn compiled_code_agrees_with_the_naive_form_and_with_the_interpreter() {
    let find = |wanted: &str| {
        let (_, body, options) = all().into_iter().find(|(name, ..)| *name == wanted).unwrap();
        (Kernels::formulate(&body, &options).unwrap(), body)
    };
    let (kernels, body) = find("rigid");
    witness::check::<0, 6, _>(&rigid::RigidBody, &body, &kernels, true);
    let (kernels, body) = find("general_m2");
    witness::check::<2, 8, _>(&general_m2::GeneralBody, &body, &kernels, true);
    let (kernels, body) = find("stiffened_m2");
    witness::check::<2, 8, _>(&stiffened_m2::StiffenedBody, &body, &kernels, true);
    let (kernels, body) = find("stiffened_lanes_m3");
    witness::check::<3, 9, _>(&stiffened_lanes_m3::StiffenedLanes, &body, &kernels, true);
    let (kernels, body) = find("generic_m2");
    witness::check::<2, 8, _>(&generic_m2::GenericBody, &body, &kernels, true);
    let (kernels, body) = find("normalised_m3");
    witness::check::<3, 9, _>(&normalised_m3::NormalisedBody, &body, &kernels, true);
    let (kernels, body) = find("free_free_m3");
    witness::check::<3, 9, _>(&free_free_m3::FreeFreeBody, &body, &kernels, true);
    // A truncated energy is not that of the naive form.
    let (kernels, body) = find("constant_m2");
    witness::check::<2, 8, _>(&constant_m2::ConstantBody, &body, &kernels, false);
}

#[test]
fn single_precision_code_agrees_with_double_precision() {
    let (_, body, options) = all().into_iter().find(|(name, ..)| *name == "single_m3").unwrap();
    let kernels = Kernels::formulate(&body, &options).unwrap();
    witness::check_single::<3, 9, _>(&single_m3::SingleBody, &kernels);
}

#[test]
fn constants_and_markers_of_a_body_are_those_of_its_model() {
    use ffrf::{FlexibleBody, NamedMarkers};
    use general_m2::GeneralBody;
    let (_, body, _) = all().into_iter().find(|(name, ..)| *name == "general_m2").unwrap();
    assert_eq!(GeneralBody::MODE_COUNT, 2);
    assert_eq!(GeneralBody::MASS, body.inertia.mass);
    assert_eq!(GeneralBody::FREQUENCIES_HZ, [None, Some(12.5)]);
    assert_eq!(GeneralBody.largest_stable_step(), body.largest_stable_step());
    assert_eq!(GeneralBody.marker_names(), ["tip", "root"]);
    assert_eq!(GeneralBody::TIP.position.as_slice(), body.markers[0].position);
    let root = GeneralBody.marker("root").unwrap();
    for axis in 0..3 {
        for mode in 0..2 {
            assert_eq!(root.translation[axis][mode], body.markers[1].translation[mode][axis]);
            assert_eq!(root.rotation[axis][mode], body.markers[1].rotation[mode][axis]);
        }
    }
    assert_eq!(GeneralBody.marker("nowhere"), None);
}

#[test]
fn stress_markers_of_a_body_are_those_of_its_model() {
    use ffrf::NamedMarkers;
    use ffrf::nalgebra::Vector2;
    use stiffened_m2::StiffenedBody;
    let (_, body, _) = all().into_iter().find(|(name, ..)| *name == "stiffened_m2").unwrap();
    assert_eq!(StiffenedBody.stress_marker_names(), ["notch"]);
    let (marker, model) = (StiffenedBody.stress_marker("notch").unwrap(), &body.stress_markers[0]);
    assert_eq!(marker.position.as_slice(), model.position);
    let q = [0.3, -0.7];
    let expected: [f64; 6] = std::array::from_fn(|k| q[0] * model.stress[0][k] + q[1] * model.stress[1][k]);
    let found = marker.stress(&Vector2::from(q));
    // Two products of numbers up to a hundred.
    assert!(
        found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-13),
        "{found:?}"
    );
    assert_eq!(marker.von_mises(&Vector2::from(q)), ffrf::von_mises(&found));
    assert_eq!(StiffenedBody.stress_marker("tip"), None);
    assert_eq!(StiffenedBody.section_marker_names(), ["cut"]);
    let (marker, model) = (StiffenedBody.section_marker("cut").unwrap(), &body.section_markers[0]);
    assert_eq!(marker, StiffenedBody::CUT);
    assert_eq!(marker.position.as_slice(), model.position);
    let q = [2.0, -1.0];
    let expected: [f64; 6] = std::array::from_fn(|k| q[0] * model.force[0][k] + q[1] * model.force[1][k]);
    let (force, moment) = (marker.force(&Vector2::from(q)), marker.moment(&Vector2::from(q)));
    assert_eq!([force.as_slice(), moment.as_slice()].concat(), expected);
}
