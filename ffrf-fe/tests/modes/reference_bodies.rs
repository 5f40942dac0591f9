//! Frequencies and invariants of the reference bodies.

use ffrf_fe::modes::{Method, ModeRequest, compute_modes, user_modes};
use ffrf_fe::reduction::{ReductionOptions, reduce};

use crate::reference::load;
use crate::tolerances::{INVARIANTS, ORTHOGONALITY, REFERENCE_FREQUENCY, ZERO_MOMENT};

const BODIES: [&str; 8] =
    ["blockC3D8", "blockC3D10", "rotorDisc", "synth_m1", "synth_m2", "synth_m3", "synth_m5", "truss3"];

/// `mechanisms`: modes without frequency, which the reference leaves out.
fn check_frequencies(name: &str, method: Method, mechanisms: usize) {
    let Some((case, model, _)) = load(name) else { return };
    let expected = case.frequencies_hz.expect("the case has frequencies");
    let request = ModeRequest { method, ..ModeRequest::free_free(expected.len() + mechanisms) };
    let solution = compute_modes(&model, &request, &mut |_| {}).unwrap();
    println!("{name}\n{}", solution.report);
    for (mode, expected) in solution.report.modes[mechanisms..].iter().zip(&expected) {
        let found = mode.frequency_hz.unwrap();
        assert!(
            (found - expected).abs() <= REFERENCE_FREQUENCY * expected,
            "{name}: {found} Hz, expected {expected} Hz"
        );
    }
    assert_eq!(solution.report.rigid_modes.len(), 6, "{name}");
    assert_eq!(solution.report.mechanisms, mechanisms, "{name}");
    assert_eq!(solution.report.counted, Some(solution.report.found), "{name}");
    assert!(
        solution.report.orthogonality_error < ORTHOGONALITY,
        "{name}: {:e}",
        solution.report.orthogonality_error
    );
    let body = reduce(&model, &solution.basis, &ReductionOptions::default()).unwrap();
    for (mode, moment) in body.inertia.modal_first_moment.iter().enumerate() {
        for value in moment {
            let error = value.abs() / (body.inertia.mass.sqrt() * case.size);
            assert!(
                error < ZERO_MOMENT,
                "{name}: first moment of mode {mode} is {value:e}, not orthogonal to rigid motion"
            );
        }
    }
}

#[test]
fn frequencies_of_the_fe_exports_by_the_dense_method() {
    for name in ["blockC3D8", "blockC3D10", "rotorDisc"] {
        check_frequencies(name, Method::Dense, 0);
    }
    check_frequencies("truss3", Method::Dense, 1);
}

#[test]
fn frequencies_of_the_fe_exports_by_the_sparse_method() {
    for name in ["blockC3D8", "blockC3D10", "rotorDisc"] {
        check_frequencies(name, Method::Sparse, 0);
    }
}

#[test]
fn invariants_of_the_reference_bodies() {
    for name in BODIES {
        let Some((case, model, shapes)) = load(name) else { return };
        let solution = user_modes(&model, shapes).unwrap();
        let body = reduce(&model, &solution.basis, &ReductionOptions::default()).unwrap();
        let (found, expected) = (&body.inertia, &case.invariants);
        let moment = expected.m * case.size;
        close(name, "m", &[found.mass], &[expected.m], 0.0);
        close(name, "a", &found.first_moment.map(|value| value / found.mass), &expected.a, case.size);
        let first: Vec<f64> =
            found.modal_first_moment.iter().flatten().map(|value| value / found.mass).collect();
        let largest_shape = (0..solution.basis.shapes.ncols())
            .flat_map(|j| solution.basis.shapes.col_as_slice(j))
            .fold(0.0_f64, |largest, value| largest.max(value.abs()));
        close(name, "b", &first, expected.b.as_flattened(), largest_shape);
        close(name, "T", found.second_moment.as_flattened(), expected.T.as_flattened(), 0.0);
        close(
            name,
            "T_mu",
            found.position_mode_moment.as_flattened().as_flattened(),
            expected.T_mu.as_flattened().as_flattened(),
            moment * largest_shape,
        );
        let blocks: Vec<f64> = found.mode_mode_moment.iter().flatten().flatten().flatten().copied().collect();
        let reference: Vec<f64> = expected.T_munu.iter().flatten().flatten().flatten().copied().collect();
        close(name, "T_munu", &blocks, &reference, 0.0);
        let stiffness: Vec<f64> = body.stiffness.iter().flatten().copied().collect();
        let reference: Vec<f64> = expected.K_ff.iter().flatten().copied().collect();
        close(name, "K_ff", &stiffness, &reference, 0.0);
    }
}

/// Compares two blocks relative to the larger of the reference's largest entry and a given scale.
fn close(name: &str, block: &str, found: &[f64], expected: &[f64], scale: f64) {
    assert_eq!(found.len(), expected.len(), "{name}: shape of {block}");
    let scale = expected.iter().fold(scale, |largest, value| largest.max(value.abs()));
    for (found, expected) in found.iter().zip(expected) {
        let error = (found - expected).abs() / scale;
        assert!(
            error <= INVARIANTS,
            "{name}: {block} has {found:e}, expected {expected:e}, relative error {error:e}"
        );
    }
}
