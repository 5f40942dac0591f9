//! A whole mesh of 10,000 coordinates swinging as a pendulum: what the one factorisation and a step cost.
//!
//! `cargo run --release -p ffrf-fe --example absolute_coordinates`

use std::error::Error;
use std::time::Instant;

use faer::Mat;
use ffrf_fe::elements::{Material, brick};
use ffrf_fe::formulations::corotated::{CorotatedModel, GroundJoint, Midpoint, Motion};

const STEP: f64 = 1e-3;
const STEPS: usize = 20;

fn main() -> Result<(), Box<dyn Error>> {
    let rubber = Material { youngs_modulus: 5e6, poisson_ratio: 0.4, density: 1100.0 };
    let model = brick([1.0, 0.1, 0.08], [48, 8, 7], &rubber)?;
    let body = CorotatedModel::absolute(&model)?;
    let held: Vec<usize> = (0..model.nodes.len()).filter(|&n| model.nodes.positions[n][0] == 0.0).collect();
    let clock = Instant::now();
    let mut rule = Midpoint::new(&body, body.mean_frame(), &[GroundJoint::mean_of(&held)], STEP)?;
    println!("{} coordinates, factored in {:.0} ms", 3 * body.triples(), 1e3 * clock.elapsed().as_secs_f64());
    rule.load = body.gravity([0.0, 0.0, -9.81]);
    let velocity = Mat::zeros(3 * body.triples(), 1);
    let mut motion = Motion { time: 0.0, position: body.reference.clone(), velocity };
    let energy = rule.energy(&motion)?;
    let (clock, mut iterations) = (Instant::now(), 0);
    for _ in 0..STEPS {
        iterations += rule.advance(&mut motion)?.iterations;
    }
    let per_step = 1e3 * clock.elapsed().as_secs_f64() / STEPS as f64;
    println!(
        "{per_step:.0} ms a step of {STEP} s, {:.1} iterations a step",
        iterations as f64 / STEPS as f64
    );
    let (mass, _) = body.centre_of_mass();
    let change = (rule.energy(&motion)? - energy) / (mass * 9.81);
    println!("energy changed by {change:.1e} of the weight times a metre");
    Ok(())
}
