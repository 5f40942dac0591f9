//! A block made mass-orthonormal to a basis and within itself.
//!
//! Where the columns of a block are nearly dependent, what is left of a column after its neighbours are removed is
//! small, and round-off of the larger vectors, which lies in the basis too, is then a large part of it. One pass
//! after another, each with the basis first and the block second, until a pass takes nothing away any more.
//! (Barlow, Smoktunowicz: Reorthogonalized block classical Gram-Schmidt, Numerische Mathematik 123, 2013.)

use faer::{Mat, MatRef, Par};

use super::block::{dot, product, scale, subtract_multiple, subtract_tall_product, tall_gram};
use super::operator::Operator;
use super::random::Random;

/// Columns that orthogonalisation shrinks below this part of their length are round-off.
const DEPENDENT: f64 = 1e-13;
/// A pass that leaves every column at least this part of its length leaves it orthogonal to round-off.
const KEPT: f64 = 0.5;
/// Two passes are enough for a well-conditioned block; each replaced column costs at most two more.
const PASSES: usize = 8;
/// A new direction of which less than this is left outside the basis: there is no further direction.
const EXHAUSTED: f64 = 1e-10;

/// V⁺ with W = V C + V⁺ B, [V V⁺] mass-orthonormal.
pub(crate) struct Orthonormal {
    /// V⁺. As wide as W, or less if the space has no further directions.
    pub block: Mat<f64>,
    /// M V⁺.
    pub mass_block: Mat<f64>,
    /// C = Vᵀ M W.
    pub coefficients: Mat<f64>,
    /// B. Columns of W that were dependent have a zero row: another direction stands in their place.
    pub residual_factor: Mat<f64>,
}

/// Orthonormalises W against V and within itself.
pub(crate) fn orthonormalise_block(
    operator: &dyn Operator,
    random: &mut Random,
    basis: MatRef<'_, f64>,
    block: Mat<f64>,
) -> Orthonormal {
    let threads = operator.threads();
    let width = block.ncols();
    let mut result = Orthonormal {
        block,
        mass_block: Mat::zeros(0, 0),
        coefficients: Mat::zeros(basis.ncols(), width),
        residual_factor: Mat::identity(width, width),
    };
    for pass in 0..PASSES {
        let mass_block = operator.mass_times(result.block.as_ref());
        let removed = tall_gram(basis, mass_block.as_ref(), threads);
        subtract_tall_product(result.block.as_mut(), basis, removed.as_ref(), threads);
        result.coefficients += product(removed.as_ref(), result.residual_factor.as_ref(), Par::Seq);
        result.mass_block = operator.mass_times(result.block.as_ref());
        let lengths: Vec<f64> = (0..removed.ncols()).map(|j| removed.col(j).squared_norm_l2()).collect();
        let within = orthonormalise_within(operator, random, basis, &mut result, &lengths);
        result.residual_factor = product(within.factor.as_ref(), result.residual_factor.as_ref(), Par::Seq);
        if pass > 0 && within.kept >= KEPT {
            break;
        }
    }
    result
}

struct Within {
    factor: Mat<f64>,
    /// Least part of its length that a column kept; 0 if one was replaced.
    kept: f64,
}

/// Modified Gram-Schmidt within the block, along with its products with the mass. `removed` is the square of what
/// was taken from each column before.
fn orthonormalise_within(
    operator: &dyn Operator,
    random: &mut Random,
    basis: MatRef<'_, f64>,
    result: &mut Orthonormal,
    removed: &[f64],
) -> Within {
    let width = result.block.ncols();
    let mut factor = Mat::zeros(width, width);
    let mut kept = 1.0_f64;
    // Columns move to the front where one is left out.
    let mut count = 0;
    for j in 0..width {
        let mut column = result.block.col_as_slice(j).to_vec();
        let mut mass_column = result.mass_block.col_as_slice(j).to_vec();
        let mut before = removed[j];
        for _ in 0..2 {
            for i in 0..count {
                let part = dot(result.mass_block.col_as_slice(i), &column);
                subtract_multiple(&mut column, part, result.block.col_as_slice(i));
                subtract_multiple(&mut mass_column, part, result.mass_block.col_as_slice(i));
                factor[(i, j)] += part;
                before += part * part;
            }
        }
        let squared = dot(&column, &mass_column).max(0.0);
        let length = squared.sqrt();
        let before = (before + squared).sqrt();
        if length > DEPENDENT * before && length.is_normal() {
            factor[(count, j)] = length;
            kept = kept.min(length / before);
            scale(&mut column, length.recip());
            scale(&mut mass_column, length.recip());
        } else {
            kept = 0.0;
            let block = result.block.get(.., 0..count);
            match new_direction(operator, random, basis, block) {
                Some(pair) => (column, mass_column) = pair,
                None => continue,
            }
        }
        result.block.col_as_slice_mut(count).copy_from_slice(&column);
        result.mass_block.col_as_slice_mut(count).copy_from_slice(&mass_column);
        count += 1;
    }
    let rows = result.block.nrows();
    result.block.truncate(rows, count);
    result.mass_block.truncate(rows, count);
    factor.truncate(count, width);
    Within { factor, kept }
}

/// A vector of unit length in the range of the operator, roughly orthogonal to what is there, and its product with
/// the mass; `None` if there is nothing outside.
fn new_direction(
    operator: &dyn Operator,
    random: &mut Random,
    basis: MatRef<'_, f64>,
    block: MatRef<'_, f64>,
) -> Option<(Vec<f64>, Vec<f64>)> {
    let mut column = Mat::zeros(basis.nrows(), 1);
    random.fill(column.col_as_slice_mut(0));
    let mut mass_column = operator.mass_times(column.as_ref());
    let before = mass_length(&column, &mass_column);
    for _ in 0..2 {
        operator.remove_rigid(&mut column);
        mass_column = operator.mass_times(column.as_ref());
        for known in [basis, block] {
            let removed = tall_gram(known, mass_column.as_ref(), operator.threads());
            subtract_tall_product(column.as_mut(), known, removed.as_ref(), operator.threads());
        }
        mass_column = operator.mass_times(column.as_ref());
    }
    if mass_length(&column, &mass_column) <= EXHAUSTED * before {
        return None;
    }
    // Without the operator, degrees of freedom without mass would keep what chance gave them.
    column = operator.apply(mass_column.as_ref());
    mass_column = operator.mass_times(column.as_ref());
    let length = mass_length(&column, &mass_column);
    if !length.is_normal() {
        return None;
    }
    scale(column.col_as_slice_mut(0), length.recip());
    scale(mass_column.col_as_slice_mut(0), length.recip());
    Some((column.col_as_slice(0).to_vec(), mass_column.col_as_slice(0).to_vec()))
}

fn mass_length(column: &Mat<f64>, mass_column: &Mat<f64>) -> f64 {
    dot(column.col_as_slice(0), mass_column.col_as_slice(0)).max(0.0).sqrt()
}
