//! Free flight of a baked body against the reference trajectory.

use ffrf::nalgebra::{Quaternion, SVector, UnitQuaternion};
use ffrf::{FlexibleBody, FreeBody};
use serde_json::Value;

use crate::Run;
use crate::compare::{deviation, numbers, vector, vector3};

/// Step of the classical Runge-Kutta method. Units: s. Small enough that its error is far below the tolerance.
const STEP: f64 = 1e-4;
/// Demanded agreement per block, relative to the block's largest value over the whole flight.
const AGREEMENT: f64 = 1e-8;

/// Integrates from the first sample and compares at every other one.
pub fn check<B, const M: usize>(run: &mut Run, name: &str, body: B)
where
    B: FlexibleBody<Modal = SVector<f64, M>>,
{
    let trajectory = run.read(&format!("{name}.json"));
    let samples = trajectory["samples"].as_array().expect("samples");
    let mut flight = start(body, &samples[0]);
    let blocks = ["q_t", "theta", "q", "v_t", "omega", "q_dot"];
    let mut worst = [0.0f64; 6];
    for sample in &samples[1..] {
        let until = sample["t"].as_f64().expect("t");
        let steps = ((until - flight.time) / STEP).round().max(1.0) as usize;
        let step = (until - flight.time) / steps as f64;
        for _ in 0..steps {
            flight.step_rk4(step, &()).expect("a step in free flight");
        }
        let state = &flight.state;
        let turn = state.orientation.to_rotation_matrix();
        let theta = state.orientation.quaternion();
        let sign = if theta.w * numbers(&sample["theta"])[0] < 0.0 { -1.0 } else { 1.0 };
        let found = [
            state.position.as_slice().to_vec(),
            vec![sign * theta.w, sign * theta.i, sign * theta.j, sign * theta.k],
            state.modal_coordinates.as_slice().to_vec(),
            state.velocity.as_slice().to_vec(),
            (turn * state.angular_velocity).as_slice().to_vec(),
            state.modal_rates.as_slice().to_vec(),
        ];
        for (index, block) in blocks.iter().enumerate() {
            let scale = largest(samples, block);
            worst[index] = worst[index].max(deviation(&found[index], &numbers(&sample[*block]), scale) );
        }
    }
    for (block, off) in blocks.iter().zip(worst) {
        run.check(&format!("{name}: {block}"), off, AGREEMENT);
    }
}

fn start<B, const M: usize>(body: B, sample: &Value) -> FreeBody<B>
where
    B: FlexibleBody<Modal = SVector<f64, M>>,
{
    let theta = numbers(&sample["theta"]);
    let orientation = UnitQuaternion::from_quaternion(Quaternion::new(theta[0], theta[1], theta[2], theta[3]));
    FreeBody::new(body)
        .with_position(vector3(&sample["q_t"]))
        .with_orientation(orientation)
        .with_velocity(vector3(&sample["v_t"]))
        .with_spin(orientation.inverse() * vector3(&sample["omega"]))
        .with_deformation(vector(&sample["q"]), vector(&sample["q_dot"]))
}

fn largest(samples: &[Value], block: &str) -> f64 {
    samples.iter().flat_map(|sample| numbers(&sample[block])).fold(0.0, |m: f64, x| m.max(x.abs()))
}
