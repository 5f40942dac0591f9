//! The bodies whose generated code is committed: which model, by which options.

use ffrf_codegen::{Fidelity, FusedMultiplyAdd, GenerateOptions, ScalarType};
use ffrf_model::ReducedBody;

use ffrf_test_kit::random_body::{Modes, random_body};

/// Name of the file and of the module, model and options of each golden body.
pub fn all() -> Vec<(&'static str, ReducedBody, GenerateOptions)> {
    let options = |name: &str| GenerateOptions {
        name: name.to_owned(),
        source_name: "made in the test".to_owned(),
        ..GenerateOptions::default()
    };
    vec![
        ("rigid", random_body(1, 0, Modes::Random), options("RigidBody")),
        ("general_m2", random_body(2, 2, Modes::Random), options("GeneralBody")),
        ("normalised_m3", random_body(3, 3, Modes::Normalised), options("NormalisedBody")),
        (
            "free_free_m3",
            random_body(4, 3, Modes::FreeFree),
            // Orthogonal up to the rounding of a few dozen products.
            GenerateOptions { layout_tolerance: 1e-13, ..options("FreeFreeBody") },
        ),
        (
            "single_m3",
            random_body(5, 3, Modes::Normalised),
            GenerateOptions {
                scalar: ScalarType::F32,
                fused_multiply_add: FusedMultiplyAdd::Off,
                ..options("SingleBody")
            },
        ),
        (
            "generic_m2",
            random_body(8, 2, Modes::Normalised),
            GenerateOptions { scalar: ScalarType::Generic, ..options("GenericBody") },
        ),
        (
            "constant_m2",
            random_body(6, 2, Modes::Random),
            GenerateOptions { fidelity: Fidelity::Constant, ..options("ConstantBody") },
        ),
        (
            "jacobians_m2",
            random_body(7, 2, Modes::Normalised),
            GenerateOptions { jacobians: true, ..options("JacobianBody") },
        ),
    ]
}
