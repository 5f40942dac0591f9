//! Modal assurance criterion: how alike the modes of two bases are.

use faer::{Mat, MatRef, Par};

use crate::modes::{gram, mass_times_full};
use crate::{FeError, FeModel};

use super::ComponentModeError;

/// MAC_ij = (a_i · b_j)² / ((a_i · a_i)(b_j · b_j)): 1 for equal shapes, 0 for orthogonal ones.
///
/// For shapes of a test, give the rows that were measured. Shape: columns of `a` x columns of `b`.
/// Errors: shapes of different length.
pub fn mac(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Result<Mat<f64>, FeError> {
    check_rows(a, b)?;
    Ok(normalised(a, b, a, b))
}

/// [`mac`] in the mass inner product of a model, in which eigenmodes of one part are orthogonal to each other.
///
/// Shapes: 3N x any. Errors: shapes of different length or of another model.
pub fn mass_weighted_mac(model: &FeModel, a: &Mat<f64>, b: &Mat<f64>) -> Result<Mat<f64>, FeError> {
    check_rows(a.as_ref(), b.as_ref())?;
    let (expected, found) = (3 * model.nodes.len(), a.nrows());
    if expected != found {
        let what = "rows of the mode shapes".to_owned();
        return Err(ComponentModeError::Size { what, expected, found }.into());
    }
    let (mass_a, mass_b) = (mass_times_full(&model.mass, a), mass_times_full(&model.mass, b));
    Ok(normalised(a.as_ref(), b.as_ref(), mass_a.as_ref(), mass_b.as_ref()))
}

fn normalised(a: MatRef<'_, f64>, b: MatRef<'_, f64>, wa: MatRef<'_, f64>, wb: MatRef<'_, f64>) -> Mat<f64> {
    let products = gram(a, wb, Par::Seq);
    let square = |x: MatRef<'_, f64>, y: MatRef<'_, f64>, j: usize| -> f64 {
        (0..x.nrows()).map(|i| x[(i, j)] * y[(i, j)]).sum()
    };
    let of_a: Vec<f64> = (0..a.ncols()).map(|j| square(a, wa, j)).collect();
    let of_b: Vec<f64> = (0..b.ncols()).map(|j| square(b, wb, j)).collect();
    Mat::from_fn(products.nrows(), products.ncols(), |i, j| {
        let scale = of_a[i] * of_b[j];
        if scale > 0.0 { products[(i, j)].powi(2) / scale } else { 0.0 }
    })
}

fn check_rows(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Result<(), ComponentModeError> {
    if a.nrows() == b.nrows() {
        return Ok(());
    }
    let what = "rows of the second set of shapes".to_owned();
    Err(ComponentModeError::Size { what, expected: a.nrows(), found: b.nrows() })
}
