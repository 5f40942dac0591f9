//! A basis as it is: every shape keeps its meaning, and only what depends on rigid motion or on others is left out.

use faer::Mat;
use ffrf_model::ModeKind;

use crate::FeError;

use super::ComponentModeError;
use super::coordinates::Coordinates;
use super::free_free::{DEPENDENT, inverse_norms};
use super::rigid_motion::RigidMotion;
use super::shapes::Shapes;

/// Numbers of the shapes to keep, ascending.
///
/// Shapes are taken in order, the constraint modes of the interface `last` behind all others: with a frame tied to
/// that interface they are what the other shapes and rigid motion already hold.
/// Errors: nothing left.
pub(crate) fn independent(
    coordinates: &Coordinates<'_>,
    rigid: &RigidMotion,
    shapes: &Shapes,
    last: usize,
) -> Result<Vec<usize>, FeError> {
    let count = shapes.columns.ncols();
    let scale = inverse_norms(coordinates, &shapes.columns);
    let mut elastic = shapes.columns.clone();
    rigid.remove_from(&mut elastic);
    let gram = coordinates.mass_gram(elastic.as_ref());
    let is_last = |j: usize| shapes.modes[j].kind == ModeKind::Constraint && j / 6 == last;
    let order = (0..count).filter(|&j| !is_last(j)).chain((0..count).filter(|&j| is_last(j)));
    // Rows of the Cholesky factor of the shapes kept so far.
    let mut kept: Vec<usize> = Vec::new();
    let mut factor: Mat<f64> = Mat::zeros(count, count);
    for candidate in order {
        let entry = |other: usize| gram[(candidate, other)] * scale[candidate] * scale[other];
        let row = kept.len();
        let mut rest = entry(candidate);
        for (k, &other) in kept.iter().enumerate() {
            let known: f64 = (0..k).map(|l| factor[(row, l)] * factor[(k, l)]).sum();
            let value = (entry(other) - known) / factor[(k, k)];
            factor[(row, k)] = value;
            rest -= value * value;
        }
        if rest > DEPENDENT {
            factor[(row, row)] = rest.sqrt();
            kept.push(candidate);
        }
    }
    if kept.is_empty() {
        return Err(ComponentModeError::EmptyBasis { given: count }.into());
    }
    kept.sort_unstable();
    Ok(kept)
}
