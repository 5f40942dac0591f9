//! Motions that are given as functions of time.

/// A function of time with its exact first and second derivative.
#[derive(Debug, Clone, PartialEq)]
pub enum Drive {
    /// Σ c_k t^k.
    Polynomial(Vec<f64>),
}

impl Drive {
    /// Value, rate and acceleration at `time` (s).
    pub fn at(&self, time: f64) -> [f64; 3] {
        match self {
            Self::Polynomial(coefficients) => {
                // Horner's scheme for the polynomial, its derivative and half its second derivative
                let [value, rate, half] =
                    coefficients.iter().rev().fold([0.0; 3], |[value, rate, half], coefficient| {
                        [value * time + coefficient, rate * time + value, half * time + rate]
                    });
                [value, rate, 2.0 * half]
            }
        }
    }
}
