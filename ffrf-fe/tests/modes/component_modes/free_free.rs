//! The free-free transformation changes the coordinates and nothing else.

use ffrf_fe::component_modes::{
    BasisForm, ComponentBasis, ComponentRequest, ReferenceCondition, reduce_component_modes,
};
use ffrf_fe::reduction::ReductionOptions;
use ffrf_model::ReducedBody;

use super::dense::deviation;
use super::free_body::receptance;
use super::parts::{bar, compute, mixed_ends, rigid_ends};
use super::tolerances::{RESPONSE, ROUND_OFF};

const BASES: [ComponentBasis; 4] = [
    ComponentBasis::CraigBampton,
    ComponentBasis::Attachment,
    ComponentBasis::Rubin,
    ComponentBasis::Herting,
];

/// Bodies of one basis: transformed, raw in mean axes, raw fixed to an interface, transformed along a chord.
fn bodies(basis: ComponentBasis) -> Vec<ReducedBody> {
    let model = bar();
    let interfaces = if basis == ComponentBasis::Rubin { rigid_ends(&model) } else { mixed_ends(&model) };
    let fixed = ReferenceCondition::Fixed { interface: "left".to_owned() };
    let chord = ReferenceCondition::Chord { from: "right".to_owned(), to: "left".to_owned() };
    let variants = [
        (BasisForm::FreeFree, ReferenceCondition::MeanAxes),
        (BasisForm::Raw, ReferenceCondition::MeanAxes),
        (BasisForm::Raw, fixed),
        (BasisForm::FreeFree, chord),
    ];
    let reduce = |(form, reference)| {
        let request = ComponentRequest {
            basis,
            form,
            reference,
            ..ComponentRequest::craig_bampton(interfaces.clone(), 5)
        };
        reduce_component_modes(&model, &compute(&model, &request), &ReductionOptions::default()).unwrap()
    };
    variants.into_iter().map(reduce).collect()
}

#[test]
fn transformed_modes_have_the_cheap_layout() {
    for basis in BASES {
        let body = &bodies(basis)[0];
        let (modal_mass, first) = (body.inertia.modal_mass(), body.inertia.mass.sqrt());
        let arm = body.inertia.second_moment.iter().enumerate().map(|(i, row)| row[i]).sum::<f64>().sqrt();
        for mu in 0..body.mode_count() {
            for nu in 0..body.mode_count() {
                let expected = if mu == nu { 1.0 } else { 0.0 };
                let error = (modal_mass[mu][nu] - expected).abs();
                assert!(error < ROUND_OFF, "{basis}: Θ_ff({mu}, {nu}) off by {error:e}");
                assert!(mu == nu || body.stiffness[mu][nu] == 0.0, "{basis}: K_ff is diagonal");
            }
            // Cleared by the reduction only where they were round-off.
            assert_eq!(body.inertia.modal_first_moment[mu], [0.0; 3], "{basis}: b_{mu} against {first}");
            assert_eq!(body.inertia.rotation_coupling(mu), [0.0; 3], "{basis}: ϑ_{mu} against {arm}");
        }
    }
}

#[test]
fn form_and_frame_change_no_response_and_no_mass() {
    for basis in BASES {
        let bodies = bodies(basis);
        let first = &bodies[0];
        for body in &bodies[1..] {
            assert_eq!(body.mode_count(), first.mode_count(), "{basis}");
            assert_eq!(body.inertia.mass, first.inertia.mass);
            assert_eq!(body.inertia.second_moment, first.inertia.second_moment);
            for hertz in [30.0, 700.0, 5000.0] {
                let error = deviation(&receptance(first, 2, hertz), &receptance(body, 2, hertz));
                assert!(error < RESPONSE, "{basis}, {hertz} Hz: {error:e}");
            }
        }
    }
}

#[test]
fn frames_are_where_they_are_said_to_be() {
    let bodies = bodies(ComponentBasis::CraigBampton);
    let scale = |rows: &[[f64; 3]]| rows.iter().flatten().fold(0.0_f64, |max, x| max.max(x.abs()));
    let (left, right) = (&bodies[2].markers[0], &bodies[2].markers[1]);
    assert!(scale(&left.translation) < 1e-9 * scale(&right.translation));
    assert!(scale(&left.rotation) < 1e-9 * scale(&right.rotation));
    // Chord from right to left: nearly along -x, tilted by the reference points.
    let (left, right) = (&bodies[3].markers[0], &bodies[3].markers[1]);
    let largest = scale(&left.translation);
    assert!(scale(&right.translation) < 1e-9 * largest);
    let chord = [0, 1, 2].map(|i| left.position[i] - right.position[i]);
    let length = chord.iter().map(|x| x * x).sum::<f64>().sqrt();
    for (translation, rotation) in left.translation.iter().zip(&right.rotation) {
        let along: f64 = (0..3).map(|i| translation[i] * chord[i] / length).sum();
        for i in 0..3 {
            assert!((translation[i] - along * chord[i] / length).abs() < 1e-9 * largest);
        }
        let twist: f64 = (0..3).map(|i| rotation[i] * chord[i] / length).sum();
        assert!(twist.abs() < 1e-9 * scale(&right.rotation));
    }
}
