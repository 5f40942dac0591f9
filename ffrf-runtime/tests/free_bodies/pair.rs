//! Two bodies and a spring between them: what no load on one body alone can be.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

use ffrf_runtime::nalgebra::{SVector, UnitQuaternion, Vector2, Vector3};
use ffrf_runtime::{
    FreeBody, GeneralisedForce, Load, Marker, Pair, PairSystem, PlacedMarker, State, StepError, System,
    Tolerances, Wrench, step_linearly_implicit, step_rk4,
};
use ffrf_test_kit::bodies::{cloud, rigid_about};
use ffrf_test_kit::convergence::measured_order;
use ffrf_test_kit::naive_body::NaiveBody;
use ffrf_test_kit::tolerances::{CONSERVED_BY_RK4, ROUND_OFF, SLOPE};

type Flexible = NaiveBody<2, 8>;
type Rigid = NaiveBody<0, 6>;
type Bodies = Pair<Flexible, Rigid>;
type States = Pair<State<SVector<f64, 2>>, State<SVector<f64, 0>>>;
type Forces = Pair<GeneralisedForce<SVector<f64, 2>>, GeneralisedForce<SVector<f64, 0>>>;

/// A linear spring between a marker of each body.
struct Spring {
    first: Marker<SVector<f64, 2>>,
    second: Marker<SVector<f64, 0>>,
    stiffness: f64,
    length: f64,
}

impl Spring {
    fn span(&self, state: &States) -> Vector3<f64> {
        let first = PlacedMarker::new(&self.first, &state.first).motion(&state.first);
        let second = PlacedMarker::new(&self.second, &state.second).motion(&state.second);
        second.position - first.position
    }

    fn energy(&self, state: &States) -> f64 {
        0.5 * self.stiffness * (self.span(state).norm() - self.length).powi(2)
    }
}

impl Load<Bodies, States, Forces> for Spring {
    fn add_to(&self, _: &Bodies, _: f64, state: &States, forces: &mut Forces) {
        let span = self.span(state);
        let force = span.normalize() * (self.stiffness * (span.norm() - self.length));
        let on_first = Wrench { force, moment: Vector3::zeros() };
        let on_second = Wrench { force: -force, moment: Vector3::zeros() };
        let first = PlacedMarker::new(&self.first, &state.first).generalised_force(&on_first);
        let second = PlacedMarker::new(&self.second, &state.second).generalised_force(&on_second);
        forces.first.add_scaled(1.0, &first);
        forces.second.add_scaled(1.0, &second);
    }
}

fn coupled() -> (Bodies, Spring, States) {
    let (flexible, markers) = cloud::<2, 8>(7, 40.0, 0.0);
    let rigid = rigid_about(3.0, Vector3::new(0.1, 0.0, -0.2), Vector3::new(1.0, 2.0, 2.5));
    let second = Marker::rigid(Vector3::new(0.4, -0.3, 0.2), &SVector::zeros());
    let spring = Spring { first: markers[4], second, stiffness: 25.0, length: 0.8 };
    let first = FreeBody::new(flexible)
        .with_orientation(UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -0.8, 0.5)))
        .with_velocity(Vector3::new(0.5, -0.4, 0.2))
        .with_spin(Vector3::new(1.0, 2.0, -0.5))
        .with_deformation(Vector2::new(0.2, -0.1), Vector2::new(0.3, 0.5));
    let second = FreeBody::new(rigid)
        .with_position(Vector3::new(1.5, 0.4, -0.3))
        .with_spin(Vector3::new(-0.4, 1.0, 0.7));
    (Pair { first: flexible, second: rigid }, spring, Pair { first: first.state, second: second.state })
}

/// Energy, linear and angular momentum of both bodies together.
fn totals(bodies: &Bodies, spring: &Spring, state: &States) -> SVector<f64, 7> {
    let first = FreeBody::new(bodies.first).with_state(state.first);
    let second = FreeBody::new(bodies.second).with_state(state.second);
    let energy = first.kinetic_energy() + first.elastic_energy() + second.kinetic_energy();
    let mut all = SVector::<f64, 7>::zeros();
    all[0] = energy + spring.energy(state);
    all.fixed_rows_mut::<3>(1).copy_from(&(first.linear_momentum() + second.linear_momentum()));
    all.fixed_rows_mut::<3>(4).copy_from(&(first.angular_momentum() + second.angular_momentum()));
    all
}

fn after(duration: f64, steps: usize, implicit: bool) -> States {
    let (bodies, spring, mut state) = coupled();
    let system = PairSystem { bodies: &bodies, load: &spring };
    let step = duration / steps as f64;
    for k in 0..steps {
        let time = step * k as f64;
        let result = if implicit {
            step_linearly_implicit(&system, &state, time, step)
        } else {
            step_rk4(&system, &state, time, step)
        };
        state = result.unwrap().0;
    }
    state
}

#[test]
fn a_spring_between_two_bodies_keeps_their_energy_and_momentum() {
    let (bodies, spring, start) = coupled();
    let before = totals(&bodies, &spring, &start);
    let end = after(2.0, 4_000, false);
    let change = totals(&bodies, &spring, &end) - before;
    assert!(change.amax() < CONSERVED_BY_RK4 * before[0], "{change}");
    // each body's own momentum does change, and the spring has worked
    let own = |state: &States| FreeBody::new(bodies.second).with_state(state.second).linear_momentum();
    assert!((own(&end) - own(&start)).norm() > 1.0);
    assert!((spring.energy(&end) - spring.energy(&start)).abs() > 0.1);
}

#[test]
fn both_methods_keep_their_order_on_two_bodies() {
    let exact = after(0.5, 4_000, false);
    let distance = |state: &States| {
        (state.first.position - exact.first.position).norm()
            + (state.first.modal_coordinates - exact.first.modal_coordinates).norm()
            + state.first.orientation.angle_to(&exact.first.orientation)
            + (state.second.position - exact.second.position).norm()
            + state.second.orientation.angle_to(&exact.second.orientation)
    };
    let explicit = measured_order(20, 3, |steps| distance(&after(0.5, steps, false)));
    assert!((explicit - 4.0).abs() < SLOPE, "{explicit}");
    let implicit = measured_order(200, 3, |steps| distance(&after(0.5, steps, true)));
    assert!((implicit - 2.0).abs() < SLOPE, "{implicit}");
}

#[test]
fn bodies_that_do_not_push_each_other_move_as_if_alone() {
    let (bodies, _, start) = coupled();
    let system = PairSystem { bodies: &bodies, load: &() };
    for implicit in [false, true] {
        let mut first = FreeBody::new(bodies.first).with_state(start.first);
        let mut second = FreeBody::new(bodies.second).with_state(start.second);
        let (state, report) = if implicit {
            first.step_linearly_implicit(0.01, &()).unwrap();
            second.step_linearly_implicit(0.01, &()).unwrap();
            step_linearly_implicit(&system, &start, 0.0, 0.01).unwrap()
        } else {
            first.step_rk4(0.01, &()).unwrap();
            second.step_rk4(0.01, &()).unwrap();
            step_rk4(&system, &start, 0.0, 0.01).unwrap()
        };
        assert_eq!((state.first, state.second), (first.state, second.state));
        assert!(report.local_error.modal_coordinates > 0.0);
    }
}

#[test]
fn what_is_wrong_with_one_body_is_wrong_with_the_pair() {
    let (bodies, spring, start) = coupled();
    let system = PairSystem { bodies: &bodies, load: &spring };
    let mut broken = start;
    broken.second.velocity.x = f64::NAN;
    assert_eq!(step_rk4(&system, &broken, 0.0, 0.01), Err(StepError::NonFiniteState));
    let unphysical = Pair { first: bodies.first, second: rigid_about(-1.0, Vector3::zeros(), Vector3::x()) };
    let system = PairSystem { bodies: &unphysical, load: &spring };
    assert_eq!(step_linearly_implicit(&system, &start, 0.0, 0.01), Err(StepError::MassNotPositive));
}

/// The root mean square over all components of both bodies, of which the larger body has more.
#[test]
fn errors_of_both_bodies_are_weighed_together() {
    let (bodies, spring, start) = coupled();
    let system = PairSystem { bodies: &bodies, load: &spring };
    let tolerances = Tolerances { relative: 0.0, absolute: 1e-3 };
    let mut difference = system.no_change(&start);
    assert_eq!(system.weighted_error(&start, &difference, &tolerances), 0.0);
    difference.second.position.x = 1e-3;
    // 16 components of the flexible body, 12 of the rigid one
    let expected = (1.0_f64 / 28.0).sqrt();
    assert!((system.weighted_error(&start, &difference, &tolerances) - expected).abs() < ROUND_OFF);
}
