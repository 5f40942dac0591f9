//! Vectors and symmetric matrices in space: xx, yy, zz, xy, xz, yz.

use super::{Registers, Scalar};

/// a × b
#[inline(always)]
pub(super) fn cross<T: Scalar, R: Registers<T>>(registers: R, a: [T; 3], b: [T; 3]) -> [T; 3] {
    [
        registers.multiply_add(a[1], b[2], -(a[2] * b[1])),
        registers.multiply_add(a[2], b[0], -(a[0] * b[2])),
        registers.multiply_add(a[0], b[1], -(a[1] * b[0])),
    ]
}

/// a · b
#[inline(always)]
pub(super) fn dot<T: Scalar, R: Registers<T>>(registers: R, a: [T; 3], b: [T; 3]) -> T {
    registers.multiply_add(a[0], b[0], registers.multiply_add(a[1], b[1], a[2] * b[2]))
}

/// start - a · b, from the first product to the last.
#[inline(always)]
pub(super) fn subtract_dot<T: Scalar, R: Registers<T>>(registers: R, start: T, a: [T; 3], b: [T; 3]) -> T {
    registers.multiply_add(
        -a[2],
        b[2],
        registers.multiply_add(-a[1], b[1], registers.multiply_add(-a[0], b[0], start)),
    )
}

/// S v
#[inline(always)]
pub(super) fn times<T: Scalar, R: Registers<T>>(
    registers: R,
    [xx, yy, zz, xy, xz, yz]: [T; 6],
    v: [T; 3],
) -> [T; 3] {
    [dot(registers, [xx, xy, xz], v), dot(registers, [xy, yy, yz], v), dot(registers, [xz, yz, zz], v)]
}

/// tr(S) I - S, where S has the off-diagonal entries `share` times T^{ij} + T^{ji}.
///
/// From the trace and yy, zz, xy + yx, xz + zx, yz + zy of T.
#[inline(always)]
pub(super) fn traced<T: Scalar>([trace, yy, zz, xy, xz, yz]: [T; 6], share: T) -> [T; 6] {
    [yy + zz, trace - yy, trace - zz, -share * xy, -share * xz, -share * yz]
}

#[inline(always)]
pub(super) fn add<T: Scalar, const K: usize>(a: [T; K], b: [T; K]) -> [T; K] {
    core::array::from_fn(|i| a[i] + b[i])
}

#[inline(always)]
pub(super) fn subtract<T: Scalar, const K: usize>(a: [T; K], b: [T; K]) -> [T; K] {
    core::array::from_fn(|i| a[i] - b[i])
}

#[cfg(test)]
mod tests {
    use super::super::Compiled;
    use super::*;

    #[test]
    fn products_have_their_usual_values() {
        assert_eq!(times(Compiled, [4.0, 5.0, 6.0, 0.5, -0.25, 1.0], [1.0, 2.0, 4.0]), [4.0, 14.5, 25.75]);
        assert_eq!(cross(Compiled, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]);
    }
}
