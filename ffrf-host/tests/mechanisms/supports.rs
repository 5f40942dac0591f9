//! Bodies that stand on supports, in evaluations that ask for motions alone: accelerations against a dense solve of the equations of
//! all bodies and joints, and corrections against what least kinetic energy says.

use ffrf_runtime::System;
use ffrf_runtime::joints::{JointKind, Revolute};
use ffrf_runtime::mechanism::{Assembly, Connection, Constrained};
use ffrf_test_kit::every_joint::every_kind;
use ffrf_test_kit::random::Random;
use nalgebra::DVector;

use super::accelerations::{SINGULAR, every_case};
use super::dense::{Saddle, evaluate, free_equations, subtracted_motion};
use super::graphs::{Case, attachment, case};
use super::tolerances::{SOLVED, left_by_regularisation};

/// Motions that each support of a mechanism leaves.
fn left_by_supports(case: &Case) -> Vec<usize> {
    case.mechanism.plan().joints.iter().filter(|joint| joint.is_support).map(|joint| 6 - joint.rows).collect()
}

/// Whether accelerations without reactions are those of the dense system, as exactly as its condition allows. `None` where it
/// counts as singular.
fn check(case: &Case) -> Option<()> {
    let found = evaluate(case, &case.states, 0.0, None);
    let (mass, force) = free_equations(case, &case.states, None);
    let saddle = Saddle::new(&mass, &force, &found);
    let condition = saddle.condition();
    if condition.is_nan() || condition > SINGULAR {
        return None;
    }
    let expected = saddle.matrix.clone().full_piv_lu().solve(&saddle.right)?;
    let system = Constrained(&case.mechanism);
    let rates = system.rates(0.0, &case.states, &system.no_change(&case.states)).ok()?;
    let motion = subtracted_motion(&case.states, &rates).component_div(&saddle.scale.rows(0, mass.nrows()));
    let error = (motion - expected.rows(0, mass.nrows())).norm() / expected.norm();
    let bound = SOLVED * f64::EPSILON * condition + left_by_regularisation(condition);
    assert!(error <= bound, "{}: error {error:e} at condition {condition:e}", case.name);
    Some(())
}

#[test]
fn bodies_on_supports_accelerate_as_a_dense_solve_says() {
    let mut seen = [0; 4];
    every_case(|_, case| {
        let left = left_by_supports(case);
        if !left.is_empty() && check(case).is_some() {
            left.iter().for_each(|left| seen[*left] += 1);
        }
    });
    eprintln!("supports that leave 0 to 3 motions: {seen:?}");
    assert!(seen.iter().all(|count| *count >= 4), "{seen:?}");
}

/// A bridge between two supports, whichever end of its joint each body is, with and without modes between them.
#[test]
fn either_end_of_a_support_may_be_the_ground() {
    let kinds = every_kind::<f64>();
    let mut checked = 0;
    let one_row = *kinds.iter().find(|kind| kind.row_count() == 1).unwrap();
    for (number, kind) in kinds.iter().enumerate().filter(|(_, kind)| kind.row_count() >= 3) {
        for (seed, modes) in [(1, [0, 2, 0]), (2, [0, 0, 0])] {
            let mut random = Random::new(seed + number as u64);
            let revolute = JointKind::Revolute(Revolute);
            let ends = [(None, Some(0)), (Some(2), None), (Some(0), Some(1)), (Some(1), Some(2))];
            let joints = ends.iter().zip([*kind, *kind, revolute, one_row]);
            let joints = joints.map(|((first, second), kind)| {
                let (first, second) = (attachment(*first, &mut random), attachment(*second, &mut random));
                (Connection { kind, first, second }, None)
            });
            let joints = joints.collect();
            let case = case(format!("{kind:?}, seed {seed}"), &modes, joints, seed, &mut random);
            assert_eq!(left_by_supports(&case).len(), 2, "{}", case.name);
            checked += usize::from(check(&case).is_some());
        }
    }
    assert!(checked >= 40, "{checked}");
}

/// A projection moves places by M⁻¹ times a combination of the gradients of all rows, those of supports included.
#[test]
fn corrections_are_those_of_least_kinetic_energy() {
    let mut seen = 0;
    every_case(|_, case| {
        if left_by_supports(case).is_empty() {
            return;
        }
        let found = evaluate(case, &case.states, 0.0, None);
        let (mass, _) = free_equations(case, &case.states, None);
        let system = Constrained(&case.mechanism);
        let Ok((after, _)) = system.project(0.0, case.states.clone(), None, 1, f64::MAX) else { return };
        let moved = after.iter().zip(&case.states).flat_map(|(after, before)| {
            let linear = before.to_body(&(after.position - before.position));
            // the inverse of the map of Cayley
            let turned = before.orientation.inverse() * after.orientation;
            let angular = turned.imag() * (2.0 / turned.scalar());
            let modal = &after.modal_coordinates.0 - &before.modal_coordinates.0;
            linear.iter().chain(&angular).chain(&modal).copied().collect::<Vec<_>>()
        });
        let change = DVector::from_vec(moved.collect());
        let momentum = &mass * &change;
        let rows = found.jacobian.transpose();
        let left = &momentum - &rows * rows.clone().svd(true, true).solve(&momentum, 1e-12).unwrap();
        // the map is ill-conditioned near half a turn, which random residuals ask for
        assert!(left.norm() <= 1e-7 * momentum.norm(), "{}: {:e}", case.name, left.norm() / momentum.norm());
        seen += 1;
    });
    assert!(seen > 50, "{seen}");
}
