//! The finite-element side: import, modes, reduction.

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use ffrf_fe::import::{ModelFiles, NodeSource, read_model};
use ffrf_fe::modes::{ModeRequest, compute_modes};
use ffrf_fe::reduction::{MarkerRequest, ReductionOptions, reduce};
use ffrf_fe::{FeModel, ModeBasis};
use ffrf_model::ReducedBody;

use crate::M;

/// The part as a finite-element model, its modes, and the body that it reduces to.
pub struct Part {
    pub model: FeModel,
    pub basis: ModeBasis,
    pub body: ReducedBody,
}

impl Part {
    /// Displacement of node `n` in the body frame, Ψ_n q. Units: m.
    pub fn displacement(&self, n: usize, q: &[f64]) -> [f64; 3] {
        std::array::from_fn(|i| (0..q.len()).map(|mu| self.basis.shapes[(3 * n + i, mu)] * q[mu]).sum())
    }

    /// Largest displacement of any node, max_n |Ψ_n q|. Units: m.
    pub fn largest_displacement(&self, q: &[f64]) -> f64 {
        let length = |u: [f64; 3]| u.iter().map(|x| x * x).sum::<f64>().sqrt();
        (0..self.model.nodes.len()).map(|n| length(self.displacement(n, q))).fold(0.0, f64::max)
    }
}

/// Reads the deck with the matrices beside it, computes the modes, shows their table, reduces.
pub fn import(deck: &Path) -> Result<Part, Box<dyn Error>> {
    let start = Instant::now();
    let files = ModelFiles { nodes: NodeSource::Calculix(deck.to_path_buf()), mass: None, stiffness: None };
    let model = read_model(&files)?;
    println!(
        "{} nodes, {} elements, read and checked in {:.2} s; M_FE differs from M_s x I3 by {:.1e}",
        model.nodes.len(),
        model.elements.len(),
        start.elapsed().as_secs_f64(),
        model.mass_anisotropy
    );

    let start = Instant::now();
    let solution = compute_modes(&model, &ModeRequest::free_free(M), &mut |_| ())?;
    println!("modes in {:.2} s\n{}", start.elapsed().as_secs_f64(), solution.report);

    let marker = |name: &str| MarkerRequest {
        name: name.to_owned(),
        nodes: model.nodes.sets.get(name).cloned().unwrap_or_default(),
    };
    let options = ReductionOptions {
        title: "Connecting rod, 8 free-free modes".to_owned(),
        markers: vec![marker("BIG_END"), marker("SMALL_END")],
        ..ReductionOptions::default()
    };
    let body = reduce(&model, &solution.basis, &options)?;
    body.check()?.verdict()?;
    println!("mass {:.6} kg, reduced body passes every check", body.inertia.mass);
    Ok(Part { model, basis: solution.basis, body })
}
