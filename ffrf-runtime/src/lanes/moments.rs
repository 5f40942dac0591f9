//! The product that the equations are made of.

use super::Lanes;
use super::Scalar;
use super::scalar::Register;

/// q_ν T_νμ in the components that need it, and the whirl, in lanes over μ.
///
/// The trace is not here: with a diagonal Θ_ff it is known without a product.
#[derive(Clone, Copy)]
pub struct Moments<T: Scalar, const G: usize> {
    /// q_ν T_νμ in yy, zz, xy + yx, xz + zx, yz + zy.
    pub even: [[Register<T>; G]; 5],
    /// q_ν ϑ_νμ.
    pub odd: [[Register<T>; G]; 3],
    /// 2 ω · q̇_ν ϑ_νμ.
    pub whirl: [Register<T>; G],
}

impl<T: Scalar, const G: usize> Moments<T, G> {
    /// All zero.
    pub const ZERO: Self = Self {
        even: [[Register::<T>::ZERO; G]; 5],
        odd: [[Register::<T>::ZERO; G]; 3],
        whirl: [Register::<T>::ZERO; G],
    };
}

/// The moments T_μν of a body, as a table that can be multiplied.
pub trait MomentTable<T: Scalar, const M: usize, const G: usize> {
    /// The product with modal coordinates and rates; `two_omega` is 2 ω.
    fn times(&self, q: &[T; M], q_dot: &[T; M], two_omega: [T; 3]) -> Moments<T, G>;
}

/// No moments at all: the fidelities `rigid` and `constant`.
impl<T: Scalar, const M: usize, const G: usize> MomentTable<T, M, G> for () {
    #[inline(always)]
    fn times(&self, _q: &[T; M], _q_dot: &[T; M], _two_omega: [T; 3]) -> Moments<T, G> {
        Moments::ZERO
    }
}
