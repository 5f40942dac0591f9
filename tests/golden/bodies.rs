//! The bodies whose generated code is committed: which model, by which options.

use ffrf_codegen::{Fidelity, FusedMultiplyAdd, GenerateOptions, ScalarType, Strategy};
use ffrf_model::{MarkerLoadStiffness, ReducedBody, SectionMarker, StressMarker};

use ffrf_test_kit::random::Random;
use ffrf_test_kit::random_body::{Modes, random_body, stiffened};

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
        (
            "stiffened_m2",
            with_loads(with_section(with_stress(stiffened(
                random_body(9, 2, Modes::Normalised),
                10,
                STIFFENING,
            )))),
            options("StiffenedBody"),
        ),
        (
            "stiffened_lanes_m3",
            stiffened_without_linear_acceleration(),
            GenerateOptions { strategy: Strategy::Lanes, ..options("StiffenedLanes") },
        ),
    ]
}

/// Size of the geometric stiffness, beside masses of modes of about one.
const STIFFENING: f64 = 0.1;

/// The same of loads at markers, beside rows of about one: what amplitudes of some tenths change them by is a few percent.
const LOAD_STIFFENING: f64 = 0.3;

/// As in mean axes: no stress of a linear acceleration, which loops over lanes do not know.
fn stiffened_without_linear_acceleration() -> ReducedBody {
    let mut body = stiffened(random_body(10, 3, Modes::Normalised), 11, STIFFENING);
    if let Some(geometric) = &mut body.geometric_stiffness {
        geometric.uniform_load.iter_mut().flatten().for_each(|load| *load = [0.0; 3]);
    }
    body
}

/// With the stress stiffness of loads at both markers, of random numbers.
fn with_loads(mut body: ReducedBody) -> ReducedBody {
    let (mut random, modes) = (Random::new(13), body.mode_count());
    if let Some(geometric) = &mut body.geometric_stiffness {
        let loads = body.markers.iter().map(|marker| {
            let mut stiffness = vec![vec![[0.0; 6]; modes]; modes];
            for mu in 0..modes {
                for nu in mu..modes {
                    stiffness[mu][nu] = std::array::from_fn(|_| LOAD_STIFFENING * random.number());
                    stiffness[nu][mu] = stiffness[mu][nu];
                }
            }
            MarkerLoadStiffness { marker: marker.name.clone(), stiffness }
        });
        geometric.marker_loads = loads.collect();
    }
    body
}

/// With a cut, of numbers that tell rows from columns.
fn with_section(mut body: ReducedBody) -> ReducedBody {
    body.section_markers = vec![SectionMarker {
        name: "cut".to_owned(),
        position: [0.25, 0.5, -1.0],
        normal: [0.0, 1.0, 0.0],
        force: (0..body.mode_count()).map(|mu| std::array::from_fn(|k| (10 * mu + k) as f64)).collect(),
    }];
    body
}

/// With the stress at one node, of random numbers.
fn with_stress(mut body: ReducedBody) -> ReducedBody {
    let mut random = Random::new(12);
    body.stress_markers = vec![StressMarker {
        name: "notch".to_owned(),
        nodes: vec![2],
        position: [0.3, -0.1, 0.2],
        stress: (0..body.mode_count()).map(|_| std::array::from_fn(|_| 100.0 * random.number())).collect(),
    }];
    body
}
