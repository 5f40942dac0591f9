//! Sparse Cholesky and LDLᵀ factorisations of shifted stiffness matrices.
//!
//! The factorisations run on one thread: measured on a brick of 92,000 degrees of freedom, two threads of faer were no
//! faster on a quiet machine and slower on a busy one.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::linalg::cholesky::llt::factor::{LltError, LltRegularization};
use faer::sparse::SparseColMat;
use faer::sparse::linalg::cholesky::{LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering};
use faer::{Conj, MatMut, Par, Side};

use super::ModeError;
use super::ordering::{analyse, permutation};

/// The pattern of a factor: it serves every shift of the same problem.
pub(crate) struct Analysis {
    symbolic: SymbolicCholesky<u32>,
}

impl Analysis {
    /// Analyses the pattern of a lower triangle, eliminated in the given order.
    ///
    /// Errors: [`ModeError::FactorTooLarge`].
    pub fn new(lower: &SparseColMat<u32, f64>, order: &[u32]) -> Result<Self, ModeError> {
        let pattern =
            lower.symbolic().to_owned().map_err(|_| ModeError::FactorTooLarge { size: lower.nrows() })?;
        let permutation = permutation(order);
        let symbolic = analyse(&pattern, SymmetricOrdering::Custom(permutation.as_ref()))
            .map_err(|_| ModeError::FactorTooLarge { size: lower.nrows() })?;
        Ok(Self { symbolic })
    }

    /// Number of values stored in the factor.
    pub fn stored_values(&self) -> usize {
        self.symbolic.len_val()
    }

    /// Factors a positive definite matrix A = L Lᵀ.
    ///
    /// Errors: [`ModeError::NotPositiveDefinite`].
    pub fn factorise(&self, lower: &SparseColMat<u32, f64>) -> Result<Factor<'_>, ModeError> {
        let size = lower.nrows();
        let too_large = |_| ModeError::FactorTooLarge { size };
        let mut values = zeros(self.symbolic.len_val(), size)?;
        let scratch = self.symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        let mut memory = MemBuffer::try_new(scratch).map_err(too_large)?;
        self.symbolic
            .factorize_numeric_llt(
                &mut values,
                lower.as_ref(),
                Side::Lower,
                LltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut memory),
                Default::default(),
            )
            .map_err(|LltError::NonPositivePivot { index }| ModeError::NotPositiveDefinite {
                what: "K - shift M".to_owned(),
                pivot: index,
                size,
            })?;
        Ok(Factor { analysis: self, values })
    }

    /// Number of negative pivots of A = L D Lᵀ: by Sylvester's law the number of negative eigenvalues of A.
    ///
    /// Errors: [`ModeError::FactorTooLarge`], [`ModeError::ZeroPivot`] if a pivot vanishes or is not finite.
    pub fn negative_pivots(&self, lower: &SparseColMat<u32, f64>) -> Result<usize, ModeError> {
        let size = lower.nrows();
        let too_large = |_| ModeError::FactorTooLarge { size };
        let mut values = zeros(self.symbolic.len_val(), size)?;
        let scratch = self.symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Default::default());
        let mut memory = MemBuffer::try_new(scratch).map_err(too_large)?;
        self.symbolic
            .factorize_numeric_ldlt(
                &mut values,
                lower.as_ref(),
                Side::Lower,
                LdltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut memory),
                Default::default(),
            )
            .map_err(|_| ModeError::ZeroPivot { size })?;
        let SymbolicCholeskyRaw::Supernodal(supernodes) = self.symbolic.raw() else {
            return Err(ModeError::FactorTooLarge { size });
        };
        let mut negative = 0;
        for (supernode, &start) in
            supernodes.col_ptr_for_val().iter().take(supernodes.n_supernodes()).enumerate()
        {
            let columns =
                (supernodes.supernode_end()[supernode] - supernodes.supernode_begin()[supernode]) as usize;
            let end = supernodes.col_ptr_for_val()[supernode + 1] as usize;
            let rows = (end - start as usize).checked_div(columns).unwrap_or(0);
            for column in 0..columns {
                let pivot = values[start as usize + column * (rows + 1)];
                if pivot == 0.0 || !pivot.is_finite() {
                    return Err(ModeError::ZeroPivot { size });
                }
                negative += usize::from(pivot < 0.0);
            }
        }
        Ok(negative)
    }
}

/// A Cholesky factor.
pub(crate) struct Factor<'a> {
    analysis: &'a Analysis,
    values: Vec<f64>,
}

impl Factor<'_> {
    /// X := A⁻¹ X.
    ///
    /// The columns are solved in two halves, each by its own thread if `threads` says so. The halves are the same
    /// for one thread, so that the result is, too.
    pub fn solve_in_place(&self, shapes: MatMut<'_, f64>, threads: usize) {
        let half = shapes.ncols().div_ceil(2);
        let (left, right) = shapes.split_at_col_mut(half);
        if threads == 1 || right.ncols() == 0 {
            self.solve_half(left);
            self.solve_half(right);
        } else {
            std::thread::scope(|scope| {
                scope.spawn(|| self.solve_half(left));
                self.solve_half(right);
            });
        }
    }

    fn solve_half(&self, shapes: MatMut<'_, f64>) {
        if shapes.ncols() == 0 {
            return;
        }
        let scratch = self.analysis.symbolic.solve_in_place_scratch::<f64>(shapes.ncols(), Par::Seq);
        let mut memory = MemBuffer::new(scratch);
        LltRef::new(&self.analysis.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            shapes,
            Par::Seq,
            MemStack::new(&mut memory),
        );
    }
}

fn zeros(length: usize, size: usize) -> Result<Vec<f64>, ModeError> {
    let mut values = Vec::new();
    values.try_reserve_exact(length).map_err(|_| ModeError::FactorTooLarge { size })?;
    values.resize(length, 0.0);
    Ok(values)
}
