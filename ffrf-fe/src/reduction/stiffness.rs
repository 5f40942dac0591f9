//! The modal stiffness K_ff.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};
use ffrf_model::ModeKind;

use crate::modes::stiffness_times;
use crate::tolerances::{MODAL_STIFFNESS_ASYMMETRY, RESIDUAL_COUPLING};
use crate::{FeModel, ModeBasis};

use super::ReductionError;

/// ΨᵀKΨ or the modal stiffness given, symmetrised; diagonal for computed eigenmodes.
///
/// Errors: neither K nor K_ff there; K_ff of a wrong size, not finite or not symmetric.
pub(crate) fn modal_stiffness(
    model: &FeModel,
    basis: &ModeBasis,
    given: Option<&Mat<f64>>,
) -> Result<Mat<f64>, ReductionError> {
    let shapes = &basis.shapes;
    let modes = shapes.ncols();
    let stiffness = match (given, &model.stiffness) {
        (Some(given), _) => {
            check(given, modes)?;
            given.clone()
        }
        (None, Some(stiffness)) => {
            let forces = stiffness_times(stiffness, shapes);
            let mut projected = Mat::zeros(modes, modes);
            matmul(&mut projected, Accum::Replace, shapes.transpose(), &forces, 1.0, Par::Seq);
            projected
        }
        (None, None) => return Err(ReductionError::MissingStiffness),
    };
    let symmetric = Mat::from_fn(modes, modes, |i, j| 0.5 * (stiffness[(i, j)] + stiffness[(j, i)]));
    let computed = given.is_none() && basis.modes.iter().all(|mode| mode.kind != ModeKind::User);
    Ok(if computed && couples_only_by_residuals(&symmetric) {
        Mat::from_fn(modes, modes, |i, j| if i == j { symmetric[(i, j)] } else { 0.0 })
    } else {
        symmetric
    })
}

fn couples_only_by_residuals(stiffness: &Mat<f64>) -> bool {
    (0..stiffness.nrows()).all(|i| {
        (0..i).all(|j| {
            let scale = (stiffness[(i, i)] * stiffness[(j, j)]).max(0.0).sqrt();
            stiffness[(i, j)].abs() <= RESIDUAL_COUPLING * scale
        })
    })
}

fn check(given: &Mat<f64>, modes: usize) -> Result<(), ReductionError> {
    let (rows, columns) = (given.nrows(), given.ncols());
    if rows != modes || columns != modes {
        return Err(ReductionError::ModalStiffnessSize { modes, rows, columns });
    }
    let mut largest = 0.0_f64;
    for column in 0..modes {
        for &value in given.col_as_slice(column) {
            if !value.is_finite() {
                return Err(ReductionError::NotFinite { what: "modal stiffness".to_owned(), value });
            }
            largest = largest.max(value.abs());
        }
    }
    for row in 0..modes {
        for column in 0..row {
            let (value, mirrored) = (given[(row, column)], given[(column, row)]);
            if (value - mirrored).abs() > MODAL_STIFFNESS_ASYMMETRY * largest {
                return Err(ReductionError::ModalStiffnessAsymmetric {
                    row,
                    column,
                    value,
                    mirrored,
                    tolerance: MODAL_STIFFNESS_ASYMMETRY,
                });
            }
        }
    }
    Ok(())
}
