//! One node in the elimination: square blocks of six, of which a node uses as many rows as it has unknowns.

#![allow(clippy::absurd_extreme_comparisons)] // of the constants in `six_times`

use nalgebra::RealField;

use crate::six::{Square, block_at, dot, multiply_add, scaled, six_times, subtract_scaled, zeros};

/// Calls a kernel with the number of columns of its left block as a constant.
macro_rules! by_columns {
    ($size:expr, $kernel:ident::<$rows:ident, $scalar:ident>($($argument:expr),*)) => {
        match $size {
            1 => $kernel::<$rows, 1, $scalar>($($argument),*),
            2 => $kernel::<$rows, 2, $scalar>($($argument),*),
            3 => $kernel::<$rows, 3, $scalar>($($argument),*),
            4 => $kernel::<$rows, 4, $scalar>($($argument),*),
            5 => $kernel::<$rows, 5, $scalar>($($argument),*),
            _ => $kernel::<$rows, LARGEST_NODE, $scalar>($($argument),*),
        }
    };
}

/// The largest node: six accelerations or six rows.
pub const LARGEST_NODE: usize = 6;

/// A node in the order of elimination.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    /// Number of unknowns.
    pub size: usize,
    /// The node: where its unknowns stand.
    pub node: usize,
    /// Its diagonal block; the blocks of its couplings follow in their order.
    pub diagonal: usize,
    /// First of its couplings.
    pub couplings: usize,
    /// Whether this is a rigid body that nothing has been taken out of: its mass matrix is diagonal then.
    pub is_diagonal: bool,
    /// First of its targets: one for each pair of couplings p >= q, in the order (0, 0), (1, 0), (1, 1), (2, 0), ...
    pub targets: usize,
}

/// A node that is eliminated later and coupled to a node that is eliminated now.
///
/// Their block has the rows of the one eliminated now and the columns of the later node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Coupling {
    /// Number of unknowns of the later node.
    pub size: usize,
    /// The later node.
    pub node: usize,
    /// Whether a rigid body whose mass matrix is diagonal is coupled to a joint that holds a point: the first three rows of
    /// their block have an entry in the column of the same number and no other.
    pub holds_point: bool,
}

/// A node, with the nodes that are coupled to it when its turn comes.
pub(super) struct Node<'a> {
    pub(super) step: &'a Step,
    pub(super) couplings: &'a [Coupling],
    /// The blocks of each pair of couplings.
    pub(super) targets: &'a [usize],
    /// Whether what couplings say of rows holds.
    pub(super) of_instant: bool,
}

impl Node<'_> {
    /// Factors the diagonal block and takes the node out of the later ones.
    pub(super) fn factor<const N: usize, T: RealField + Copy>(
        &self,
        blocks: &mut [Option<Square<T>>],
    ) -> Option<()> {
        let base = self.step.diagonal + 1 + self.couplings.len();
        let (panel, later) = blocks.split_at_mut_checked(base)?;
        let (diagonal, others) = panel.get_mut(self.step.diagonal..)?.split_first_mut()?;
        let diagonal = match diagonal {
            Some(diagonal) => diagonal,
            // the joint that a body stands on: it is coupled to nothing, and has nothing to find
            None if others.iter().all(Option::is_none) => return Some(()),
            None => diagonal.insert(zeros()),
        };
        let is_diagonal = self.is_diagonal::<N>();
        let inverse = match is_diagonal {
            true => invert_diagonal(diagonal)?,
            false => factor_diagonal::<N, T>(diagonal)?,
        };
        let mut rest_of_targets = self.targets;
        for (p, last) in self.couplings.iter().enumerate() {
            let (targets, after) = rest_of_targets.split_at_checked(p + 1)?;
            rest_of_targets = after;
            let (done, rest) = others.split_at_mut_checked(p)?;
            let Some(own) = rest.first_mut()? else { continue };
            let held = is_diagonal && self.of_instant && last.holds_point;
            // U = L⁻¹ A, of which D⁻¹ U stays
            let eliminated = match is_diagonal {
                true => scale_rows(own, &inverse),
                false => eliminate_rows::<N, T>(own, diagonal, &inverse),
            };
            for ((block, coupling), target) in done.iter().zip(self.couplings).zip(targets) {
                let Some(block) = block else { continue };
                let target = block_at(later, target.checked_sub(base)?)?;
                if held && coupling.holds_point {
                    subtract_held(target, block, &eliminated);
                } else {
                    by_columns!(coupling.size, subtract::<N, T>(target, block, &eliminated));
                }
            }
            let target = block_at(later, targets.last()?.checked_sub(base)?)?;
            if held {
                subtract_held(target, own, &eliminated);
            } else {
                by_columns!(last.size, subtract::<N, T>(target, own, &eliminated));
            }
        }
        Some(())
    }

    /// Whether the diagonal block is one of a rigid body that nothing was taken out of.
    #[inline(always)]
    fn is_diagonal<const N: usize>(&self) -> bool {
        N == LARGEST_NODE && self.step.is_diagonal
    }

    /// L x = b, this node's part.
    pub(super) fn solve_forwards<const N: usize, T: RealField + Copy>(
        &self,
        blocks: &[Option<Square<T>>],
        unknowns: &mut [[T; 6]],
    ) -> Option<()> {
        let (diagonal, others) = blocks.get(self.step.diagonal..)?.split_first()?;
        let diagonal = diagonal.as_ref()?;
        let place = unknowns.get_mut(self.step.node)?;
        let mut own = *place;
        let is_diagonal = self.is_diagonal::<N>();
        if !is_diagonal {
            six_times!(J: { if J < N {
                six_times!(I: { if I > J && I < N { own[I] = multiply_add(-diagonal[J][I], own[J], own[I]); } });
            } });
            *place = own;
        }
        for (coupling, block) in self.couplings.iter().zip(others) {
            let Some(block) = block else { continue };
            let later = unknowns.get_mut(coupling.node)?;
            let mut sum = *later;
            if is_diagonal && self.of_instant && coupling.holds_point {
                six_times!(I: { if I < 3 { sum[I] = multiply_add(-own[I], block[I][I], sum[I]); } });
                six_times!(I: { if I >= 3 { subtract_scaled(&mut sum, own[I], &block[I]); } });
            } else {
                six_times!(I: { if I < N { subtract_scaled(&mut sum, own[I], &block[I]); } });
            }
            *later = sum;
        }
        Some(())
    }

    /// D Lᵀ x = b, this node's part.
    pub(super) fn solve_backwards<const N: usize, T: RealField + Copy>(
        &self,
        blocks: &[Option<Square<T>>],
        unknowns: &mut [[T; 6]],
    ) -> Option<()> {
        let (diagonal, others) = blocks.get(self.step.diagonal..)?.split_first()?;
        let diagonal = diagonal.as_ref()?;
        let mut own = *unknowns.get(self.step.node)?;
        let is_diagonal = self.is_diagonal::<N>();
        six_times!(I: { if I < N { own[I] *= diagonal[I][I]; } });
        for (coupling, block) in self.couplings.iter().zip(others) {
            let Some(block) = block else { continue };
            let later = unknowns.get(coupling.node)?;
            if is_diagonal && self.of_instant && coupling.holds_point {
                six_times!(I: {
                    own[I] -= if I < 3 { block[I][I] * later[I] } else { dot(&block[I], later) };
                });
            } else {
                six_times!(I: { if I < N { own[I] -= dot(&block[I], later); } });
            }
        }
        if !is_diagonal {
            six_times!(K: { {
                const I: usize = 5 - K;
                if I < N {
                    six_times!(J: { if J < I { own[J] = multiply_add(-diagonal[J][I], own[I], own[J]); } });
                }
            } });
        }
        *unknowns.get_mut(self.step.node)? = own;
        Some(())
    }
}

// Each of the following works on blocks where they are, row by row: not inlined, because a compiler that sees several of them
// at once keeps entries of blocks in registers, shuffles them, and runs out of registers.

/// L D Lᵀ in place: Lᵀ above the diagonal, D⁻¹ on it; gives D⁻¹.
///
/// What stands below the diagonal is neither read nor kept.
#[inline(never)]
#[allow(clippy::needless_range_loop)] // entries above and left of each other
fn factor_diagonal<const N: usize, T: RealField + Copy>(block: &mut Square<T>) -> Option<[T; 6]> {
    let mut rows = *block;
    let (mut inverse, mut sound) = ([T::one(); 6], T::zero());
    for i in 0..N {
        let mut row = rows[i];
        for j in 0..i {
            subtract_scaled(&mut row, block[j][i], &rows[j]);
        }
        rows[i] = row;
        inverse[i] = T::one() / row[i];
        // one, unless a pivot is zero or not finite
        sound += row[i] * inverse[i];
        block[i] = scaled(inverse[i], &row);
        block[i][i] = inverse[i];
    }
    sound.is_finite().then_some(inverse)
}

/// [`factor_diagonal`] of a diagonal matrix, the rest of which is not touched.
#[inline(never)]
fn invert_diagonal<T: RealField + Copy>(block: &mut Square<T>) -> Option<[T; 6]> {
    let (mut inverse, mut sound) = ([T::one(); 6], T::zero());
    for (i, (row, inverse)) in block.iter_mut().zip(&mut inverse).enumerate() {
        *inverse = T::one() / row[i];
        sound += *inverse * row[i];
        row[i] = *inverse;
    }
    sound.is_finite().then_some(inverse)
}

/// Gives L⁻¹ times a block, and leaves D⁻¹ L⁻¹ times it.
#[inline(never)]
#[allow(clippy::needless_range_loop)] // entries above and left of each other
fn eliminate_rows<const N: usize, T: RealField + Copy>(
    block: &mut Square<T>,
    diagonal: &Square<T>,
    inverse: &[T; 6],
) -> Square<T> {
    let mut rows = *block;
    for i in 0..N {
        let mut row = rows[i];
        for j in 0..i {
            subtract_scaled(&mut row, diagonal[j][i], &rows[j]);
        }
        rows[i] = row;
        block[i] = scaled(inverse[i], &row);
    }
    rows
}

/// Gives a block, and leaves D⁻¹ times it.
#[inline(never)]
fn scale_rows<T: RealField + Copy>(block: &mut Square<T>, inverse: &[T; 6]) -> Square<T> {
    let rows = *block;
    for (row, inverse) in block.iter_mut().zip(inverse) {
        *row = scaled(*inverse, row);
    }
    rows
}

/// Subtracts the product of the first `R` columns of one block with another from a third.
#[inline(never)]
fn subtract<const N: usize, const R: usize, T: RealField + Copy>(
    target: &mut Square<T>,
    left: &Square<T>,
    right: &Square<T>,
) {
    for (k, row) in target.iter_mut().enumerate().take(R) {
        let mut sum = *row;
        for (left, right) in left.iter().zip(right).take(N) {
            subtract_scaled(&mut sum, left[k], right);
        }
        *row = sum;
    }
}

/// [`subtract`] where both blocks couple a rigid body with a joint that holds a point, see [`Coupling::holds_point`].
#[inline(never)]
#[allow(clippy::needless_range_loop)] // of constant length: this is unrolled, iterators here are not
fn subtract_held<T: RealField + Copy>(target: &mut Square<T>, left: &Square<T>, right: &Square<T>) {
    for k in 0..LARGEST_NODE {
        let mut row = target[k];
        for i in 3..LARGEST_NODE {
            subtract_scaled(&mut row, left[i][k], &right[i]);
        }
        target[k] = row;
    }
    for k in 0..3 {
        target[k][k] = multiply_add(-left[k][k], right[k][k], target[k][k]);
    }
}
