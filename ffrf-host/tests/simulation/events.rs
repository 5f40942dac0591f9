//! Events and dense output on a pendulum whose period is known in closed form.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

use ffrf_host::simulate::{Event, Then, run_with_events};
use ffrf_host::{HostBody, HostMechanism, HostModal};
use ffrf_runtime::joints::{JointKind, Revolute};
use ffrf_runtime::mechanism::{Attachment, Connection, Constrained};
use ffrf_runtime::{FlexibleBody, Marker, State, System, Tolerances, try_dormand_prince_dense};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

const GRAVITY: f64 = 9.81;
/// Distance of the mass. Units: m.
const LENGTH: f64 = 0.7;
/// Moment of inertia about the hinge over mass and length. Units: m.
const REDUCED: f64 = LENGTH + 0.02 / LENGTH;

/// Times of events: the dense output has order 4 in steps of an error of 1e-10.
const LOCATED: f64 = 1e-8;

type States = Vec<State<HostModal>>;

/// A pendulum that begins at rest, horizontal.
fn pendulum() -> (HostMechanism, States) {
    let body = HostBody::rigid(1.0, Vector3::new(LENGTH, 0.0, 0.0), &Matrix3::from_diagonal_element(0.02));
    let hinge = Marker::rigid(Vector3::zeros(), &body.undeformed());
    let states = vec![State::at_rest(&body)];
    let at = |body| Attachment {
        body,
        marker: 0,
        position: Vector3::zeros(),
        orientation: UnitQuaternion::identity(),
    };
    let joint = Connection { kind: JointKind::Revolute(Revolute), first: at(None), second: at(Some(0)) };
    let gravity = Vector3::new(0.0, -GRAVITY, 0.0);
    (HostMechanism::new(vec![(body, vec![hinge])], vec![(joint, None)], gravity).unwrap(), states)
}

/// A quarter of the period from a height of 90 degrees: K(sin 45°) √(l/g), by the arithmetic-geometric mean.
fn quarter() -> f64 {
    let (mut a, mut b) = (1.0, (0.5_f64).sqrt());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    std::f64::consts::FRAC_PI_2 / a * (REDUCED / GRAVITY).sqrt()
}

/// Across the vertical: zero when the pendulum hangs.
fn across(_: f64, state: &States) -> f64 {
    (state[0].orientation * Vector3::x()).x
}

const TOLERANCES: Tolerances = Tolerances { relative: 1e-10, absolute: 1e-12 };

#[test]
fn a_pendulum_passes_its_lowest_point_when_the_elliptic_integral_says() {
    let (mechanism, start) = pendulum();
    let system = Constrained(&mechanism);
    let spin = |_: f64, state: &States| state[0].angular_velocity.z;
    let mut found: Vec<Event<States>> = Vec::new();
    let ended = run_with_events(&system, &start, [0.0, 5.0], &TOLERANCES, &[&across, &spin], |event| {
        found.push(event.clone());
        Then::Continue
    })
    .unwrap();
    assert!((ended.time - 5.0).abs() < 1e-15);
    // lowest points at odd quarters, turning points at even ones, one after the other
    let expected = (5.0 / quarter()).floor() as usize;
    assert_eq!(found.len(), expected);
    for (index, event) in found.iter().enumerate() {
        let time = (index + 1) as f64 * quarter();
        assert!((event.time - time).abs() < LOCATED, "{index}: {} {time}", event.time);
        assert_eq!(event.function, index % 2);
        assert_eq!(event.rising, index % 4 == 1 || index % 4 == 2);
        // the state there is on the constraints
        assert!(event.state[0].position.norm() < 1e-14);
    }
}

#[test]
fn a_run_ends_at_an_event_that_says_so() {
    let (mechanism, start) = pendulum();
    let system = Constrained(&mechanism);
    let ended =
        run_with_events(&system, &start, [0.0, 5.0], &TOLERANCES, &[&across], |_| Then::Stop).unwrap();
    assert!((ended.time - quarter()).abs() < LOCATED);
    // all potential energy is kinetic: ω² = 2 g / l
    let spin = ended.state[0].angular_velocity.z;
    assert!((spin + (2.0 * GRAVITY / REDUCED).sqrt()).abs() < LOCATED, "{spin}");
}

#[test]
fn the_dense_output_has_order_four() {
    let (mechanism, start) = pendulum();
    let system = Constrained(&mechanism);
    let lax = Tolerances { relative: 1.0, absolute: 1.0 };
    // from a state that moves
    let (moving, _) = try_dormand_prince_dense(&system, &start, 0.0, 0.2, &lax).unwrap();
    let start = moving.accepted.unwrap().0;
    let error = |step: f64| {
        let (_, dense) = try_dormand_prince_dense(&system, &start, 0.0, step, &lax).unwrap();
        let dense = dense.unwrap();
        let worst = [0.25, 0.5, 0.8].map(|share| {
            let found = &system.retract(&start, &dense.increment(share))[0];
            // the same way in steps that are much shorter
            let exact = (0..20).fold(start.clone(), |state, _| {
                let (tried, _) =
                    try_dormand_prince_dense(&system, &state, 0.0, share * step / 20.0, &lax).unwrap();
                tried.accepted.unwrap().0
            });
            (found.angular_velocity - exact[0].angular_velocity).norm()
        });
        worst.into_iter().fold(0.0, f64::max)
    };
    let (coarse, fine) = (error(0.05), error(0.025));
    // within one step the error of an order of 4 falls with the fifth power
    let order = (coarse / fine).log2();
    eprintln!("{coarse:e} {fine:e} {order}");
    assert!((order - 5.0).abs() < 0.5, "{order}");
    // and at the ends it is the step itself
    let (tried, dense) = try_dormand_prince_dense(&system, &start, 0.0, 0.1, &lax).unwrap();
    let end = &system.retract(&start, &dense.unwrap().increment(1.0))[0];
    assert!((end.angular_velocity - tried.accepted.unwrap().0[0].angular_velocity).norm() < 1e-12);
}

/// The pendulum as a scene.
fn scene(simulation: &str, events: &str) -> Result<ffrf_host::scene::Scene, String> {
    let text = format!(
        r#"[simulation]
duration = 2.0
{simulation}
gravity = [0.0, -9.81, 0.0]
output_step = 0.1
[bodies.bob]
mass = 1.0
center_of_mass = [{LENGTH}, 0.0, 0.0]
inertia = [[0.02, 0.0, 0.0], [0.0, 0.02, 0.0], [0.0, 0.0, 0.02]]
markers.TIP = [{LENGTH}, 0.0, 0.0]
[joints.hinge]
kind = "revolute"
first = "ground"
second = "bob"
[sensors.tip]
kind = "position"
of = "bob.TIP"
[sensors.swing]
kind = "angle"
of = "hinge"
{events}"#
    );
    let file = ffrf_host::scene::file::SceneFile::parse(&text).map_err(|error| error.to_string())?;
    ffrf_host::scene::Scene::compose(&file, std::path::Path::new("")).map_err(|error| error.to_string())
}

const LOWEST: &str = "[events.lowest]\nsensor = \"tip\"\ncomponent = \"x\"\n";

#[test]
fn events_of_scenes_happen_when_the_elliptic_integral_says() {
    // RK4 and the methods of order 2 at their own accuracy
    for (simulation, located) in [
        ("step = 1e-3", 1e-9),
        ("tolerance = 1e-11", 1e-8),
        ("step = 1e-3\nintegrator = \"linearly_implicit\"", 1e-5),
        ("step = 1e-3\nintegrator = \"energy_momentum\"", 1e-5),
        ("step = 1e-3\nintegrator = \"generalized_alpha\"", 1e-5),
        ("step = 1e-3\nconstraints = \"minimal\"", 1e-9),
    ] {
        let scene = scene(simulation, LOWEST).unwrap();
        let summary = ffrf_host::simulate::simulate(&scene, None, |_| Ok(()), |_| ()).unwrap();
        let ways: Vec<bool> = summary.events.iter().map(|event| event.rising).collect();
        assert_eq!(ways, [false, true], "{simulation}: {:?}", summary.events);
        for (k, event) in summary.events.iter().enumerate() {
            let expected = quarter() * (1 + 2 * k) as f64;
            assert!((event.time - expected).abs() < located, "{simulation}: {event:?} {expected}");
        }
    }
}

#[test]
fn an_event_can_stop_a_run_that_goes_on_later() {
    let stopping = format!("{LOWEST}then = \"stop\"\ndirection = \"falling\"\n");
    let scene_of = |events: &str| scene("step = 1e-3", events).unwrap();
    let run = |scene: &ffrf_host::scene::Scene, from: Option<&ffrf_host::simulate::SavedState>| {
        let mut samples = Vec::new();
        let keep = |sample: &ffrf_host::simulate::Sample| {
            samples.push(sample.clone());
            Ok(())
        };
        let summary = ffrf_host::simulate::simulate(scene, from, keep, |_| ()).unwrap();
        (samples, summary)
    };
    let (samples, summary) = run(&scene_of(&stopping), None);
    let last = samples.last().unwrap();
    assert!((last.time - quarter()).abs() < 1e-9 && summary.end.time == last.time, "{}", last.time);
    assert!((summary.end.bodies["bob"].orientation[0] - 0.5_f64.sqrt()).abs() < 1e-9);
    // from there on it is the run that was not stopped
    let (rest, on) = run(&scene_of(&stopping), Some(&summary.end));
    let (whole, _) = run(&scene_of(LOWEST), None);
    assert_eq!(rest.last(), whole.last());
    assert!(on.events.is_empty(), "{:?}", on.events);
}

#[test]
fn an_angle_turns_over_without_an_event() {
    let spin = "[events.over]\nsensor = \"swing\"\nvalue = -1.0\n";
    let scene = scene("step = 1e-3", spin).unwrap();
    let summary = ffrf_host::simulate::simulate(&scene, None, |_| Ok(()), |_| ()).unwrap();
    // down through -1 rad and up again
    let ways: Vec<bool> = summary.events.iter().map(|event| event.rising).collect();
    assert_eq!(ways, [false, true], "{:?}", summary.events);
}

#[test]
fn tables_of_events_refuse_what_they_cannot_mean() {
    for (events, expected) in [
        ("[events.a]\nsensor = \"tap\"", "events.a.sensor: no sensor is called `tap`; there are tip, swing"),
        ("[events.a]\nsensor = \"tip\"", "events.a.component: expected one of x, y, z, found nothing"),
        (
            "[events.a]\nsensor = \"tip\"\ncomponent = \"w\"",
            "events.a.component: expected one of x, y, z, found `w`",
        ),
        (
            "[events.a]\nsensor = \"swing\"\ncomponent = \"x\"",
            "events.a.component: expected nothing: `swing` is one number, found `x`",
        ),
        (
            "[events.a]\nsensor = \"swing\"\ndirection = \"up\"",
            "events.a.direction: expected one of either, rising, falling, found `up`",
        ),
        (
            "[events.a]\nsensor = \"swing\"\nthen = \"halt\"",
            "events.a.then: expected one of record, stop, found `halt`",
        ),
        (
            "[events.a]\nsensor = \"swing\"\nvalue = nan",
            "events.a.value: expected a finite number, found NaN",
        ),
        ("[events.a]\nsensor = \"swing\"\nlevel = 1.0", "events.a: unknown field `level`"),
    ] {
        let said = scene("step = 1e-3", events).err().unwrap_or_default();
        assert!(said.contains(expected), "{events}: {said}");
    }
}
