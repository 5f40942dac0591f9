//! The rows of every kind of joint are exact derivatives of their residuals, on bodies with and without modes and on the
//! ground, far from where the joints are met. By dual numbers: two markers on prescribed motions give g(t), ġ and g̈.

use super::motions::{Prescribed, wave};
use ffrf_runtime::joints::Joint;
use ffrf_runtime::nalgebra::{Quaternion, UnitQuaternion, Vector3};
use ffrf_runtime::relations::Row;
use ffrf_runtime::{MarkerMotion, PlacedMarker};
use ffrf_test_kit::bodies::cloud;
use ffrf_test_kit::every_joint::every_kind;
use ffrf_test_kit::tolerances::DERIVED;
use num_dual::{Dual2, Dual2_64};

/// One end of a joint at one time: as joints see it, with the accelerations (without bias) that go with it, and as a
/// function of time.
pub struct End {
    pub motion: MarkerMotion,
    acceleration: [Vector3<f64>; 2],
    pub path: MarkerMotion<Dual2_64>,
}

/// A triad that is turned against its marker, as an attachment has it.
fn turn(seed: usize) -> UnitQuaternion<f64> {
    let component = |k: usize| wave(k + 50 * seed, 0.3);
    UnitQuaternion::from_scaled_axis(Vector3::new(component(0), component(1), component(2)))
}

fn constant(orientation: &UnitQuaternion<f64>) -> UnitQuaternion<Dual2_64> {
    UnitQuaternion::new_unchecked(Quaternion::from(orientation.coords.map(Dual2_64::from)))
}

/// A marker of a body with `M` modes.
fn moving<const M: usize, const N: usize>(seed: usize, time: f64) -> End {
    let marker = cloud::<M, N>(seed as u64, 30.0, 0.0).1[seed % 8];
    let prescribed = Prescribed::<M>::at(seed, time);
    let placed = PlacedMarker::new(&marker, &prescribed.state);
    let dual_marker = marker.cast::<Dual2_64>();
    let mut end = End {
        motion: placed.motion(&prescribed.state),
        acceleration: placed.twist(&prescribed.acceleration),
        path: PlacedMarker::new(&dual_marker, &prescribed.place).motion(&prescribed.place),
    };
    end.motion.orientation *= turn(seed);
    end.path.orientation *= constant(&turn(seed));
    end
}

fn ground(seed: usize) -> End {
    let position = Vector3::from_fn(|k, _| wave(k + 9 * seed, 0.1));
    End {
        motion: MarkerMotion::fixed(position, turn(seed)),
        acceleration: [Vector3::zeros(); 2],
        path: MarkerMotion::fixed(position.map(Dual2_64::from), constant(&turn(seed))),
    }
}

/// The ground, or a body with `modes` modes.
pub fn end(modes: Option<usize>, seed: usize, time: f64) -> End {
    match modes {
        None => ground(seed),
        Some(0) => moving::<0, 6>(seed, time),
        Some(1) => moving::<1, 7>(seed, time),
        Some(2) => moving::<2, 8>(seed, time),
        Some(3) => moving::<3, 9>(seed, time),
        Some(4) => moving::<4, 10>(seed, time),
        Some(_) => moving::<5, 11>(seed, time),
    }
}

/// Ground on either side, then bodies with every number of modes on both sides.
pub fn pairs() -> Vec<[Option<usize>; 2]> {
    let mut pairs = Vec::new();
    for modes in 0..=5 {
        pairs.extend([[None, Some(modes)], [Some(modes), None], [Some(modes), Some(5 - modes)]]);
    }
    pairs
}

/// What the sums of a row are made of, which is what round-off goes by.
fn size(row: &Row, ends: [&End; 2]) -> f64 {
    let gradients = [&row.first, &row.second];
    gradients.iter().zip(ends).fold(1.0 + row.bias.abs(), |size, (gradient, end)| {
        let MarkerMotion { velocity, angular_velocity, acceleration_bias, angular_acceleration_bias, .. } =
            &end.motion;
        let [linear, angular] = &end.acceleration;
        size + gradient.force.norm() * (velocity.norm() + linear.norm() + acceleration_bias.norm())
            + gradient.moment.norm()
                * (angular_velocity.norm() + angular.norm() + angular_acceleration_bias.norm())
    })
}

#[test]
fn rows_are_the_derivatives_of_their_residuals() {
    let mut biases = Vec::new();
    for (number, (kind, dual_kind)) in every_kind().iter().zip(&every_kind::<Dual2_64>()).enumerate() {
        let mut largest = 0.0_f64;
        for (case, pair) in pairs().into_iter().enumerate() {
            for time in [0.0, 0.4, 1.3] {
                let seeds = [1 + case % 7, 8 + (case + number) % 9];
                let ends = [end(pair[0], seeds[0], time), end(pair[1], seeds[1], time)];
                let [first, second] = [&ends[0], &ends[1]];
                let driven = wave(number, Dual2::new(time, 1.0, 0.0));
                let rows = kind.rows(&first.motion, &second.motion, &[driven.re, driven.v1, driven.v2]);
                // the residual alone makes the truth: the drive comes without its rates
                let zero = Dual2_64::from(0.0);
                let exact = dual_kind.rows(&first.path, &second.path, &[driven, zero, zero]);
                assert_eq!(rows.len(), kind.row_count(), "{kind:?}");
                for (k, (row, exact)) in rows.iter().zip(exact.iter()).enumerate() {
                    let bound = DERIVED * size(&row, [first, second]);
                    let exact = exact.residual;
                    let rate = row.velocity(&first.motion, &second.motion);
                    let accelerations = row.first.power(&first.acceleration[0], &first.acceleration[1])
                        + row.second.power(&second.acceleration[0], &second.acceleration[1]);
                    let second_rate = accelerations + row.whole_bias(&first.motion, &second.motion);
                    for (what, found, expected) in [
                        ("g", row.residual, exact.re),
                        ("its rate", rate, exact.v1),
                        ("its second rate", second_rate, exact.v2),
                    ] {
                        assert!(
                            (found - expected).abs() <= bound,
                            "{kind:?} between {pair:?}, row {k} `{}`, {what}: {found} and {expected}",
                            kind.row_name(k)
                        );
                    }
                    assert!(!kind.row_name(k).is_empty());
                    largest = largest.max(exact.v2.abs()).max(exact.v1.abs());
                    biases.push(row.bias);
                }
                assert_eq!(kind.row_name(kind.row_count()), "", "{kind:?}");
            }
        }
        // no joint is seen at rest
        assert!(largest > 0.1, "{kind:?}");
    }
    assert!(biases.iter().any(|bias| bias.abs() > 1.0));
}

/// The forces that a row exerts on both ends, seen from the ground, balance: a joint adds no momentum to the world.
#[test]
fn forces_of_rows_balance_and_so_do_their_moments() {
    for kind in every_kind() {
        for (case, pair) in pairs().into_iter().enumerate() {
            let ends = [end(pair[0], 1 + case, 0.4), end(pair[1], 20 + case, 0.4)];
            let motions = [&ends[0].motion, &ends[1].motion];
            for row in kind.rows(motions[0], motions[1], &[0.2, 0.3, 0.4]).iter() {
                let mut force = Vector3::zeros();
                let mut moment = Vector3::zeros();
                let mut size = 0.0;
                for (wrench, end) in [row.first, row.second].iter().zip(motions) {
                    force += wrench.force;
                    moment += wrench.moment + end.position.cross(&wrench.force);
                    size += wrench.moment.norm() + end.position.norm() * wrench.force.norm();
                }
                assert!(force.norm() <= DERIVED, "{kind:?}: {force}");
                // away from the place where it is met, a coincidence is no pair of opposite forces on one line
                let apart = motions[1].position - motions[0].position;
                let lever = apart.cross(&row.second.force);
                let offset = (moment - lever).norm().min(moment.norm());
                assert!(offset <= DERIVED * (1.0 + size), "{kind:?}: {moment}");
            }
        }
    }
}
