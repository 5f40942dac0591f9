//! Every kind of joint and force element in one mechanism.

use ffrf::mechanism;
use ffrf::mechanism::{Assembly, Constrained};
use ffrf_codegen::mechanism::KNOWN_JOINTS;

use crate::bodies::Rod;

mechanism! {
    /// A rod and twelve blocks that hang on it.
    pub struct Everything {
        bodies: {
            rod: free Rod,
            blocks: [rigid { mass: 1.0, inertia: [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]] }; 12],
            far: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], center_of_mass: [0.1, 0.0, 0.0] },
        },
        gravity: [0.0, 0.0, -9.81],
        joints: {
            fixed: fixed(rod.SMALL_END, blocks[0]),
            revolute: revolute(rod.SMALL_END, blocks[1], axis: -y),
            spherical: spherical(rod.SMALL_END, blocks[2]),
            universal: universal(rod.SMALL_END, blocks[3], axis: (x, [0.0, 1.0, 0.0])),
            cylindrical: cylindrical(rod.SMALL_END, blocks[4], axis: [1.0, 1.0, 0.0]),
            prismatic: prismatic(rod.SMALL_END, blocks[5], axis: x),
            planar: planar(rod.SMALL_END, blocks[6], axis: z),
            distance: distance(rod.SMALL_END, blocks[7].at([0.3, 0.0, 0.0]), length: 0.3),
            in_line: in_line(rod.SMALL_END, blocks[8], axis: x),
            in_plane: in_plane(rod.SMALL_END, blocks[9], axis: x),
            constant_orientation: constant_orientation(rod, blocks[10]),
            generic: generic(rod, blocks[11], translation: [true, false, true], rotation: [false, true, false]),
            anchor: in_plane(ground, far, axis: z),
        },
        drives: {
            turn: angle(cylindrical, polynomial: [0.0, 0.0, 1.0]),
            shift: position(cylindrical, function: travel),
            slide: position(prismatic),
        },
        forces: {
            spring: spring(ground, far, stiffness: 10.0, damping: 0.1, rest_length: 0.1),
            coil: torsion_spring(revolute, stiffness: 1.0),
            bushing: bushing(ground, blocks[10], stiffness: [10.0; 6], damping: [0.1; 6]),
            push: force(far.at([0.0, 0.1, 0.0]), value: [1.0, 0.0, 0.0], frame: body),
            twist: moment(far, value: [0.0, 0.0, 0.1]),
            motor: actuator(spherical),
        },
        sensors: { tilt: orientation(far), pull: reaction_force(anchor), hold: reaction_moment(fixed) },
    }
}

/// Position, speed and acceleration along the axis.
fn travel(time: f64) -> [f64; 3] {
    [0.01 * time, 0.01, 0.0]
}

#[test]
fn macro_and_runtime_know_the_same_kinds() {
    let model = Everything::new(Rod);
    let rows = |name: &str| {
        let joint = Everything::JOINTS.iter().position(|joint| *joint == name).unwrap();
        assert_eq!(model.plan().joints[joint].rows, model.connections()[joint].kind.row_count(), "{name}");
        model.plan().joints[joint].rows
    };
    for known in &KNOWN_JOINTS {
        let expected = known.rows.unwrap_or(3);
        assert_eq!(rows(known.name), expected, "{}", known.name);
    }
    for drive in ["turn", "shift", "slide"] {
        assert_eq!(rows(drive), 1);
    }
}

#[test]
fn all_of_them_move_together() {
    let mut model = Everything::new(Rod);
    model.motor.kind.moment = 0.05;
    let mut mechanism = model.in_motion(model.at_rest());
    mechanism.assemble().unwrap();
    for _ in 0..20 {
        let report = mechanism.step_linearly_implicit(1e-4).unwrap();
        assert!(report.drift.position < 1e-6, "{report:?}");
    }
    let residuals = Constrained(&model)
        .evaluate(mechanism.time, mechanism.state, None, |_, storage| {
            let rows = storage.evaluated().flat_map(|joint| joint.rows.iter());
            rows.fold(0.0_f64, |largest, row| largest.max(row.residual.abs()))
        })
        .unwrap();
    assert!(residuals < 1e-12, "{residuals:.2e}");
    assert!(model.tilt(&mechanism.state).angle() > 0.0);
    assert!(model.pull(mechanism.time, &mechanism.state).unwrap().norm() > 1.0);
    assert!(model.hold(mechanism.time, &mechanism.state).unwrap().norm() > 0.0);
}
