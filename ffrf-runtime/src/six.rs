//! Arrays of six numbers, the width of everything in the equations of a mechanism: six accelerations of a frame, six rows of
//! a joint at most. Loops of constant length over contiguous numbers, which compilers put into vector registers.

use nalgebra::{RealField, Vector3};

/// The same statements with a constant that is 0 to 5: straight-line code, in which what is not needed is left out when
/// compiling. Loops whose bounds depend on each other are not always unrolled.
macro_rules! six_times {
    ($index:ident: $statements:block) => {{
        {
            const $index: usize = 0;
            $statements
        }
        {
            const $index: usize = 1;
            $statements
        }
        {
            const $index: usize = 2;
            $statements
        }
        {
            const $index: usize = 3;
            $statements
        }
        {
            const $index: usize = 4;
            $statements
        }
        {
            const $index: usize = 5;
            $statements
        }
    }};
}
pub(crate) use six_times;

/// a b + c, fused where the target does that in hardware.
///
/// See [`fused_multiply_add`](crate::math::fused_multiply_add) for when.
#[inline(always)]
pub(crate) fn multiply_add<T: RealField + Copy>(a: T, b: T, c: T) -> T {
    if cfg!(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64"))) {
        a.mul_add(b, c)
    } else {
        a * b + c
    }
}

/// Six rows of six numbers.
pub(crate) type Square<T> = [[T; 6]; 6];

/// Six rows of zeros.
#[inline(always)]
pub(crate) fn zeros<T: RealField + Copy>() -> Square<T> {
    [[T::zero(); 6]; 6]
}

/// `factor * numbers`
#[inline(always)]
pub(crate) fn scaled<T: RealField + Copy>(factor: T, [a, b, c, d, e, f]: &[T; 6]) -> [T; 6] {
    [factor * *a, factor * *b, factor * *c, factor * *d, factor * *e, factor * *f]
}

/// Adds `factor * numbers`.
#[inline(always)]
pub(crate) fn add_scaled<T: RealField + Copy>(sum: &mut [T; 6], factor: T, numbers: &[T; 6]) {
    six_times!(K: { sum[K] = multiply_add(factor, numbers[K], sum[K]); });
}

/// Subtracts `factor * numbers`.
#[inline(always)]
pub(crate) fn subtract_scaled<T: RealField + Copy>(sum: &mut [T; 6], factor: T, numbers: &[T; 6]) {
    add_scaled(sum, -factor, numbers);
}

/// Adds numbers.
#[inline(always)]
pub(crate) fn add<T: RealField + Copy>(sum: &mut [T; 6], numbers: &[T; 6]) {
    six_times!(K: { sum[K] += numbers[K]; });
}

/// Adds the products entry by entry.
#[inline(always)]
pub(crate) fn add_products<T: RealField + Copy>(sum: &mut [T; 6], left: &[T; 6], right: &[T; 6]) {
    six_times!(K: { sum[K] = multiply_add(left[K], right[K], sum[K]); });
}

/// The products entry by entry.
#[inline(always)]
pub(crate) fn products<T: RealField + Copy>(left: &[T; 6], right: &[T; 6]) -> [T; 6] {
    let mut products = *left;
    six_times!(K: { products[K] *= right[K]; });
    products
}

/// Scalar product.
#[inline(always)]
pub(crate) fn dot<T: RealField + Copy>(left: &[T; 6], right: &[T; 6]) -> T {
    sum(&products(left, right))
}

/// The sum, in two halves that do not wait for each other.
#[inline(always)]
pub(crate) fn sum<T: RealField + Copy>([a, b, c, d, e, f]: &[T; 6]) -> T {
    (*a + *c + *e) + (*b + *d + *f)
}

/// Adds the moment of a force, the first three numbers, about a point that it is `arm` away from.
#[inline(always)]
pub(crate) fn add_moment<T: RealField + Copy>([x, y, z, about @ ..]: &mut [T; 6], arm: &Vector3<T>) {
    about[0] += arm.y * *z - arm.z * *y;
    about[1] += arm.z * *x - arm.x * *z;
    about[2] += arm.x * *y - arm.y * *x;
}

/// Transposes in place.
#[inline]
pub(crate) fn transpose<T: RealField + Copy>(square: &mut Square<T>) {
    for i in 1..6 {
        for j in 0..i {
            (square[i][j], square[j][i]) = (square[j][i], square[i][j]);
        }
    }
}

/// A block, of zeros if it was not written to.
#[inline(always)]
pub(crate) fn block_at<T: RealField + Copy>(
    blocks: &mut [Option<Square<T>>],
    index: usize,
) -> Option<&mut Square<T>> {
    blocks.get_mut(index).map(|block| block.get_or_insert_with(zeros))
}
