//! Motions that are given as functions of time.

use nalgebra::RealField;

/// The most coefficients of a polynomial drive.
pub const MOST_COEFFICIENTS: usize = 6;

/// The angle (rad) or position (m) of a driven joint as a function of time (s).
#[derive(Debug, Clone, Copy)]
pub enum Drive<T = f64> {
    /// Σ c_k t^k.
    Polynomial([T; MOST_COEFFICIENTS]),
    /// Value, rate and acceleration; the latter two must be the exact derivatives of the first.
    Function(fn(T) -> [T; 3]),
}

impl<T: RealField + Copy> Drive<T> {
    /// A polynomial of at most [`MOST_COEFFICIENTS`] coefficients, that of t^0 first; others are left out.
    pub fn polynomial(coefficients: &[T]) -> Self {
        let mut all = [T::zero(); MOST_COEFFICIENTS];
        for (place, coefficient) in all.iter_mut().zip(coefficients) {
            *place = *coefficient;
        }
        Self::Polynomial(all)
    }

    /// Value, rate and acceleration at `time`.
    pub fn at(&self, time: T) -> [T; 3] {
        match self {
            Self::Polynomial(coefficients) => polynomial(coefficients, time),
            Self::Function(function) => function(time),
        }
    }
}

/// Value, first and second derivative of Σ c_k t^k.
pub fn polynomial<T: RealField + Copy>(coefficients: &[T], time: T) -> [T; 3] {
    // Horner's scheme for the polynomial, its derivative and half its second derivative
    let [value, rate, half] =
        coefficients.iter().rev().fold([T::zero(); 3], |[value, rate, half], coefficient| {
            [value * time + *coefficient, rate * time + value, half * time + rate]
        });
    [value, rate, half + half]
}
