//! The product that the equations are made of.

use super::found::{Narrow, Widest};
use super::{Compiled, Registers, Scalar};

/// q_ν T_νμ in the components that need it, and the whirl, in groups of four lanes over μ.
///
/// The trace is not here: it is the product of Θ_ff, which is a matrix of its own, with q.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub struct Moments<T: Scalar, const G: usize> {
    /// q_ν T_νμ in yy, zz, xy + yx, xz + zx, yz + zy.
    pub even: [[[T; 4]; G]; 5],
    /// q_ν ϑ_νμ.
    pub odd: [[[T; 4]; G]; 3],
    /// 2 ω · q̇_ν ϑ_νμ.
    pub whirl: [[T; 4]; G],
}

impl<T: Scalar, const G: usize> Moments<T, G> {
    /// All zero.
    #[inline(always)]
    pub fn zero() -> Self {
        let zero = T::zero();
        Self { even: [[[zero; 4]; G]; 5], odd: [[[zero; 4]; G]; 3], whirl: [[zero; 4]; G] }
    }
}

/// The moments T_μν of a body, as a table that can be multiplied.
pub trait MomentTable<T: Scalar, const M: usize, const G: usize, R: Registers<T> = Compiled> {
    /// Writes the product with modal coordinates and rates in the place of zeros; `two_omega` is 2 ω.
    fn multiply(
        &self,
        registers: R,
        q: &[T; M],
        q_dot: &[T; M],
        two_omega: [T; 3],
        moments: &mut Moments<T, G>,
    );
}

/// A table that stands elsewhere.
impl<T: Scalar, const M: usize, const G: usize, R: Registers<T>, P: MomentTable<T, M, G, R>>
    MomentTable<T, M, G, R> for &P
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
        P::multiply(self, registers, q, q_dot, two_omega, moments);
    }
}

/// No moments at all: the fidelities `rigid` and `constant`.
impl<T: Scalar, const M: usize, const G: usize, R: Registers<T>> MomentTable<T, M, G, R> for () {
    #[inline(always)]
    fn multiply(
        &self,
        _registers: R,
        _q: &[T; M],
        _q_dot: &[T; M],
        _two_omega: [T; 3],
        _moments: &mut Moments<T, G>,
    ) {
    }
}

/// A table that can be multiplied in whatever registers are found when running.
pub trait PortableTable<T: Scalar, const M: usize, const G: usize>:
    MomentTable<T, M, G> + MomentTable<T, M, G, Narrow> + MomentTable<T, M, G, Widest>
where
    Narrow: Registers<T>,
    Widest: Registers<T>,
{
}

impl<T: Scalar, const M: usize, const G: usize, P> PortableTable<T, M, G> for P
where
    Narrow: Registers<T>,
    Widest: Registers<T>,
    P: MomentTable<T, M, G> + MomentTable<T, M, G, Narrow> + MomentTable<T, M, G, Widest>,
{
}
