//! Geometric stiffness of forces and moments at markers: closed forms of rods, Euler's column, and the motion of the marker in
//! second order.

use faer::{Mat, Side};
use ffrf_fe::elements::{Material, quadratic_brick};
use ffrf_fe::geometric_stiffness::{PrestressSupport, marker_load_stiffness, second_order_displacements};
use ffrf_fe::modes::{ModeRequest, compute_modes};
use ffrf_fe::reduction::{MarkerRequest, ReductionOptions, reduce};
use ffrf_fe::{FeModel, ModeBasis};
use ffrf_model::{MarkerLoadStiffness, Mode, ModeKind, ReducedBody};

/// Without Poisson's effect the stress of a pulled rod is that of the closed form everywhere.
const MATERIAL: Material = Material { youngs_modulus: 2.0e6, poisson_ratio: 0.0, density: 1200.0 };

/// Polynomials that the elements and their quadrature hold: round-off of the static solution.
const EXACT: f64 = 1e-9;

fn face(model: &FeModel, x: f64) -> Vec<usize> {
    (0..model.nodes.len()).filter(|&row| (model.nodes.positions[row][0] - x).abs() < 1e-9).collect()
}

fn body(model: &FeModel, basis: &ModeBasis, tip: Vec<usize>) -> ReducedBody {
    let markers = vec![MarkerRequest { name: "tip".to_owned(), nodes: tip }];
    let options = ReductionOptions { markers, ..ReductionOptions::default() };
    reduce(model, basis, &options).expect("a body")
}

fn of(
    model: &FeModel,
    basis: &ModeBasis,
    support: &PrestressSupport,
    body: &ReducedBody,
) -> MarkerLoadStiffness {
    let mut found = marker_load_stiffness(model, basis, support, None, &[&body.markers[0]]).expect("loads");
    assert_eq!((found.len(), found[0].marker.as_str()), (1, "tip"));
    found.remove(0)
}

/// The force N = 1 everywhere, or in mean axes N = x: Γ = ∫ N (2 x)² is 4/3, or 1, for u_y = x² and u_z = x².
#[test]
fn a_pulled_rod_has_the_stiffness_of_its_axial_force() {
    let model = quadratic_brick([1.0, 0.1, 0.05], [10, 1, 1], &MATERIAL).expect("a sound mesh");
    let shapes = Mat::from_fn(3 * model.nodes.len(), 2, |row, mode| {
        let x = model.nodes.positions[row / 3][0];
        if row % 3 == mode + 1 { x * x } else { 0.0 }
    });
    let basis = ModeBasis { shapes, modes: vec![Mode { kind: ModeKind::User, frequency_hz: None }; 2] };
    let body = body(&model, &basis, face(&model, 1.0));
    let held = PrestressSupport::Clamped { nodes: face(&model, 0.0) };
    for (support, expected) in [(held, 4.0 / 3.0), (PrestressSupport::MeanAxes, 1.0)] {
        let found = of(&model, &basis, &support, &body);
        for mode in 0..2 {
            let pulled = found.stiffness[mode][mode][0];
            assert!((pulled - expected).abs() < EXACT, "{support:?}: {pulled}, expected {expected}");
        }
        assert!(found.stiffness[0][1][0].abs() < EXACT, "{found:?}");
    }
}

/// Lowest angular frequencies of a clamped beam under a dead push at its free end; EI = ρA = L = 1. The root of the boundary
/// conditions of w'''' + P w'' = ω² w, found by a scan and bisection.
fn beam_column(push: f64) -> f64 {
    let conditions = |omega: f64| {
        let root = (push * push + 4.0 * omega * omega).sqrt();
        let (a, b) = ((0.5 * (root - push)).sqrt(), (0.5 * (root + push)).sqrt());
        // w = A (cosh ax - cos bx) + B (sinh ax - a/b sin bx); moment and shear at the end
        let moment = [a * a * a.cosh() + b * b * b.cos(), a * a * a.sinh() + a * b * b.sin()];
        let shear = [
            a.powi(3) * a.sinh() - b.powi(3) * b.sin() + push * (a * a.sinh() + b * b.sin()),
            a.powi(3) * a.cosh() + a * b * b * b.cos() + push * a * (a.cosh() - b.cos()),
        ];
        moment[0] * shear[1] - moment[1] * shear[0]
    };
    let (mut low, step) = (1e-3, 1e-2);
    while conditions(low) * conditions(low + step) > 0.0 {
        low += step;
    }
    let mut high = low + step;
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if conditions(low) * conditions(middle) > 0.0 { low = middle } else { high = middle }
    }
    low
}

/// Slender, so that shear and rotational inertia are a thousandth: what the beam does not know.
const COLUMN: [f64; 3] = [1.0, 0.04, 0.02];
const BEAM_THEORY: f64 = 2e-3;

#[test]
fn a_pushed_column_buckles_at_eulers_load() {
    let model = quadratic_brick(COLUMN, [20, 1, 1], &MATERIAL).expect("a sound mesh");
    let root = face(&model, 0.0);
    let solution = compute_modes(&model, &ModeRequest::clamped(6, root.clone()), &mut |_| {}).expect("modes");
    let body = body(&model, &solution.basis, face(&model, 1.0));
    let load = of(&model, &solution.basis, &PrestressSupport::Clamped { nodes: root }, &body);
    let count = body.mode_count();
    // modes of unit mass
    let least = |force: f64| {
        let stiffness =
            Mat::from_fn(count, count, |mu, nu| body.stiffness[mu][nu] + force * load.stiffness[mu][nu][0]);
        stiffness.self_adjoint_eigenvalues(Side::Lower).expect("real")[0]
    };
    let [length, width, height] = COLUMN;
    let rigidity = MATERIAL.youngs_modulus * width * height.powi(3) / 12.0;
    let euler = std::f64::consts::PI.powi(2) * rigidity / (4.0 * length * length);
    let (mut low, mut high) = (0.0, 2.0 * euler);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if least(-middle) > 0.0 { low = middle } else { high = middle }
    }
    assert!((low / euler - 1.0).abs() < BEAM_THEORY, "buckles at {low}, Euler says {euler}");

    let unit = rigidity / (length * length);
    let line_mass = MATERIAL.density * width * height;
    for push in [-2.0, -0.5, 0.0, 0.5, 0.9] {
        let force = -push * euler;
        let expected = beam_column(push * euler / unit) * (rigidity / (line_mass * length.powi(4))).sqrt();
        let found = least(force).sqrt();
        // The square of the frequency is a difference that vanishes at Euler's load: so much more is left of what the beam lacks.
        let within = BEAM_THEORY / (1.0 - push).min(1.0);
        assert!((found / expected - 1.0).abs() < within, "push {push}: {found}, theory says {expected}");
    }
}

/// -Γ is what the marker moves by: its translation and rotation of the displacements of second order, which come from elements by
/// another way. All six loads of a part without symmetry.
#[test]
fn the_marker_moves_by_it_in_second_order() {
    let material = Material { youngs_modulus: 7e10, poisson_ratio: 0.3, density: 2700.0 };
    let mut model = quadratic_brick([0.5, 0.06, 0.04], [5, 1, 1], &material).expect("a sound mesh");
    for x in &mut model.nodes.positions {
        x[1] -= 0.03;
    }
    let root = face(&model, 0.0);
    let solution = compute_modes(&model, &ModeRequest::clamped(3, root.clone()), &mut |_| {}).expect("modes");
    let tip: Vec<usize> =
        face(&model, 0.5).into_iter().filter(|&row| model.nodes.positions[row][1] > -0.02).collect();
    let body = body(&model, &solution.basis, tip.clone());
    let support = PrestressSupport::Clamped { nodes: root };
    let found = of(&model, &solution.basis, &support, &body);
    let second = second_order_displacements(&model, &solution.basis, &support, None).expect("fields");
    // A body whose modes are these fields has a marker that says how it moves with them.
    let kinds = vec![Mode { kind: ModeKind::User, frequency_hz: None }; second.columns.ncols()];
    let names: Vec<(usize, usize)> = (0..3).flat_map(|mu| (mu..3).map(move |nu| (mu, nu))).collect();
    let fields = ModeBasis { shapes: second.columns.clone(), modes: kinds };
    let moved = ffrf_fe::reduction::marker_motion(
        &model,
        &fields,
        &MarkerRequest { name: "tip".to_owned(), nodes: tip },
    )
    .expect("a marker");
    let largest = found.stiffness.iter().flatten().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    assert!(largest > 0.0);
    for (column, (mu, nu)) in names.into_iter().enumerate() {
        let motion = [moved.translation[column], moved.rotation[column]].concat();
        for k in 0..6 {
            let expected = -motion[k];
            let off = (found.stiffness[mu][nu][k] - expected).abs();
            assert!(off < EXACT * largest, "{mu} {nu} {k}: {} {expected}", found.stiffness[mu][nu][k]);
            assert_eq!(found.stiffness[mu][nu][k], found.stiffness[nu][mu][k]);
        }
    }
}
