//! What the undeformed lever arm of (199)-(201) and (215) costs in accuracy, on the connecting rod and a random body.
//!
//! `cargo test -p ffrf --test macro_bodies lever_arms -- --nocapture` prints the figures of `docs/theory/lever_arms.md`.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

use ffrf::forms::LeverArm::{self, Deformed, Undeformed};
use ffrf::forms::{force_about, marker_velocity_jacobian};
use ffrf::nalgebra::{SMatrix, SVector, Vector3};
use ffrf::{FlexibleBody, GeneralisedForce, Marker, NamedMarkers, flexible_body};

flexible_body! {
    /// Mass-normalised free-free modes about the centre of mass.
    struct ConnectingRod { model: "models/conrod.ffrf.json" }
}

flexible_body! {
    /// Modes that move the centre of mass.
    struct RandomBody { model: "tests/models/random_m4.ffrf.json" }
}

/// Differences of accelerations of order g or of a unit of the load, through one solution.
const SOLVED: f64 = 1e-10;
/// Deviation from proportionality where the deflection is up to a thousandth of the lever arm: the next order, by ten.
const LINEAR: f64 = 0.02;

/// Coordinates of one mode that move `marker` by `ratio` of its distance from the origin.
fn deflected<const M: usize>(marker: &Marker<SVector<f64, M>>, mode: usize, ratio: f64) -> SVector<f64, M> {
    let mut q = SVector::zeros();
    q[mode] = 1.0;
    let shift = (marker.position(&q) - marker.position).norm();
    q * (ratio * marker.position.norm() / shift)
}

/// ω̇ from rest under a unit force at the marker, the worst of modes and directions: its error over its largest value.
fn force_error<const M: usize, const N: usize>(
    body: &impl FlexibleBody<Modal = SVector<f64, M>>,
    marker: &Marker<SVector<f64, M>>,
    ratio: f64,
) -> f64 {
    let (mut error, mut largest) = (0.0_f64, 0.0_f64);
    for mode in 0..M {
        let q = deflected(marker, mode, ratio);
        // The elastic force is left out: its part in ω̇ has nothing to do with the lever arm.
        let internal = body.internal_force(&q, &SVector::zeros());
        for direction in [Vector3::x(), Vector3::y(), Vector3::z()] {
            let spin = |lever_arm: LeverArm| {
                let about = force_about::<M, N, f64>(marker, &q, &direction, lever_arm);
                let mut force = GeneralisedForce::from_vector(&about);
                force.modal += internal;
                body.forward_dynamics(&q, &Vector3::zeros(), &SVector::zeros(), &force).angular
            };
            error = error.max((spin(Undeformed) - spin(Deformed)).norm());
            largest = largest.max(spin(Deformed).norm());
        }
    }
    error / largest
}

/// Power of a spherical joint at the marker over |λ| |ω| |x + Ψ q|, the worst of modes and axes; the body turns freely.
fn joint_power<const M: usize, const N: usize>(
    marker: &Marker<SVector<f64, M>>,
    ratio: f64,
    lever_arm: LeverArm,
) -> f64 {
    let mut worst = 0.0_f64;
    for mode in 0..M {
        let q = deflected(marker, mode, ratio);
        for omega in [Vector3::x(), Vector3::y(), Vector3::z()] {
            let velocity = -omega.cross(&marker.position(&q));
            let mut velocities = SVector::<f64, N>::zeros();
            velocities.fixed_rows_mut::<3>(0).copy_from(&velocity);
            velocities.fixed_rows_mut::<3>(3).copy_from(&omega);
            let jacobian: SMatrix<f64, 3, N> = marker_velocity_jacobian(marker, &q, lever_arm);
            // The worst direction of λ is that of C w.
            worst = worst.max((jacobian * velocities).norm() / marker.position(&q).norm());
        }
    }
    worst
}

/// Spurious ω̇ times size over g in free fall from rest, the worst of modes.
fn fall<const M: usize>(
    body: &impl FlexibleBody<Modal = SVector<f64, M>>,
    marker: &Marker<SVector<f64, M>>,
    ratio: f64,
    lever_arm: LeverArm,
) -> f64 {
    let gravity = Vector3::new(0.0, 0.0, -9.81);
    let size = marker.position.norm();
    let mut worst = 0.0_f64;
    for mode in 0..M {
        let q = deflected(marker, mode, ratio);
        let mut force = body.gravity_force(&q, &gravity);
        if lever_arm == Undeformed {
            // Every node's weight about A x_n: the moment of the undeformed body.
            force.moment = body.gravity_force(&SVector::zeros(), &gravity).moment;
        }
        force.modal += body.internal_force(&q, &SVector::zeros());
        let acceleration = body.forward_dynamics(&q, &Vector3::zeros(), &SVector::zeros(), &force);
        worst = worst.max(acceleration.angular.norm() * size / 9.81);
    }
    worst
}

#[test]
fn the_error_is_the_deflection_over_the_lever_arm() {
    let (rod, random) = (ConnectingRod, RandomBody);
    let (small_end, tip) = (&rod.marker("SMALL_END").unwrap(), &random.marker("tip").unwrap());
    println!("|Ψq|/|x|   rod: ω̇   rod: joint   random: ω̇   random: joint   rod falls   random falls");
    let mut rows = Vec::new();
    for ratio in [1e-4, 1e-3, 1e-2, 1e-1] {
        let row = [
            force_error::<8, 14>(&rod, small_end, ratio),
            joint_power::<8, 14>(small_end, ratio, Undeformed),
            force_error::<4, 10>(&random, tip, ratio),
            joint_power::<4, 10>(tip, ratio, Undeformed),
            fall::<8>(&rod, small_end, ratio, Undeformed),
            fall::<4>(&random, tip, ratio, Undeformed),
        ];
        println!(
            "{ratio:8.0e} {:9.1e} {:12.1e} {:11.1e} {:15.1e} {:11.1e} {:14.1e}",
            row[0], row[1], row[2], row[3], row[4], row[5]
        );
        // Nothing of the kind with the deformed lever arm.
        assert!(joint_power::<8, 14>(small_end, ratio, Deformed) < SOLVED);
        assert!(joint_power::<4, 10>(tip, ratio, Deformed) < SOLVED);
        assert!(fall::<8>(&rod, small_end, ratio, Deformed) < SOLVED);
        assert!(fall::<4>(&random, tip, ratio, Deformed) < SOLVED);
        // Modes that leave the centre of mass in place: a uniform field has no moment about it, deformed or not.
        assert!(row[4] < SOLVED, "{:e}", row[4]);
        rows.push(row);
    }
    for column in [0, 1, 2, 3, 5] {
        let growth = rows[1][column] / rows[0][column];
        assert!((growth / 10.0 - 1.0).abs() < LINEAR, "column {column} grows by {growth}");
    }
}
