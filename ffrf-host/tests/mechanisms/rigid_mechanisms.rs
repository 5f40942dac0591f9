//! Rigid mechanisms against closed forms.
#![allow(clippy::unwrap_used)]

use ffrf_host::{HostBody, HostMechanism};
use ffrf_runtime::joints::{JointKind, Prismatic, Revolute};
use ffrf_runtime::mechanism::{Attachment, Connection, Constrained};
use ffrf_runtime::{FlexibleBody, Marker, State, step_linearly_implicit, step_rk4};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

fn at(body: Option<usize>, marker: usize, position: Vector3<f64>) -> Attachment<f64> {
    Attachment { body, marker, position, orientation: UnitQuaternion::identity() }
}

fn marker(body: &HostBody, x: f64) -> Marker<ffrf_host::HostModal, f64> {
    Marker::rigid(Vector3::new(x, 0.0, 0.0), &body.undeformed())
}

fn bar() -> HostBody {
    HostBody::rigid(
        1.0,
        Vector3::new(0.5, 0.0, 0.0),
        &Matrix3::from_diagonal(&Vector3::new(1e-4, 1.0 / 12.0, 1.0 / 12.0)),
    )
}

/// A chain of bars that begins at the origin, horizontal, in the xy plane.
fn chain(count: usize) -> (HostMechanism, Vec<State<ffrf_host::HostModal>>) {
    let bodies: Vec<_> = (0..count)
        .map(|_| {
            let b = bar();
            let m = vec![marker(&b, 0.0), marker(&b, 1.0)];
            (b, m)
        })
        .collect();
    let joints = (0..count)
        .map(|i| {
            let first =
                if i == 0 { at(None, 0, Vector3::zeros()) } else { at(Some(i - 1), 1, Vector3::zeros()) };
            (
                Connection {
                    kind: JointKind::Revolute(Revolute),
                    first,
                    second: at(Some(i), 0, Vector3::zeros()),
                },
                None,
            )
        })
        .collect();
    let states = (0..count)
        .map(|i| {
            let mut s = State::at_rest(&bar());
            s.position.x = i as f64;
            s
        })
        .collect();
    (HostMechanism::new(bodies, joints, Vector3::new(0.0, -9.81, 0.0)).unwrap(), states)
}

fn energy(mechanism: &HostMechanism, states: &[State<ffrf_host::HostModal>]) -> f64 {
    use ffrf_runtime::Observables;
    mechanism
        .bodies()
        .iter()
        .zip(states)
        .map(|(b, s)| {
            b.kinetic_energy(&s.modal_coordinates, &s.body_velocity(), &s.angular_velocity, &s.modal_rates)
                - mechanism
                    .gravity()
                    .dot(&(s.position * b.mass() + s.to_inertial(&b.first_mass_moment(&s.modal_coordinates))))
        })
        .sum()
}

#[test]
fn chains_keep_energy_and_constraints() {
    for count in [1, 2, 5] {
        let (mechanism, mut states) = chain(count);
        let system = Constrained(&mechanism);
        let start = energy(&mechanism, &states);
        let mut worst = 0.0_f64;
        for k in 0..1000 {
            let (next, report) = step_rk4(&system, &states, k as f64 * 1e-3, 1e-3).unwrap();
            states = next;
            worst = worst.max(report.drift.position);
        }
        eprintln!(
            "{count}: energy change {:e}, drift {worst:e}, tip {:?}",
            energy(&mechanism, &states) - start,
            states[count - 1].position
        );
        assert!((energy(&mechanism, &states) - start).abs() < 1e-6);
    }
}

#[test]
fn redundant_slider_crank() {
    // three revolutes and a prismatic joint in space: three redundant rows
    let crank = HostBody::rigid(0.5, Vector3::new(0.1, 0.0, 0.0), &(Matrix3::identity() * 1e-3));
    let rod = HostBody::rigid(0.5, Vector3::new(0.2, 0.0, 0.0), &(Matrix3::identity() * 5e-3));
    let slider = HostBody::rigid(0.3, Vector3::zeros(), &(Matrix3::identity() * 1e-3));
    let along_x = UnitQuaternion::rotation_between(&Vector3::z(), &Vector3::x()).unwrap();
    let bodies = vec![
        (crank.clone(), vec![marker(&crank, 0.0), marker(&crank, 0.2)]),
        (rod.clone(), vec![marker(&rod, 0.0), marker(&rod, 0.4)]),
        (slider.clone(), vec![marker(&slider, 0.0)]),
    ];
    let revolute = |a, b| (Connection { kind: JointKind::Revolute(Revolute), first: a, second: b }, None);
    let o = Vector3::zeros();
    let mut guide = (
        Connection {
            kind: JointKind::Prismatic(Prismatic),
            first: at(None, 0, o),
            second: at(Some(2), 0, o),
        },
        None,
    );
    guide.0.first.orientation = along_x;
    guide.0.second.orientation = along_x;
    let joints = vec![
        revolute(at(None, 0, o), at(Some(0), 0, o)),
        revolute(at(Some(0), 1, o), at(Some(1), 0, o)),
        revolute(at(Some(1), 1, o), at(Some(2), 0, o)),
        guide,
    ];
    let mechanism = HostMechanism::new(bodies, joints, Vector3::new(0.0, -9.81, 0.0)).unwrap();
    // crank along x, rod along x: a dead centre with the crank turning
    let mut states: Vec<_> = (0..3).map(|i| State::at_rest(&mechanism.bodies()[i])).collect();
    states[1].position.x = 0.2;
    states[2].position.x = 0.6;
    states[0].angular_velocity.z = 30.0;
    states[1].velocity.y = 6.0;
    states[1].angular_velocity.z = -15.0;
    for implicit in [false, true] {
        let mut states = states.clone();
        let system = Constrained(&mechanism);
        let start = energy(&mechanism, &states);
        let mut worst = 0.0_f64;
        for k in 0..2000 {
            let t = k as f64 * 1e-4;
            let (next, report) = if implicit {
                step_linearly_implicit(&system, &states, t, 1e-4)
            } else {
                step_rk4(&system, &states, t, 1e-4)
            }
            .unwrap();
            states = next;
            worst = worst.max(report.drift.position);
        }
        let change = energy(&mechanism, &states) - start;
        eprintln!("{implicit}: energy {start}, change {change:e}, drift {worst:e}");
        assert!(change.abs() < if implicit { 1e-3 } else { 1e-8 });
    }
}
