//! Accelerations and multipliers of random mechanisms against a dense solve of the same equations from naive bodies.

use ffrf_runtime::joints::{Fixed, JointKind, Prismatic, Revolute, Spherical};
use ffrf_runtime::mechanism::{Attachment, Connection, Constrained};
use ffrf_runtime::{System, VectorSpace};
use ffrf_test_kit::random::Random;

use super::dense::{Evaluation, Saddle, Stage, evaluate, free_equations};
use super::graphs::{Case, SHAPES, Shape, attachment, case, random_case, random_case_of};
use super::tolerances::{RESIDUAL, SOLVED, left_by_regularisation};

/// Beyond this the system counts as singular: the random joints hold what cannot be held. See `redundant` for those.
pub const SINGULAR: f64 = 1e9;

/// Bodies of each mechanism.
const COUNTS: [usize; 4] = [2, 3, 5, 8];
const SEEDS: u64 = 12;

pub struct Tally {
    checked: usize,
    singular: usize,
    worst: f64,
    worst_condition: f64,
    residual: f64,
}

impl Tally {
    pub fn new() -> Self {
        Self { checked: 0, singular: 0, worst: 0.0, worst_condition: 0.0, residual: 0.0 }
    }

    pub fn add(&mut self, case: &Case, found: &Evaluation, stage: Stage<'_>) {
        let (mass, force) = free_equations(case, &case.states, stage);
        let saddle = Saddle::new(&mass, &force, found);
        let condition = saddle.condition();
        if condition.is_nan() || condition > SINGULAR {
            self.singular += 1;
            return;
        }
        let solution = saddle.scaled(found);
        let expected = saddle.matrix.clone().full_piv_lu().solve(&saddle.right).unwrap();
        let error = (&solution - &expected).norm() / expected.norm();
        let left = left_by_regularisation(condition);
        let share = (error - left).max(0.0) / (f64::EPSILON * condition);
        let residual = saddle.residual(&solution);
        assert!(
            error <= SOLVED * f64::EPSILON * condition + left,
            "{}: error {error:e} at condition {condition:e}",
            case.name
        );
        assert!(
            residual <= RESIDUAL + left,
            "{}: residual {residual:e} at condition {condition:e}",
            case.name
        );
        self.checked += 1;
        self.worst = self.worst.max(share);
        self.worst_condition = self.worst_condition.max(condition);
        self.residual = self.residual.max(residual - left);
    }

    pub fn tell(&self, what: &str) {
        eprintln!(
            "{what}: {} mechanisms, {} singular, error / (ε κ) up to {:.2}, κ up to {:.1e}, residual up to {:.1e}",
            self.checked, self.singular, self.worst, self.worst_condition, self.residual
        );
        assert!(self.checked > 4 * self.singular, "{what}: most random mechanisms are regular");
    }
}

pub fn every_case(mut check: impl FnMut(Shape, &Case)) {
    for shape in SHAPES {
        for count in COUNTS {
            for seed in 1..=SEEDS {
                check(shape, &random_case(shape, count, 100 * seed + count as u64));
                check(shape, &random_case_of(shape, &vec![0; count], 100 * seed + count as u64));
            }
        }
    }
}

#[test]
fn random_mechanisms_accelerate_as_a_dense_solve_says() {
    let mut tally = Tally::new();
    every_case(|_, case| tally.add(case, &evaluate(case, &case.states, 0.0, None), None));
    tally.tell("accelerations");
}

/// The second stage of ROS2, from soft modes (γ h ω of 1e-2) to stiff ones (1e3).
#[test]
fn stages_of_linearly_implicit_steps_are_a_dense_solve_too() {
    let mut tally = Tally::new();
    let mut number = 0;
    every_case(|_, case| {
        number += 1;
        let gamma_h = [1e-3, 0.1, 100.0][number % 3];
        let system = Constrained(&case.mechanism);
        let unchanged = system.no_change(&case.states);
        let mut subtracted = system.rates(0.0, &case.states, &unchanged).unwrap();
        subtracted.scale(0.3);
        let stage = Some((gamma_h, &subtracted));
        tally.add(case, &evaluate(case, &case.states, 0.0, stage), stage);
    });
    tally.tell("linearly implicit stages");
}

/// A body that is held at a point can do nothing there: a joint at the same point must not be measured by it alone.
#[test]
fn joints_at_one_point_lose_no_digits() {
    let mut tally = Tally::new();
    let (spherical, fixed) = (JointKind::Spherical(Spherical), JointKind::Fixed(Fixed));
    let (revolute, prismatic) = (JointKind::Revolute(Revolute), JointKind::Prismatic(Prismatic));
    for kinds in
        [[spherical, spherical, fixed], [prismatic, revolute, fixed], [revolute, spherical, spherical]]
    {
        for (seed, modes) in [(1, [0, 0, 0]), (2, [2, 0, 3]), (3, [5, 1, 4]), (4, [0, 4, 0])] {
            let mut random = Random::new(seed);
            let ends = [None, Some(0), Some(1), Some(2)].map(|body| attachment(body, &mut random));
            let at_one_point = |end: Attachment<f64>| Attachment { marker: 0, ..end };
            let joints = kinds.iter().enumerate().map(|(k, kind)| {
                let connection = Connection {
                    kind: *kind,
                    first: at_one_point(ends[k]),
                    second: at_one_point(ends[k + 1]),
                };
                (connection, None)
            });
            let joints = joints.collect();
            let case = case(format!("{kinds:?}, seed {seed}"), &modes, joints, seed, &mut random);
            tally.add(&case, &evaluate(&case, &case.states, 0.0, None), None);
        }
    }
    tally.tell("joints at one point");
    assert_eq!(tally.singular, 0);
}
