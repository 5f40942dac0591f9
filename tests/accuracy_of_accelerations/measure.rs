//! Forward errors of accelerations, beside those of a Cholesky factorisation of the same mass matrix.

use std::ops::Range;

use ffrf::nalgebra::{DMatrix, DVector};
use ffrf_codegen::{GenerateOptions, Kernels, Strategy, lanes};
use ffrf_model::ReducedBody;

use crate::double_double::DoubleDouble;
use crate::equations::{Equations, Inverted, Point, Statements, Truth};
use crate::families::Family;
use crate::loops;
use crate::real::Real;
use ffrf_test_kit::random::Random;

/// In what an error is measured: all accelerations, each times the square root of its mass, and as they are; then parts,
/// scaled likewise.
pub const NORMS: [&str; 5] = ["all, scaled by mass", "all", "linear", "angular", "modal"];

/// Errors of one solution in each of the norms, relative to all exact accelerations in that norm.
type Errors = [f64; NORMS.len()];

/// Errors over many bodies, states and forces.
#[derive(Debug, Clone, Default)]
pub struct Spread(Vec<Errors>);

impl Spread {
    /// The largest error in each norm.
    pub fn largest(&self) -> Errors {
        self.0.iter().fold([0.0; NORMS.len()], |a, b| std::array::from_fn(|k| f64::max(a[k], b[k])))
    }

    /// The root of the mean square in each norm.
    pub fn mean(&self) -> Errors {
        std::array::from_fn(|k| {
            (self.0.iter().map(|e| e[k] * e[k]).sum::<f64>() / self.0.len() as f64).sqrt()
        })
    }
}

/// How accelerations are computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    Statements,
    Lanes,
    /// Not ours, and not to be: elimination of the modes by products with the inverse of Θ_ff.
    Inverse,
}

/// What is found for one form of the kernels of bodies of a kind.
#[derive(Default)]
pub struct Found {
    /// Condition number of the mass matrix scaled to a unit diagonal, the largest over bodies and states.
    pub condition: f64,
    /// Under any force, and under forces that give accelerations of order one.
    pub errors: [Compared; 2],
}

/// Errors of three solutions of the same equations.
#[derive(Default)]
pub struct Compared {
    /// Of `forward_dynamics`.
    pub forward_dynamics: Spread,
    /// Of the accelerations in `equations_of_motion`.
    pub equations_of_motion: Spread,
    /// Of a Cholesky factorisation of the mass matrix of the same kernels.
    pub cholesky: Spread,
}

/// Bodies of a kind.
#[derive(Debug, Clone, Copy)]
pub struct Case {
    pub family: Family,
    pub modes: usize,
    pub condition: f64,
    pub bodies: u64,
    /// States of each body, each with two forces.
    pub states: usize,
}

/// Measures bodies in one precision and one form.
pub fn measure<T: Real>(case: &Case, forms: &[Form]) -> Vec<Found> {
    let mut found: Vec<Found> = forms.iter().map(|_| Found::default()).collect();
    for seed in 1..=case.bodies {
        let mut body = case.family.fields(seed, case.modes, case.condition).body();
        if forms.contains(&Form::Inverse) {
            body.stiffness.iter_mut().chain(&mut body.damping).for_each(|row| row.fill(0.0));
        }
        let options = GenerateOptions { scalar: T::SCALAR, ..GenerateOptions::default() };
        let kernels = Kernels::formulate(&body, &options).unwrap();
        let points: Vec<(Point<T>, Truth)> = (0..case.states)
            .map(|state| {
                let point = point(case, &body, seed, state);
                let truth = Truth::new(&kernels, &point);
                (point, truth)
            })
            .collect();
        for (form, found) in forms.iter().zip(&mut found) {
            let equations: Box<dyn Equations<T>> = match form {
                Form::Statements => Box::new(Statements::new(&kernels)),
                Form::Inverse => Box::new(Inverted(Statements::new(&kernels))),
                Form::Lanes => {
                    let options = GenerateOptions { strategy: Strategy::Lanes, ..options.clone() };
                    loops::of(&lanes::tables_of(&body, &options).unwrap().unwrap())
                }
            };
            compare(equations.as_ref(), &kernels, &points, seed, found);
        }
    }
    found
}

/// A state with displacements, rates and spin of the size that the family admits. Every third is not deformed at all.
fn point<T: Real>(case: &Case, body: &ReducedBody, seed: u64, state: usize) -> Point<T> {
    let mut random = Random::new(1000 * seed + state as u64 + 1);
    let deformation = if state.is_multiple_of(3) { 0.0 } else { case.family.deformation(case.condition) };
    let size = |mu: usize| -> f64 {
        let trace: f64 = (0..3).map(|i| body.inertia.mode_mode_moment[mu][mu][i][i]).sum();
        (body.inertia.mass / (trace * case.modes as f64)).sqrt()
    };
    let modal = |random: &mut Random, factor: f64| -> Vec<T> {
        (0..case.modes).map(|mu| T::nearest(factor * size(mu) * random.number())).collect()
    };
    Point {
        q: modal(&mut random, deformation),
        q_dot: modal(&mut random, 1.0),
        omega: [0, 1, 2].map(|_| T::nearest(case.family.spin(case.condition) * random.number())),
    }
}

fn compare<T: Real>(
    equations: &dyn Equations<T>,
    kernels: &Kernels,
    points: &[(Point<T>, Truth)],
    seed: u64,
    found: &mut Found,
) {
    let mut random = Random::new(seed + 77);
    for (point, truth) in points {
        let scale = truth.scale();
        let size = scale.len();
        found.condition = found.condition.max(condition(truth, &scale));
        let matrix = DMatrix::from_vec(size, size, equations.mass_matrix(point));
        let factors = matrix.cholesky().expect("a mass matrix that is positive definite in this precision");
        let bias = {
            let mut bias = equations.quadratic_velocity(point);
            let internal = point.internal_force(kernels);
            bias.iter_mut().skip(6).zip(internal).for_each(|(bias, internal)| *bias += internal);
            DVector::from_vec(bias)
        };
        // Any force, and one that gives accelerations of order one, which is rare where the matrix is nearly singular.
        let any: Vec<f64> = scale.iter().map(|scale| scale * random.number()).collect();
        let wanted: Vec<f64> = scale.iter().map(|scale| random.number() / scale).collect();
        for (force, found) in [any, truth.force_of(&wanted)].into_iter().zip(&mut found.errors) {
            let force: Vec<T> = force.into_iter().map(T::nearest).collect();
            let exact = truth.accelerations(&force);
            let errors = |accelerations: &[T]| relative(accelerations, &exact, &scale);
            found.forward_dynamics.0.push(errors(&equations.accelerations(point, &force)));
            found.equations_of_motion.0.push(errors(&equations.accelerations_with_equations(point, &force)));
            let right = DVector::from_vec(force) - &bias;
            found.cholesky.0.push(errors(factors.solve(&right).as_slice()));
        }
    }
}

/// Errors relative to the exact vector in each of the norms.
fn relative<T: Real>(found: &[T], exact: &[DoubleDouble], scale: &[f64]) -> Errors {
    let error: Vec<f64> =
        found.iter().zip(exact).map(|(w, exact)| (DoubleDouble::from(w.double()) - *exact).value()).collect();
    let exact: Vec<f64> = exact.iter().map(|w| w.value()).collect();
    let norm = |vector: &[f64], range: Range<usize>, is_scaled: bool| -> f64 {
        let terms = vector[range.clone()].iter().zip(&scale[range]);
        terms.map(|(x, scale)| (x * if is_scaled { *scale } else { 1.0 }).powi(2)).sum::<f64>().sqrt()
    };
    let size = exact.len();
    [(0..size, true), (0..size, false), (0..3, true), (3..6, true), (6..size, true)]
        .map(|(part, is_scaled)| norm(&error, part, is_scaled) / norm(&exact, 0..size, is_scaled))
}

/// Condition number of the mass matrix scaled to a unit diagonal.
fn condition(truth: &Truth, scale: &[f64]) -> f64 {
    let size = scale.len();
    let scaled = DMatrix::from_fn(size, size, |i, j| truth.mass(i, j) / (scale[i] * scale[j]));
    let eigenvalues = scaled.symmetric_eigenvalues();
    eigenvalues.max() / eigenvalues.min()
}
