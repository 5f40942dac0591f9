//! Geometric stiffness and stress markers: read back, checked, chosen with their modes, absent where they were not asked for.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use ffrf_model::{
    GeometricStiffness, MarkerLoadStiffness, ModelError, ReducedBody, SectionMarker, StressMarker,
};

use crate::sample;

/// The sample body with both parts, all numbers different.
fn whole(modes: usize) -> ReducedBody {
    let mut body = sample::body(modes);
    // Symmetric in the modes: by their sum and product.
    let pair = |mu: usize, nu: usize| (mu + nu) as f64 + 10.0 * (mu * nu) as f64;
    let list = || 0..modes;
    body.geometric_stiffness = Some(GeometricStiffness {
        uniform_load: list()
            .map(|mu| list().map(|nu| [0.1, 0.2, 0.3].map(|x| x + pair(mu, nu))).collect())
            .collect(),
        linear_load: list()
            .map(|mu| {
                list().map(|nu| [[1.0; 3], [2.0; 3], [3.0; 3]].map(|r| r.map(|x| x - pair(mu, nu)))).collect()
            })
            .collect(),
        marker_loads: vec![MarkerLoadStiffness {
            marker: body.markers[0].name.clone(),
            stiffness: list()
                .map(|mu| list().map(|nu| std::array::from_fn(|k| k as f64 - pair(mu, nu))).collect())
                .collect(),
        }],
    });
    body.stress_markers = vec![StressMarker {
        name: "notch".to_owned(),
        nodes: vec![4, 9],
        position: [0.5, 0.25, 0.0],
        stress: list().map(|mu| std::array::from_fn(|k| (6 * mu + k) as f64)).collect(),
    }];
    body.section_markers = vec![SectionMarker {
        name: "cut".to_owned(),
        position: [0.25, 0.0, 0.1],
        normal: [1.0, 0.0, 0.0],
        force: list().map(|mu| std::array::from_fn(|k| (60 * mu + k) as f64)).collect(),
    }];
    body
}

#[test]
fn they_are_read_back_to_the_last_bit() {
    let body = whole(3);
    assert_eq!(ReducedBody::from_json(&body.to_json().unwrap()).unwrap(), body);
}

#[test]
fn a_body_without_them_does_not_mention_them() {
    let text = sample::body(2).to_json().unwrap();
    assert!(!text.contains("geometric_stiffness") && !text.contains("stress_markers"));
    assert!(!text.contains("section_markers") && !text.contains("second_order_terms"));
}

#[test]
fn chosen_modes_keep_their_numbers() {
    let (body, all) = (whole(3), whole(3));
    let chosen = body.with_selected_modes(&"[2, 0]".parse().unwrap()).unwrap();
    let (found, given) = (chosen.geometric_stiffness.unwrap(), all.geometric_stiffness.unwrap());
    assert_eq!(found.uniform_load[0][1], given.uniform_load[2][0]);
    assert_eq!(found.linear_load[1][1], given.linear_load[0][0]);
    assert_eq!(found.marker_loads[0].stiffness[0][1], given.marker_loads[0].stiffness[2][0]);
    assert_eq!(
        chosen.stress_markers[0].stress,
        [all.stress_markers[0].stress[2], all.stress_markers[0].stress[0]]
    );
    let (found, given) = (&chosen.section_markers[0].force, &all.section_markers[0].force);
    assert_eq!(found[..], [given[2], given[0]]);
}

#[test]
fn what_does_not_fit_is_named() {
    let spoilt = |spoil: fn(&mut ReducedBody)| {
        let mut body = whole(2);
        spoil(&mut body);
        body.check().and_then(|report| report.verdict()).unwrap_err()
    };
    let field = |error: ModelError| match error {
        ModelError::Length { field, .. } | ModelError::NotFinite { field, .. } => field,
        other => panic!("{other}"),
    };
    let error = spoilt(|body| {
        body.geometric_stiffness.as_mut().unwrap().linear_load[1].pop();
    });
    assert_eq!(field(error), "geometric_stiffness.linear_load[1]");
    let error = spoilt(|body| body.geometric_stiffness.as_mut().unwrap().uniform_load[0][1][2] = f64::NAN);
    assert_eq!(field(error), "geometric_stiffness.uniform_load[0][1][2]");
    let error = spoilt(|body| body.stress_markers[0].stress[1][5] = f64::INFINITY);
    assert_eq!(field(error), "stress_markers[0].stress[1][5]");
    let error = spoilt(|body| body.stress_markers[0].stress.clear());
    assert_eq!(field(error), "stress_markers[0].stress");
    let error = spoilt(|body| body.geometric_stiffness.as_mut().unwrap().linear_load[0][1][0][2] += 1.0);
    assert!(error.to_string().contains("asymmetry of the geometric stiffness of linear loads"), "{error}");
    let error = spoilt(|body| {
        body.geometric_stiffness.as_mut().unwrap().marker_loads[0].stiffness[1][0][4] = f64::NAN
    });
    assert_eq!(field(error), "geometric_stiffness.marker_loads[0].stiffness[1][0][4]");
    let error =
        spoilt(|body| body.geometric_stiffness.as_mut().unwrap().marker_loads[0].stiffness[1].clear());
    assert_eq!(field(error), "geometric_stiffness.marker_loads[0].stiffness[1]");
    let error =
        spoilt(|body| body.geometric_stiffness.as_mut().unwrap().marker_loads[0].stiffness[1][0][4] += 1.0);
    assert!(error.to_string().contains("asymmetry of the geometric stiffness of loads at"), "{error}");
    let mut body = whole(2);
    body.geometric_stiffness.as_mut().unwrap().marker_loads[0].marker = "nowhere".to_owned();
    let error = body.check().and_then(|report| report.verdict()).unwrap_err();
    assert!(error.to_string().contains("at what is no marker"), "{error}");
    let error = spoilt(|body| body.section_markers[0].force[1][5] = f64::NAN);
    assert_eq!(field(error), "section_markers[0].force[1][5]");
    let error = spoilt(|body| body.section_markers[0].force.clear());
    assert_eq!(field(error), "section_markers[0].force");
    let error = spoilt(|body| body.section_markers[0].name = body.stress_markers[0].name.clone());
    assert!(error.to_string().contains("repeated marker names"), "{error}");
    let error = spoilt(|body| body.stress_markers[0].name = body.markers[0].name.clone());
    assert!(error.to_string().contains("repeated marker names"), "{error}");
}
