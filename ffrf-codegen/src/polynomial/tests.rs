//! Ring laws, derivative, substitution and printing of polynomials.

use proptest::prelude::*;

use super::{Polynomial, PolynomialError};

type P = Polynomial<char>;

fn x(name: char) -> P {
    P::variable(name)
}

fn c(value: f64) -> P {
    P::constant(value).unwrap()
}

/// A polynomial of degree up to 3 in a, b, c with small half-integer coefficients.
fn polynomials() -> impl Strategy<Value = P> {
    let term = (-6_i32..7, prop::collection::vec(prop::sample::select(vec!['a', 'b', 'c']), 0..4));
    prop::collection::vec(term, 0..6).prop_map(|terms| {
        terms.into_iter().fold(P::zero(), |sum, (half, factors)| {
            let product = factors
                .into_iter()
                .fold(c(f64::from(half) / 2.0), |product, factor| product.multiply(&x(factor)).unwrap());
            sum.add(&product).unwrap()
        })
    })
}

proptest! {
    #[test]
    fn products_distribute_and_commute(p in polynomials(), q in polynomials(), r in polynomials()) {
        let left = p.multiply(&q.add(&r).unwrap()).unwrap();
        let right = q.multiply(&p).unwrap().add(&r.multiply(&p).unwrap()).unwrap();
        prop_assert_eq!(left, right);
    }

    #[test]
    fn differences_of_equals_are_empty(p in polynomials(), q in polynomials()) {
        let sum = p.add(&q).unwrap();
        prop_assert!(sum.subtract(&q).unwrap().subtract(&p).unwrap().is_zero());
    }

    #[test]
    fn derivatives_obey_the_product_rule(p in polynomials(), q in polynomials()) {
        let left = p.multiply(&q).unwrap().derivative(&'a').unwrap();
        let right = p
            .derivative(&'a')
            .unwrap()
            .multiply(&q)
            .unwrap()
            .add(&p.multiply(&q.derivative(&'a').unwrap()).unwrap())
            .unwrap();
        prop_assert_eq!(left, right);
    }

    #[test]
    fn substitution_is_a_ring_homomorphism(p in polynomials(), q in polynomials(), r in polynomials()) {
        let left = p.multiply(&q).unwrap().substitute(&'a', &r).unwrap();
        let right = p.substitute(&'a', &r).unwrap().multiply(&q.substitute(&'a', &r).unwrap()).unwrap();
        prop_assert_eq!(left, right);
    }
}

#[test]
fn display_is_readable() {
    let half_square = c(-0.5).multiply(&x('z')).unwrap().multiply(&x('z')).unwrap();
    let sum = c(2.0).multiply(&x('y')).unwrap().multiply(&x('x')).unwrap();
    let polynomial = sum.add(&half_square).unwrap().add(&c(3.0)).unwrap();
    assert_eq!(polynomial.to_string(), "-1/2 z^2 + 2 x y + 3");
    assert_eq!(polynomial.degree(), 2);
    assert_eq!(P::zero().to_string(), "0");
}

#[test]
fn constants_must_be_finite() {
    assert!(matches!(P::constant(f64::INFINITY), Err(PolynomialError::NotFinite { .. })));
}

#[test]
fn a_variable_that_cancels_does_not_occur() {
    let sum = x('a').add(&x('b')).unwrap();
    assert!(sum.depends_on(&'a'));
    assert!(!sum.subtract(&x('a')).unwrap().depends_on(&'a'));
}
