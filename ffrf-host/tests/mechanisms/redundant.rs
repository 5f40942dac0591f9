//! Redundant rows: the accelerations are those of a dense solve, the reactions those of least norm.
//!
//! The norm is Σ d λ², where d is the compliance that a row meets at its rigid bodies, and at the frames of flexible ones and
//! in their modes, which makes forces and moments comparable. So joints that are declared twice share the reaction half and half.

use ffrf_runtime::joints::{
    Cylindrical, Fixed, InLine, InPlane, JointKind, Planar, Prismatic, Revolute, Spherical,
};
use ffrf_runtime::mechanism::{Attachment, Connection};
use ffrf_test_kit::random::Random;
use nalgebra::{DMatrix, DVector, UnitQuaternion, Vector3};

use super::dense::{Evaluation, Saddle, evaluate, free_equations, offsets};
use super::graphs::{Case, attachment, case, rigid_case};

/// Accelerations, relative: round-off through systems with a condition number (of what is not redundant) of some thousand.
const SOLVED: f64 = 1e-11;
/// How redundant rows share a reaction: what round-off says of it is divided by the shift μ = 1e-9.
const SHARED: f64 = 20.0 * f64::EPSILON / 1e-9;
/// Singular values below this share of the largest are zero: the rows are redundant by construction, or not at all.
const ZERO: f64 = 1e-9;

/// The expected accelerations and multipliers, and the rank of the rows.
fn expected(case: &Case, found: &Evaluation) -> (DVector<f64>, DVector<f64>, usize) {
    let (mass, force) = free_equations(case, &case.states, None);
    let factors = mass.clone().cholesky().unwrap();
    let gradients = &found.jacobian;
    let compliance = gradients * factors.solve(&gradients.transpose());
    let metric = row_metric(case, &mass, gradients);
    let half = metric.map(f64::sqrt);
    let right = -(&found.bias) - gradients * factors.solve(&force);
    // √d λ by the pseudo-inverse
    let scaled = DMatrix::from_fn(half.len(), half.len(), |i, j| compliance[(i, j)] / (half[i] * half[j]));
    let decomposed = scaled.svd(true, true);
    let zero = ZERO * decomposed.singular_values.max();
    let rank = decomposed.rank(zero);
    let multipliers = decomposed.solve(&right.component_div(&half), zero).unwrap().component_div(&half);
    let accelerations = factors.solve(&(force + gradients.transpose() * &multipliers));
    (accelerations, multipliers, rank)
}

/// d of each row: the compliance of rigid bodies; that of the modes, and that of the frames' diagonal with the modes eliminated.
fn row_metric(case: &Case, mass: &DMatrix<f64>, gradients: &DMatrix<f64>) -> DVector<f64> {
    let offsets = offsets(&case.states);
    DVector::from_fn(gradients.nrows(), |row, _| {
        offsets.windows(2).fold(0.0, |sum, bounds| {
            let (start, modes) = (bounds[0], bounds[1] - bounds[0] - 6);
            let gradient = gradients.row(row).columns(start, 6 + modes).transpose();
            let own = mass.view((start, start), (6 + modes, 6 + modes));
            if modes == 0 {
                return sum + gradient.dot(&own.clone_owned().cholesky().unwrap().solve(&gradient));
            }
            let coupling = own.view((0, 6), (6, modes));
            let factors = own.view((6, 6), (modes, modes)).clone_owned().cholesky().unwrap();
            let follow = factors.solve(&coupling.transpose());
            let modal = factors.solve(&gradient.rows(6, modes).clone_owned());
            let rigid = own.view((0, 0), (6, 6)) - coupling * &follow;
            let effect = gradient.rows(0, 6) - follow.transpose() * gradient.rows(6, modes);
            let frames: f64 = (0..6).map(|i| effect[i] * effect[i] / rigid[(i, i)]).sum();
            sum + frames + gradient.rows(6, modes).dot(&modal)
        })
    })
}

/// Checks a case whose rows have this many redundant ones among them.
pub fn check(case: &Case, redundant: usize) {
    let found = evaluate(case, &case.states, 0.0, None);
    let (accelerations, multipliers, rank) = expected(case, &found);
    assert_eq!(found.bias.len() - rank, redundant, "{}: redundant rows", case.name);
    let error = (&found.accelerations - &accelerations).norm() / accelerations.norm();
    assert!(error < SOLVED, "{}: accelerations off by {error:e}", case.name);
    let error = (&found.multipliers - &multipliers).norm() / multipliers.norm();
    assert!(error < SHARED, "{}: multipliers off by {error:e}", case.name);
    // rows and equations of motion are met
    let (mass, force) = free_equations(case, &case.states, None);
    let saddle = Saddle::new(&mass, &force, &found);
    let residual = saddle.residual(&saddle.scaled(&found));
    assert!(residual < SOLVED, "{}: residual {residual:e}", case.name);
}

/// Two bodies with modes, joined by several joints at the same triads.
fn several(kinds: &[JointKind], modes: [usize; 2], seed: u64) -> Case {
    let mut random = Random::new(seed);
    let ends = [attachment(Some(0), &mut random), attachment(Some(1), &mut random)];
    let joints = kinds
        .iter()
        .map(|kind| (Connection { kind: *kind, first: ends[0], second: ends[1] }, None))
        .chain([(
            Connection {
                kind: JointKind::Spherical(Spherical),
                first: attachment(None, &mut random),
                second: attachment(Some(0), &mut random),
            },
            None,
        )])
        .collect();
    case(format!("{kinds:?} on {modes:?} modes, seed {seed}"), &modes, joints, seed, &mut random)
}

#[test]
fn joints_with_rows_in_common_are_solved_with_reactions_of_least_norm() {
    let (revolute, spherical) = (JointKind::Revolute(Revolute), JointKind::Spherical(Spherical));
    let (fixed, in_line) = (JointKind::Fixed(Fixed), JointKind::InLine(InLine));
    let (cylindrical, prismatic) = (JointKind::Cylindrical(Cylindrical), JointKind::Prismatic(Prismatic));
    let (planar, in_plane) = (JointKind::Planar(Planar), JointKind::InPlane(InPlane));
    for (kinds, redundant) in [
        (vec![revolute, revolute], 5),
        (vec![fixed, fixed], 6),
        (vec![prismatic, prismatic, prismatic], 10),
        (vec![revolute, spherical], 3),
        (vec![cylindrical, in_line], 2),
        (vec![planar, in_plane, planar], 4),
    ] {
        for modes in [[0, 0], [0, 3], [2, 5], [4, 1]] {
            for seed in 1..=4 {
                check(&several(&kinds, modes, 100 * seed), redundant);
            }
        }
    }
}

#[test]
fn a_joint_declared_twice_carries_half_of_the_reaction_each_time() {
    let revolute = JointKind::Revolute(Revolute);
    for (modes, seed) in [([0, 0], 1), ([3, 2], 2), ([1, 5], 3)] {
        let [once, twice] = [vec![revolute], vec![revolute; 2]].map(|kinds| {
            let case = several(&kinds, modes, seed);
            evaluate(&case, &case.states, 0.0, None)
        });
        let difference = (&once.accelerations - &twice.accelerations).norm();
        assert!(difference < SOLVED * once.accelerations.norm(), "{difference:e}");
        for k in 0..5 {
            let half = 0.5 * once.multipliers[k];
            let size = once.multipliers.norm();
            assert!((twice.multipliers[k] - half).abs() < SHARED * size, "row {k}");
            assert!((twice.multipliers[5 + k] - half).abs() < SHARED * size, "row {k}");
        }
    }
}

/// A planar four-bar of revolutes in space, at rest under forces of any direction.
#[test]
fn a_rigid_four_bar_has_three_redundant_rows() {
    let mut random = Random::new(5);
    let corners = [[0.0, 0.0], [0.2, 0.5], [0.9, 0.6], [0.8, 0.0]].map(|[x, y]| Vector3::new(x, y, 0.0));
    let mut joints = Vec::new();
    let marker = |body: usize, k: usize| Attachment {
        body: Some(body),
        marker: 2 + k,
        position: Vector3::zeros(),
        orientation: UnitQuaternion::identity(),
    };
    let ground = |position: Vector3<f64>| Attachment {
        body: None,
        marker: 0,
        position,
        orientation: UnitQuaternion::identity(),
    };
    let kind = JointKind::Revolute(Revolute);
    for (first, second) in [
        (ground(corners[0]), marker(0, 0)),
        (marker(0, 1), marker(1, 0)),
        (marker(1, 1), marker(2, 0)),
        (marker(2, 1), ground(corners[3])),
    ] {
        joints.push((Connection { kind, first, second }, None));
    }
    let points = [[corners[0], corners[1]], [corners[1], corners[2]], [corners[2], corners[3]]];
    let case = rigid_case("four-bar", &points, joints, &mut random);
    check(&case, 3);
}
