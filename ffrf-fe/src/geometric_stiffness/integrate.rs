//! From displacements to stresses inside the elements, and from stresses to geometric stiffness.

use faer::{Mat, MatRef};

use crate::elements::quadrature;
use crate::modes::stiffness_times;
use crate::{FeError, FeModel, PartElasticity, SparseMatrix};

use super::loads::COUNT;

/// Entry (k, l) of a symmetric 3 x 3 matrix in the order xx, yy, zz, xy, xz, yz.
const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// What the elements say.
pub(super) struct Integrals {
    /// ∫ ∇φ_μᵀ σ ∇φ_ν for every load, at [mu][nu] with mu <= nu.
    pub stiffness: Vec<Vec<[f64; COUNT]>>,
    /// ½ ∫ σ : ε, summed over the loads. Units: J for loads of a unit field.
    pub strain_energy: f64,
}

/// Integrates over all elements of a part.
///
/// Errors: an element that is not usable or has no material.
pub(super) fn integrate(
    model: &FeModel,
    elasticity: &PartElasticity,
    displacements: MatRef<'_, f64>,
    shapes: MatRef<'_, f64>,
) -> Result<Integrals, FeError> {
    let modes = shapes.ncols();
    let mut stiffness: Vec<Vec<[f64; COUNT]>> = vec![vec![[0.0; COUNT]; modes]; modes];
    let mut strain_energy = 0.0;
    for (number, element) in model.elements.iter().enumerate() {
        let elasticity = elasticity.of(number)?;
        let corners: Vec<[f64; 3]> = element.nodes.iter().map(|&row| model.nodes.positions[row]).collect();
        for point in quadrature(element.kind, &corners)? {
            let slopes = |fields: MatRef<'_, f64>| -> Vec<[[f64; 3]; 3]> {
                (0..fields.ncols()).map(|j| slope(fields, j, &element.nodes, &point.gradient)).collect()
            };
            let (loaded, modal) = (slopes(displacements), slopes(shapes));
            let mut stresses = [[0.0; 6]; COUNT];
            for (stress, slope) in stresses.iter_mut().zip(&loaded) {
                *stress = elasticity.stress(slope);
                let work: f64 = PAIRS
                    .iter()
                    .zip(&*stress)
                    .map(|(&(k, l), s)| s * if k == l { slope[k][k] } else { slope[k][l] + slope[l][k] })
                    .sum();
                strain_energy += 0.5 * point.volume * work;
            }
            for mu in 0..modes {
                for nu in mu..modes {
                    let product = PAIRS.map(|(k, l)| {
                        let entry = |k: usize, l: usize| -> f64 {
                            (0..3).map(|i| modal[mu][i][k] * modal[nu][i][l]).sum()
                        };
                        point.volume * if k == l { entry(k, k) } else { entry(k, l) + entry(l, k) }
                    });
                    for (sum, stress) in stiffness[mu][nu].iter_mut().zip(&stresses) {
                        *sum += product.iter().zip(stress).map(|(p, s)| p * s).sum::<f64>();
                    }
                }
            }
        }
    }
    Ok(Integrals { stiffness, strain_energy })
}

/// ∂u_i/∂x_k of field `j`.
fn slope(fields: MatRef<'_, f64>, j: usize, nodes: &[usize], gradient: &[[f64; 3]]) -> [[f64; 3]; 3] {
    let mut slope = [[0.0; 3]; 3];
    for (&row, gradient) in nodes.iter().zip(gradient) {
        for (i, line) in slope.iter_mut().enumerate() {
            let u = fields[(3 * row + i, j)];
            for (entry, g) in line.iter_mut().zip(gradient) {
                *entry += u * g;
            }
        }
    }
    slope
}

/// ½ uᵀ K u, summed over the columns.
pub(super) fn strain_energy(stiffness: &SparseMatrix, displacements: &Mat<f64>) -> f64 {
    let forces = stiffness_times(stiffness, displacements);
    (0..forces.ncols())
        .map(|j| (0..forces.nrows()).map(|i| 0.5 * displacements[(i, j)] * forces[(i, j)]).sum::<f64>())
        .sum()
}
