//! The accelerations of one state without rounding, and how far others are from them.

use std::fmt;

use ffrf::nalgebra::{DMatrix, Vector3};
use ffrf_codegen::formulate::Definition;
use ffrf_codegen::formulate::kernels::{INTERNAL_FORCE, MASS_MATRIX, QUADRATIC_VELOCITY};
use ffrf_codegen::{KernelInput, Kernels};
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::Point;
use ffrf_test_kit::proof::exact::Exact;

/// What drives the body.
#[derive(Debug, Clone, Copy)]
pub enum Force {
    /// Of order one, so that the spin about the long axis dominates the accelerations.
    Any,
    /// What gives accelerations of order one: next to no moment about the long axis.
    OfModerateAccelerations,
}

/// Largest errors.
#[derive(Debug, Clone, Copy, Default)]
pub struct Errors {
    /// Of the accelerations, each times the square root of its mass, relative to them as a whole.
    pub forward: f64,
    /// Of M w + Q + K q + D q̇ - force, relative to the terms of each row.
    pub backward: f64,
    /// Of the angular acceleration across the long axis, relative to it.
    pub across: f64,
}

impl Errors {
    /// The larger of both.
    pub fn widen(&mut self, other: Self) {
        self.forward = self.forward.max(other.forward);
        self.backward = self.backward.max(other.backward);
        self.across = self.across.max(other.across);
    }
}

impl fmt::Display for Errors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { forward, backward, across } = self;
        write!(f, "forward {forward:.1e}, backward {backward:.1e}, across the axis {across:.1e}")
    }
}

/// The equations M w = right of one state, and w.
///
/// The constants in the kernels are the body; that they are rounded themselves is no error of the solution.
pub struct ExactMotion {
    /// The generalised force, as the kernels get it. Shape: N.
    pub force: Vec<f64>,
    mass: Vec<Vec<BigRational>>,
    /// Q + K q + D q̇
    bias: Vec<BigRational>,
    right: Vec<BigRational>,
    acceleration: Vec<BigRational>,
}

impl ExactMotion {
    /// `numbers` are the force, or the accelerations that it gives. Shape: N.
    pub fn new(kernels: &Kernels, point: &Point, applied: Force, numbers: &[f64]) -> Self {
        let exact = |numbers: &[f64]| -> Vec<Exact> { numbers.iter().map(|&x| Exact(rational(x))).collect() };
        let (q, q_dot, omega) = (exact(&point.q), exact(&point.q_dot), exact(&point.omega));
        let input = KernelInput { q: &q, q_dot: &q_dot, omega: &omega, ..KernelInput::default() };
        let evaluate = |kernel: &Definition| -> Vec<BigRational> {
            kernels.evaluate(kernel, &input).into_iter().map(|Exact(number)| number).collect()
        };
        let entries = evaluate(&MASS_MATRIX);
        let mass: Vec<Vec<BigRational>> = entries.chunks(numbers.len()).map(<[_]>::to_vec).collect();
        let mut bias = evaluate(&QUADRATIC_VELOCITY);
        let internal = evaluate(&INTERNAL_FORCE);
        bias.iter_mut().skip(6).zip(internal).for_each(|(bias, internal)| *bias += internal);
        let force: Vec<f64> = match applied {
            Force::Any => numbers.to_vec(),
            Force::OfModerateAccelerations => mass
                .iter()
                .zip(&bias)
                .map(|(row, bias)| {
                    let terms = row.iter().zip(numbers).map(|(entry, &w)| entry * rational(w));
                    double(&(terms.sum::<BigRational>() + bias))
                })
                .collect(),
        };
        let right: Vec<BigRational> =
            force.iter().zip(&bias).map(|(&force, bias)| rational(force) - bias).collect();
        let acceleration = solve(mass.clone(), right.clone());
        Self { force, mass, bias, right, acceleration }
    }

    /// √M_ii
    fn scale(&self) -> Vec<f64> {
        self.mass.iter().enumerate().map(|(i, row)| double(&row[i]).sqrt()).collect()
    }

    /// Condition number of the mass matrix scaled to a unit diagonal.
    pub fn condition(&self) -> f64 {
        let scale = self.scale();
        let size = scale.len();
        let scaled = DMatrix::from_fn(size, size, |i, j| double(&self.mass[i][j]) / (scale[i] * scale[j]));
        let eigenvalues = scaled.symmetric_eigenvalues();
        eigenvalues.max() / eigenvalues.min()
    }

    /// How far `found` is from the exact accelerations of a body along `axis`.
    pub fn errors(&self, found: &[f64], axis: &Vector3<f64>) -> Errors {
        let found: Vec<BigRational> = found.iter().map(|&x| rational(x)).collect();
        let expected: Vec<f64> = self.acceleration.iter().map(double).collect();
        let error: Vec<f64> =
            found.iter().zip(&self.acceleration).map(|(w, exact)| double(&(w - exact))).collect();
        let scale = self.scale();
        let norm = |vector: &[f64]| -> f64 {
            vector.iter().zip(&scale).map(|(x, scale)| (x * scale).powi(2)).sum::<f64>().sqrt()
        };
        let across = |vector: &[f64]| {
            let angular = Vector3::new(vector[3], vector[4], vector[5]);
            (angular - axis * axis.dot(&angular)).norm()
        };
        let mut backward = 0.0_f64;
        for ((row, right), (bias, force)) in
            self.mass.iter().zip(&self.right).zip(self.bias.iter().zip(&self.force))
        {
            let terms: Vec<BigRational> = row.iter().zip(&found).map(|(entry, w)| entry * w).collect();
            let size = double(bias).abs() + force.abs() + terms.iter().map(|x| double(x).abs()).sum::<f64>();
            let residual = double(&(terms.into_iter().sum::<BigRational>() - right));
            backward = backward.max(residual.abs() / size);
        }
        Errors {
            forward: norm(&error) / norm(&expected),
            backward,
            across: across(&error) / across(&expected),
        }
    }
}

fn rational(number: f64) -> BigRational {
    BigRational::from_float(number).unwrap()
}

fn double(number: &BigRational) -> f64 {
    number.to_f64().unwrap()
}

/// Gaussian elimination; a positive definite matrix needs no exchange of rows.
fn solve(mut matrix: Vec<Vec<BigRational>>, mut right: Vec<BigRational>) -> Vec<BigRational> {
    let size = right.len();
    for k in 0..size {
        for i in k + 1..size {
            let factor = &matrix[i][k] / &matrix[k][k];
            for j in k + 1..size {
                let product = &factor * &matrix[k][j];
                matrix[i][j] -= product;
            }
            let product = &factor * &right[k];
            right[i] -= product;
        }
    }
    for k in (0..size).rev() {
        for j in k + 1..size {
            let product = &matrix[k][j] * &right[j];
            right[k] -= product;
        }
        right[k] = &right[k] / &matrix[k][k];
    }
    right
}
