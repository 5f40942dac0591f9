//! Displacements of second order: the other side of geometric stiffness, for checks.

use faer::Mat;

use crate::elements::quadrature;
use crate::{Elasticity, FeError, FeModel, ModeBasis, PartElasticity};

use super::support::{PrestressSupport, responses};

/// Displacements g_μν of second order.
#[derive(Debug, Clone)]
pub struct SecondOrder {
    /// A column for each pair μ <= ν, those of μ = 0 first. Shape: 3N x M (M + 1) / 2.
    pub columns: Mat<f64>,
}

/// Displacements g_μν of second order: with ½ q_μ q_ν g_μν added to q_μ φ_μ, a load does the work -½ q_μ q_ν Γ_μν more.
///
/// K g_μν = -f_μν on the support, with f_μν · w = ∫ σ(w) : sym(∇φ_μᵀ∇φ_ν). For a bent beam that is what bending shortens it by.
/// Errors: as those of [`geometric_stiffness`](super::geometric_stiffness).
pub fn second_order_displacements(
    model: &FeModel,
    basis: &ModeBasis,
    support: &PrestressSupport,
    elasticity: Option<Elasticity>,
) -> Result<SecondOrder, FeError> {
    let elasticity = match elasticity {
        Some(given) => given.into(),
        None => PartElasticity::of_model(model)?,
    };
    let modes = basis.shapes.ncols();
    let pairs: Vec<(usize, usize)> = (0..modes).flat_map(|mu| (mu..modes).map(move |nu| (mu, nu))).collect();
    let mut forces = Mat::zeros(3 * model.nodes.len(), pairs.len());
    for (number, element) in model.elements.iter().enumerate() {
        let elasticity = elasticity.of(number)?;
        let corners: Vec<[f64; 3]> = element.nodes.iter().map(|&row| model.nodes.positions[row]).collect();
        for point in quadrature(element.kind, &corners)? {
            let slopes: Vec<[[f64; 3]; 3]> = (0..modes)
                .map(|mu| {
                    let entry = |i: usize, k: usize| -> f64 {
                        let nodes = element.nodes.iter().zip(&point.gradient);
                        nodes.map(|(&row, g)| basis.shapes[(3 * row + i, mu)] * g[k]).sum()
                    };
                    std::array::from_fn(|i| std::array::from_fn(|k| entry(i, k)))
                })
                .collect();
            for (column, &(mu, nu)) in pairs.iter().enumerate() {
                let (a, b) = (&slopes[mu], &slopes[nu]);
                let product = |k: usize, l: usize| -> f64 {
                    (0..3).map(|i| 0.5 * (a[i][k] * b[i][l] + a[i][l] * b[i][k])).sum()
                };
                // The stress of a strain that is sym(∇φ_μᵀ∇φ_ν) does the work f · w on every displacement w.
                let strain: [[f64; 3]; 3] = std::array::from_fn(|k| std::array::from_fn(|l| product(k, l)));
                let [xx, yy, zz, xy, xz, yz] = elasticity.stress(&strain);
                let stress = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
                for (&row, gradient) in element.nodes.iter().zip(&point.gradient) {
                    for (i, line) in stress.iter().enumerate() {
                        let force: f64 = line.iter().zip(gradient).map(|(s, g)| s * g).sum();
                        forces[(3 * row + i, column)] -= point.volume * force;
                    }
                }
            }
        }
    }
    Ok(SecondOrder { columns: responses(model, support, forces.as_ref())? })
}
