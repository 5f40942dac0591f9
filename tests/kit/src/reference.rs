//! Reference trajectories: reading them, starting from them, comparing with them
//! (`../shared/reference/FORMAT.md`).

use ffrf_runtime::nalgebra::{SVector, Vector3};
use ffrf_runtime::{FreeBody, Gravity, rotation};
use serde_json::Value;

use crate::naive_body::{Invariants, NaiveBody};

/// The file of this name, or `None` with a loud note when the references are not here.
pub fn read(name: &str) -> Option<Value> {
    let path = format!("{}/../../../shared/reference/{name}", env!("CARGO_MANIFEST_DIR"));
    match std::fs::read_to_string(&path) {
        Ok(text) => Some(serde_json::from_str(&text).unwrap()),
        Err(_) => {
            eprintln!("SKIPPED: {path} is missing");
            None
        }
    }
}

/// The number that the value is.
pub fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("expected a number, found {value}"))
}

/// The three numbers that the value is.
pub fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from(numbers::<3>(value))
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

/// The body of the file's invariants, in the state of its first sample.
pub fn start<const M: usize, const N: usize>(file: &Value) -> FreeBody<NaiveBody<M, N>> {
    let (value, sample) = (&file["invariants"], &file["samples"][0]);
    let invariants = Invariants {
        mass: number(&value["m"]),
        centre_of_mass: numbers(&value["a"]),
        modal_centre_of_mass: rows(&value["b"]),
        euler_tensor: rows(&value["T"]),
        modal_euler_tensor: list(&value["T_mu"], rows),
        modal_pair_euler_tensor: list(&value["T_munu"], |row| list(row, rows)),
        stiffness: rows(&value["K_ff"]),
        damping: [[0.0; M]; M],
    };
    let orientation = rotation::from_euler_parameters(numbers(&sample["theta"])).unwrap();
    FreeBody::new(NaiveBody::new(&invariants))
        .with_position(vector(&sample["q_t"]))
        .with_orientation(orientation)
        .with_velocity(vector(&sample["v_t"]))
        // the files have inertial components
        .with_spin(orientation.inverse_transform_vector(&vector(&sample["omega"])))
        .with_deformation(
            SVector::from(numbers::<M>(&sample["q"])),
            SVector::from(numbers::<M>(&sample["q_dot"])),
        )
}

/// Gravity of the file, zero if it names none.
pub fn gravity(file: &Value) -> Gravity {
    let acceleration = &file["gravity"];
    Gravity { acceleration: if acceleration.is_null() { Vector3::zeros() } else { vector(acceleration) } }
}

/// What a sample holds, block by block.
fn blocks<const M: usize, const N: usize>(
    body: &FreeBody<NaiveBody<M, N>>,
    gravity: &Gravity,
) -> [(&'static str, Vec<f64>); 9] {
    let state = &body.state;
    let energy = body.kinetic_energy() + body.elastic_energy() + body.potential_energy(&gravity.acceleration);
    [
        ("q_t", state.position.as_slice().to_vec()),
        ("theta", with_positive_scalar(rotation::euler_parameters(&state.orientation).to_vec())),
        ("q", state.modal_coordinates.as_slice().to_vec()),
        ("v_t", state.velocity.as_slice().to_vec()),
        ("omega", state.to_inertial(&state.angular_velocity).as_slice().to_vec()),
        ("q_dot", state.modal_rates.as_slice().to_vec()),
        ("energy", vec![energy]),
        ("P", body.linear_momentum().as_slice().to_vec()),
        ("L_origin", body.angular_momentum().as_slice().to_vec()),
    ]
}

/// θ and -θ are the same orientation.
fn with_positive_scalar(mut theta: Vec<f64>) -> Vec<f64> {
    if theta[0] < 0.0 {
        theta.iter_mut().for_each(|x| *x = -*x);
    }
    theta
}

fn expected_block(sample: &Value, name: &str) -> Vec<f64> {
    let values: Vec<f64> = match &sample[name] {
        Value::Array(entries) => entries.iter().map(number).collect(),
        single => vec![number(single)],
    };
    if name == "theta" { with_positive_scalar(values) } else { values }
}

/// Follows the samples of `file` with `advance(body, step)`, a whole number of steps of about `step` between
/// samples; gives the largest deviation relative to the largest value of its block, and that block's name.
pub fn follow<const M: usize, const N: usize>(
    file: &Value,
    step: f64,
    mut advance: impl FnMut(&mut FreeBody<NaiveBody<M, N>>, f64, &Gravity),
) -> (f64, &'static str) {
    let samples = file["samples"].as_array().unwrap();
    assert!(samples.len() > 1, "a trajectory has more than its start");
    let gravity = gravity(file);
    let mut body = start::<M, N>(file);
    let mut worst = (0.0, "nothing");
    for sample in samples {
        let duration = number(&sample["t"]) - body.time;
        let steps = (duration / step).round();
        for _ in 0..steps as usize {
            advance(&mut body, duration / steps, &gravity);
        }
        for (name, found) in blocks(&body, &gravity) {
            let expected = expected_block(sample, name);
            assert_eq!(found.len(), expected.len(), "{name}");
            let scale =
                samples.iter().flat_map(|s| expected_block(s, name)).fold(0.0_f64, |m, x| m.max(x.abs()));
            let error = found.iter().zip(&expected).fold(0.0_f64, |most, (f, e)| most.max((f - e).abs()));
            // a block that is zero throughout (a held origin) is compared as it is
            let relative = if scale > 0.0 { error / scale } else { error };
            assert!(relative.is_finite(), "{name}: {found:?}");
            if relative > worst.0 {
                worst = (relative, name);
            }
        }
    }
    worst
}
