//! One node in the elimination: square blocks of six, of which a node uses as many rows as it has unknowns.

#![allow(clippy::absurd_extreme_comparisons)] // of the constants in `six_times`

use nalgebra::RealField;

use crate::six::{Square, dot, multiply_add, scaled, six_times, subtract_scaled};

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
}

/// A node, with the nodes that are coupled to it when its turn comes.
pub(super) struct Node<'a> {
    pub(super) step: &'a Step,
    pub(super) couplings: &'a [Coupling],
    /// The blocks of each pair of couplings.
    pub(super) targets: &'a [usize],
}

impl Node<'_> {
    /// Factors the diagonal block and takes the node out of the later ones.
    pub(super) fn factor<const N: usize, T: RealField + Copy>(&self, blocks: &mut [Square<T>]) -> Option<()> {
        let base = self.step.diagonal + 1 + self.couplings.len();
        let (panel, later) = blocks.split_at_mut_checked(base)?;
        let (diagonal, others) = panel.get_mut(self.step.diagonal..)?.split_first_mut()?;
        let inverse = match self.step.is_diagonal {
            true => invert_diagonal::<N, T>(diagonal)?,
            false => factor_diagonal::<N, T>(diagonal)?,
        };
        let mut targets = self.targets.iter();
        for (p, last) in self.couplings.iter().enumerate() {
            let (done, rest) = others.split_at_mut_checked(p)?;
            let own = rest.first_mut()?;
            // U = L⁻¹ A, of which D⁻¹ U stays
            let eliminated = match self.step.is_diagonal {
                true => *own,
                false => eliminated::<N, T>(diagonal, own),
            };
            six_times!(I: { if I < N { own[I] = scaled(inverse[I], &eliminated[I]); } });
            for (block, coupling) in done.iter().zip(self.couplings) {
                let target = later.get_mut(targets.next()?.checked_sub(base)?)?;
                match coupling.size {
                    1 => subtract::<N, 1, false, T>(target, block, &eliminated),
                    2 => subtract::<N, 2, false, T>(target, block, &eliminated),
                    3 => subtract::<N, 3, false, T>(target, block, &eliminated),
                    4 => subtract::<N, 4, false, T>(target, block, &eliminated),
                    5 => subtract::<N, 5, false, T>(target, block, &eliminated),
                    _ => subtract::<N, 6, false, T>(target, block, &eliminated),
                }
            }
            let target = later.get_mut(targets.next()?.checked_sub(base)?)?;
            match last.size {
                1 => subtract::<N, 1, true, T>(target, own, &eliminated),
                2 => subtract::<N, 2, true, T>(target, own, &eliminated),
                3 => subtract::<N, 3, true, T>(target, own, &eliminated),
                4 => subtract::<N, 4, true, T>(target, own, &eliminated),
                5 => subtract::<N, 5, true, T>(target, own, &eliminated),
                _ => subtract::<N, 6, true, T>(target, own, &eliminated),
            }
        }
        Some(())
    }

    /// L x = b, this node's part.
    pub(super) fn solve_forwards<const N: usize, T: RealField + Copy>(
        &self,
        blocks: &[Square<T>],
        unknowns: &mut [[T; 6]],
    ) -> Option<()> {
        let (diagonal, others) = blocks.get(self.step.diagonal..)?.split_first()?;
        let place = unknowns.get_mut(self.step.node)?;
        let mut own = *place;
        if !self.step.is_diagonal {
            six_times!(J: { if J < N {
                six_times!(I: { if I > J && I < N { own[I] = multiply_add(-diagonal[J][I], own[J], own[I]); } });
            } });
            *place = own;
        }
        for (coupling, block) in self.couplings.iter().zip(others) {
            let later = unknowns.get_mut(coupling.node)?;
            let mut sum = *later;
            six_times!(I: { if I < N { subtract_scaled(&mut sum, own[I], &block[I]); } });
            *later = sum;
        }
        Some(())
    }

    /// D Lᵀ x = b, this node's part.
    pub(super) fn solve_backwards<const N: usize, T: RealField + Copy>(
        &self,
        blocks: &[Square<T>],
        unknowns: &mut [[T; 6]],
    ) -> Option<()> {
        let (diagonal, others) = blocks.get(self.step.diagonal..)?.split_first()?;
        let mut own = *unknowns.get(self.step.node)?;
        six_times!(I: { if I < N { own[I] *= diagonal[I][I]; } });
        for (coupling, block) in self.couplings.iter().zip(others) {
            let later = unknowns.get(coupling.node)?;
            six_times!(I: { if I < N { own[I] -= dot(&block[I], later); } });
        }
        if !self.step.is_diagonal {
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

/// L D Lᵀ in place: Lᵀ above the diagonal, D⁻¹ on it; gives D⁻¹.
///
/// Reads and writes the upper triangle; below it stands nothing.
#[inline(always)]
fn factor_diagonal<const N: usize, T: RealField + Copy>(block: &mut Square<T>) -> Option<[T; 6]> {
    let mut rows = *block;
    let [mut inverse, mut pivots] = [[T::one(); 6]; 2];
    six_times!(J: { if J < N {
        let row = rows[J];
        pivots[J] = row[J];
        inverse[J] = T::one() / row[J];
        let mut upper = scaled(inverse[J], &row);
        six_times!(I: { if I > J && I < N { subtract_scaled(&mut rows[I], upper[I], &row); } });
        upper[J] = inverse[J];
        block[J] = upper;
    } });
    let mut sound = T::zero();
    six_times!(J: { if J < N {
        // one, unless a pivot is zero or not finite
        sound += pivots[J] * inverse[J];
    } });
    sound.is_finite().then_some(inverse)
}

/// [`factor_diagonal`] of a diagonal matrix, the rest of which is not touched.
#[inline(always)]
fn invert_diagonal<const N: usize, T: RealField + Copy>(block: &mut Square<T>) -> Option<[T; 6]> {
    let (mut inverse, mut sound) = ([T::one(); 6], T::zero());
    six_times!(J: { if J < N {
        inverse[J] = T::one() / block[J][J];
        sound += inverse[J] * block[J][J];
        block[J][J] = inverse[J];
    } });
    sound.is_finite().then_some(inverse)
}

/// L⁻¹ times a block.
#[inline(always)]
fn eliminated<const N: usize, T: RealField + Copy>(diagonal: &Square<T>, block: &Square<T>) -> Square<T> {
    let mut rows = *block;
    six_times!(J: { if J < N {
        let row = rows[J];
        six_times!(I: { if I > J && I < N { subtract_scaled(&mut rows[I], diagonal[J][I], &row); } });
    } });
    rows
}

/// Subtracts the product of the first `R` columns of one block with another from a third; of a symmetric one the upper
/// triangle is enough.
#[inline(always)]
fn subtract<const N: usize, const R: usize, const SYMMETRIC: bool, T: RealField + Copy>(
    target: &mut Square<T>,
    left: &Square<T>,
    right: &Square<T>,
) {
    six_times!(K: { if K < R {
        let mut row = target[K];
        six_times!(I: { if I < N {
            let factor = -left[I][K];
            // pairs stay together
            six_times!(L: { if !SYMMETRIC || L >= K / 2 * 2 { row[L] = multiply_add(factor, right[I][L], row[L]); } });
        } });
        target[K] = row;
    } });
}
