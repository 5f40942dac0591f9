//! Accelerations are as accurate as the mass matrix allows: never more than a few times the error of a Cholesky
//! factorisation of the same mass matrix in the same precision, whatever the body.
//!
//! Errors are forward errors, against arithmetic of 106 bits. The families of bodies are hard in different ways, each up
//! to condition numbers of 1e10 in f64, beyond which a model is refused, and 1e5 in f32, beyond which f32 has no digit
//! left.
//! `cargo test -p ffrf --test accuracy_of_accelerations -- --nocapture` prints what is found for each.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // helpers of tests are tests

mod double_double;
mod equations;
mod families;
mod fields;
mod loops;
mod measure;
mod real;
mod slender_bodies;
mod tolerances;

use families::Family;
use measure::{Case, Compared, Form, Found, NORMS, Spread, measure};
use real::Real;
use tolerances::{BODIES_FOR_PARTS, DIGITS, RATIO, YARDSTICK};

/// Which bodies of every family are measured.
struct Survey {
    modes: &'static [usize],
    conditions: &'static [f64],
    bodies: u64,
    states: usize,
}

impl Survey {
    fn cases(&self) -> impl Iterator<Item = Case> {
        Family::ALL.into_iter().flat_map(move |family| {
            let modes = self.modes.iter().filter(move |&&modes| family.admits(modes));
            let conditions = if family.has_condition() { self.conditions } else { &self.conditions[..1] };
            modes.flat_map(move |&modes| {
                conditions.iter().map(move |&condition| Case {
                    family,
                    modes,
                    condition,
                    bodies: self.bodies,
                    states: self.states,
                })
            })
        })
    }

    /// Every body keeps the bound; prints the largest ratios.
    fn run<T: Real>(&self) {
        let mut worst = [0.0_f64; NORMS.len()];
        let mut largest_condition = 0.0_f64;
        for case in self.cases() {
            let forms: &[Form] =
                if case.modes == 0 { &[Form::Statements] } else { &[Form::Statements, Form::Lanes] };
            for (form, found) in forms.iter().zip(measure::<T>(&case, forms)) {
                let name = format!("{:?} {case:?} as {form:?}, condition {:.1e}", T::SCALAR, found.condition);
                if found.condition * T::EPSILON > DIGITS {
                    println!("{name}: no digit is certain");
                    continue;
                }
                let ratios = ratios(&found, case.bodies);
                println!("{name}: {}", shown(&found, &ratios));
                for (ratio, norm) in ratios.iter().zip(NORMS) {
                    assert!(*ratio <= RATIO, "{name}: {norm}: {ratio:.1} times the error of Cholesky");
                }
                let yardstick = YARDSTICK * T::EPSILON * (found.condition + case.condition.sqrt());
                let cholesky = found.errors.each_ref().map(|compared| compared.cholesky.largest()[0]);
                let cholesky = cholesky[0].max(cholesky[1]);
                assert!(cholesky <= yardstick, "{name}: Cholesky {cholesky:.1e}, at most {yardstick:.1e}");
                worst = std::array::from_fn(|k| worst[k].max(ratios[k]));
                largest_condition = largest_condition.max(found.condition);
            }
        }
        println!("{:?}: condition up to {largest_condition:.1e}, largest ratios {worst:.1?}", T::SCALAR);
    }
}

/// Our errors over those of Cholesky in each norm, the larger ratio of the two kinds of forces: of the largest errors for
/// all accelerations scaled by mass, of the mean squares for the rest.
fn ratios(found: &Found, bodies: u64) -> [f64; NORMS.len()] {
    let of = |compared: &Compared, norm: usize| {
        let forms = [&compared.forward_dynamics, &compared.equations_of_motion];
        let errors = |spread: &Spread| if norm == 0 { spread.largest() } else { spread.mean() };
        let ours = forms.map(|spread| errors(spread)[norm]);
        let theirs = errors(&compared.cholesky)[norm];
        let is_compared = theirs > 0.0 && (norm == 0 || bodies >= BODIES_FOR_PARTS);
        if is_compared { ours[0].max(ours[1]) / theirs } else { 0.0 }
    };
    let [any, moderate] = &found.errors;
    std::array::from_fn(|norm| of(any, norm).max(of(moderate, norm)))
}

fn shown(found: &Found, ratios: &[f64; NORMS.len()]) -> String {
    let pairs = found.errors.each_ref().map(|compared| {
        let (ours, theirs) = (compared.forward_dynamics.largest()[0], compared.cholesky.largest()[0]);
        format!("{ours:.1e} (Cholesky {theirs:.1e})")
    });
    format!("{}, ratios {ratios:.1?}", pairs.join(", "))
}

const DOUBLE: [f64; 3] = [1e2, 1e6, 3e9];
const SINGLE: [f64; 2] = [1e2, 1e4];

#[test]
fn few_modes_in_f64() {
    Survey { modes: &[0, 1, 2, 4, 8], conditions: &DOUBLE, bodies: 10, states: 6 }.run::<f64>();
}

#[test]
fn few_modes_in_f32() {
    Survey { modes: &[0, 1, 2, 4, 8], conditions: &SINGLE, bodies: 10, states: 6 }.run::<f32>();
}

#[test]
fn many_modes_in_f64() {
    Survey { modes: &[12, 16], conditions: &DOUBLE, bodies: 8, states: 3 }.run::<f64>();
    Survey { modes: &[32], conditions: &[1e6], bodies: 2, states: 3 }.run::<f64>();
    Survey { modes: &[64], conditions: &[3e9], bodies: 1, states: 3 }.run::<f64>();
}

#[test]
fn many_modes_in_f32() {
    Survey { modes: &[12, 16], conditions: &SINGLE, bodies: 8, states: 3 }.run::<f32>();
    Survey { modes: &[32, 64], conditions: &[1e4], bodies: 1, states: 3 }.run::<f32>();
}

/// The tests above can fail: elimination by products with an inverse is found.
#[test]
fn an_inverse_would_be_found() {
    for family in [Family::ClampedPowers, Family::CraigBampton] {
        let case = Case { family, modes: 12, condition: 1e6, bodies: 8, states: 6 };
        let found = measure::<f64>(&case, &[Form::Inverse]);
        let ratio = ratios(&found[0], case.bodies)[0];
        assert!(ratio > 2.0 * RATIO, "{case:?}: {ratio:.1}");
    }
}
