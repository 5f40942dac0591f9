//! Products of variables, in canonical order.

use std::cmp::Ordering;
use std::fmt;

/// A product of variables: a sorted list, a variable repeated as often as its power says.
///
/// The order of monomials is graded, then lexicographic. Degrees stay small here (at most 6 in the
/// equations of motion), so that a plain list beats a table of powers.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Monomial<V> {
    factors: Vec<V>,
}

impl<V> Monomial<V> {
    /// Whether this is the empty product.
    pub fn is_one(&self) -> bool {
        self.factors.is_empty()
    }
}

impl<V: Ord + Clone> Monomial<V> {
    /// The empty product, 1.
    pub fn one() -> Self {
        Self { factors: Vec::new() }
    }

    /// One variable.
    pub fn variable(variable: V) -> Self {
        Self { factors: vec![variable] }
    }

    /// The factors in ascending order, powers as repetitions.
    pub fn factors(&self) -> &[V] {
        &self.factors
    }

    /// Number of factors.
    pub fn degree(&self) -> usize {
        self.factors.len()
    }

    /// The power of `variable`.
    pub fn power(&self, variable: &V) -> usize {
        self.factors.iter().filter(|factor| *factor == variable).count()
    }

    /// The product of two monomials: their sorted lists, merged.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut factors = Vec::with_capacity(self.factors.len() + other.factors.len());
        let (mut left, mut right) = (self.factors.as_slice(), other.factors.as_slice());
        while let (Some((first, left_rest)), Some((second, right_rest))) =
            (left.split_first(), right.split_first())
        {
            if first <= second {
                factors.push(first.clone());
                left = left_rest;
            } else {
                factors.push(second.clone());
                right = right_rest;
            }
        }
        factors.extend_from_slice(left);
        factors.extend_from_slice(right);
        Self { factors }
    }

    /// The monomial without `power` of its factors equal to `variable`.
    #[must_use]
    pub fn without(&self, variable: &V, power: usize) -> Self {
        let mut left = power;
        let keep = |factor: &&V| {
            let dropped = left > 0 && *factor == variable;
            left -= usize::from(dropped);
            !dropped
        };
        Self { factors: self.factors.iter().filter(keep).cloned().collect() }
    }
}

impl<V: Ord> Ord for Monomial<V> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.factors.len().cmp(&other.factors.len()).then_with(|| self.factors.cmp(&other.factors))
    }
}

impl<V: Ord> PartialOrd for Monomial<V> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<V: PartialEq + fmt::Display> fmt::Display for Monomial<V> {
    /// `x y^2`; the empty product is `1`.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.factors.is_empty() {
            return formatter.write_str("1");
        }
        for (index, run) in self.factors.chunk_by(|a, b| a == b).enumerate() {
            let separator = if index == 0 { "" } else { " " };
            match run {
                [variable] => write!(formatter, "{separator}{variable}")?,
                [variable, ..] => write!(formatter, "{separator}{variable}^{}", run.len())?,
                [] => {}
            }
        }
        Ok(())
    }
}
