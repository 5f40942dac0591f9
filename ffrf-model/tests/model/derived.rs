//! Derived quantities and truncation against their definitions.

use crate::sample;
use ffrf_model::{ModeSelection, ModelError, Vector3};

fn cross(a: Vector3, b: Vector3) -> Vector3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Sums of twelve products of order one, in another order.
const ROUND_OFF: f64 = 1e-13;

fn assert_close(found: &[f64], expected: &[f64], what: &str) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < ROUND_OFF, "{what}: {found} instead of {expected}");
    }
}

#[test]
fn couplings_are_sums_of_cross_products() {
    let points = sample::points(3);
    let inertia = sample::inertia(&points);
    let sum = |term: &dyn Fn(&sample::Point) -> Vector3| -> Vector3 {
        std::array::from_fn(|i| points.iter().map(|p| p.mass * term(p)[i]).sum())
    };
    for mu in 0..3 {
        let expected = sum(&|p| cross(p.position, p.shapes[mu]));
        assert_close(&inertia.rotation_coupling(mu), &expected, "ϑ_μ");
        for nu in 0..3 {
            let expected = sum(&|p| cross(p.shapes[mu], p.shapes[nu]));
            assert_close(&inertia.mode_mode_coupling(mu, nu), &expected, "ϑ_μν");
        }
    }
}

#[test]
fn inertia_tensors_are_sums_of_double_cross_products() {
    // Θ w = ∫ρ x × (w × x), Θ_μ w = ∫ρ x × (w × φ_μ), Θ_μν w = ∫ρ φ_μ × (w × φ_ν).
    let points = sample::points(2);
    let inertia = sample::inertia(&points);
    for column in 0..3 {
        let mut w = [0.0; 3];
        w[column] = 1.0;
        let sum = |term: &dyn Fn(&sample::Point) -> Vector3| -> Vector3 {
            std::array::from_fn(|i| points.iter().map(|p| p.mass * term(p)[i]).sum())
        };
        let of = |matrix: [[f64; 3]; 3]| -> Vector3 { std::array::from_fn(|i| matrix[i][column]) };
        let expected = sum(&|p| cross(p.position, cross(w, p.position)));
        assert_close(&of(inertia.inertia_tensor()), &expected, "Θ");
        for mu in 0..2 {
            let expected = sum(&|p| cross(p.position, cross(w, p.shapes[mu])));
            assert_close(&of(inertia.mode_inertia(mu)), &expected, "Θ_μ");
            for nu in 0..2 {
                let expected = sum(&|p| cross(p.shapes[mu], cross(w, p.shapes[nu])));
                assert_close(&of(inertia.mode_mode_inertia(mu, nu)), &expected, "Θ_μν");
            }
        }
    }
}

#[test]
fn centres_of_mass_and_modal_mass() {
    let points = sample::points(2);
    let inertia = sample::inertia(&points);
    let mass: f64 = points.iter().map(|p| p.mass).sum();
    for i in 0..3 {
        let mean = |field: &dyn Fn(&sample::Point) -> Vector3| {
            points.iter().map(|p| p.mass * field(p)[i]).sum::<f64>() / mass
        };
        assert_close(&[inertia.centre_of_mass()[i]], &[mean(&|p| p.position)], "a");
        assert_close(&[inertia.modal_centre_of_mass(1)[i]], &[mean(&|p| p.shapes[1])], "b_μ");
    }
    let dot = |a: Vector3, b: Vector3| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let expected: f64 = points.iter().map(|p| p.mass * dot(p.shapes[0], p.shapes[1])).sum();
    assert_close(&[inertia.modal_mass()[1][0]], &[expected], "Θ_ff");
}

#[test]
fn fewer_modes_are_the_leading_part() {
    let body = sample::body(4);
    let fewer = body.with_modes(2).unwrap();
    fewer.check().unwrap().verdict().unwrap();
    assert_eq!(fewer.mode_count(), 2);
    assert_eq!(fewer.inertia, sample::inertia(&sample_leading(2)));
    assert_eq!(fewer.stiffness[1], body.stiffness[1][..2]);
    assert_eq!(fewer.markers[0].translation, body.markers[0].translation[..2]);
    assert_eq!(body.with_modes(4).unwrap(), body);
    let error = body.with_modes(5).unwrap_err();
    assert!(matches!(error, ModelError::TooFewModes { requested: 5, available: 4 }), "{error}");
}

#[test]
fn selected_modes_come_in_the_order_of_the_selection() {
    let body = sample::body(4);
    let select = |text: &str| body.with_selected_modes(&text.parse::<ModeSelection>().unwrap());
    assert_eq!(select("2").unwrap(), body.with_modes(2).unwrap());
    assert_eq!(select("..2").unwrap(), body.with_modes(2).unwrap());
    assert_eq!(select("1..3").unwrap(), select("[1, 2]").unwrap());
    assert_eq!(select("0,1,2,3").unwrap(), body);
    assert_eq!(select("[]").unwrap(), body.with_modes(0).unwrap());
    let mixed = select("3,0").unwrap();
    mixed.check().unwrap().verdict().unwrap();
    let whole = &body.inertia.mode_mode_moment;
    assert_eq!(mixed.inertia.mode_mode_moment, [[whole[3][3], whole[3][0]], [whole[0][3], whole[0][0]]]);
    assert_eq!(mixed.stiffness[0], [body.stiffness[3][3], body.stiffness[3][0]]);
    assert_eq!(mixed.markers[0].rotation.len(), 2);
    let message = |text: &str| select(text).unwrap_err().to_string();
    assert_eq!(message("5"), "5 modes asked for, but the body has 4");
    assert_eq!(message("[0, 4]"), "mode 4 asked for, but the body has 4 modes, counted from 0");
    // A range that no memory could hold is refused before it is written out.
    assert_eq!(
        message("0..18446744073709551615"),
        "mode 18446744073709551614 asked for, but the body has 4 modes, counted from 0"
    );
    assert_eq!(message("1,2,1"), "mode 1 asked for twice");
    for text in ["", "a", "..", "3..", "3..3", "-1", "1,,2", "[1", "[1 2]"] {
        text.parse::<ModeSelection>().unwrap_err();
    }
}

fn sample_leading(modes: usize) -> Vec<sample::Point> {
    let mut points = sample::points(4);
    for point in &mut points {
        point.shapes.truncate(modes);
    }
    points
}
