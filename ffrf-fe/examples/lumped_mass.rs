//! What lumped masses cost: frequencies and inertia invariants of our parts, against the consistent mass.
//!
//! `cargo run -p ffrf-fe --example lumped_mass` prints the second table of `docs/theory/lumped_mass.md`.

use std::error::Error;
use std::path::Path;

use faer::Mat;
use ffrf_fe::elements::{Material, brick};
use ffrf_fe::formulations::gcms::gram_matrix;
use ffrf_fe::formulations::quadrature::LumpedMass;
use ffrf_fe::import::{ModelFiles, NodeSource, read_model};
use ffrf_fe::modes::{ModeRequest, compute_modes};
use ffrf_fe::{FeModel, SparseMatrix};

fn main() -> Result<(), Box<dyn Error>> {
    let deck = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/conrod/conrod.inp");
    let files = ModelFiles { nodes: NodeSource::Calculix(deck), mass: None, stiffness: None };
    println!("| part | mass | frequency 1 | 2 | 3 | T | T_11 of mode 1 |");
    println!("|---|---|---|---|---|---|---|");
    compare("connecting rod, 157 C3D20", &read_model(&files)?, 7850.0)?;
    for n in [1, 2, 4] {
        let model = brick([0.3, 0.03, 0.04], [10 * n, n, n], &Material::STEEL)?;
        compare(&format!("beam, {} C3D8", 10 * n * n * n), &model, Material::STEEL.density)?;
    }
    Ok(())
}

fn compare(name: &str, model: &FeModel, density: f64) -> Result<(), Box<dyn Error>> {
    let positions = &model.nodes.positions;
    let consistent = LumpedMass::Consistent.assemble(positions, &model.elements, density)?;
    let (truth, shapes) = frequencies(model, consistent.clone())?;
    for (label, way) in [("row sums", LumpedMass::RowSum), ("scaled diagonal", LumpedMass::ScaledDiagonal)] {
        let mass = way.assemble(positions, &model.elements, density)?;
        let table = |mass: &SparseMatrix| gram_matrix(positions, shapes.as_ref(), mass);
        let (right, found) = (table(&consistent), table(&mass));
        let inertia = relative(&right, &found, 1, 1);
        let modal = relative(&right, &found, 4, 4);
        let least = (0..positions.len()).map(|n| mass[(n, n)]).fold(f64::INFINITY, f64::min);
        let shift = if least > 0.0 {
            let (values, _) = frequencies(model, mass)?;
            values.iter().zip(&truth).map(|(a, b)| format!("{:+.3} %", 100.0 * (a / b - 1.0))).collect()
        } else {
            vec!["negative masses".to_owned(), String::new(), String::new()]
        };
        println!("| {name} | {label} | {} | {inertia:.1e} | {modal:.1e} |", shift.join(" | "));
    }
    Ok(())
}

/// The first three elastic free-free frequencies and the modes.
fn frequencies(model: &FeModel, mass: SparseMatrix) -> Result<(Vec<f64>, Mat<f64>), Box<dyn Error>> {
    let model = FeModel { mass, ..model.clone() };
    let basis = compute_modes(&model, &ModeRequest::free_free(3), &mut |_| {})?.basis;
    let stiffness = model.stiffness.as_ref().ok_or("no stiffness")?;
    let modal = basis.shapes.transpose() * (stiffness * &basis.shapes);
    Ok(((0..3).map(|mu| modal[(mu, mu)].sqrt()).collect(), basis.shapes))
}

/// Largest deviation of a 3 x 3 block of the Gram matrix.
fn relative(a: &Mat<f64>, b: &Mat<f64>, row: usize, column: usize) -> f64 {
    let block = |m: &Mat<f64>| m.as_ref().submatrix(row, column, 3, 3).to_owned();
    (block(a) - block(b)).norm_max() / block(a).norm_max()
}
