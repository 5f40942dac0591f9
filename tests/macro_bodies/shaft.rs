//! The shaft in `models/`: a steel bar of 20-node hexahedra, and what it reduces to.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

use std::path::{Path, PathBuf};

use ffrf_fe::elements::{Material, quadratic_brick};
use ffrf_fe::modes::{ModeRequest, compute_modes};
use ffrf_fe::reduction::{Damping, MarkerRequest, ReductionOptions, reduce};

use ffrf_model::{ReducedBody, Units};

/// Units: m.
const EDGES: [f64; 3] = [0.5, 0.02, 0.02];
const DIVISIONS: [usize; 3] = [20, 2, 2];
/// Three pairs of bending; the next is torsion.
const MODES: usize = 6;
/// Modes are the end of an iteration in floating point; another machine rounds differently.
const SAME_MODES: f64 = 1e-9;
/// Bernoulli's beam against a solid of length to thickness 25: shear and rotary inertia take 1 % of the first frequency.
const SLENDER: f64 = 0.02;

fn model_path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("models/shaft.ffrf.json")
}

fn made() -> ReducedBody {
    let mut model = quadratic_brick(EDGES, DIVISIONS, &Material::STEEL).unwrap();
    for position in &mut model.nodes.positions {
        *position = [0, 1, 2].map(|axis| position[axis] - 0.5 * EDGES[axis]);
    }
    let section = |name: &str, x: f64| MarkerRequest {
        name: name.to_owned(),
        nodes: (0..model.nodes.len())
            .filter(|row| (model.nodes.positions[*row][0] - x).abs() < 1e-9)
            .collect(),
    };
    let solution = compute_modes(&model, &ModeRequest::free_free(MODES), &mut |_| ()).unwrap();
    let options = ReductionOptions {
        title: "steel shaft, 500 mm x 20 mm x 20 mm".to_owned(),
        units: Some(Units::SI),
        damping: Damping::ModalRatio(vec![0.01]),
        markers: vec![section("LEFT", -0.25), section("MIDDLE", 0.0), section("RIGHT", 0.25)],
        ..ReductionOptions::default()
    };
    reduce(&model, &solution.basis, &options).unwrap()
}

#[test]
fn the_committed_shaft_is_a_bar_of_steel() {
    let made = made();
    if std::env::var_os("FFRF_UPDATE_GOLDEN").is_some() {
        std::fs::write(model_path(), made.to_json().unwrap()).unwrap();
    }
    let committed = ReducedBody::read(model_path()).unwrap();
    let frequency = |body: &ReducedBody, mode: usize| body.modes[mode].frequency_hz.unwrap();
    for mode in 0..MODES {
        let (found, expected) = (frequency(&made, mode), frequency(&committed, mode));
        assert!((found / expected - 1.0).abs() < SAME_MODES, "{found} Hz, committed {expected} Hz");
    }
    assert!((committed.inertia.mass / made.inertia.mass - 1.0).abs() < SAME_MODES);
    // (4.730 / L)² √(E I / ρ A) of a free beam
    let [length, height, _] = EDGES;
    let Material { youngs_modulus, density, .. } = Material::STEEL;
    let radius_of_gyration = height / 12.0_f64.sqrt();
    let bernoulli =
        (4.730_040_744_862_704 / length).powi(2) * (youngs_modulus / density).sqrt() * radius_of_gyration;
    for mode in 0..2 {
        let found = std::f64::consts::TAU * frequency(&committed, mode);
        assert!((found / bernoulli - 1.0).abs() < SLENDER, "{found} rad/s, {bernoulli} rad/s");
    }
}
