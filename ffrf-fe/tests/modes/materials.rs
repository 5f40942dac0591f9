//! A bar of two materials: its longitudinal frequency in closed form, and the frequencies of CalculiX with two `*MATERIAL`s.

use std::fmt::Write as _;

use ffrf_fe::FeModel;
use ffrf_fe::elements::{Material, assemble_materials, quadratic_brick};
use ffrf_fe::modes::{ModeRequest, compute_modes};
use ffrf_test_kit::calculix;

const LENGTHS: [f64; 3] = [0.5, 0.04, 0.03];
const SEAM: f64 = 0.2;
const MODES: usize = 8;
/// CalculiX prints seven digits of eigenvalues.
const PRINTED: f64 = 1e-6;
/// A quarter of a wave in ten quadratic elements, h⁴ of it.
const DISCRETISED: f64 = 1e-5;

fn bar(materials: [Material; 2]) -> FeModel {
    let whole = quadratic_brick(LENGTHS, [10, 1, 1], &Material::STEEL).unwrap();
    let last = |nodes: &[usize]| nodes.iter().map(|&row| whole.nodes.positions[row][0]).fold(0.0, f64::max);
    let of_element = whole.elements.iter().map(|it| usize::from(last(&it.nodes) > SEAM + 1e-9)).collect();
    let materials = materials.map(|material| (String::new(), material));
    assemble_materials(whole.nodes, whole.elements, &materials, of_element).unwrap()
}

fn root(model: &FeModel) -> Vec<usize> {
    (0..model.nodes.len()).filter(|&row| model.nodes.positions[row][0] == 0.0).collect()
}

fn frequencies(model: &FeModel) -> Vec<(f64, f64)> {
    let solution = compute_modes(model, &ModeRequest::clamped(MODES, root(model)), &mut |_| {}).unwrap();
    let shapes = &solution.basis.shapes;
    let of = |mode: usize| {
        let square = |axis: usize| -> f64 {
            (0..model.nodes.len()).map(|row| shapes[(3 * row + axis, mode)].powi(2)).sum()
        };
        let along = square(0) / (square(0) + square(1) + square(2));
        (solution.report.modes[mode].frequency_hz.unwrap(), along)
    };
    (0..MODES).map(of).collect()
}

/// E₁ k₁ cot k₁ c = E₂ k₂ tan k₂ (L - c) with k = ω √(ρ / E): force and displacement are the same on both sides of the seam.
#[test]
fn a_bar_of_two_materials_has_its_longitudinal_frequency() {
    let materials = [
        Material { youngs_modulus: 2e11, poisson_ratio: 0.0, density: 7000.0 },
        Material { youngs_modulus: 5e9, poisson_ratio: 0.0, density: 1500.0 },
    ];
    let rest = |omega: f64| {
        let wave = materials.map(|it| omega * (it.density / it.youngs_modulus).sqrt());
        let (one, two) = (wave[0] * SEAM, wave[1] * (LENGTHS[0] - SEAM));
        let stiff = [0, 1].map(|k| materials[k].youngs_modulus * wave[k]);
        stiff[0] * one.cos() * two.cos() - stiff[1] * one.sin() * two.sin()
    };
    // The first root: the rest is positive before and negative behind it.
    let (mut low, mut high) = (1.0, 12_000.0);
    assert!(rest(low) > 0.0 && rest(high) < 0.0);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if rest(middle) > 0.0 { low = middle } else { high = middle }
    }
    let expected = low / std::f64::consts::TAU;
    let all = frequencies(&bar(materials));
    let &(found, _) = all.iter().find(|(_, along)| *along > 0.999).expect("a longitudinal mode");
    assert!((found / expected - 1.0).abs() < DISCRETISED, "{found} Hz, expected {expected} Hz");
}

#[test]
fn a_bar_of_two_materials_has_the_frequencies_of_calculix() {
    let rubber = Material { youngs_modulus: 3e9, poisson_ratio: 0.4, density: 1200.0 };
    let materials = [Material::STEEL, rubber];
    let model = bar(materials);
    let mut deck = String::from("*NODE\n");
    for (row, [x, y, z]) in model.nodes.positions.iter().enumerate() {
        writeln!(deck, "{}, {x:.12e}, {y:.12e}, {z:.12e}", row + 1).unwrap();
    }
    for (number, element) in model.elements.iter().enumerate() {
        let mut fields = vec![(number + 1).to_string()];
        fields.extend(element.nodes.iter().map(|node| (node + 1).to_string()));
        let set = model.element_materials[number];
        writeln!(deck, "*ELEMENT, TYPE=C3D20, ELSET=E{set}\n{},", fields[..11].join(", ")).unwrap();
        writeln!(deck, "{}", fields[11..].join(", ")).unwrap();
    }
    for (set, material) in materials.iter().enumerate() {
        write!(
            deck,
            "*MATERIAL, NAME=M{set}\n*ELASTIC\n{:e}, {}\n*DENSITY\n{:e}\n*SOLID SECTION, ELSET=E{set}, MATERIAL=M{set}\n",
            material.youngs_modulus, material.poisson_ratio, material.density
        )
        .unwrap();
    }
    deck.push_str("*NSET, NSET=ROOT\n");
    root(&model).iter().for_each(|row| writeln!(deck, "{},", row + 1).unwrap());
    write!(deck, "*BOUNDARY\nROOT, 1, 3\n*STEP\n*FREQUENCY\n{MODES}\n*END STEP\n").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let Some(results) = calculix::results(folder.path(), &deck) else { return };
    let expected = calculix::frequencies(&results, MODES);
    for ((found, _), expected) in frequencies(&model).iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < PRINTED, "{found} Hz, CalculiX {expected} Hz");
    }
}
