//! Generated C: committed texts are up to date, compilers have nothing to complain about, and it computes what Rust does.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use ffrf::nalgebra::{SVector, Vector3};
use ffrf::{DenseForms, FlexibleBody, GeneralisedForce, Observables};
use ffrf_codegen::formulate::KERNELS;
use ffrf_codegen::{
    FusedMultiplyAdd, GenerateOptions, KernelInput, Kernels, ScalarType, Strategy, generate_c,
};
use ffrf_model::ReducedBody;
use ffrf_test_kit::random::Random;

use crate::bodies::all;
use crate::c_program::{CProgram, Inputs};
use crate::committed::Committed;
use crate::{general_m2, single_m3};

/// Sums of a few hundred products, in another order, of numbers of order one.
const POLYNOMIAL: f64 = 1e-13;
/// Accelerations: the mass matrices of these bodies have condition numbers below 1e4.
const ACCELERATION: f64 = 1e-10;
/// The same two in single precision.
const SINGLE: f64 = 2e-3;

fn find(wanted: &str) -> (ReducedBody, GenerateOptions) {
    let (_, body, options) = all().into_iter().find(|(name, ..)| *name == wanted).unwrap();
    (body, options)
}

#[test]
fn committed_texts_are_what_the_generator_prints() {
    let mut committed = Committed::default();
    for name in ["general_m2", "single_m3"] {
        let (body, options) = find(name);
        let code = generate_c(&body, &options).unwrap();
        committed.compare(&format!("{name}.h"), &code.header);
        committed.compare(&format!("{name}.c"), &code.source);
    }
    committed.assert_current();
}

fn inputs(mode_count: usize, random: &mut Random) -> Inputs {
    let mut list = |scale: f64, count: usize| {
        // exact in single precision, so that both scalars compute with the same numbers
        random.numbers(count).into_iter().map(|x| f64::from((scale * x) as f32)).collect::<Vec<f64>>()
    };
    Inputs {
        q: list(0.3, mode_count),
        velocity: list(1.0, 3),
        omega: list(3.0, 3),
        q_dot: list(1.0, mode_count),
        force: list(10.0, 6 + mode_count),
        gravity: list(9.81, 3),
    }
}

#[test]
fn every_kernel_of_every_body_agrees_with_its_expressions() {
    for (name, body, options) in all() {
        if options.scalar == ScalarType::Generic {
            continue;
        }
        let options = GenerateOptions { jacobians: false, strategy: Strategy::Auto, ..options };
        let kernels = Kernels::formulate(&body, &options).unwrap();
        let Some(program) = CProgram::compile(&generate_c(&body, &options).unwrap()) else { return };
        let modes = body.mode_count();
        let mut random = Random::new(7);
        for _ in 0..3 {
            let inputs = inputs(modes, &mut random);
            let found = program.run(&inputs);
            // without modes, kernels of the modes have no results and are left out
            let expected: Vec<_> = KERNELS
                .into_iter()
                .map(|kernel| (kernel.signature.name, kernels.evaluate(kernel, &input(&inputs))))
                .filter(|(_, values)| !values.is_empty())
                .collect();
            assert_eq!(found.len(), expected.len(), "{name}");
            for ((kernel, expected), (found_kernel, found)) in expected.into_iter().zip(&found) {
                assert_eq!(kernel, found_kernel);
                let is_condensed = found.len() != expected.len();
                let expected: Vec<f64> =
                    if is_condensed { expected.into_iter().step_by(modes + 1).collect() } else { expected };
                assert_eq!(found.len(), expected.len(), "{name}: {kernel}");
                let tolerance = match (options.scalar, kernel) {
                    (ScalarType::F32, _) => SINGLE,
                    (_, "forward_dynamics" | "equations_of_motion") => ACCELERATION,
                    _ => POLYNOMIAL,
                };
                let size = expected.iter().fold(1e-3_f64, |size, x| size.max(x.abs()));
                for (k, (found, expected)) in found.iter().zip(&expected).enumerate() {
                    let error = (found - expected).abs() / size;
                    assert!(error <= tolerance, "{name}: {kernel}[{k}]: {found} and {expected}, {error:e}");
                }
            }
        }
    }
}

fn input(inputs: &Inputs) -> KernelInput<'_> {
    KernelInput {
        q: &inputs.q,
        velocity: &inputs.velocity,
        omega: &inputs.omega,
        q_dot: &inputs.q_dot,
        force: &inputs.force,
        gravity: &inputs.gravity,
    }
}

/// Some results of a compiled Rust body, by the names of their kernels.
macro_rules! rust_results {
    ($body:expr, $inputs:expr, $scalar:ty, $modes:literal, $size:literal) => {{
        let list = |values: &[f64]| values.iter().map(|x| *x as $scalar).collect::<Vec<$scalar>>();
        let three = |values: &[f64]| Vector3::from_row_slice(&list(values));
        let modal = |values: &[f64]| SVector::<$scalar, $modes>::from_row_slice(&list(values));
        let (q, q_dot) = (modal(&$inputs.q), modal(&$inputs.q_dot));
        let (velocity, omega) = (three(&$inputs.velocity), three(&$inputs.omega));
        let force = SVector::<$scalar, $size>::from_row_slice(&list(&$inputs.force));
        let acceleration = $body.forward_dynamics(&q, &omega, &q_dot, &GeneralisedForce::from_vector(&force));
        let wide = |values: &[$scalar]| values.iter().map(|x| f64::from(*x)).collect::<Vec<f64>>();
        vec![
            ("mass_matrix", wide($body.mass_matrix(&q).as_slice())),
            ("quadratic_velocity", wide($body.quadratic_velocity(&q, &omega, &q_dot).as_slice())),
            ("forward_dynamics", wide(acceleration.to_vector::<$size>().as_slice())),
            ("kinetic_energy", wide(&[$body.kinetic_energy(&q, &velocity, &omega, &q_dot)])),
            ("angular_momentum", wide($body.angular_momentum(&q, &velocity, &omega, &q_dot).as_slice())),
        ]
    }};
}

#[test]
fn without_contraction_c_and_rust_give_the_same_bits() {
    if cfg!(target_feature = "fma") {
        eprintln!("SKIPPED: this build contracts products and sums of the golden body in Rust");
        return;
    }
    let mut random = Random::new(3);
    let (body, options) = find("general_m2");
    let Some(program) = CProgram::compile(&generate_c(&body, &options).unwrap()) else { return };
    for _ in 0..20 {
        let inputs = inputs(2, &mut random);
        let found = program.run(&inputs);
        for (kernel, expected) in rust_results!(general_m2::GeneralBody, inputs, f64, 2, 8) {
            assert_eq!(found[kernel], expected, "{kernel}");
        }
    }
    let (body, options) = find("single_m3");
    assert_eq!(options.fused_multiply_add, FusedMultiplyAdd::Off);
    let Some(program) = CProgram::compile(&generate_c(&body, &options).unwrap()) else { return };
    for _ in 0..20 {
        let inputs = inputs(3, &mut random);
        let found = program.run(&inputs);
        for (kernel, expected) in rust_results!(single_m3::SingleBody, inputs, f32, 3, 9) {
            assert_eq!(found[kernel], expected, "{kernel}");
        }
    }
}

#[test]
fn no_marker_has_the_name_of_the_stiffness_of_another() {
    let (mut body, options) = find("stiffened_m2");
    let old = body.markers[1].name.clone();
    let new = format!("{}_stressed", body.markers[0].name);
    body.markers[1].name = new.clone();
    let loads = body.geometric_stiffness.iter_mut().flat_map(|stiffness| &mut stiffness.marker_loads);
    loads.filter(|load| load.marker == old).for_each(|load| load.marker = new.clone());
    let code = generate_c(&body, &options).unwrap();
    for name in ["TIP_STRESSED_[6]", "TIP_STRESSED_STRESSED[6]", "marker STIFFENED_BODY_TIP_STRESSED;"] {
        assert!(code.header.contains(name), "{name}: {}", code.header);
    }
    CProgram::compile(&code);
}

#[test]
fn what_c_cannot_have_is_refused_by_name() {
    let (body, options) = find("general_m2");
    for (options, expected) in [
        (GenerateOptions { scalar: ScalarType::Generic, ..options.clone() }, "scalar generic"),
        (GenerateOptions { fused_multiply_add: FusedMultiplyAdd::On, ..options.clone() }, "fma on"),
        (GenerateOptions { strategy: Strategy::Lanes, ..options.clone() }, "strategy lanes"),
    ] {
        let message = generate_c(&body, &options).unwrap_err().to_string();
        assert!(message.starts_with(expected) && message.contains("expected"), "{message}");
    }
}
