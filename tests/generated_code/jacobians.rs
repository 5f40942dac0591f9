//! Compiled Jacobians of a body against dual numbers on its interpreted kernels.

#![allow(clippy::unwrap_used)] // helpers of tests are tests

use ffrf::nalgebra::{SMatrix, SVector, Vector2, Vector3};
use ffrf::{FlexibleBodyJacobians, GeneralisedForce, flexible_body};
use ffrf_codegen::formulate::kernels::FORWARD_DYNAMICS;
use ffrf_codegen::{GenerateOptions, KernelInput, Kernels};
use ffrf_model::ReducedBody;
use ffrf_test_kit::proof::dual::Dual;
use ffrf_test_kit::random::Random;

use crate::{bodies, jacobians_m2};

/// Through mass matrices with condition numbers below 1e4, as in the committed bodies' own test.
const SOLVED: f64 = 1e-10;

/// Derivative of the accelerations in one direction of [q; ω; q̇; force].
fn by_dual_numbers(kernels: &Kernels, point: &[f64; 15], direction: usize) -> SVector<f64, 8> {
    let dual: Vec<Dual> = point
        .iter()
        .enumerate()
        .map(|(k, &value)| Dual { value, slope: if k == direction { 1.0 } else { 0.0 } })
        .collect();
    let input = KernelInput {
        q: &dual[0..2],
        omega: &dual[2..5],
        q_dot: &dual[5..7],
        force: &dual[7..15],
        ..KernelInput::default()
    };
    let result = kernels.evaluate(&FORWARD_DYNAMICS, &input);
    SVector::from_iterator(result.into_iter().map(|dual| dual.slope))
}

/// The state and force [q; ω; q̇; force] of one sample.
type Point = [f64; 15];

fn points() -> Vec<Point> {
    let mut random = Random::new(5);
    let mut block = |size: f64| random.number() * size;
    (0..5)
        .map(|_| {
            std::array::from_fn(|k| match k {
                0..2 => block(0.2),
                2..5 => block(3.0),
                5..7 => block(1.0),
                _ => block(10.0),
            })
        })
        .collect()
}

#[track_caller]
fn close<const C: usize>(what: &str, found: &SMatrix<f64, 8, C>, expected: &SMatrix<f64, 8, C>) {
    let error = (found - expected).amax();
    assert!(error <= SOLVED * expected.amax(), "{what}: {found} and {expected}, error {error:e}");
}

/// Both Jacobians of `body` at several points.
fn check<B: FlexibleBodyJacobians<2, 8>>(body: &B, kernels: &Kernels) {
    for point in points() {
        let q = Vector2::from_row_slice(&point[0..2]);
        let omega = Vector3::from_row_slice(&point[2..5]);
        let q_dot = Vector2::from_row_slice(&point[5..7]);
        let force = SVector::<f64, 8>::from_row_slice(&point[7..15]);

        let found = body.acceleration_jacobian(&q, &omega, &q_dot, &force);
        let resultant = GeneralisedForce::from_vector(&force);
        let expected = body.forward_dynamics(&q, &omega, &q_dot, &resultant).to_vector();
        close("acceleration", &found.acceleration, &expected);
        let columns = found
            .coordinates
            .column_iter()
            .chain(found.angular_velocity.column_iter())
            .chain(found.rates.column_iter())
            .chain(found.force.column_iter());
        for (direction, column) in columns.enumerate() {
            let expected = by_dual_numbers(kernels, &point, direction);
            close(&format!("column {direction}"), &column.into_owned(), &expected);
        }
        assert_eq!(found.velocity().amax(), 0.0);

        // ∂w/∂x = -M⁻¹ ∂R/∂x, with the residual's own Jacobian
        let residual = body.residual_jacobian(&q, &omega, &q_dot, &found.acceleration, &force);
        let size = (residual.acceleration.abs() * found.acceleration.abs()).amax();
        assert!(residual.residual.amax() <= SOLVED * size, "{}", residual.residual);
        close("mass", &residual.acceleration, &body.mass_matrix(&q));
        let factors = residual.acceleration.cholesky().unwrap();
        close("coordinates", &factors.solve(&-residual.coordinates), &found.coordinates);
        close("rates", &factors.solve(&-residual.rates), &found.rates);
        close("angular velocity", &factors.solve(&-residual.angular_velocity), &found.angular_velocity);
        close("force", &factors.solve(&-residual.force()), &found.force);
        assert_eq!(residual.velocity().amax(), 0.0);
    }
}

#[test]
fn jacobians_of_a_committed_body_agree_with_dual_numbers() {
    let (_, body, options) = bodies::all().into_iter().find(|(name, ..)| *name == "jacobians_m2").unwrap();
    check(&jacobians_m2::JacobianBody, &Kernels::formulate(&body, &options).unwrap());
}

flexible_body! {
    /// The connecting rod's first two modes, free-free about its centre of mass.
    struct ConnectingRod { model: "models/conrod.ffrf.json", modes: ..2, jacobians: true }
}

#[test]
fn jacobians_made_by_the_macro_agree_with_dual_numbers() {
    let body = ReducedBody::read(concat!(env!("CARGO_MANIFEST_DIR"), "/models/conrod.ffrf.json")).unwrap();
    let options = GenerateOptions { modes: Some(2.into()), ..GenerateOptions::default() };
    check(&ConnectingRod, &Kernels::formulate(&body, &options).unwrap());
}
