//! T_νμ = T_μνᵀ stored once and used twice.
//!
//! Blocks of W x W modes. A block below the diagonal acts on the columns' coordinates for its rows, and
//! transposed on the rows' coordinates for its columns. To do both without horizontal sums, a block is stored by
//! its wrapped diagonals: entry r of diagonal k belongs to row r and column (r + k) mod W. Then
//!
//! ```text
//! rows    += diagonal_k * rotate_k(columns' q)
//! partial_k += ± diagonal_k * rows' q,     columns += rotate_-k(partial_k) once, at the end of the column
//! ```
//!
//! with + for the even components (symmetric under μ <-> ν) and - for the odd ones (antisymmetric).

use super::groups::{constants, scaled};
use super::{Lanes, MomentTable, Moments, Registers, Scalar, Width};

/// Moments by blocks of `W` x `W` modes, for `H` rows of blocks; `TILES` = 8 H (H - 1) / 2.
///
/// Components: yy, zz, xy + yx, xz + zx, yz + zy, then ϑ_νμ (3); rows are μ, columns ν.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(64))]
pub struct HalfTable<C, const W: usize, const H: usize, const TILES: usize> {
    /// Diagonal blocks, whole: `[row of blocks][component][diagonal][lane]`.
    pub diagonal: [[[[C; W]; W]; 8]; H],
    /// One component of a block below the diagonal each, in the order of use: column by column of blocks; in a
    /// column the components in the groups (0, 1), (2, 3), (4), (5), (6), (7); in such a group row by row, then
    /// component by component.
    pub below: [[[C; W]; W]; TILES],
}

type Of<T, R, const W: usize> = <R as Width<T, W>>::Lanes;

/// What a block column knows while it is worked through.
struct Column<R, const W: usize> {
    /// Its coordinates, rotated by 0..W.
    q: [R; W],
    /// Its rates, rotated by 0..W.
    q_dot: [R; W],
}

#[inline(always)]
fn rotations<T: Copy, R: Lanes<T, W>, const W: usize>(lanes: R) -> [R; W] {
    core::array::from_fn(|by| lanes.rotate(by))
}

/// Σ_k rotate_-k(partial_k), pairwise.
#[inline(always)]
fn collect<T: Copy, R: Lanes<T, W>, const W: usize>(partial: &[R; W]) -> R {
    let mut terms: [R; W] = core::array::from_fn(|k| partial[k].rotate(W - k));
    let mut count = W;
    while count > 1 {
        count /= 2;
        for k in 0..count {
            terms[k] = terms[2 * k] + terms[2 * k + 1];
        }
    }
    terms[0]
}

/// `N` even components of one block column; `below` runs through the tiles.
#[inline(always)]
fn even<'a, T: Scalar, R: Width<T, W>, const W: usize, const H: usize, const G: usize, const N: usize>(
    registers: R,
    column: usize,
    coordinates: &[Of<T, R, W>; H],
    known: &Column<Of<T, R, W>, W>,
    diagonal: &[[[T::Constant; W]; W]],
    below: &mut core::slice::Iter<'a, [[T::Constant; W]; W]>,
    moments: &mut [[[T; 4]; G]],
) {
    let zero = registers.splat(T::zero());
    let mut partial = [[zero; W]; N];
    for row in column + 1..H {
        let q = coordinates[row];
        for (moments, partial) in moments.iter_mut().zip(&mut partial) {
            let Some(tile) = below.next() else { return };
            let Some(place) = blocks_of::<T, W>(moments).get_mut(row) else { return };
            let mut sum = Width::<T, W>::load(registers, place);
            for k in 0..W {
                let moment = constants::<T, R, W>(registers, &tile[k]);
                sum = moment.multiply_add(known.q[k], sum);
                partial[k] = moment.multiply_add(q, partial[k]);
            }
            *place = sum.store();
        }
    }
    for ((moments, partial), diagonal) in moments.iter_mut().zip(&partial).zip(diagonal) {
        let Some(place) = blocks_of::<T, W>(moments).get_mut(column) else { return };
        let mut sum = Width::<T, W>::load(registers, place);
        for k in 0..W {
            sum = constants::<T, R, W>(registers, &diagonal[k]).multiply_add(known.q[k], sum);
        }
        *place = (sum + collect(partial)).store();
    }
}

/// One odd component of one block column, and its part of the whirl; `twice` is 2 ω of that axis.
#[inline(always)]
#[allow(clippy::too_many_arguments)] // the state of one loop nest, written once
fn odd<'a, T: Scalar, R: Width<T, W>, const W: usize, const H: usize>(
    registers: R,
    column: usize,
    [coordinates, rates]: [&[Of<T, R, W>; H]; 2],
    known: &Column<Of<T, R, W>, W>,
    twice: Of<T, R, W>,
    diagonal: &[[T::Constant; W]; W],
    below: &mut core::slice::Iter<'a, [[T::Constant; W]; W]>,
    moments: &mut [[T; 4]],
    whirl: &mut [[T; 4]],
    whirl_partial: &mut [Of<T, R, W>; W],
) {
    let (moments, whirl) = (blocks_of::<T, W>(moments), blocks_of::<T, W>(whirl));
    let mut partial = [registers.splat(T::zero()); W];
    let turned = scaled(twice, known.q_dot);
    for row in column + 1..H {
        let (q, rate) = (coordinates[row], rates[row] * twice);
        let Some(tile) = below.next() else { return };
        let (Some(moments), Some(whirl)) = (moments.get_mut(row), whirl.get_mut(row)) else { return };
        let (mut sum, mut turn) =
            (Width::<T, W>::load(registers, moments), Width::<T, W>::load(registers, whirl));
        for k in 0..W {
            let moment = constants::<T, R, W>(registers, &tile[k]);
            sum = moment.multiply_add(known.q[k], sum);
            turn = moment.multiply_add(turned[k], turn);
            partial[k] = moment.subtract_from(q, partial[k]);
            whirl_partial[k] = moment.subtract_from(rate, whirl_partial[k]);
        }
        (*moments, *whirl) = (sum.store(), turn.store());
    }
    // Diagonal 0 of a diagonal block is ϑ_μμ = 0.
    let (Some(moments), Some(whirl)) = (moments.get_mut(column), whirl.get_mut(column)) else { return };
    let (mut sum, mut turn) =
        (Width::<T, W>::load(registers, moments), Width::<T, W>::load(registers, whirl));
    for k in 1..W {
        let moment = constants::<T, R, W>(registers, &diagonal[k]);
        sum = moment.multiply_add(known.q[k], sum);
        turn = moment.multiply_add(turned[k], turn);
    }
    (*moments, *whirl) = ((sum + collect(&partial)).store(), turn.store());
}

/// Groups of four numbers as blocks of `W`.
#[inline(always)]
fn blocks_of<T, const W: usize>(groups: &mut [[T; 4]]) -> &mut [[T; W]] {
    groups.as_flattened_mut().as_chunks_mut::<W>().0
}

impl<T, R, const M: usize, const G: usize, const W: usize, const H: usize, const TILES: usize>
    MomentTable<T, M, G, R> for HalfTable<T::Constant, W, H, TILES>
where
    T: Scalar,
    R: Registers<T> + Width<T, W>,
{
    #[inline(always)]
    fn multiply(
        &self,
        registers: R,
        q: &[T; M],
        q_dot: &[T; M],
        two_omega: [T; 3],
        moments: &mut Moments<T, G>,
    ) {
        const { assert!(TILES == 4 * H * (H - 1) && 4 * G == W * H && W * H >= M) };
        let (coordinates, rates) =
            (blocks::<T, R, M, W, H>(registers, q), blocks::<T, R, M, W, H>(registers, q_dot));
        let two_omega = two_omega.map(|number| Width::<T, W>::splat(registers, number));
        let Moments { even: evens, odd: odds, whirl } = moments;
        let mut below = self.below.iter();
        for column in 0..H {
            let known = Column { q: rotations(coordinates[column]), q_dot: rotations(rates[column]) };
            let diagonal = &self.diagonal[column];
            let below = &mut below;
            even::<T, R, W, H, G, 2>(
                registers,
                column,
                &coordinates,
                &known,
                &diagonal[..2],
                below,
                &mut evens[..2],
            );
            even::<T, R, W, H, G, 2>(
                registers,
                column,
                &coordinates,
                &known,
                &diagonal[2..4],
                below,
                &mut evens[2..4],
            );
            even::<T, R, W, H, G, 1>(
                registers,
                column,
                &coordinates,
                &known,
                &diagonal[4..5],
                below,
                &mut evens[4..],
            );
            let mut partial = [Width::<T, W>::splat(registers, T::zero()); W];
            for axis in 0..3 {
                odd::<T, R, W, H>(
                    registers,
                    column,
                    [&coordinates, &rates],
                    &known,
                    two_omega[axis],
                    &diagonal[5 + axis],
                    below,
                    &mut odds[axis],
                    whirl,
                    &mut partial,
                );
            }
            if let Some(place) = blocks_of::<T, W>(whirl).get_mut(column) {
                *place = (Width::<T, W>::load(registers, place) + collect(&partial)).store();
            }
        }
    }
}

/// The numbers in blocks of `W`, padded with zero.
#[inline(always)]
fn blocks<T: Scalar, R: Width<T, W>, const M: usize, const W: usize, const H: usize>(
    registers: R,
    numbers: &[T; M],
) -> [Of<T, R, W>; H] {
    let mut padded = [[T::zero(); W]; H];
    for (place, number) in padded.as_flattened_mut().iter_mut().zip(numbers) {
        *place = *number;
    }
    padded.map(|block| registers.load(&block))
}
