//! Every T_μν stored: groups of eight lanes, and one of four if their number is odd.

use super::scalar::{Register, grouped};
use super::{HasLanes, Lanes, MomentTable, Moments, Scalar};

/// T_νμ at `[group][nu][component][lane]`, lanes over μ.
///
/// Components: yy, zz, xy + yx, xz + zx, yz + zy, then ϑ_νμ (3). The number of groups of four is
/// `2 PAIRS + SINGLE`.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(64))]
pub struct FullTable<T, const M: usize, const PAIRS: usize, const SINGLE: usize> {
    /// Groups of eight modes.
    pub eights: [[[[T; 8]; 8]; M]; PAIRS],
    /// The last group of four modes, if there is one.
    pub fours: [[[[T; 4]; 8]; M]; SINGLE],
}

/// The sums of one group: eight components with q, the last three with q̇.
#[inline(always)]
fn group<T: Scalar, R: Lanes<T, W>, const W: usize, const M: usize>(
    table: &[[[T; W]; 8]; M],
    q: &[T; M],
    q_dot: &[T; M],
    two_omega: [T; 3],
) -> ([R; 8], R) {
    let mut deformed = [R::ZERO; 8];
    let mut whirl = [R::ZERO; 3];
    for ((moments, q), q_dot) in table.iter().zip(q).zip(q_dot) {
        let (q, q_dot) = (R::splat(*q), R::splat(*q_dot));
        for component in 0..8 {
            let moment = R::load(&moments[component]);
            deformed[component] = moment.multiply_add(q, deformed[component]);
            if component >= 5 {
                whirl[component - 5] = moment.multiply_add(q_dot, whirl[component - 5]);
            }
        }
    }
    let [x, y, z] = two_omega.map(R::splat);
    (deformed, whirl[0].multiply_add(x, whirl[1].multiply_add(y, whirl[2] * z)))
}

impl<T: Scalar, const M: usize, const G: usize, const PAIRS: usize, const SINGLE: usize> MomentTable<T, M, G>
    for FullTable<T, M, PAIRS, SINGLE>
{
    #[inline(always)]
    fn times(&self, q: &[T; M], q_dot: &[T; M], two_omega: [T; 3]) -> Moments<T, G> {
        const { assert!(G == 2 * PAIRS + SINGLE && SINGLE <= 1 && 4 * G >= M) };
        let mut moments = Moments::ZERO;
        for pair in 0..PAIRS {
            let (deformed, whirl) =
                group::<T, <T as HasLanes<8>>::Lanes, 8, M>(&self.eights[pair], q, q_dot, two_omega);
            let halves = |lanes: <T as HasLanes<8>>::Lanes| -> [Register<T>; 2] { grouped(&lanes.store()) };
            for component in 0..5 {
                let halves = halves(deformed[component]);
                moments.even[component][2 * pair..2 * pair + 2].copy_from_slice(&halves);
            }
            for axis in 0..3 {
                let halves = halves(deformed[5 + axis]);
                moments.odd[axis][2 * pair..2 * pair + 2].copy_from_slice(&halves);
            }
            moments.whirl[2 * pair..2 * pair + 2].copy_from_slice(&halves(whirl));
        }
        for table in &self.fours {
            let (deformed, whirl) = group::<T, Register<T>, 4, M>(table, q, q_dot, two_omega);
            for component in 0..5 {
                moments.even[component][G - 1] = deformed[component];
            }
            for axis in 0..3 {
                moments.odd[axis][G - 1] = deformed[5 + axis];
            }
            moments.whirl[G - 1] = whirl;
        }
        moments
    }
}
