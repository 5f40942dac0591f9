//! One node in the elimination: dense blocks whose number of columns is a constant.

use nalgebra::RealField;

/// A node in the order of elimination.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    /// Number of unknowns.
    pub size: usize,
    /// Where its unknowns begin in a vector of all.
    pub unknowns: usize,
    /// Where its diagonal block begins among the values, row by row; the blocks of its couplings follow in their order.
    pub diagonal: usize,
    /// First of its couplings.
    pub couplings: usize,
    /// First of its targets: one for each pair of couplings p >= q, in the order (0, 0), (1, 0), (1, 1), (2, 0), ...
    pub targets: usize,
}

/// A node that is eliminated later and coupled to a node that is eliminated now.
///
/// Their block has the rows of the later node and the columns of the one eliminated now, row by row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Coupling {
    /// Number of unknowns of the later node.
    pub size: usize,
    /// Where the unknowns of the later node begin in a vector of all.
    pub unknowns: usize,
}

/// A node, with the nodes that are coupled to it when its turn comes.
pub(super) struct Node<'a> {
    pub(super) step: &'a Step,
    pub(super) couplings: &'a [Coupling],
    /// Where the blocks of each pair of couplings begin.
    pub(super) targets: &'a [usize],
}

impl Node<'_> {
    /// Number of rows of all couplings.
    fn rows(&self) -> usize {
        self.couplings.iter().map(|coupling| coupling.size).sum()
    }

    /// Factors the diagonal block and takes the node out of the later ones; gives the smallest relative pivot.
    pub(super) fn factor<const N: usize, T: RealField + Copy>(&self, values: &mut [T]) -> Option<T> {
        let size = N * (N + self.rows());
        let (panel, later) = values.get_mut(self.step.diagonal..)?.split_at_mut_checked(size)?;
        let (diagonal, rows) = panel.as_chunks_mut::<N>().0.split_first_chunk_mut::<N>()?;
        let (inverse, smallest) = factor_diagonal(diagonal)?;
        // U = A L⁻ᵀ
        for row in rows.iter_mut() {
            forwards(diagonal, row);
        }
        let mut targets = self.targets.iter();
        let mut rest: &[[T; N]] = rows;
        for (p, left) in self.couplings.iter().enumerate() {
            let (left_rows, others) = rest.split_at_checked(left.size)?;
            rest = others;
            let mut all: &[[T; N]] = rows;
            for right in self.couplings.iter().take(p + 1) {
                let (right_rows, others) = all.split_at_checked(right.size)?;
                all = others;
                let target = targets.next()?.checked_sub(self.step.diagonal + size)?;
                let target = later.get_mut(target..)?;
                match right.size {
                    1 => subtract::<N, 1, T>(left_rows, right_rows, &inverse, target),
                    2 => subtract::<N, 2, T>(left_rows, right_rows, &inverse, target),
                    3 => subtract::<N, 3, T>(left_rows, right_rows, &inverse, target),
                    4 => subtract::<N, 4, T>(left_rows, right_rows, &inverse, target),
                    5 => subtract::<N, 5, T>(left_rows, right_rows, &inverse, target),
                    6 => subtract::<N, 6, T>(left_rows, right_rows, &inverse, target),
                    _ => None,
                }?;
            }
        }
        for row in rows {
            for (entry, inverse) in row.iter_mut().zip(&inverse) {
                *entry *= *inverse;
            }
        }
        Some(smallest)
    }

    /// L x = b, this node's part.
    pub(super) fn solve_forwards<const N: usize, T: RealField + Copy>(
        &self,
        values: &[T],
        unknowns: &mut [T],
    ) -> Option<()> {
        let (diagonal, mut rows) =
            values.get(self.step.diagonal..)?.as_chunks::<N>().0.split_first_chunk::<N>()?;
        let place = unknowns.get_mut(self.step.unknowns..)?.first_chunk_mut::<N>()?;
        forwards(diagonal, place);
        let own = *place;
        for coupling in self.couplings {
            let (block, others) = rows.split_at_checked(coupling.size)?;
            rows = others;
            let later = unknowns.get_mut(coupling.unknowns..)?;
            for (entry, row) in later.iter_mut().zip(block) {
                *entry -= product(row, &own);
            }
        }
        Some(())
    }

    /// D Lᵀ x = b, this node's part.
    pub(super) fn solve_backwards<const N: usize, T: RealField + Copy>(
        &self,
        values: &[T],
        unknowns: &mut [T],
    ) -> Option<()> {
        let (diagonal, mut rows) =
            values.get(self.step.diagonal..)?.as_chunks::<N>().0.split_first_chunk::<N>()?;
        let mut own = *unknowns.get(self.step.unknowns..)?.first_chunk::<N>()?;
        for (k, (entry, row)) in own.iter_mut().zip(diagonal).enumerate() {
            if let Some(inverse) = row.get(k) {
                *entry *= *inverse;
            }
        }
        for coupling in self.couplings {
            let (block, others) = rows.split_at_checked(coupling.size)?;
            rows = others;
            let later = unknowns.get(coupling.unknowns..)?;
            for (known, row) in later.iter().zip(block) {
                for (entry, factor) in own.iter_mut().zip(row) {
                    *entry -= *factor * *known;
                }
            }
        }
        for (i, row) in diagonal.iter().enumerate().rev() {
            let known = own.get(i).copied().unwrap_or(T::zero());
            for (entry, factor) in own.iter_mut().zip(row).take(i) {
                *entry -= *factor * known;
            }
        }
        *unknowns.get_mut(self.step.unknowns..)?.first_chunk_mut::<N>()? = own;
        Some(())
    }

    /// Subtracts A x from `right`, this node's columns of a matrix that is not factored and the rows across from them.
    pub(super) fn subtract_product<const N: usize, T: RealField + Copy>(
        &self,
        matrix: &[T],
        unknowns: &[T],
        right: &mut [T],
    ) -> Option<()> {
        let (diagonal, mut rows) =
            matrix.get(self.step.diagonal..)?.as_chunks::<N>().0.split_first_chunk::<N>()?;
        let own = unknowns.get(self.step.unknowns..)?.first_chunk::<N>()?;
        let mut left = *right.get(self.step.unknowns..)?.first_chunk::<N>()?;
        for (entry, row) in left.iter_mut().zip(diagonal) {
            *entry -= product(row, own);
        }
        for coupling in self.couplings {
            let (block, others) = rows.split_at_checked(coupling.size)?;
            rows = others;
            let known = unknowns.get(coupling.unknowns..)?;
            let later = right.get_mut(coupling.unknowns..)?;
            for ((row, other), entry) in block.iter().zip(known).zip(later) {
                *entry -= product(row, own);
                for (entry, factor) in left.iter_mut().zip(row) {
                    *entry -= *factor * *other;
                }
            }
        }
        *right.get_mut(self.step.unknowns..)?.first_chunk_mut::<N>()? = left;
        Some(())
    }
}

/// L D Lᵀ in place: the unit triangle L below the diagonal, D⁻¹ on it. Gives D⁻¹ and the smallest relative pivot.
#[inline(always)]
fn factor_diagonal<const N: usize, T: RealField + Copy>(block: &mut [[T; N]; N]) -> Option<([T; N], T)> {
    let mut inverse = [T::one(); N];
    let mut smallest = T::one();
    let original: [T; N] = core::array::from_fn(|k| block[k][k]);
    for j in 0..N {
        let pivot = block[j][j];
        if pivot == T::zero() || !pivot.is_finite() {
            return None;
        }
        smallest = smallest.min((pivot / original[j]).abs());
        inverse[j] = T::one() / pivot;
        let column: [T; N] = core::array::from_fn(|i| block[i][j]);
        for i in j + 1..N {
            let factor = column[i] * inverse[j];
            for k in j + 1..=i {
                block[i][k] -= factor * column[k];
            }
            block[i][j] = factor;
        }
        block[j][j] = inverse[j];
    }
    Some((inverse, smallest))
}

/// L⁻¹ times a vector, in place.
#[inline(always)]
fn forwards<const N: usize, T: RealField + Copy>(lower: &[[T; N]; N], vector: &mut [T; N]) {
    for k in 0..N {
        let known = vector[k];
        for j in k + 1..N {
            vector[j] -= lower[j][k] * known;
        }
    }
}

/// Subtracts U_left D⁻¹ U_rightᵀ from a block, row by row.
#[inline(always)]
fn subtract<const N: usize, const R: usize, T: RealField + Copy>(
    left: &[[T; N]],
    right: &[[T; N]],
    inverse: &[T; N],
    block: &mut [T],
) -> Option<()> {
    let right = right.first_chunk::<R>()?;
    let weighted: [[T; R]; N] =
        core::array::from_fn(|k| core::array::from_fn(|column| right[column][k] * inverse[k]));
    for (row, place) in left.iter().zip(block.as_chunks_mut::<R>().0) {
        for (factor, weighted) in row.iter().zip(&weighted) {
            for (entry, weighted) in place.iter_mut().zip(weighted) {
                *entry -= *factor * *weighted;
            }
        }
    }
    Some(())
}

#[inline(always)]
fn product<const N: usize, T: RealField + Copy>(left: &[T; N], right: &[T; N]) -> T {
    left.iter().zip(right).fold(T::zero(), |sum, (left, right)| sum + *left * *right)
}
