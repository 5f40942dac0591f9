//! Drives, forces and sensors on the joints of `for`.

use ffrf::mechanism;
use ffrf::nalgebra::Vector3;

use crate::bodies::{BIG_END, Rod, SMALL_END};

/// Order of operations.
const SAME: f64 = 1e-13;
const BENDING: [f64; 3] = [0.5, 1.0, 2.0];

mechanism! {
    /// Four rods: the first joint is driven, the others have springs, dampers and friction.
    pub struct Whip {
        bodies: { links: [Rod; 4] },
        gravity: [0.0, -9.81, 0.0],
        joints: {
            first: revolute(ground, links[0].BIG_END, axis: z),
            hinges: for i in 1..4 { revolute(links[i - 1].SMALL_END, links[i].BIG_END, axis: z) },
        },
        drives: {
            motor: angle(first, polynomial: [0.0, 5.0]),
            followers: for k in 2..4 { angle(hinges[k], polynomial: [0.0, 1.0]) },
        },
        forces: {
            coils: for i in 1..4 { torsion_spring(hinges[i], stiffness: BENDING[i - 1], damping: 1e-3) },
            ropes: for i in 0..3 { spring(links[i], links[i + 1], stiffness: 10.0, rest_length: 0.1) },
            weights: for i in 0..4 { force(links[i].SMALL_END, value: [0.0, -0.1 * i as f64, 0.0]) },
            bearings: for i in 1..4 { friction(hinges[i], coefficient: 0.1, radius: 0.005, speed: 0.1) },
        },
        sensors: {
            tips: for i in 0..4 { position(links[i].SMALL_END) },
            turns: for i in 1..4 { angle(hinges[i]) },
            loads: for i in 1..4 { reaction_force(hinges[i]) },
            shocks: for i in 0..2 { acceleration(links[i]) },
            second: reaction_force(hinges[2]),
        },
    }
}

mechanism! {
    /// The same, one by one.
    pub struct Spelled {
        bodies: { a: Rod, b: Rod, c: Rod, d: Rod },
        gravity: [0.0, -9.81, 0.0],
        joints: {
            first: revolute(ground, a.BIG_END, axis: z),
            one: revolute(a.SMALL_END, b.BIG_END, axis: z),
            two: revolute(b.SMALL_END, c.BIG_END, axis: z),
            three: revolute(c.SMALL_END, d.BIG_END, axis: z),
        },
        drives: {
            motor: angle(first, polynomial: [0.0, 5.0]),
            follow_two: angle(two, polynomial: [0.0, 1.0]),
            follow_three: angle(three, polynomial: [0.0, 1.0]),
        },
        forces: {
            coil_one: torsion_spring(one, stiffness: 0.5, damping: 1e-3),
            coil_two: torsion_spring(two, stiffness: 1.0, damping: 1e-3),
            coil_three: torsion_spring(three, stiffness: 2.0, damping: 1e-3),
            rope_one: spring(a, b, stiffness: 10.0, rest_length: 0.1),
            rope_two: spring(b, c, stiffness: 10.0, rest_length: 0.1),
            rope_three: spring(c, d, stiffness: 10.0, rest_length: 0.1),
            weight_b: force(b.SMALL_END, value: [0.0, -0.1, 0.0]),
            weight_c: force(c.SMALL_END, value: [0.0, -0.2, 0.0]),
            weight_d: force(d.SMALL_END, value: [0.0, -0.3, 0.0]),
            bearing_one: friction(one, coefficient: 0.1, radius: 0.005, speed: 0.1),
            bearing_two: friction(two, coefficient: 0.1, radius: 0.005, speed: 0.1),
            bearing_three: friction(three, coefficient: 0.1, radius: 0.005, speed: 0.1),
        },
        sensors: {
            tip: position(d.SMALL_END),
            turn: angle(two),
            load: reaction_force(two),
            shock: acceleration(b),
        },
    }
}

#[test]
fn arrays_are_their_entries_one_by_one() {
    let whip = Whip::new([Rod; 4]);
    let spelled = Spelled::new(Rod, Rod, Rod, Rod);
    assert_eq!(
        Whip::JOINTS,
        ["first", "motor", "hinges[1]", "hinges[2]", "hinges[3]", "followers[2]", "followers[3]"]
    );
    let mut state = whip.at_rest();
    for (k, link) in state.links.iter_mut().enumerate() {
        link.position.x = k as f64 * (SMALL_END - BIG_END) - BIG_END;
    }
    let other = spelled.state_from_array(&state.to_array());
    let (mut one, mut two) = (whip.in_motion(state), spelled.in_motion(other));
    one.assemble().unwrap();
    two.assemble().unwrap();
    for _ in 0..30 {
        one.step_linearly_implicit(1e-4).unwrap();
        two.step_linearly_implicit(1e-4).unwrap();
    }
    let (found, expected) = (one.state.to_array(), two.state.to_array());
    let apart = found.iter().zip(&expected).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    let size = expected.iter().fold(0.0_f64, |most, number| most.max(number.abs()));
    assert!(apart < SAME * size * 1e2, "{apart:.2e} of {size:.2e}");
    let close = |one: Vector3<f64>, two: Vector3<f64>| (one - two).norm() < 1e-8 * two.norm();
    assert!(close(whip.tips(&one.state)[3], spelled.tip(&two.state)));
    assert!((whip.turns(&one.state)[1] - spelled.turn(&two.state)).abs() < SAME);
    assert!((whip.turns(&one.state)[1] - one.time).abs() < 1e-9, "driven");
    let loads = whip.loads(one.time, &one.state).unwrap();
    assert!(close(loads[1], spelled.load(two.time, &two.state).unwrap()));
    assert_eq!(loads[1], whip.second(one.time, &one.state).unwrap());
    assert!(close(
        whip.shocks(one.time, &one.state).unwrap()[1],
        spelled.shock(two.time, &two.state).unwrap()
    ));
}
