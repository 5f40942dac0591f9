//! The pendulums: a soft solid beam, and three bars between three nodes.

use std::error::Error;

use faer::Mat;
use faer::linalg::solvers::Solve;
use faer::sparse::Triplet;
use ffrf_fe::elements::{Material, brick};
use ffrf_fe::{FeModel, Nodes, SparseMatrix};

/// 1 m x 0.1 m x 0.12 m of hexahedra, as soft as jelly, so that it bends visibly under its weight.
pub fn beam(divisions: [usize; 3]) -> Result<FeModel, Box<dyn Error>> {
    let soft = Material { youngs_modulus: 1e6, poisson_ratio: 0.3, density: 1000.0 };
    Ok(brick([1.0, 0.1, 0.12], divisions, &soft)?)
}

/// The truss of the paper's appendix with a third bar, so that it keeps its shape: (218) with consistent masses.
pub fn three_bars() -> Result<FeModel, Box<dyn Error>> {
    let positions = vec![[0.0, 0.0, 0.0], [0.5, 0.1, 0.4], [1.0, 0.0, 0.0]];
    let mut stiffness = Vec::new();
    let mut mass = Vec::new();
    for (n, m) in [(0, 1), (1, 2), (0, 2)] {
        let along: [f64; 3] = [0, 1, 2].map(|i| positions[n][i] - positions[m][i]);
        let length = along.iter().map(|x| x * x).sum::<f64>().sqrt();
        for (a, b, sign) in [(n, n, 1.0), (m, m, 1.0), (n, m, -1.0), (m, n, -1.0)] {
            mass.push(Triplet::new(a, b, if a == b { length / 3.0 } else { length / 6.0 }));
            for i in 0..3 {
                for j in 0..3 {
                    let value = sign * 400.0 * along[i] * along[j] / length.powi(3);
                    stiffness.push(Triplet::new(3 * a + i, 3 * b + j, value));
                }
            }
        }
    }
    Ok(FeModel {
        nodes: Nodes { ids: vec![1, 2, 3], positions, ..Nodes::default() },
        mass: SparseMatrix::try_new_from_triplets(3, 3, &mass).map_err(|e| format!("{e:?}"))?,
        mass_anisotropy: 0.0,
        stiffness: Some(SparseMatrix::try_new_from_triplets(9, 9, &stiffness).map_err(|e| format!("{e:?}"))?),
        fixed_dofs: Vec::new(),
        elements: Vec::new(),
        materials: Vec::new(),
        element_materials: Vec::new(),
        sources: Vec::new(),
        notes: Vec::new(),
    })
}

/// The first elastic free-free modes, mass-normalised, by a dense eigenproblem. Shape: 3N x `count`.
pub fn free_modes(model: &FeModel, count: usize) -> Result<Mat<f64>, Box<dyn Error>> {
    let size = 3 * model.nodes.len();
    let stiffness = model.stiffness.as_ref().ok_or("no stiffness")? * Mat::<f64>::identity(size, size);
    let mass = Mat::from_fn(size, size, |i, j| {
        if i % 3 == j % 3 { model.mass.get(i / 3, j / 3).copied().unwrap_or(0.0) } else { 0.0 }
    });
    let factor = mass.llt(faer::Side::Lower).map_err(|e| format!("{e:?}"))?;
    let lower = factor.L().partial_piv_lu();
    let whole = lower.solve(lower.solve(&stiffness).transpose());
    let symmetric = Mat::from_fn(size, size, |i, j| 0.5 * (whole[(i, j)] + whole[(j, i)]));
    let eigen = symmetric.self_adjoint_eigen(faer::Side::Lower).map_err(|e| format!("{e:?}"))?;
    let shapes = factor.L().transpose().to_owned().partial_piv_lu().solve(eigen.U());
    Ok(shapes.subcols(6, count).to_owned())
}
