//! The free-free transformation: any basis as orthonormal modes in mean axes.
//!
//! Rigid motion is removed, dependent shapes are left out, and the rest is rotated to the eigenmodes of the
//! unsupported part within the span of the basis. Then Θ_ff = I, K_ff = diag(ω²), b_μ = 0 and ϑ_μ = 0.

use faer::{Mat, Par};
use ffrf_model::{Mode, ModeKind};

use crate::FeError;
use crate::modes::{product, settle_signs};

use super::ComponentModeError;
use super::coordinates::Coordinates;
use super::frequency::hertz;
use super::jacobi;
use super::rigid_motion::RigidMotion;
use super::shapes::Shapes;

/// Directions whose share of a unit shape's kinetic energy is below this are dependent on the others: above what
/// static solutions leave of a rigid motion (1e-16 or less), below what a shape of use has of its own.
pub(crate) const DEPENDENT: f64 = 1e-12;

/// Modes of the span of a basis.
pub(crate) struct Transformed {
    /// Shapes with unit modal mass in mean axes. Shape: n x M.
    pub shapes: Shapes,
    /// ω², ascending. Units: (rad/s)².
    pub values: Vec<f64>,
    /// Shapes that were dependent on the others or rigid.
    pub removed: usize,
}

/// Transforms a basis. Export boundary conditions that stop rigid motion leave nothing to remove.
///
/// Errors: nothing left.
pub(crate) fn transform(
    coordinates: &Coordinates<'_>,
    rigid: &RigidMotion,
    given: Shapes,
) -> Result<Transformed, FeError> {
    let count = given.columns.ncols();
    let mut columns = given.columns;
    let scale = inverse_norms(coordinates, &columns);
    rigid.remove_from(&mut columns);
    let independent = independent_directions(coordinates, &columns, &scale)?;
    if independent.ncols() == 0 {
        return Err(ComponentModeError::EmptyBasis { given: count }.into());
    }
    let mut shapes = product(columns.as_ref(), independent.as_ref(), Par::Seq);
    let mut values = Vec::new();
    // The second pass starts from orthonormal shapes: what the scaling of the first amplified is gone.
    for _ in 0..2 {
        rigid.remove_from(&mut shapes);
        let stiffness = coordinates.stiffness_gram(shapes.as_ref());
        let mass = coordinates.mass_gram(shapes.as_ref());
        let (found, factors) = jacobi::generalised(stiffness.as_ref(), mass.as_ref())?;
        shapes = product(shapes.as_ref(), factors.as_ref(), Par::Seq);
        values = found;
    }
    rigid.remove_from(&mut shapes);
    settle_signs(&mut shapes);
    let removed = count - values.len();
    let modes = values
        .iter()
        .map(|&value| Mode { kind: ModeKind::Component, frequency_hz: Some(hertz(value)) })
        .collect();
    Ok(Transformed { shapes: Shapes { columns: shapes, modes }, values, removed })
}

/// Reciprocal mass norms of shapes, 0 for shapes without mass: what is left of a rigid shape is small against it.
pub(crate) fn inverse_norms(coordinates: &Coordinates<'_>, columns: &Mat<f64>) -> Vec<f64> {
    let mass_columns = coordinates.mass_times(columns.as_ref());
    let square = |j| -> f64 {
        columns.col_as_slice(j).iter().zip(mass_columns.col_as_slice(j)).map(|(x, y)| x * y).sum()
    };
    (0..columns.ncols()).map(square).map(|x: f64| if x > 0.0 { x.sqrt().recip() } else { 0.0 }).collect()
}

/// Factors that make mass-orthonormal shapes of the columns, dependent directions left out. Shape: p x M.
fn independent_directions(
    coordinates: &Coordinates<'_>,
    columns: &Mat<f64>,
    scale: &[f64],
) -> Result<Mat<f64>, FeError> {
    let gram = coordinates.mass_gram(columns.as_ref());
    let scaled = Mat::from_fn(gram.nrows(), gram.ncols(), |i, j| gram[(i, j)] * scale[i] * scale[j]);
    let (values, vectors) = jacobi::eigen(scaled.as_ref())?;
    let first = values.iter().take_while(|&&value| value <= DEPENDENT).count();
    Ok(Mat::from_fn(values.len(), values.len() - first, |i, j| {
        scale[i] * vectors[(i, first + j)] / values[first + j].sqrt()
    }))
}
