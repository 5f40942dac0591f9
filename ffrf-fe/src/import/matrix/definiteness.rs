//! Is a symmetric matrix positive semidefinite? Pivots of L D Lᵀ answer by Sylvester's law of inertia.

use std::path::Path;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky, simplicial, supernodal,
};
use faer::{Par, Side, Spec};

use super::large_definiteness::{lowest_minor, lowest_ritz_value};
use super::symmetric::sparse;
use crate::SparseMatrix;
use crate::import::ImportError;
use crate::tolerances::{DEFINITENESS_TOLERANCE, VANISHING_PIVOT};

/// Entries of the factor up to which the check factorises: about 160 MB and a second. Larger matrices are
/// factorised by the mode computation anyway, with a count of the eigenvalues below zero; here they get the cheap
/// tests of [`super::large_definiteness`].
const FACTOR_ENTRIES: usize = 20_000_000;

/// Refuses a matrix with an eigenvalue below `-DEFINITENESS_TOLERANCE` after scaling to unit diagonal. Rows of
/// zeros (massless nodes, held degrees of freedom) pass.
///
/// Hands back how many pivots vanish, rows of zeros not counted; `None` for a matrix too large to be factorised here.
pub(crate) fn refuse_indefinite(
    matrix: &SparseMatrix,
    role: &'static str,
    path: &Path,
) -> Result<Option<usize>, ImportError> {
    let size = matrix.nrows();
    let failure =
        |reason: String| ImportError::Factorization { path: path.to_path_buf(), role, size, reason };
    let scaled = scaled_and_shifted(matrix);
    let symbolic = factorize_symbolic_cholesky(
        scaled.symbolic(),
        Side::Lower,
        SymmetricOrdering::Amd,
        CholeskySymbolicParams::default(),
    )
    .map_err(|error| failure(error.to_string()))?;
    let mut vanishing = None;
    let (negative, row, pivot) = if symbolic.len_val() > FACTOR_ENTRIES {
        let minor = lowest_minor(&scaled);
        let ritz = lowest_ritz_value(&scaled).unwrap_or(f64::INFINITY);
        // A witness shows one negative eigenvalue at least.
        (usize::from(minor.value.min(ritz) < 0.0), minor.row, minor.value.min(ritz))
    } else {
        let pivots = pivots(&scaled, &symbolic).map_err(failure)?;
        let negative = pivots.iter().filter(|&&(_, pivot)| pivot.is_nan() || pivot <= 0.0).count();
        vanishing = Some(pivots.iter().filter(|&&(_, pivot)| pivot < VANISHING_PIVOT).count());
        let lowest = pivots.into_iter().min_by(|a, b| a.1.total_cmp(&b.1));
        lowest.map_or((0, 0, 0.0), |(row, pivot)| (negative, row, pivot))
    };
    if negative == 0 {
        return Ok(vanishing);
    }
    Err(ImportError::Indefinite {
        path: path.to_path_buf(),
        role,
        negative,
        size,
        row: row + 1,
        pivot: pivot - DEFINITENESS_TOLERANCE,
        tolerance: DEFINITENESS_TOLERANCE,
    })
}

/// Pivots (row, value) of L D Lᵀ of a matrix given by its lower triangle.
fn pivots(lower: &SparseMatrix, symbolic: &SymbolicCholesky<usize>) -> Result<Vec<(usize, f64)>, String> {
    let parallel = Par::rayon(0);
    let params = Spec::default();
    let mut values = vec![0.0; symbolic.len_val()];
    let scratch = symbolic.factorize_numeric_ldlt_scratch::<f64>(parallel, params);
    let mut memory = MemBuffer::try_new(scratch).map_err(|_| "out of memory".to_owned())?;
    symbolic
        .factorize_numeric_ldlt(
            &mut values,
            lower.as_ref(),
            Side::Lower,
            LdltRegularization::default(),
            parallel,
            MemStack::new(&mut memory),
            params,
        )
        .map_err(|error| error.to_string())?;
    // Row of the matrix that stands at each place of the elimination order.
    let forward = symbolic.perm().map(|perm| perm.arrays().0.to_vec());
    let original = |place: usize| forward.as_ref().map_or(place, |forward| forward[place]);
    Ok(match symbolic.raw() {
        SymbolicCholeskyRaw::Simplicial(structure) => {
            let factor = simplicial::SimplicialLdltRef::new(structure, &values);
            let pivots = structure.col_ptr()[..lower.nrows()].iter().map(|&start| factor.values()[start]);
            pivots.enumerate().map(|(place, pivot)| (original(place), pivot)).collect()
        }
        SymbolicCholeskyRaw::Supernodal(structure) => {
            let factor = supernodal::SupernodalLdltRef::new(structure, &values);
            let mut pivots = Vec::with_capacity(lower.nrows());
            for number in 0..structure.n_supernodes() {
                let node = factor.supernode(number);
                let block = node.val();
                pivots.extend((0..block.ncols()).map(|k| (original(node.start() + k), block[(k, k)])));
            }
            pivots
        }
    })
}

/// The lower triangle of D^-½ A D^-½ + tolerance · I, with D the diagonal of A; rows of zeros get a unit diagonal.
fn scaled_and_shifted(matrix: &SparseMatrix) -> SparseMatrix {
    let size = matrix.nrows();
    let scale: Vec<f64> = (0..size)
        .map(|column| {
            let diagonal = matrix.get(column, column).copied().unwrap_or(0.0).abs();
            let largest = matrix.val_of_col(column).iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            // A zero diagonal in a row with entries makes the matrix indefinite; scaling by the row shows it.
            if diagonal > 0.0 {
                diagonal.sqrt().recip()
            } else if largest > 0.0 {
                largest.sqrt().recip()
            } else {
                0.0
            }
        })
        .collect();
    let (mut starts, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
    for column in 0..size {
        let empty_row = scale[column] == 0.0;
        rows.push(column);
        let place = values.len();
        values.push(if empty_row { 1.0 } else { DEFINITENESS_TOLERANCE });
        for (row, &value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
            if row == column {
                values[place] += value * scale[row] * scale[column];
            } else if row > column {
                rows.push(row);
                values.push(value * scale[row] * scale[column]);
            }
        }
        starts.push(rows.len());
    }
    sparse(size, starts, rows, values)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tridiagonal(size: usize, diagonal: f64) -> SparseMatrix {
        let mut triplets = Vec::new();
        for k in 0..size {
            triplets.push(faer::sparse::Triplet::new(k, k, diagonal));
            if k > 0 {
                triplets.push(faer::sparse::Triplet::new(k, k - 1, -1.0));
                triplets.push(faer::sparse::Triplet::new(k - 1, k, -1.0));
            }
        }
        SparseMatrix::try_new_from_triplets(size, size, &triplets).unwrap()
    }

    /// Dense enough that the factorisation takes its supernodal path.
    fn filled(size: usize, shift: f64) -> SparseMatrix {
        let mut triplets = Vec::new();
        for i in 0..size {
            for j in 0..size {
                let value = 1.0 / (1.0 + i.abs_diff(j) as f64) + if i == j { shift } else { 0.0 };
                triplets.push(faer::sparse::Triplet::new(i, j, value));
            }
        }
        SparseMatrix::try_new_from_triplets(size, size, &triplets).unwrap()
    }

    fn negative(matrix: &SparseMatrix) -> usize {
        match refuse_indefinite(matrix, "stiffness", Path::new("k.mtx")) {
            Ok(_) => 0,
            Err(ImportError::Indefinite { negative, .. }) => negative,
            Err(other) => panic!("{other}"),
        }
    }

    #[test]
    fn counts_negative_eigenvalues_like_the_dense_solver() {
        for matrix in [
            tridiagonal(40, 2.0),
            tridiagonal(40, 1.2),
            filled(60, 0.0),
            filled(60, -0.55),
            filled(300, -0.4),
        ] {
            let dense = matrix.to_dense();
            let values = dense.self_adjoint_eigenvalues(Side::Lower).unwrap();
            let wanted = values.iter().filter(|&&value| value < 0.0).count();
            assert_eq!(negative(&matrix), wanted);
        }
    }

    #[test]
    fn singular_and_empty_rows_pass_and_zero_diagonals_do_not() {
        let mut free = tridiagonal(30, 2.0);
        let (symbolic, values) = free.parts_mut();
        let ends = [symbolic.col_ptr()[0], values.len() - 1];
        for end in ends {
            values[end] = 1.0;
        }
        assert_eq!(negative(&free), 0, "a free chain has the eigenvalue zero");
        let vanishing =
            |matrix: &SparseMatrix| refuse_indefinite(matrix, "mass", Path::new("m.mtx")).unwrap();
        assert_eq!(vanishing(&free), Some(1));
        assert_eq!(vanishing(&tridiagonal(30, 2.01)), Some(0));
        let empty =
            SparseMatrix::try_new_from_triplets(3, 3, &[faer::sparse::Triplet::new(1, 1, 2.0)]).unwrap();
        assert_eq!((negative(&empty), vanishing(&empty)), (0, Some(0)));
        let coupled = [(0, 1, 1.0), (1, 0, 1.0), (1, 1, 1.0)];
        let coupled = coupled.map(|(row, column, value)| faer::sparse::Triplet::new(row, column, value));
        assert_eq!(negative(&SparseMatrix::try_new_from_triplets(2, 2, &coupled).unwrap()), 1);
    }
}
