//! Force elements: what springs take from moving bodies is the exact rate of their energy, and efforts have power on the
//! exact rate of what they act along. By dual numbers, between bodies with and without modes and the ground.

use super::joints::{End, end, pairs};
use ffrf_runtime::forces::{
    Actuator, Bushing, Effort, ForceElement, Friction, SoftRow, Spring, TorsionSpring, relative_angle,
};
use ffrf_runtime::nalgebra::{UnitQuaternion, Vector3};
use ffrf_runtime::{MarkerMotion, Wrench};
use ffrf_test_kit::tolerances::DERIVED;
use num_dual::Dual2_64;

const EFFORTS: [Effort; 3] = [Effort::About, Effort::Along, Effort::Line];

fn for_every_pair(mut check: impl FnMut([&End; 2])) {
    for (case, pair) in pairs().into_iter().enumerate() {
        for time in [0.0, 0.4, 1.3] {
            let (first, second) = (end(pair[0], 1 + case % 7, time), end(pair[1], 8 + case % 9, time));
            check([&first, &second]);
        }
    }
}

/// The power of wrenches on both ends, and the sum of the sizes of its terms.
fn power(wrenches: &[Wrench; 2], ends: [&End; 2]) -> (f64, f64) {
    let mut sum = (0.0, 1.0);
    for (wrench, end) in wrenches.iter().zip(ends) {
        let MarkerMotion { velocity, angular_velocity, .. } = &end.motion;
        sum.0 += wrench.power(velocity, angular_velocity);
        sum.1 += wrench.force.norm() * velocity.norm() + wrench.moment.norm() * angular_velocity.norm();
    }
    sum
}

#[track_caller]
fn close(found: f64, expected: f64, size: f64) {
    assert!((found - expected).abs() <= DERIVED * size, "{found} and {expected}");
}

/// Together they add neither momentum nor angular momentum to the world.
#[track_caller]
fn balanced(wrenches: &[Wrench; 2], ends: [&End; 2]) {
    let (mut force, mut moment, mut size) = (Vector3::zeros(), Vector3::zeros(), 1.0);
    for (wrench, end) in wrenches.iter().zip(ends) {
        force += wrench.force;
        moment += wrench.moment + end.motion.position.cross(&wrench.force);
        size += wrench.moment.norm() + (1.0 + end.motion.position.norm()) * wrench.force.norm();
    }
    assert!(force.norm() + moment.norm() <= DERIVED * size, "{force} {moment}");
}

#[test]
fn springs_and_bushings_take_the_rate_of_their_energy() {
    let number = Dual2_64::from;
    for_every_pair(|ends| {
        let motions = [&ends[0].motion, &ends[1].motion];
        let paths = [&ends[0].path, &ends[1].path];

        let spring = Spring { stiffness: 30.0, damping: 0.0, rest_length: 0.7 };
        let exact = Spring { stiffness: number(30.0), damping: number(0.0), rest_length: number(0.7) };
        let wrenches = spring.wrenches(motions[0], motions[1]);
        let (power, size) = power(&wrenches, ends);
        close(power, -exact.energy(paths[0], paths[1]).v1, size);
        balanced(&wrenches, ends);

        let stiffness = [10.0, 20.0, 30.0, 4.0, 5.0, 60.0];
        let bushing = Bushing { stiffness, damping: [0.0; 6] };
        let exact = Bushing { stiffness: stiffness.map(number), damping: [number(0.0); 6] };
        let wrenches = bushing.wrenches(motions[0], motions[1]);
        let (power, size) = self::power(&wrenches, ends);
        close(power, -exact.energy(paths[0], paths[1]).v1, size);
        balanced(&wrenches, ends);
        assert!(
            (bushing.energy(motions[0], motions[1]) - exact.energy(paths[0], paths[1]).re).abs()
                < 1e-12 * size
        );
    });
}

/// A torsion spring is for joints that keep both z axes together: here both ends turn about the same axis.
#[test]
fn torsion_springs_take_the_rate_of_their_energy() {
    for_every_pair(|ends| {
        let rate = 0.8;
        let angle = Dual2_64::new(0.9, rate, 0.3);
        let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), angle);
        let second_path = MarkerMotion { orientation: ends[0].path.orientation * turn, ..ends[0].path };
        let number = Dual2_64::from;
        let exact = TorsionSpring { stiffness: number(7.0), damping: number(0.0), rest_angle: number(0.2) };
        let energy = exact.energy(&ends[0].path, &second_path);
        let plain = TorsionSpring { stiffness: 7.0, damping: 0.0, rest_angle: 0.2 };
        let first = ends[0].motion;
        let axis = first.orientation * Vector3::z();
        let mut second = first;
        second.orientation *= UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.9);
        second.angular_velocity += axis * rate;
        assert!((relative_angle(&first, &second) - 0.9).abs() < DERIVED);
        let [on_first, on_second] = plain.wrenches(&first, &second);
        let power = on_first.power(&first.velocity, &first.angular_velocity)
            + on_second.power(&second.velocity, &second.angular_velocity);
        close(power, -energy.v1, 1.0 + 20.0 * first.angular_velocity.norm());
    });
}

/// What an effort acts along, as a function of the places alone; the angle about an axis is one only while axes agree.
fn coordinate(effort: Effort, ends: [&End; 2]) -> Option<Dual2_64> {
    let [first, second] = [&ends[0].path, &ends[1].path];
    let between = second.position - first.position;
    match effort {
        Effort::Along => Some(first.orientation.transform_vector(&Vector3::z()).dot(&between)),
        Effort::Line => Some(between.norm()),
        Effort::About => None,
    }
}

#[test]
fn efforts_have_power_on_the_rate_of_what_they_act_along() {
    for_every_pair(|ends| {
        for effort in EFFORTS {
            let rate = effort.rate(&ends[0].motion, &ends[1].motion);
            if let Some(exact) = coordinate(effort, ends) {
                close(rate, exact.v1, 10.0 + exact.v1.abs());
            }
            let wrenches = effort.wrenches(&ends[0].motion, &ends[1].motion, 3.0);
            let (power, size) = power(&wrenches, ends);
            close(power, 3.0 * rate, size);
            balanced(&wrenches, ends);
        }
    });
}

#[test]
fn friction_takes_energy_and_never_more_than_its_limit() {
    for_every_pair(|ends| {
        for effort in EFFORTS {
            let friction = Friction { effort, limit: 2.0, speed: 1e-2, viscous: 0.5 };
            let wrenches = friction.wrenches(&ends[0].motion, &ends[1].motion);
            let rate = effort.rate(&ends[0].motion, &ends[1].motion);
            let (power, size) = power(&wrenches, ends);
            // between the viscous part and that with all of the limit
            let lost = -power - 0.5 * rate * rate;
            assert!(
                lost >= -DERIVED * size && lost <= 2.0 * rate.abs() + DERIVED * size,
                "{effort:?}: {lost}"
            );
            balanced(&wrenches, ends);
        }
    });
    let friction = Friction::<f64> { effort: Effort::About, limit: 2.0, speed: 1e-2, viscous: 0.0 };
    assert_eq!(friction.exerted(0.0), 0.0);
    // fast: the limit; at the speed of the passage: 1/√2 of it; slow: a damper of limit / speed
    assert!((friction.exerted(10.0) + 2.0).abs() < 1e-6);
    assert!((friction.exerted(-1e-2) - 2.0 / 2.0_f64.sqrt()).abs() < 1e-12);
    assert!((friction.exerted(1e-8) + 200.0 * 1e-8).abs() < 1e-15);
}

#[test]
fn actuators_are_an_effort_along_and_one_about_the_axis() {
    for_every_pair(|ends| {
        let actuator = Actuator { force: 1.5, moment: -0.7 };
        let [first, second] = [&ends[0].motion, &ends[1].motion];
        let wrenches = actuator.wrenches(first, second);
        let (power, size) = power(&wrenches, ends);
        let rates = [Effort::Along, Effort::About].map(|effort| effort.rate(first, second));
        close(power, 1.5 * rates[0] - 0.7 * rates[1], size);
        balanced(&wrenches, ends);
        assert_eq!(Actuator::idle().wrenches(first, second), [Wrench::zero(); 2]);
        // positive is apart on a line
        let apart = Effort::Line.wrenches(first, second, 2.0)[1].force;
        assert!(apart.dot(&(second.position - first.position)) > 0.0);
    });
}

/// What the soft rows of an element say of wrenches on both ends: -(stiffness + `of_damping` damping) g v along g.
fn of_soft_rows(element: &dyn ForceElement<f64>, ends: [&End; 2], of_damping: f64) -> [Wrench; 2] {
    let [first, second] = [&ends[0].motion, &ends[1].motion];
    let mut sum = [Wrench::zero(); 2];
    element.soften(first, second, &mut |row: SoftRow| {
        let rate = row.first.power(&first.velocity, &first.angular_velocity)
            + row.second.power(&second.velocity, &second.angular_velocity);
        let effort = -(row.stiffness + of_damping * row.damping) * rate;
        for (sum, gradient) in sum.iter_mut().zip([row.first, row.second]) {
            sum.force += gradient.force * effort;
            sum.moment += gradient.moment * effort;
        }
    });
    sum
}

#[track_caller]
fn same(found: &[Wrench; 2], expected: &[Wrench; 2]) {
    for (found, expected) in found.iter().zip(expected) {
        let apart = (found.force - expected.force).norm() + (found.moment - expected.moment).norm();
        let size = 1.0 + expected.force.norm() + expected.moment.norm();
        assert!(apart <= DERIVED * size, "{found:?} and {expected:?}");
    }
}

#[test]
fn soft_rows_are_the_dampers() {
    for_every_pair(|ends| {
        let elements: [Box<dyn ForceElement<f64>>; 3] = [
            Box::new(Spring { stiffness: 0.0, damping: 3.0, rest_length: 0.7 }),
            Box::new(TorsionSpring { stiffness: 0.0, damping: 2.0, rest_angle: 0.2 }),
            Box::new(Bushing { stiffness: [0.0; 6], damping: [1.0, 2.0, 3.0, 0.4, 0.5, 0.6] }),
        ];
        for element in elements {
            let wrenches = element.wrenches(&ends[0].motion, &ends[1].motion);
            same(&of_soft_rows(&*element, ends, 1.0), &wrenches);
        }
        for effort in EFFORTS {
            // far below the speed of the passage friction is a damper
            let friction = Friction { effort, limit: 2e9, speed: 1e9, viscous: 0.5 };
            same(&of_soft_rows(&friction, ends, 1.0), &friction.wrenches(&ends[0].motion, &ends[1].motion));
        }
    });
}

#[test]
fn soft_rows_of_a_stretched_spring_are_the_rate_of_its_force() {
    let number = Dual2_64::from;
    for_every_pair(|ends| {
        for rest_length in [0.0, 1e-3] {
            let spring = Spring { stiffness: 30.0, damping: 4.0, rest_length };
            let exact =
                Spring { stiffness: number(30.0), damping: number(0.0), rest_length: number(rest_length) };
            let rates = exact.wrenches(&ends[0].path, &ends[1].path).map(|wrench| Wrench {
                force: wrench.force.map(|x| x.v1),
                moment: wrench.moment.map(|x| x.v1),
            });
            same(&of_soft_rows(&spring, ends, 0.0), &rates);
        }
    });
}
