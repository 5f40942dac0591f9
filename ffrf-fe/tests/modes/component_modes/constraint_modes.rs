//! Constraint modes against dense algebra.

use faer::Mat;
use ffrf_fe::component_modes::{BasisForm, ComponentRequest, ReferenceCondition};
use ffrf_model::ModeKind;

use super::dense::{Dense, deviation};
use super::parts::{bar, compute, mixed_ends, rigid_ends};
use super::tolerances::STATIC;

/// With the frame fixed to the first interface, the constraint modes of the second are kept as they are.
#[test]
fn constraint_modes_are_the_static_shapes_of_unit_motions() {
    let model = bar();
    for interfaces in [rigid_ends(&model), mixed_ends(&model)] {
        let dense = Dense::new(&model, &interfaces);
        let request = ComponentRequest {
            form: BasisForm::Raw,
            reference: ReferenceCondition::Fixed { interface: "left".to_owned() },
            ..ComponentRequest::craig_bampton(interfaces, 0)
        };
        let modes = compute(&model, &request);
        assert_eq!(modes.basis.modes.len(), 6);
        assert!(modes.basis.modes.iter().all(|mode| mode.kind == ModeKind::Constraint));
        let unit = Mat::from_fn(12, 6, |i, j| if i == 6 + j { 1.0 } else { 0.0 });
        let expected = dense.prescribed(&unit);
        for j in 0..6 {
            let column = |matrix: &Mat<f64>| matrix.get(.., j..j + 1).to_owned();
            let error = deviation(&column(&expected), &column(&modes.basis.shapes));
            assert!(error < STATIC, "constraint mode {j}: {error:e}");
        }
        let error = deviation(&unit, &modes.interface_motion);
        assert!(error < STATIC, "interface motion {error:e}");
    }
}

/// In mean axes a rigid motion of all interfaces leaves nothing: the constraint modes hold it exactly.
#[test]
fn rigid_motion_is_held_exactly() {
    let model = bar();
    for interfaces in [rigid_ends(&model), mixed_ends(&model)] {
        let dense = Dense::new(&model, &interfaces);
        let modes = compute(&model, &ComponentRequest::craig_bampton(interfaces.clone(), 3));
        assert_eq!(modes.report.removed, 6);
        assert_eq!(modes.basis.modes.len(), 12 + 3 - 6);
        // Prescribed rigid motion of both reference points, by the independent algebra: no strain.
        let motion = Mat::from_fn(12, 6, |i, k| {
            let p = interfaces[i / 6].reference_point();
            let rotation = |axis: usize| if k == 3 + axis { 1.0 } else { 0.0 };
            match i % 6 {
                0 => {
                    if k == 0 {
                        1.0
                    } else {
                        rotation(1) * p[2] - rotation(2) * p[1]
                    }
                }
                1 => {
                    if k == 1 {
                        1.0
                    } else {
                        rotation(2) * p[0] - rotation(0) * p[2]
                    }
                }
                2 => {
                    if k == 2 {
                        1.0
                    } else {
                        rotation(0) * p[1] - rotation(1) * p[0]
                    }
                }
                axis => rotation(axis - 3),
            }
        });
        let shapes = dense.prescribed(&motion);
        let stiffness = model.stiffness.as_ref().unwrap();
        let forces = stiffness * &shapes;
        let scale = shapes.norm_max() * stiffness.val().iter().fold(0.0_f64, |max, x| max.max(x.abs()));
        assert!(forces.norm_max() < STATIC * scale, "{:e} of {scale:e}", forces.norm_max());
        // The twelve motions less six rigid ones: six elastic shapes of the interfaces and three clamped modes remain.
        assert!(modes.report.compliance_kept > 0.5 && modes.report.compliance_kept < 1.0 + 1e-9);
    }
}
