//! Canonical multivariate polynomials with exact coefficients: the form in which equality is decidable.
//!
//! Two expression graphs that compute the same polynomial in different ways (factored, reordered, through
//! shared intermediate results) have the same [`Polynomial`]. That is how the fast kernels are
//! proven equal to the equations derived from the kinetic energy: coefficient by coefficient, without a tolerance.

mod dyadic;
mod error;
mod from_expression;
mod monomial;

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::fmt;

pub use dyadic::Dyadic;
pub use error::PolynomialError;
pub use from_expression::polynomials_of;
pub use monomial::Monomial;

/// A polynomial in variables of type `V`: each monomial once, none with coefficient zero.
///
/// The form is canonical: equal polynomials are structurally equal. Operations that compute coefficients
/// fail with [`PolynomialError::CoefficientOverflow`] instead of rounding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Polynomial<V: Ord> {
    terms: BTreeMap<Monomial<V>, Dyadic>,
}

impl<V: Ord + Clone> Polynomial<V> {
    /// 0.
    pub fn zero() -> Self {
        Self { terms: BTreeMap::new() }
    }

    /// The exact value of `value`.
    ///
    /// Errors: `value` is not finite.
    pub fn constant(value: f64) -> Result<Self, PolynomialError> {
        let coefficient = Dyadic::from_f64(value).ok_or(PolynomialError::NotFinite { value })?;
        let mut result = Self::zero();
        result.accumulate(Monomial::one(), coefficient)?;
        Ok(result)
    }

    /// One variable.
    pub fn variable(variable: V) -> Self {
        Self { terms: BTreeMap::from([(Monomial::variable(variable), Dyadic::ONE)]) }
    }

    /// Monomials and their coefficients, in graded lexicographic order.
    pub fn terms(&self) -> impl ExactSizeIterator<Item = (&Monomial<V>, Dyadic)> {
        self.terms.iter().map(|(monomial, coefficient)| (monomial, *coefficient))
    }

    /// Number of monomials.
    pub fn term_count(&self) -> usize {
        self.terms.len()
    }

    /// Whether the polynomial is 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The highest degree of a monomial; 0 for the zero polynomial.
    pub fn degree(&self) -> usize {
        self.terms.last_key_value().map_or(0, |(monomial, _)| monomial.degree())
    }

    /// Whether `variable` occurs.
    pub fn depends_on(&self, variable: &V) -> bool {
        self.terms.keys().any(|monomial| monomial.power(variable) > 0)
    }

    /// Adds one term.
    fn accumulate(&mut self, monomial: Monomial<V>, coefficient: Dyadic) -> Result<(), PolynomialError> {
        if coefficient.is_zero() {
            return Ok(());
        }
        match self.terms.entry(monomial) {
            Entry::Vacant(entry) => {
                entry.insert(coefficient);
            }
            Entry::Occupied(mut entry) => {
                let sum = entry.get().checked_add(coefficient).ok_or(PolynomialError::CoefficientOverflow)?;
                if sum.is_zero() {
                    entry.remove();
                } else {
                    *entry.get_mut() = sum;
                }
            }
        }
        Ok(())
    }

    /// The sum.
    ///
    /// Errors: a coefficient overflows.
    pub fn add(&self, other: &Self) -> Result<Self, PolynomialError> {
        let (long, short) =
            if self.term_count() < other.term_count() { (other, self) } else { (self, other) };
        let mut result = long.clone();
        for (monomial, coefficient) in &short.terms {
            result.accumulate(monomial.clone(), *coefficient)?;
        }
        Ok(result)
    }

    /// The difference.
    ///
    /// Errors: a coefficient overflows.
    pub fn subtract(&self, other: &Self) -> Result<Self, PolynomialError> {
        self.add(&other.negate())
    }

    /// The polynomial with the opposite sign.
    #[must_use]
    pub fn negate(&self) -> Self {
        let negated =
            |(monomial, coefficient): (&Monomial<V>, &Dyadic)| (monomial.clone(), coefficient.negated());
        Self { terms: self.terms.iter().map(negated).collect() }
    }

    /// The product.
    ///
    /// Errors: a coefficient overflows.
    pub fn multiply(&self, other: &Self) -> Result<Self, PolynomialError> {
        let mut result = Self::zero();
        for (left, left_coefficient) in &self.terms {
            for (right, right_coefficient) in &other.terms {
                let coefficient = left_coefficient
                    .checked_mul(*right_coefficient)
                    .ok_or(PolynomialError::CoefficientOverflow)?;
                result.accumulate(left.times(right), coefficient)?;
            }
        }
        Ok(result)
    }

    /// The partial derivative with respect to `variable`.
    ///
    /// Errors: a coefficient overflows.
    pub fn derivative(&self, variable: &V) -> Result<Self, PolynomialError> {
        let mut result = Self::zero();
        for (monomial, coefficient) in &self.terms {
            let power = monomial.power(variable);
            let factor = Dyadic::from_f64(power as f64).unwrap_or(Dyadic::ZERO);
            let coefficient = coefficient.checked_mul(factor).ok_or(PolynomialError::CoefficientOverflow)?;
            if power > 0 {
                result.accumulate(monomial.without(variable, 1), coefficient)?;
            }
        }
        Ok(result)
    }

    /// The polynomial with `replacement` in the place of `variable`.
    ///
    /// Errors: a coefficient overflows.
    pub fn substitute(&self, variable: &V, replacement: &Self) -> Result<Self, PolynomialError> {
        let mut result = Self::zero();
        for (monomial, coefficient) in &self.terms {
            let power = monomial.power(variable);
            let rest = monomial.without(variable, power);
            let mut product = Self { terms: BTreeMap::from([(rest, *coefficient)]) };
            for _ in 0..power {
                product = product.multiply(replacement)?;
            }
            for (monomial, coefficient) in product.terms {
                result.accumulate(monomial, coefficient)?;
            }
        }
        Ok(result)
    }
}

impl<V: Ord + fmt::Display> fmt::Display for Polynomial<V> {
    /// `2 x y - 1/2 z^2 + 3`, highest degree first; the zero polynomial is `0`.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.terms.is_empty() {
            return formatter.write_str("0");
        }
        for (index, (monomial, coefficient)) in self.terms.iter().rev().enumerate() {
            let magnitude = if coefficient.is_negative() { coefficient.negated() } else { *coefficient };
            formatter.write_str(match (index, coefficient.is_negative()) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            })?;
            match (magnitude == Dyadic::ONE, monomial.is_one()) {
                (_, true) => write!(formatter, "{magnitude}")?,
                (true, false) => write!(formatter, "{monomial}")?,
                (false, false) => write!(formatter, "{magnitude} {monomial}")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
