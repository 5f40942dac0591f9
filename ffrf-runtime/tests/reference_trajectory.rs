//! Free flight of the reference body, against a trajectory computed elsewhere (FORMAT.md of the references).
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

mod common;

use common::naive_body::{Invariants, NaiveBody};
use common::tolerances::REFERENCE_TRAJECTORY;
use ffrf_runtime::nalgebra::{SVector, Vector3};
use ffrf_runtime::{FreeBody, rotation};
use serde_json::Value;

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/reference/traj_free_synth_m3.json");
const MODES: usize = 3;
type Body = FreeBody<NaiveBody<MODES, 9>, MODES, 9>;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("expected a number, found {value}"))
}

fn list<const R: usize, X>(value: &Value, entry: impl Fn(&Value) -> X) -> [X; R] {
    core::array::from_fn(|i| entry(&value[i]))
}

fn numbers<const R: usize>(value: &Value) -> [f64; R] {
    list(value, number)
}

fn rows<const R: usize, const C: usize>(value: &Value) -> [[f64; C]; R] {
    list(value, numbers)
}

fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from(numbers::<3>(value))
}

fn invariants(value: &Value) -> Invariants<MODES> {
    Invariants {
        mass: number(&value["m"]),
        centre_of_mass: numbers(&value["a"]),
        modal_centre_of_mass: rows(&value["b"]),
        euler_tensor: rows(&value["T"]),
        modal_euler_tensor: list(&value["T_mu"], rows),
        modal_pair_euler_tensor: list(&value["T_munu"], |row| list(row, rows)),
        stiffness: rows(&value["K_ff"]),
        damping: [[0.0; MODES]; MODES],
    }
}

fn start(kernels: NaiveBody<MODES, 9>, sample: &Value) -> Body {
    let orientation = rotation::from_euler_parameters(numbers(&sample["theta"])).unwrap();
    FreeBody::new(kernels)
        .with_position(vector(&sample["q_t"]))
        .with_orientation(orientation)
        .with_velocity(vector(&sample["v_t"]))
        // the files have inertial components
        .with_spin(orientation.inverse_transform_vector(&vector(&sample["omega"])))
        .with_deformation(
            SVector::from(numbers::<MODES>(&sample["q"])),
            SVector::from(numbers::<MODES>(&sample["q_dot"])),
        )
}

/// What a sample holds, block by block.
fn blocks(body: &Body) -> [(&'static str, Vec<f64>); 9] {
    let state = &body.state;
    let mut theta = rotation::euler_parameters(&state.orientation).to_vec();
    if theta[0] < 0.0 {
        theta.iter_mut().for_each(|x| *x = -*x);
    }
    [
        ("q_t", state.position.as_slice().to_vec()),
        ("theta", theta),
        ("q", state.modal_coordinates.as_slice().to_vec()),
        ("v_t", state.velocity.as_slice().to_vec()),
        ("omega", state.to_inertial(&state.angular_velocity).as_slice().to_vec()),
        ("q_dot", state.modal_rates.as_slice().to_vec()),
        ("energy", vec![body.kinetic_energy() + body.elastic_energy()]),
        ("P", body.linear_momentum().as_slice().to_vec()),
        ("L_origin", body.angular_momentum().as_slice().to_vec()),
    ]
}

/// The same block of a sample; the sign of Euler parameters is chosen as in [`blocks`].
fn expected_block(sample: &Value, name: &str) -> Vec<f64> {
    let mut values: Vec<f64> = match &sample[name] {
        Value::Array(entries) => entries.iter().map(number).collect(),
        single => vec![number(single)],
    };
    if name == "theta" && values[0] < 0.0 {
        values.iter_mut().for_each(|x| *x = -*x);
    }
    values
}

#[test]
fn small_steps_follow_the_reference() {
    let Ok(text) = std::fs::read_to_string(FILE) else {
        eprintln!("SKIPPED: reference_trajectory, {FILE} is missing");
        return;
    };
    let file: Value = serde_json::from_str(&text).unwrap();
    let samples = file["samples"].as_array().unwrap();
    assert!(samples.len() > 1);
    let largest = |name: &str| {
        samples
            .iter()
            .flat_map(|sample| expected_block(sample, name))
            .fold(0.0_f64, |most, x| most.max(x.abs()))
    };

    let mut body = start(NaiveBody::new(&invariants(&file["invariants"])), &samples[0]);
    let (step, mut worst) = (2.5e-4, ("", 0.0_f64));
    for sample in samples {
        let time = number(&sample["t"]);
        // whole steps of the same size to each sample
        let steps = ((time - body.time) / step).round() as usize;
        let exact_step = (time - body.time) / (steps.max(1) as f64);
        for _ in 0..steps {
            body.step_rk4(exact_step, &()).unwrap();
        }
        for (name, found) in blocks(&body) {
            let expected = expected_block(sample, name);
            assert_eq!(found.len(), expected.len(), "{name}");
            let scale = largest(name);
            let error =
                found.iter().zip(&expected).fold(0.0_f64, |most, (f, e)| most.max((f - e).abs())) / scale;
            assert!(error < REFERENCE_TRAJECTORY, "t = {time}, {name}: {found:?} but {expected:?}");
            if error > worst.1 {
                worst = (name, error);
            }
        }
    }
    eprintln!("free trajectory, step {step} s: worst relative deviation {:.1e} in {}", worst.1, worst.0);
}
