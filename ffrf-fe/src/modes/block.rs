//! Products of tall blocks of vectors, with explicit parallelism.
//!
//! Tall blocks are worked on in two fixed halves of their rows, each by its own thread if there are two. The halves
//! are the same for one thread, so that the result is, too.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatMut, MatRef, Par};

/// Rows that are rotated at once: the copy of a strip stays in the cache.
const STRIP: usize = 256;

/// A B.
pub(crate) fn product(a: MatRef<'_, f64>, b: MatRef<'_, f64>, par: Par) -> Mat<f64> {
    let mut result = Mat::zeros(a.nrows(), b.ncols());
    matmul(&mut result, Accum::Replace, a, b, 1.0, par);
    result
}

/// Aᵀ B.
pub(crate) fn gram(a: MatRef<'_, f64>, b: MatRef<'_, f64>, par: Par) -> Mat<f64> {
    product(a.transpose(), b, par)
}

/// X := X - A B.
pub(crate) fn subtract_product(x: MatMut<'_, f64>, a: MatRef<'_, f64>, b: MatRef<'_, f64>, par: Par) {
    matmul(x, Accum::Add, a, b, -1.0, par);
}

/// Does both, the first on a thread of its own unless `threads` is 1.
pub(crate) fn both(threads: usize, first: impl FnOnce() + Send, second: impl FnOnce() + Send) {
    if threads == 1 {
        first();
        second();
    } else {
        std::thread::scope(|scope| {
            scope.spawn(first);
            second();
        });
    }
}

/// Aᵀ B of tall blocks, the sum of their halves.
pub(crate) fn tall_gram(a: MatRef<'_, f64>, b: MatRef<'_, f64>, threads: usize) -> Mat<f64> {
    let half = a.nrows().div_ceil(2);
    let (a_upper, a_lower) = a.split_at_row(half);
    let (b_upper, b_lower) = b.split_at_row(half);
    let (mut upper, mut lower) = (Mat::zeros(0, 0), Mat::zeros(0, 0));
    both(threads, || upper = gram(a_upper, b_upper, Par::Seq), || lower = gram(a_lower, b_lower, Par::Seq));
    upper + lower
}

/// X := X - A B of tall X and A.
pub(crate) fn subtract_tall_product(
    x: MatMut<'_, f64>,
    a: MatRef<'_, f64>,
    b: MatRef<'_, f64>,
    threads: usize,
) {
    let half = a.nrows().div_ceil(2);
    let (a_upper, a_lower) = a.split_at_row(half);
    let (x_upper, x_lower) = x.split_at_row_mut(half);
    both(
        threads,
        || subtract_product(x_upper, a_upper, b, Par::Seq),
        || subtract_product(x_lower, a_lower, b, Par::Seq),
    );
}

/// Replaces the first columns of a tall X by X B, strip by strip: no second tall block is needed.
pub(crate) fn rotate(x: MatMut<'_, f64>, rotation: MatRef<'_, f64>, threads: usize) {
    let half = x.nrows().div_ceil(2);
    let (upper, lower) = x.split_at_row_mut(half);
    both(threads, || rotate_half(upper, rotation), || rotate_half(lower, rotation));
}

fn rotate_half(mut x: MatMut<'_, f64>, rotation: MatRef<'_, f64>) {
    let rows = x.nrows();
    for start in (0..rows).step_by(STRIP) {
        let end = (start + STRIP).min(rows);
        let strip = x.as_ref().get(start..end, ..).to_owned();
        let target = x.as_mut().get_mut(start..end, 0..rotation.ncols());
        matmul(target, Accum::Replace, strip.as_ref(), rotation, 1.0, Par::Seq);
    }
}

/// (A + Aᵀ) / 2.
pub(crate) fn symmetrised(a: MatRef<'_, f64>) -> Mat<f64> {
    Mat::from_fn(a.nrows(), a.ncols(), |i, j| 0.5 * (a[(i, j)] + a[(j, i)]))
}

/// Euclidean norm of one column.
pub(crate) fn column_norm(x: MatRef<'_, f64>, column: usize) -> f64 {
    x.col(column).norm_l2()
}

/// xᵀ y.
pub(crate) fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

/// y := y - factor x.
pub(crate) fn subtract_multiple(y: &mut [f64], factor: f64, x: &[f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y -= factor * x;
    }
}

/// x := factor x.
pub(crate) fn scale(x: &mut [f64], factor: f64) {
    x.iter_mut().for_each(|x| *x *= factor);
}
