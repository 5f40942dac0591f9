//! Comparison of matrices, and the only tolerances of the equation tests.

use std::cell::Cell;

use faer::Mat;

use crate::bodies::Kind;

/// Identities hold to round-off of sums over a few hundred nodes.
pub const IDENTITY: f64 = 1e-13;

/// A misprint must show at least this much in every state: ten powers of ten above what round-off hides. In random states
/// some of it cancels; the least that is found is 4e-3.
pub const VISIBLE: f64 = 1e-3;

/// Matrices that another program printed: CalculiX writes 21 digits, but integrates with its own abscissas.
pub const PRINTED_MATRIX: f64 = 1e-12;

/// Natural size of a quantity of a body in natural units, below which it counts as vanishing by symmetry.
const NATURAL: f64 = 0.1;

thread_local! {
    static KIND: Cell<Kind> = const { Cell::new(Kind::Unsymmetric) };
}

/// Sets how the following comparisons of this thread are judged.
pub fn judge_for(kind: Kind) {
    KIND.set(kind);
}

/// True if every misprint must show on the body under test.
pub fn misprints_show() -> bool {
    KIND.get() == Kind::Unsymmetric
}

/// Least scale of a comparison: 0 where nothing may vanish by symmetry.
pub fn smallest_scale() -> f64 {
    if misprints_show() { 0.0 } else { NATURAL }
}

pub fn largest(matrix: &Mat<f64>) -> f64 {
    matrix.norm_max()
}

/// max|a - b| relative to the larger of the two, or to the natural size 1 of quantities that may vanish by
/// symmetry; 0 for two zero matrices.
pub fn deviation(a: &Mat<f64>, b: &Mat<f64>) -> f64 {
    assert_eq!((a.nrows(), a.ncols()), (b.nrows(), b.ncols()), "shapes differ");
    let scale = largest(a).max(largest(b)).max(smallest_scale());
    if scale == 0.0 { 0.0 } else { largest(&(a - b)) / scale }
}

#[track_caller]
pub fn equal(a: &Mat<f64>, b: &Mat<f64>) {
    let off = deviation(a, b);
    assert!(off <= IDENTITY, "relative deviation {off:e}, at most {IDENTITY:e}");
}

#[track_caller]
pub fn different(a: &Mat<f64>, b: &Mat<f64>) {
    if !misprints_show() {
        return;
    }
    let off = deviation(a, b);
    assert!(off >= VISIBLE, "the printed form is off by only {off:e}, expected at least {VISIBLE:e}");
}

/// Asserts that `value` vanishes compared with `scale`.
#[track_caller]
pub fn vanishes(value: &Mat<f64>, scale: f64) {
    assert!(scale > 0.0);
    let off = largest(value) / scale;
    assert!(off <= IDENTITY, "{off:e} of the scale, at most {IDENTITY:e}");
}

/// Asserts equality relative to a scale given by the terms of a sum that cancels.
#[track_caller]
pub fn equal_within(a: &Mat<f64>, b: &Mat<f64>, scale: f64) {
    vanishes(&(a - b), scale);
}

pub fn column(values: &[f64]) -> Mat<f64> {
    Mat::from_fn(values.len(), 1, |i, _| values[i])
}

pub fn scaled(factor: f64, matrix: &Mat<f64>) -> Mat<f64> {
    faer::Scale(factor) * matrix
}

pub fn transposed(matrix: &Mat<f64>) -> Mat<f64> {
    matrix.transpose().to_owned()
}

pub fn identity(size: usize) -> Mat<f64> {
    Mat::identity(size, size)
}

pub fn as_vector(matrix: &Mat<f64>) -> [f64; 3] {
    assert_eq!((matrix.nrows(), matrix.ncols()), (3, 1));
    [matrix[(0, 0)], matrix[(1, 0)], matrix[(2, 0)]]
}

pub fn block(matrix: &Mat<f64>, row: usize, column: usize, rows: usize, columns: usize) -> Mat<f64> {
    matrix.as_ref().submatrix(row, column, rows, columns).to_owned()
}

/// Σ of matrices of one shape.
pub fn sum(terms: impl IntoIterator<Item = Mat<f64>>) -> Mat<f64> {
    terms.into_iter().reduce(|a, b| a + b).expect("at least one term")
}

/// u vᵀ.
pub fn outer(u: [f64; 3], v: [f64; 3]) -> Mat<f64> {
    Mat::from_fn(3, 3, |i, j| u[i] * v[j])
}
