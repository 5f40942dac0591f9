//! Joints are ideal: in the motion that they allow, their reactions have no power but what drives supply, on bodies that
//! deform and move. The reactions are what the naive equations of motion of each body lack.

use ffrf_host::HostModal;
use ffrf_host::mechanism::{Drive, Formula};
use ffrf_runtime::joints::{Angle, Distance, JointKind, Prismatic, Revolute, Travel};
use ffrf_runtime::mechanism::{Connection, Constrained};
use ffrf_runtime::{State, Wrench};
use ffrf_test_kit::every_joint::every_kind;
use ffrf_test_kit::random::Random;
use nalgebra::{DVector, UnitQuaternion, Vector3};

use super::dense::{Evaluation, evaluate, flat_motion, free_equations};
use super::graphs::{Case, attachment, case};
use super::tolerances::POWER;

/// Time of the closed state. Units: s.
const TIME: f64 = 0.3;

/// Two bodies on one joint, or one on the ground, near the place where the joint is met.
fn near(kind: JointKind, pair: [Option<usize>; 2], drive: Option<(JointKind, Drive)>, seed: u64) -> Case {
    let mut random = Random::new(seed);
    let modes: Vec<usize> = pair.iter().flatten().copied().collect();
    let mut place = 0;
    let mut index = |end: Option<usize>| {
        end.map(|_| {
            place += 1;
            place - 1
        })
    };
    let ends = [index(pair[0]), index(pair[1])];
    let connection = Connection {
        kind,
        first: attachment(ends[0], &mut random),
        second: attachment(ends[1], &mut random),
    };
    let mut joints = vec![(connection, None)];
    if let Some((kind, function)) = drive {
        joints.push((Connection { kind, ..connection }, Some(function)));
    }
    case(format!("{kind:?} between {pair:?}, seed {seed}"), &modes, joints, seed, &mut random)
}

/// Moves one body until both triads meet but for small turns and shifts, then closes position and velocity by projection.
fn close(case: &mut Case, random: &mut Random) {
    let connection = ffrf_runtime::mechanism::Assembly::connections(&case.mechanism)[0];
    let states = &mut case.states;
    let moved = connection.second.body.or(connection.first.body).unwrap();
    let motions = |states: &[State<HostModal>]| {
        let markers = case.mechanism.markers();
        [connection.first, connection.second].map(|end| match end.body {
            None => (end.position, end.orientation),
            Some(body) => {
                let marker = &markers[body][end.marker];
                let seen = ffrf_runtime::PlacedMarker::new(marker, &states[body]).motion(&states[body]);
                (seen.position, seen.orientation * end.orientation)
            }
        })
    };
    let [(_, first), (_, second)] = motions(states);
    let small = |random: &mut Random| UnitQuaternion::from_scaled_axis(Vector3::from(random.vector()) * 0.3);
    let extra = match connection.kind {
        JointKind::Universal(_) => UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 1.57),
        _ => UnitQuaternion::identity(),
    };
    // turned so that second = first * extra * small
    let wanted = first * extra * small(random);
    states[moved].orientation = if connection.second.body == Some(moved) {
        wanted * second.inverse() * states[moved].orientation
    } else {
        second * (extra * small(random)).inverse() * first.inverse() * states[moved].orientation
    };
    let [(first, triad), (second, _)] = motions(states);
    let offset = match connection.kind {
        JointKind::Distance(Distance { length }) => triad * Vector3::new(0.6, 0.8, 0.0) * length,
        _ => Vector3::zeros(),
    };
    let gap = first + offset + Vector3::from(random.vector()) * 0.1 - second;
    states[moved].position += if connection.second.body == Some(moved) { gap } else { -gap };
    let system = Constrained(&case.mechanism);
    for _ in 0..30 {
        let closed = system.project(TIME, case.states.clone(), None, 2, f64::MAX);
        case.states = closed.unwrap_or_else(|error| panic!("{}: {error}", case.name)).0;
    }
    let closed = system.project(TIME, case.states.clone(), None, 4, 1e-12);
    let (closed, drift) = closed.unwrap_or_else(|error| panic!("{}: {error}", case.name));
    assert!(drift.position < 1e-12 && drift.velocity < 1e-11, "{}: {drift:?}", case.name);
    case.states = closed;
}

/// Generalised reactions as the bodies feel them, by the naive equations; their power, and what its size could be by the norms of the terms
/// (a body that the joint holds fast has no velocity but of round-off of the initial one, which is of order one).
fn reaction_power(case: &Case, found: &Evaluation) -> (f64, f64) {
    let (mass, force) = free_equations(case, &case.states, None);
    let inertia = mass * &found.accelerations;
    let reactions = &inertia - &force;
    let velocities: Vec<f64> =
        case.states.iter().flat_map(|state| flat_motion(&state.velocities()).as_slice().to_vec()).collect();
    let velocities = DVector::from_vec(velocities);
    assert!(reactions.norm() > 1e-3, "{}: no reactions", case.name);
    (reactions.dot(&velocities), (inertia.norm() + force.norm()) * (1.0 + velocities.norm()))
}

fn pairs() -> Vec<[Option<usize>; 2]> {
    let mut pairs = Vec::new();
    for modes in 0..=5 {
        pairs.extend([[None, Some(modes)], [Some(modes), None], [Some(modes), Some(5 - modes)]]);
    }
    pairs
}

#[test]
fn reactions_of_every_kind_of_joint_have_no_power() {
    let mut worst = 0.0_f64;
    for (number, kind) in every_kind::<f64>().into_iter().enumerate() {
        for (k, pair) in pairs().into_iter().enumerate() {
            let seed = 1000 + 40 * number as u64 + k as u64;
            let mut case = near(kind, pair, None, seed);
            close(&mut case, &mut Random::new(seed + 7));
            let found = evaluate(&case, &case.states, TIME, None);
            let (power, size) = reaction_power(&case, &found);
            assert!(power.abs() <= POWER * size, "{}: power {power:e} W of {size:e} W", case.name);
            worst = worst.max(power.abs() / size);
        }
    }
    eprintln!("power of reactions over the product of norms: at most {worst:.1e}");
}

#[test]
fn drives_supply_the_power_of_the_reactions() {
    let function = || Drive::Formula(Formula::parse("0.2*sin(3*t) + 0.4*t^2").unwrap());
    let [_, rate, _] = function().at(TIME);
    assert!(rate > 0.1);
    let mut worst = 0.0_f64;
    for (kind, drive) in [
        (JointKind::Revolute(Revolute), JointKind::Angle(Angle)),
        (JointKind::Prismatic(Prismatic), JointKind::Travel(Travel)),
    ] {
        for (k, pair) in pairs().into_iter().enumerate() {
            let seed = 7000 + k as u64;
            let mut case = near(kind, pair, Some((drive, function())), seed);
            close(&mut case, &mut Random::new(seed + 7));
            let found = evaluate(&case, &case.states, TIME, None);
            let (power, size) = reaction_power(&case, &found);
            // what the joint's axis sees: moment times rate of the angle, or force times rate of the travel
            let (axis, wrench) = on_second(&case, &found);
            let effort = match drive {
                JointKind::Angle(_) => axis.dot(&wrench.moment),
                _ => axis.dot(&wrench.force),
            };
            let supplied = effort * rate;
            assert!(supplied.abs() > 1e-3, "{}", case.name);
            assert!(
                (power - supplied).abs() <= POWER * size,
                "{}: {power} W, supplied {supplied} W",
                case.name
            );
            worst = worst.max((power - supplied).abs() / size);
        }
    }
    eprintln!("power of reactions less that of drives: at most {worst:.1e}");
}

/// The joint's axis, and the wrench of joint and drive on the second end.
fn on_second(case: &Case, found: &Evaluation) -> (Vector3<f64>, Wrench) {
    let system = Constrained(&case.mechanism);
    let summed = system.evaluate(TIME, case.states.clone(), None, |_, storage| {
        let mut sum = Wrench::zero();
        for (joint, evaluated) in storage.evaluated().enumerate() {
            for (k, row) in evaluated.rows.iter().enumerate() {
                let multiplier = found.multipliers[found.starts[joint] + k];
                sum.force += row.second.force * multiplier;
                sum.moment += row.second.moment * multiplier;
            }
        }
        (storage.joints[0].unwrap().ends[0].orientation * Vector3::z(), sum)
    });
    summed.unwrap()
}
