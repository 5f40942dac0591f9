//! The file format: bit-exact round trip, strict reading, whole files or none.
#![allow(clippy::unwrap_used)]

use crate::sample;
use ffrf_model::{ModelError, ReducedBody};
use proptest::prelude::*;

fn assert_same_bits(left: &ReducedBody, right: &ReducedBody) {
    // PartialEq takes 0.0 and -0.0 for equal; the printed form tells them apart.
    assert_eq!(format!("{left:?}"), format!("{right:?}"));
}

#[test]
fn round_trip_keeps_every_bit_and_every_byte() {
    for modes in [0, 1, 3] {
        let body = sample::body(modes);
        let text = body.to_json().unwrap();
        let read = ReducedBody::from_json(&text).unwrap();
        assert_same_bits(&body, &read);
        assert_eq!(text, read.to_json().unwrap());
    }
}

proptest! {
    #[test]
    fn any_finite_number_survives(bits in proptest::collection::vec(any::<u64>(), 9)) {
        let mut body = sample::body(1);
        let numbers: Vec<f64> = bits
            .iter()
            .map(|bits| f64::from_bits(*bits))
            .map(|number| if number.is_finite() { number } else { 0.0 })
            .collect();
        for i in 0..3 {
            body.inertia.second_moment[i].copy_from_slice(&numbers[3 * i..3 * i + 3]);
        }
        let (read, _) = ReducedBody::from_json_with_report(&body.to_json().unwrap()).unwrap();
        for (row, expected) in read.inertia.second_moment.iter().zip(numbers.chunks(3)) {
            for (found, expected) in row.iter().zip(expected) {
                prop_assert_eq!(found.to_bits(), expected.to_bits());
            }
        }
    }

    #[test]
    fn subnormal_numbers_survive(bits in 1_u64..1 << 52, negative in any::<bool>()) {
        let mut body = sample::body(1);
        let number = f64::from_bits(bits | (u64::from(negative) << 63));
        body.inertia.mass = number;
        let (read, _) = ReducedBody::from_json_with_report(&body.to_json().unwrap()).unwrap();
        prop_assert_eq!(read.inertia.mass.to_bits(), number.to_bits());
    }
}

#[test]
fn the_corners_of_the_format_survive() {
    for number in [-0.0, 0.0, f64::MIN_POSITIVE, f64::MAX, f64::MIN, 5e-324, 0.1 + 0.2, 1e22, 1e23] {
        let mut body = sample::body(1);
        body.stiffness[0][0] = number;
        let (read, _) = ReducedBody::from_json_with_report(&body.to_json().unwrap()).unwrap();
        assert_eq!(read.stiffness[0][0].to_bits(), number.to_bits(), "{number:e}");
    }
}

#[test]
fn one_matrix_row_stands_on_a_line() {
    let text = sample::body(2).to_json().unwrap();
    assert!(
        text.contains("\n  \"stiffness\": [\n    [10000.0, 17.0],\n    [17.0, 20000.0]\n  ],\n"),
        "{text}"
    );
    assert!(text.ends_with("}\n"));
}

/// The message for a text in which `from` is replaced by `to`.
fn message(from: &str, to: &str) -> String {
    let text = sample::body(2).to_json().unwrap();
    assert!(text.contains(from), "the sample has no {from}");
    let faulty = text.replacen(from, to, 1);
    ReducedBody::from_json(&faulty).unwrap_err().to_string()
}

#[test]
fn a_fault_is_named_by_its_full_path() {
    let cases = [
        (
            "\"schema_version\": 1",
            "\"schema_version\": 99",
            "schema_version: found 99, this version of ffrf reads 1",
        ),
        ("\"schema_version\": 1", "\"schema_version\": \"1\"", "schema_version: invalid type"),
        ("  \"schema_version\": 1,\n", "", "schema_version: missing field"),
        ("  \"units\": \"m, kg, s\",\n", "", "units: missing field"),
        ("\"units\"", "\"colour\": 1, \"units\"", "colour: unknown field `colour`"),
        ("\"first_moment\"", "\"third_moment\"", "inertia.third_moment: unknown field"),
        ("\"frequency_hz\": 0.1", "\"frequency\": 0.1", "modes[0].frequency: unknown field"),
        ("\"kind\": \"user\"", "\"kind\": \"guessed\"", "modes[0].kind"),
        ("[10000.0, 17.0]", "[10000.0, \"17\"]", "stiffness[0][1]: invalid type"),
        ("[10000.0, 17.0]", "[10000.0, null]", "stiffness[0][1]: invalid type: null"),
        ("[10000.0, 17.0]", "[10000.0, 1e999]", "stiffness[0][1]: the number is not finite"),
        ("[10000.0, 17.0]", "[10000.0, NaN]", "expected value"),
        ("[10000.0, 17.0]", "[10000.0]", "stiffness[0]: expected 2 entries (one per mode), found 1"),
        ("[17.0, 20000.0]", "[17.0, 20000.0], []", "stiffness: expected 2 entries (one per mode), found 3"),
        ("\"title\"", "\"title\": \"twice\", \"title\"", "title: duplicate field"),
    ];
    for (from, to, expected) in cases {
        let found = message(from, to);
        assert!(found.contains(expected), "{from} -> {to}: {found}");
    }
}

#[test]
fn a_fault_deep_in_a_block_is_named_by_its_full_path() {
    let mut body = sample::body(2);
    body.inertia.mode_mode_moment[1][0][2][1] = 4096.25;
    let text = body.to_json().unwrap().replace("4096.25", "true");
    let found = ReducedBody::from_json(&text).unwrap_err().to_string();
    assert!(found.starts_with("inertia.mode_mode_moment[1][0][2][1]: invalid type: boolean"), "{found}");

    body.inertia.mode_mode_moment[1].pop();
    let found = body.to_json().unwrap_err().to_string();
    assert_eq!(found, "inertia.mode_mode_moment[1]: expected 2 entries (one per mode), found 1");

    let mut body = sample::body(2);
    body.markers[0].rotation[1][2] = f64::NEG_INFINITY;
    let found = body.to_json().unwrap_err().to_string();
    assert_eq!(found, "markers[0].rotation[1][2]: -inf is not a finite number");
}

#[test]
fn cut_text_and_text_after_the_end_are_refused() {
    let text = sample::body(1).to_json().unwrap();
    let cut = ReducedBody::from_json(&text[..text.len() / 2]).unwrap_err();
    assert!(matches!(cut, ModelError::Syntax { line, .. } if line > 1), "{cut}");
    let more = ReducedBody::from_json(&format!("{text}1")).unwrap_err();
    assert!(matches!(more, ModelError::Syntax { .. }), "{more}");
}

#[test]
fn a_file_is_written_whole_or_not_at_all() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("body.ffrf.json");
    let body = sample::body(2);
    body.write(&path).unwrap();
    assert_same_bits(&body, &ReducedBody::read(&path).unwrap());

    let mut faulty = body.clone();
    faulty.inertia.mass = f64::NAN;
    faulty.write(&path).unwrap_err();
    assert_same_bits(&body, &ReducedBody::read(&path).unwrap());

    // A folder in the way: the renaming fails, and the temporary file goes.
    let blocked = folder.path().join("blocked");
    std::fs::create_dir_all(blocked.join("inside")).unwrap();
    let found = body.write(&blocked).unwrap_err().to_string();
    assert!(found.contains("blocked"), "{found}");
    let mut left: Vec<_> =
        std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    left.sort();
    assert_eq!(left, ["blocked", "body.ffrf.json"]);
}

#[test]
fn an_error_names_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("faulty.ffrf.json");
    let missing = ReducedBody::read(&path).unwrap_err().to_string();
    assert!(missing.contains("faulty.ffrf.json"), "{missing}");
    std::fs::write(&path, "{\"schema_version\": 2}").unwrap();
    let found = ReducedBody::read(&path).unwrap_err().to_string();
    assert!(found.contains("faulty.ffrf.json: schema_version: found 2"), "{found}");
}

#[test]
fn a_body_that_contradicts_itself_is_not_read() {
    type Fault = fn(&mut ReducedBody);
    let faults: [(&str, Fault); 6] = [
        ("mass", |body| body.inertia.mass = 5e-324),
        ("smallest eigenvalue of K_ff", |body| body.stiffness[1][1] = -1.0),
        ("smallest eigenvalue of D_ff", |body| body.damping[0][0] = -0.1),
        ("asymmetry of the stiffness", |body| body.stiffness[0][1] += 1.0),
        ("asymmetry of the stiffness", |body| body.stiffness.swap(0, 1)),
        ("deviation of T_νμ", |body| body.inertia.mode_mode_moment.swap(0, 1)),
    ];
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("faulty.ffrf.json");
    for (expected, fault) in faults {
        let mut body = sample::body(2);
        fault(&mut body);
        body.write(&path).unwrap();
        let error = ReducedBody::read(&path).unwrap_err().to_string();
        assert!(error.contains("faulty.ffrf.json: the body is not consistent: "), "{error}");
        let text = body.to_json().unwrap();
        let error = ReducedBody::from_json(&text).unwrap_err();
        assert!(matches!(error, ModelError::Inconsistent { .. }), "{error}");
        if expected != "mass" {
            assert!(error.to_string().contains(expected), "{expected}: {error}");
        }
        // The report is there for those who show it.
        let (read, report) = ReducedBody::read_with_report(&path).unwrap();
        assert_same_bits(&body, &read);
        assert!(report.failures().count() > 0);
    }
}
