//! Sensors of reactions against balances of momentum: what joints exert on a body, with its weight, is the rate of its
//! momentum, which comes from the naive form of the body by dual numbers and from nothing that joints compute.

use std::path::Path;

use ffrf_host::HostModal;
use ffrf_host::scene::Scene;
use ffrf_host::simulate::{BodyState, Sample, header, simulate};
use ffrf_model::ReducedBody;
use ffrf_runtime::mechanism::Constrained;
use ffrf_runtime::{Motion, Observables, State};
use ffrf_test_kit::naive_body::{Invariants, NaiveBody};
use ffrf_test_kit::witness::invariants;
use nalgebra::{DVector, Quaternion, SVector, UnitQuaternion, Vector3};
use num_dual::Dual64;

use super::bodies::model;
use super::tolerances::BALANCE;

const GRAVITY: Vector3<f64> = Vector3::new(0.5, -1.0, -9.0);
const DURATION: f64 = 0.02;

/// Momentum and angular momentum about the origin of space as functions of time, by the state and its accelerations.
fn momentum_rates<const M: usize, const N: usize>(
    model: &ReducedBody,
    state: &State<HostModal>,
    accelerations: &Motion<HostModal>,
) -> [Vector3<f64>; 2] {
    let number = |value: f64, rate: f64| Dual64::new(value, rate);
    let constant = |value: f64| Dual64::from(value);
    let Invariants {
        mass,
        centre_of_mass,
        modal_centre_of_mass,
        euler_tensor,
        modal_euler_tensor,
        modal_pair_euler_tensor,
        stiffness,
        damping,
    } = invariants::<M>(model);
    let tensor = |t: [[f64; 3]; 3]| t.map(|row| row.map(constant));
    let body = NaiveBody::<M, N, Dual64>::new(&Invariants {
        mass: constant(mass),
        centre_of_mass: centre_of_mass.map(constant),
        modal_centre_of_mass: modal_centre_of_mass.map(|row| row.map(constant)),
        euler_tensor: tensor(euler_tensor),
        modal_euler_tensor: modal_euler_tensor.map(tensor),
        modal_pair_euler_tensor: modal_pair_euler_tensor.map(|row| row.map(tensor)),
        stiffness: stiffness.map(|row| row.map(constant)),
        damping: damping.map(|row| row.map(constant)),
    });
    // the rate of A u is A (u̇ + ω × u): here with the body frame standing still in the rates, turned afterwards
    let vector =
        |value: &Vector3<f64>, rate: &Vector3<f64>| Vector3::from_fn(|i, _| number(value[i], rate[i]));
    let modal = |value: &HostModal, rate: &HostModal| {
        SVector::<Dual64, M>::from_fn(|i, _| number(value.0[i], rate.0[i]))
    };
    let omega = state.angular_velocity;
    let velocity = state.body_velocity();
    // v̇ of the body-frame components of the velocity: the acceleration less ω × v
    let v = vector(&velocity, &(accelerations.linear - omega.cross(&velocity)));
    let w = vector(&omega, &accelerations.angular);
    let q = modal(&state.modal_coordinates, &state.modal_rates);
    let q_dot = modal(&state.modal_rates, &accelerations.modal);
    let rate = |momentum: Vector3<Dual64>| {
        let (value, rate) = (momentum.map(|x| x.re), momentum.map(|x| x.eps));
        state.to_inertial(&(rate + omega.cross(&value)))
    };
    let linear = body.linear_momentum(&q, &v, &w, &q_dot);
    let about_frame = body.angular_momentum(&q, &v, &w, &q_dot);
    let force = rate(linear);
    let momentum = state.to_inertial(&linear.map(|x| x.re));
    let moment = rate(about_frame) + state.velocity.cross(&momentum) + state.position.cross(&force);
    [force, moment]
}

fn state_of(saved: &BodyState) -> State<HostModal> {
    let [w, i, j, k] = saved.orientation;
    State {
        position: saved.position.into(),
        orientation: UnitQuaternion::new_unchecked(Quaternion::new(w, i, j, k)),
        modal_coordinates: HostModal(DVector::from_column_slice(&saved.modal_coordinates)),
        velocity: saved.velocity.into(),
        angular_velocity: saved.angular_velocity.into(),
        modal_rates: HostModal(DVector::from_column_slice(&saved.modal_rates)),
    }
}

fn three(names: &[String], sample: &Sample, sensor: &str) -> Vector3<f64> {
    Vector3::from_fn(|i, _| {
        let name = format!("{sensor}.{}", ["x", "y", "z"][i]);
        sample.values[names.iter().position(|found| *found == name).unwrap() - 1]
    })
}

/// Runs two flexible bodies on a pin and an elbow of this kind, and checks both sensors at the end.
fn balance(folder: &Path, kind: &str, seed: u64) {
    let models = [model(seed, 3), model(seed + 1, 2)];
    for (model, name) in models.iter().zip(["a.json", "b.json"]) {
        std::fs::write(folder.join(name), serde_json::to_string(model).unwrap()).unwrap();
    }
    let text = format!(
        "[simulation]\nduration = {DURATION}\nstep = 2e-4\ngravity = [{:?}, {:?}, {:?}]\noutput_step = {DURATION}\n\
         [bodies.a]\nmodel = \"a.json\"\nangular_velocity = [0.3, 1.2, -0.5]\nmodal_rates = [0.2, -0.1, 0.4]\n\
         [bodies.b]\nmodel = \"b.json\"\nposition = [0.3, 0.2, 0.1]\norientation = [0.9, 0.2, -0.3, 0.1]\n\
         angular_velocity = [-0.4, 0.2, 0.9]\nmodal_coordinates = [0.05, -0.03]\n\
         [joints.pin]\nkind = \"revolute\"\nfirst = \"ground\"\nfirst_position = [0.1, 0.0, 0.2]\nsecond = \"a.root\"\n\
         axis = [0.3, 0.2, 1.0]\n\
         [joints.elbow]\n{kind}\nfirst = \"a.tip\"\nsecond = \"b.root\"\naxis = [1.0, -0.4, 0.2]\n\
         [sensors.pin_force]\nkind = \"reaction_force\"\nof = \"pin\"\n\
         [sensors.pin_moment]\nkind = \"reaction_moment\"\nof = \"pin\"\n\
         [sensors.elbow_force]\nkind = \"reaction_force\"\nof = \"elbow\"\n\
         [sensors.elbow_moment]\nkind = \"reaction_moment\"\nof = \"elbow\"\n\
         [sensors.at_pin]\nkind = \"position\"\nof = \"a.root\"\n\
         [sensors.at_elbow]\nkind = \"position\"\nof = \"b.root\"\n",
        GRAVITY.x, GRAVITY.y, GRAVITY.z
    );
    let path = folder.join("scene.toml");
    std::fs::write(&path, text).unwrap();
    let scene = Scene::read(&path).unwrap_or_else(|error| panic!("{kind}: {error}"));
    let mut samples = Vec::new();
    let keep = |sample: &Sample| {
        samples.push(sample.clone());
        Ok(())
    };
    let summary = simulate(&scene, None, keep, |_| ()).unwrap_or_else(|error| panic!("{kind}: {error}"));
    let names = header(&scene);
    let seen = |sensor: &str| three(&names, samples.last().unwrap(), sensor);
    let states: Vec<_> = ["a", "b"].iter().map(|name| state_of(&summary.end.bodies[*name])).collect();
    let accelerations = Constrained(&scene.mechanism).evaluate(DURATION, states.clone(), None, |ports, _| {
        ports.0.iter().map(|port| port.motion.clone()).collect::<Vec<_>>()
    });
    let accelerations = accelerations.unwrap();
    let rates = [
        momentum_rates::<3, 9>(&models[0], &states[0], &accelerations[0]),
        momentum_rates::<2, 8>(&models[1], &states[1], &accelerations[1]),
    ];
    let elbow = [seen("elbow_force"), seen("elbow_moment") + seen("at_elbow").cross(&seen("elbow_force"))];
    let pin = [seen("pin_force"), seen("pin_moment") + seen("at_pin").cross(&seen("pin_force"))];
    assert!(elbow[0].norm() > 1e-3 || elbow[1].norm() > 1e-3, "{kind}: {elbow:?}");
    for (body, (rates, exerted)) in
        rates.iter().zip([[pin[0] - elbow[0], pin[1] - elbow[1]], elbow]).enumerate()
    {
        let (model, state) = (&models[body], &states[body]);
        let weight = GRAVITY * model.inertia.mass;
        let q = &state.modal_coordinates;
        let shifted = scene.mechanism.bodies()[body].first_mass_moment(q);
        let centre = state.position * model.inertia.mass + state.to_inertial(&shifted);
        let expected = [rates[0] - weight, rates[1] - centre.cross(&GRAVITY)];
        for (what, exerted, expected) in
            [("force", exerted[0], expected[0]), ("moment", exerted[1], expected[1])]
        {
            let size = rates[0].norm() + rates[1].norm() + weight.norm();
            let error = (exerted - expected).norm();
            assert!(error <= BALANCE * size, "{kind}, body {body}, {what}: {exerted} and {expected}");
        }
    }
}

#[test]
fn reaction_sensors_say_what_the_rate_of_momentum_says() {
    for (number, kind) in [
        "kind = \"revolute\"",
        "kind = \"revolute\"\ndrive = { angle = \"0.3*sin(2*t)\" }",
        "kind = \"spherical\"",
        "kind = \"universal\"",
        "kind = \"cylindrical\"",
        "kind = \"prismatic\"",
        "kind = \"prismatic\"\ndrive = { position = [0.0, 0.4, 1.0] }",
        "kind = \"planar\"",
        "kind = \"distance\"\nlength = 0.5",
        "kind = \"in_line\"",
        "kind = \"in_plane\"",
        "kind = \"constant_orientation\"",
        "kind = \"fixed\"",
        "kind = \"generic\"\ntranslation = [true, false, true]\nrotation = [true, true, false]",
    ]
    .iter()
    .enumerate()
    {
        let folder = tempfile::tempdir().unwrap();
        balance(folder.path(), kind, 11 + 2 * number as u64);
    }
}
