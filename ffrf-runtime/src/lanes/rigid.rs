//! Vectors and symmetric matrices in space: xx, yy, zz, xy, xz, yz.

use super::Scalar;

/// a × b
#[inline(always)]
pub(super) fn cross<T: Scalar>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [
        a[1].multiply_add(b[2], -(a[2] * b[1])),
        a[2].multiply_add(b[0], -(a[0] * b[2])),
        a[0].multiply_add(b[1], -(a[1] * b[0])),
    ]
}

/// a · b
#[inline(always)]
pub(super) fn dot<T: Scalar>(a: [T; 3], b: [T; 3]) -> T {
    a[0].multiply_add(b[0], a[1].multiply_add(b[1], a[2] * b[2]))
}

/// S v
#[inline(always)]
pub(super) fn times<T: Scalar>([xx, yy, zz, xy, xz, yz]: [T; 6], v: [T; 3]) -> [T; 3] {
    [dot([xx, xy, xz], v), dot([xy, yy, yz], v), dot([xz, yz, zz], v)]
}

/// S⁻¹ by cofactors. S must be positive definite; otherwise the result is not finite.
#[inline(always)]
pub(super) fn inverse<T: Scalar>([xx, yy, zz, xy, xz, yz]: [T; 6]) -> [T; 6] {
    let c_xx = yy.multiply_add(zz, -(yz * yz));
    let c_xy = xz.multiply_add(yz, -(xy * zz));
    let c_xz = xy.multiply_add(yz, -(xz * yy));
    let factor = T::one() / dot([xx, xy, xz], [c_xx, c_xy, c_xz]);
    let c_yy = xx.multiply_add(zz, -(xz * xz));
    let c_zz = xx.multiply_add(yy, -(xy * xy));
    let c_yz = xy.multiply_add(xz, -(xx * yz));
    [c_xx, c_yy, c_zz, c_xy, c_xz, c_yz].map(|cofactor| cofactor * factor)
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
    use super::*;

    #[test]
    fn a_matrix_times_its_inverse_is_the_identity() {
        let matrix = [4.0, 5.0, 6.0, 0.5, -0.25, 1.0];
        let inverted = inverse(matrix);
        for axis in 0..3 {
            let unit: [f64; 3] = core::array::from_fn(|i| if i == axis { 1.0 } else { 0.0 });
            let back = times(matrix, times(inverted, unit));
            assert!(subtract(back, unit).iter().all(|x| x.abs() < 4.0 * f64::EPSILON), "{back:?}");
        }
        assert_eq!(cross([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]);
    }
}
