//! The 3 x 3 moments in the structures that a layout declares, in the components that the equations use.

use super::Scalar;

/// A moment T^{ij} in nine components.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MomentComponents<C> {
    /// Trace, yy, zz, xy + yx, xz + zx, yz + zy.
    pub even: [C; 6],
    /// yz - zy, zx - xz, xy - yx.
    pub odd: [C; 3],
}

/// How a moment is given.
pub trait MomentStructure<C> {
    /// What is given.
    type Entry: Copy;
    /// Its components.
    fn components(entry: &Self::Entry) -> MomentComponents<C>;
}

/// All nine entries.
pub struct Dense;
/// Nine entries, of which the upper triangle is read.
pub struct Symmetric;
/// Nine entries, of which the upper triangle is read.
pub struct Antisymmetric;
/// The diagonal.
pub struct Diagonal3;

impl<C: Scalar> MomentStructure<C> for Dense {
    type Entry = [[C; 3]; 3];

    #[inline(always)]
    fn components([[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]]: &Self::Entry) -> MomentComponents<C> {
        MomentComponents {
            even: [*xx + *yy + *zz, *yy, *zz, *xy + *yx, *xz + *zx, *yz + *zy],
            odd: [*yz - *zy, *zx - *xz, *xy - *yx],
        }
    }
}

impl<C: Scalar> MomentStructure<C> for Symmetric {
    type Entry = [[C; 3]; 3];

    #[inline(always)]
    fn components([[xx, xy, xz], [_, yy, yz], [_, _, zz]]: &Self::Entry) -> MomentComponents<C> {
        let two = C::two();
        MomentComponents {
            even: [*xx + *yy + *zz, *yy, *zz, two * *xy, two * *xz, two * *yz],
            odd: [C::zero(); 3],
        }
    }
}

impl<C: Scalar> MomentStructure<C> for Antisymmetric {
    type Entry = [[C; 3]; 3];

    #[inline(always)]
    fn components([[_, xy, xz], [_, _, yz], _]: &Self::Entry) -> MomentComponents<C> {
        let two = C::two();
        MomentComponents { even: [C::zero(); 6], odd: [two * *yz, -(two * *xz), two * *xy] }
    }
}

impl<C: Scalar> MomentStructure<C> for Diagonal3 {
    type Entry = [C; 3];

    #[inline(always)]
    fn components([xx, yy, zz]: &Self::Entry) -> MomentComponents<C> {
        let zero = C::zero();
        MomentComponents { even: [*xx + *yy + *zz, *yy, *zz, zero, zero, zero], odd: [zero; 3] }
    }
}
