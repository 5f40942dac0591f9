//! The inverse of the mass that the modes leave for translation.

use super::table::number;
use crate::CodegenError;
use crate::body::BodyExpressions;
use crate::expression::{Expression, Graph};

/// (m I - m B Θ_ff⁻¹ (m B)ᵀ)⁻¹ of a body of constants: xx, yy, zz, xy, xz, yz. Units: 1/kg.
///
/// By Cholesky factors, which also show whether it is positive definite.
/// Errors: the modes contain rigid-body translation.
pub(super) fn translation_compliance(
    graph: &Graph,
    body: &BodyExpressions,
    modal_compliance: &[Vec<Expression>],
) -> Result<[f64; 6], CodegenError> {
    let mass = number(graph, body.mass);
    let first: Vec<[f64; 3]> =
        body.modal_first_moment.iter().map(|moment| moment.map(|entry| number(graph, entry))).collect();
    // Θ_ff⁻¹ (m B)ᵀ, row by row.
    let weighted: Vec<[f64; 3]> = modal_compliance
        .iter()
        .map(|row| {
            let mut sums = [0.0; 3];
            for (entry, b) in row.iter().zip(&first) {
                let entry = number(graph, *entry);
                for (sum, b) in sums.iter_mut().zip(b) {
                    *sum += entry * b;
                }
            }
            sums
        })
        .collect();
    invert(mass, &first, &weighted)
}

fn invert(mass: f64, first: &[[f64; 3]], weighted: &[[f64; 3]]) -> Result<[f64; 6], CodegenError> {
    let mut left = [[0.0; 3]; 3];
    for (i, row) in left.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            let carried: f64 = first.iter().zip(weighted).map(|(b, w)| b[i] * w[j]).sum();
            *entry = if i == j { mass - carried } else { -carried };
        }
    }
    let mut factor = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| factor[i][k] * factor[j][k]).sum();
            let rest = left[i][j] - sum;
            if i == j {
                if rest.is_nan() || rest <= f64::EPSILON * mass {
                    return Err(CodegenError::DependentModes { pivot: i, found: rest });
                }
                factor[i][i] = f64::sqrt(rest);
            } else {
                factor[i][j] = rest / factor[j][j];
            }
        }
    }
    let mut inverse = [[0.0; 3]; 3];
    for (column, inverse) in inverse.iter_mut().enumerate() {
        let mut x = [0.0; 3];
        for i in 0..3 {
            let sum: f64 = (0..i).map(|k| factor[i][k] * x[k]).sum();
            x[i] = (if i == column { 1.0 } else { 0.0 } - sum) / factor[i][i];
        }
        for i in (0..3).rev() {
            let sum: f64 = (i + 1..3).map(|k| factor[k][i] * inverse[k]).sum();
            inverse[i] = (x[i] - sum) / factor[i][i];
        }
    }
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = inverse;
    Ok([xx, yy, zz, xy, xz, yz])
}
