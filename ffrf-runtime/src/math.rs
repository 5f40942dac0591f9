//! Scalars and arrays as generated code, loops and kernels use them: the ground floor of the runtime.
//!
//! Everything here is a few instructions long, always inlined, and free of allocation and panics.

use nalgebra::{ArrayStorage, ComplexField, RealField, SMatrix, SVector};

/// A number type that generic kernels compute with.
pub trait Number: RealField + Copy {}

impl<T: RealField + Copy> Number for T {}

/// A constant of a generic kernel.
#[inline(always)]
pub fn constant<T: Number>(value: f64) -> T {
    nalgebra::convert(value)
}

/// a b + c, fused where the target does that in hardware, otherwise a product and a sum.
///
/// Fused only with the `std` feature (`f64::mul_add` is not in `core`) on targets that are known to have
/// the instruction; a software fused multiply-add would be correct but some twenty times slower.
#[inline(always)]
pub fn fused_multiply_add(a: f64, b: f64, c: f64) -> f64 {
    #[cfg(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")))]
    return a.mul_add(b, c);
    #[cfg(not(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64"))))]
    return a * b + c;
}

/// [`fused_multiply_add`] in single precision.
#[inline(always)]
pub fn fused_multiply_add_f32(a: f32, b: f32, c: f32) -> f32 {
    #[cfg(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")))]
    return a.mul_add(b, c);
    #[cfg(not(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64"))))]
    return a * b + c;
}

/// a b + c in any number type: a product and a sum.
#[inline(always)]
pub fn fused_multiply_add_of<T: Number>(a: T, b: T, c: T) -> T {
    a * b + c
}

/// a b + c rounded once on every target, in software where there is no instruction.
#[inline(always)]
pub fn always_fused_multiply_add(a: f64, b: f64, c: f64) -> f64 {
    ComplexField::mul_add(a, b, c)
}

/// [`always_fused_multiply_add`] in single precision.
#[inline(always)]
pub fn always_fused_multiply_add_f32(a: f32, b: f32, c: f32) -> f32 {
    ComplexField::mul_add(a, b, c)
}

/// [`always_fused_multiply_add`] in any number type, as far as that type has it.
#[inline(always)]
pub fn always_fused_multiply_add_of<T: Number>(a: T, b: T, c: T) -> T {
    ComplexField::mul_add(a, b, c)
}

/// Square root, from `std` or `libm`.
#[inline(always)]
pub fn square_root(x: f64) -> f64 {
    ComplexField::sqrt(x)
}

/// Square root in single precision, from `std` or `libm`.
#[inline(always)]
pub fn square_root_f32(x: f32) -> f32 {
    ComplexField::sqrt(x)
}

/// Square root in any number type.
#[inline(always)]
pub fn square_root_of<T: Number>(x: T) -> T {
    ComplexField::sqrt(x)
}

/// The array `entries` as a column vector. Shape: R.
#[inline(always)]
pub const fn vector<const R: usize, T>(entries: [T; R]) -> SVector<T, R> {
    SVector::from_array_storage(ArrayStorage([entries]))
}

/// The columns as a matrix (nalgebra stores column by column). Shape: R x C.
#[inline(always)]
pub const fn matrix<const R: usize, const C: usize, T>(columns: [[T; R]; C]) -> SMatrix<T, R, C> {
    SMatrix::from_array_storage(ArrayStorage(columns))
}

/// The entries of a column vector as an array, without a copy. Shape: R.
#[inline(always)]
pub const fn array<const R: usize, T>(vector: &SVector<T, R>) -> &[T; R] {
    let [column] = &vector.data.0;
    column
}

/// The entries of a column vector as an array to write to. Shape: R.
#[inline(always)]
pub const fn array_mut<const R: usize, T>(vector: &mut SVector<T, R>) -> &mut [T; R] {
    let [column] = &mut vector.data.0;
    column
}

/// The columns of a matrix as arrays to write to. Shape: C columns of R.
#[inline(always)]
pub const fn columns_mut<const R: usize, const C: usize, T>(
    matrix: &mut SMatrix<T, R, C>,
) -> &mut [[T; R]; C] {
    &mut matrix.data.0
}

/// The columns of a matrix as arrays, without a copy. Shape: C columns of R.
#[inline(always)]
pub const fn columns<const R: usize, const C: usize, T>(matrix: &SMatrix<T, R, C>) -> &[[T; R]; C] {
    &matrix.data.0
}

/// Keeps what is written to memory above this line above what is read below it, when the code is compiled: no instruction.
///
/// Results of a kernel that are complete early are otherwise stored last of all, behind what takes longest.
#[inline(always)]
pub fn keep_stores_above() {
    core::sync::atomic::compiler_fence(core::sync::atomic::Ordering::SeqCst);
}

/// A zero among the results of a kernel.
///
/// For 32-bit Arm compilers make calls of a function that clears memory of neighbouring zeros, 42 instructions for ten numbers
/// where a store from a register is one each: there they do not learn that this is a zero. Cortex-M7, f64, equations of motion
/// of the connecting rod: 685 instructions in place of 895 with four modes, 1,633 in place of 2,141 with eight.
#[inline(always)]
pub fn zero_entry<T: Number>() -> T {
    #[cfg(target_arch = "arm")]
    return core::hint::black_box(T::zero());
    #[cfg(not(target_arch = "arm"))]
    T::zero()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrays_and_matrices_are_the_same_numbers() {
        let column = vector([1.0, 2.0, 3.0]);
        assert_eq!(column[2], 3.0);
        assert_eq!(array(&column), &[1.0, 2.0, 3.0]);
        let both = matrix([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
        assert_eq!((both.nrows(), both.ncols(), both[(0, 1)]), (3, 2, 4.0));
        assert_eq!(columns(&both)[1], [4.0, 5.0, 6.0]);
        assert_eq!(array(&vector::<0, f64>([])).len(), 0);
    }

    #[test]
    fn zeros_are_zeros() {
        assert_eq!(zero_entry::<f64>().to_bits(), 0);
        assert_eq!(zero_entry::<f32>().to_bits(), 0);
    }

    #[test]
    fn products_and_roots() {
        assert_eq!(fused_multiply_add(2.0, 3.0, 4.0), 10.0);
        assert_eq!(fused_multiply_add_f32(2.0, 3.0, 4.0), 10.0);
        // (1 + e) (1 - e) = 1 - e² with e = 2^-52: the product alone rounds to 1.
        let tiny = f64::EPSILON / 4.0;
        assert_eq!(always_fused_multiply_add(1.0 + 4.0 * tiny, 1.0 - 4.0 * tiny, -1.0), -16.0 * tiny * tiny);
        assert_eq!(always_fused_multiply_add_f32(2.0, 3.0, 4.0), 10.0);
        assert_eq!(square_root(2.0), core::f64::consts::SQRT_2);
        assert_eq!(square_root_f32(9.0), 3.0);
    }
}
