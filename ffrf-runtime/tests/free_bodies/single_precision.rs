//! The same runtime in f32: it follows f64 to single precision.

use ffrf_runtime::nalgebra::{SVector, Vector3};
use ffrf_runtime::{EnergyMomentum, FreeBody, FreeSystem, GeneralisedAlpha, Gravity};
use ffrf_test_kit::naive_body::{Invariants, NaiveBody};
use ffrf_test_kit::tolerances::SINGLE_PRECISION;

/// A bar with two equal end masses and one mode that lengthens it.
macro_rules! bar {
    ($scalar:ty) => {{
        let zero = [[0.0; 3]; 3];
        let along = |x: $scalar| [[x, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.5]];
        FreeBody::<_, $scalar>::new(NaiveBody::<1, 7, $scalar>::new(&Invariants {
            mass: 2.0,
            centre_of_mass: [0.0; 3],
            modal_centre_of_mass: [[0.0; 3]],
            euler_tensor: along(2.0),
            modal_euler_tensor: [[[2.0, 0.0, 0.0], zero[1], zero[2]]],
            modal_pair_euler_tensor: [[[[2.0, 0.0, 0.0], zero[1], zero[2]]]],
            stiffness: [[200.0]],
            damping: [[0.1]],
        }))
        .with_spin(Vector3::new(0.3, 1.0, 2.0))
        .with_deformation(SVector::<$scalar, 1>::new(0.05), SVector::<$scalar, 1>::zeros())
    }};
}

#[test]
fn both_steps_follow_double_precision() {
    for implicit in [false, true] {
        let (mut single, mut double) = (bar!(f32), bar!(f64));
        let (fall32, fall64) = (
            Gravity { acceleration: Vector3::new(0.0_f32, 0.0, -9.81) },
            Gravity { acceleration: Vector3::new(0.0_f64, 0.0, -9.81) },
        );
        for _ in 0..200 {
            if implicit {
                single.step_linearly_implicit(5e-3, &fall32).unwrap();
                double.step_linearly_implicit(5e-3, &fall64).unwrap();
            } else {
                single.step_rk4(5e-3, &fall32).unwrap();
                double.step_rk4(5e-3, &fall64).unwrap();
            }
        }
        let difference = double.state.position - single.state.position.cast::<f64>();
        assert!(difference.norm() < SINGLE_PRECISION, "{difference}");
        let difference = double.state.angular_velocity - single.state.angular_velocity.cast::<f64>();
        assert!(difference.norm() < SINGLE_PRECISION, "{difference}");
        let difference = double.state.modal_coordinates - single.state.modal_coordinates.cast::<f64>();
        assert!(difference.norm() < SINGLE_PRECISION, "{difference}");
    }
}

#[test]
fn methods_that_iterate_end_in_single_precision() {
    // the same steps in both number types; tolerances follow the type
    macro_rules! end {
        ($scalar:ty) => {{
            let body = bar!($scalar);
            let load = Gravity { acceleration: Vector3::<$scalar>::new(0.0, 0.0, -9.81) };
            let system = FreeSystem { body: &body.body, load: &load };
            let step: $scalar = 5e-3;
            let alpha = GeneralisedAlpha::<$scalar>::new();
            let mut memory = alpha.start(&system, &body.state, 0.0, step).unwrap();
            let (mut damped, mut kept) = (body.state, body.state);
            let mut most = 0;
            for _ in 0..200 {
                let (next, report) = alpha.step(&system, &mut memory, &damped, 0.0, step).unwrap();
                damped = next;
                most = most.max(report.iterations);
                let (next, report) =
                    EnergyMomentum::<$scalar>::new().step(&system, &kept, 0.0, step).unwrap();
                kept = next;
                most = most.max(report.iterations);
            }
            assert!(most <= 10, "{most}");
            [damped, kept].map(|state| (state.position.cast::<f64>(), state.angular_velocity.cast::<f64>()))
        }};
    }
    for (single, double) in end!(f32).into_iter().zip(end!(f64)) {
        assert!((single.0 - double.0).norm() < SINGLE_PRECISION, "{single:?} {double:?}");
        assert!((single.1 - double.1).norm() < SINGLE_PRECISION, "{single:?} {double:?}");
    }
}
