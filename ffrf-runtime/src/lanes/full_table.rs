//! Every T_μν stored: groups of eight lanes, and one of four if their number is odd.

use super::groups::constants;
use super::{Lanes, MomentTable, Moments, Registers, Scalar, Width};

/// T_νμ at `[group][nu][component][lane]`, lanes over μ.
///
/// Components: yy, zz, xy + yx, xz + zx, yz + zy, then ϑ_νμ (3). The number of groups of four is
/// `2 PAIRS + SINGLE`.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(64))]
pub struct FullTable<C, const M: usize, const PAIRS: usize, const SINGLE: usize> {
    /// Groups of eight modes.
    pub eights: [[[[C; 8]; 8]; M]; PAIRS],
    /// The last group of four modes, if there is one.
    pub fours: [[[[C; 4]; 8]; M]; SINGLE],
}

/// The sums of one group: eight components with q, the last three with q̇.
#[inline(always)]
fn group<T: Scalar, R: Width<T, W>, const W: usize, const M: usize>(
    registers: R,
    moments: impl Fn(usize, usize) -> [T::Constant; W],
    q: &[T; M],
    q_dot: &[T; M],
    two_omega: [T; 3],
) -> ([R::Lanes; 8], R::Lanes) {
    let zero = registers.splat(T::zero());
    let mut deformed = [zero; 8];
    let mut whirl = [zero; 3];
    for (nu, (q, q_dot)) in q.iter().zip(q_dot).enumerate() {
        let (q, q_dot) = (registers.splat(*q), registers.splat(*q_dot));
        for component in 0..8 {
            let moment = constants::<T, R, W>(registers, &moments(nu, component));
            deformed[component] = moment.multiply_add(q, deformed[component]);
            if component >= 5 {
                whirl[component - 5] = moment.multiply_add(q_dot, whirl[component - 5]);
            }
        }
    }
    let [x, y, z] = two_omega.map(|number| registers.splat(number));
    (deformed, whirl[0].multiply_add(x, whirl[1].multiply_add(y, whirl[2] * z)))
}

impl<T, R, const M: usize, const G: usize, const PAIRS: usize, const SINGLE: usize> MomentTable<T, M, G, R>
    for FullTable<T::Constant, M, PAIRS, SINGLE>
where
    T: Scalar,
    R: Registers<T>,
{
    /// Of one or two groups the product is kept once for all kernels: that takes as long and makes their code smaller.
    /// Of more groups it is a loop in the place of each call, which is faster.
    #[inline(always)]
    fn multiply(
        &self,
        registers: R,
        q: &[T; M],
        q_dot: &[T; M],
        two_omega: [T; 3],
        moments: &mut Moments<T, G>,
    ) {
        const { assert!(G == 2 * PAIRS + SINGLE && SINGLE <= 1 && 4 * G >= M) };
        if const { G <= 2 && R::IS_COMPILED_FOR } {
            *moments = shared_product(registers, self, q, q_dot, two_omega);
        } else {
            product(registers, self, q, q_dot, two_omega, moments);
        }
    }
}

#[inline(never)]
fn shared_product<
    T: Scalar,
    R: Registers<T>,
    const M: usize,
    const G: usize,
    const PAIRS: usize,
    const SINGLE: usize,
>(
    registers: R,
    table: &FullTable<T::Constant, M, PAIRS, SINGLE>,
    q: &[T; M],
    q_dot: &[T; M],
    two_omega: [T; 3],
) -> Moments<T, G> {
    let mut moments = Moments::zero();
    product(registers, table, q, q_dot, two_omega, &mut moments);
    moments
}

#[inline(always)]
fn product<
    T: Scalar,
    R: Registers<T>,
    const M: usize,
    const G: usize,
    const PAIRS: usize,
    const SINGLE: usize,
>(
    registers: R,
    table: &FullTable<T::Constant, M, PAIRS, SINGLE>,
    q: &[T; M],
    q_dot: &[T; M],
    two_omega: [T; 3],
    moments: &mut Moments<T, G>,
) {
    for (pair, table) in table.eights.iter().enumerate() {
        if R::HAS_ROOM_FOR_EIGHTS {
            let entries = |nu: usize, component: usize| table[nu][component];
            let (deformed, whirl) = group::<T, R, 8, M>(registers, entries, q, q_dot, two_omega);
            put(moments, 2 * pair, deformed.map(Lanes::store), whirl.store());
            continue;
        }
        // Two calls, not a loop of two: so the compiler sees that all places are written.
        let low = |nu: usize, component: usize| {
            let [a, b, c, d, ..] = table[nu][component];
            [a, b, c, d]
        };
        let (deformed, whirl) = group::<T, R, 4, M>(registers, low, q, q_dot, two_omega);
        put(moments, 2 * pair, deformed.map(Lanes::store), whirl.store());
        let high = |nu: usize, component: usize| {
            let [.., e, f, g, h] = table[nu][component];
            [e, f, g, h]
        };
        let (deformed, whirl) = group::<T, R, 4, M>(registers, high, q, q_dot, two_omega);
        put(moments, 2 * pair + 1, deformed.map(Lanes::store), whirl.store());
    }
    for table in &table.fours {
        let (deformed, whirl) =
            group::<T, R, 4, M>(registers, |nu, component| table[nu][component], q, q_dot, two_omega);
        put(moments, 2 * PAIRS, deformed.map(Lanes::store), whirl.store());
    }
}

/// Writes `W` lanes from group `start` on.
#[inline(always)]
fn put<T: Scalar, const W: usize, const G: usize>(
    moments: &mut Moments<T, G>,
    start: usize,
    deformed: [[T; W]; 8],
    whirl: [T; W],
) {
    let place = |row: &mut [[T; 4]; G], numbers: &[T; W]| {
        let (groups, _) = numbers.as_chunks::<4>();
        for (offset, group) in groups.iter().enumerate() {
            row[start + offset] = *group;
        }
    };
    for component in 0..5 {
        place(&mut moments.even[component], &deformed[component]);
    }
    for axis in 0..3 {
        place(&mut moments.odd[axis], &deformed[5 + axis]);
    }
    place(&mut moments.whirl, &whirl);
}
