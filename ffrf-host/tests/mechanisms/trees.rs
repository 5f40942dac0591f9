//! Which mechanisms are swept over as trees, and what a sweep says of bodies without mass. That sweeps solve the equations:
//! `accelerations`, on chains, trees and stars of bodies with up to five modes.

use ffrf_host::{HostBody, HostMechanism};
use ffrf_runtime::joints::{JointKind, Revolute, Spherical};
use ffrf_runtime::mechanism::{Assembly, Attachment, Connection, Constrained};
use ffrf_runtime::{Marker, State, StepError, System};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use super::graphs::{SHAPES, Shape, random_case_of};

#[test]
fn mechanisms_without_loops_and_with_few_modes_are_swept_over() {
    for shape in SHAPES {
        let is_tree = matches!(shape, Shape::Chain | Shape::FreeChain | Shape::Tree | Shape::Star);
        for (modes, few) in [([0, 0, 0, 0], true), ([9, 0, 3, 9], true), ([0, 13, 0, 0], false)] {
            let case = random_case_of(shape, &modes, 7);
            let branches = case.mechanism.plan().branches;
            assert_eq!(!branches.is_empty(), is_tree && few, "{}", case.name);
            if branches.is_empty() {
                continue;
            }
            // each body once, after its parent
            let mut bodies: Vec<usize> = branches.iter().map(|branch| branch.body).collect();
            bodies.sort_unstable();
            assert_eq!(bodies, [0, 1, 2, 3], "{}", case.name);
            for (place, branch) in branches.iter().enumerate() {
                assert!(branch.parent.is_none_or(|parent| parent < place), "{}", case.name);
            }
        }
    }
}

/// A chain of two bodies, of which the second has this mass and inertia.
fn with_second(
    mass: f64,
    inertia: f64,
    kind: JointKind,
) -> (HostMechanism, Vec<State<ffrf_host::HostModal>>) {
    let bodies = [(1.0, 0.1), (mass, inertia)].map(|(mass, inertia)| {
        let body = HostBody::rigid(mass, Vector3::zeros(), &(Matrix3::identity() * inertia));
        let none = ffrf_host::HostModal::zeros(0);
        (body, vec![Marker::rigid(Vector3::zeros(), &none), Marker::rigid(Vector3::x(), &none)])
    });
    let states = bodies.iter().map(|(body, _)| State::at_rest(body)).collect();
    let on = |body, marker| Attachment::on_body(body, marker, UnitQuaternion::identity());
    let ground = Attachment::on_ground(Vector3::zeros(), UnitQuaternion::identity());
    let joints = vec![
        (Connection { kind: JointKind::Revolute(Revolute), first: ground, second: on(0, 0) }, None),
        (Connection { kind, first: on(0, 1), second: on(1, 0) }, None),
    ];
    (HostMechanism::new(bodies.into(), joints, Vector3::new(0.0, -9.81, 0.0)).unwrap(), states)
}

#[test]
fn motions_that_meet_no_mass_are_an_error_that_names_the_body() {
    for kind in [JointKind::Revolute(Revolute), JointKind::Spherical(Spherical)] {
        let rates = |mass, inertia| {
            let (mechanism, states) = with_second(mass, inertia, kind);
            assert_eq!(mechanism.plan().branches.len(), 2);
            Constrained(&mechanism).rates(0.0, &states, &mechanism.no_change(&states)).map(|_| ())
        };
        assert_eq!(rates(1.0, 0.1), Ok(()));
        assert_eq!(rates(0.0, 0.0), Err(StepError::BodyNotPositive { body: 1, amplitude: 0.0 }));
        // a mass at the joint itself does not hold it
        assert_eq!(rates(1.0, 0.0), Err(StepError::BodyNotPositive { body: 1, amplitude: 0.0 }));
    }
}
