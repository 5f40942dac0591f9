//! A flexible pendulum from a scene file against the reference trajectory, which comes from elsewhere.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers beside the tests

use std::path::Path;

use ffrf_host::scene::Scene;
use ffrf_host::simulate::{Sample, check, header, simulate};
use serde_json::{Value, json};

/// Against the largest value of each block, at a step that resolves the highest mode well (order 4).
const REFERENCE: f64 = 1e-7;

fn reference(name: &str) -> Option<Value> {
    let path = format!("{}/../../shared/reference/{name}", env!("CARGO_MANIFEST_DIR"));
    match std::fs::read_to_string(&path) {
        Ok(text) => Some(serde_json::from_str(&text).unwrap()),
        Err(_) => {
            eprintln!("SKIPPED: {path} is missing");
            None
        }
    }
}

/// The model file of the invariants of a reference file.
fn model(invariants: &Value) -> Value {
    let number = |value: &Value| value.as_f64().unwrap();
    let mass = number(&invariants["m"]);
    let times_mass =
        |value: &Value| -> Vec<f64> { value.as_array().unwrap().iter().map(|x| mass * number(x)).collect() };
    let modes = invariants["b"].as_array().unwrap();
    let count = modes.len();
    json!({
        "schema_version": 1, "title": "reference", "units": "SI",
        "provenance": {"tool": "test", "tool_version": "0", "sources": []},
        "modes": vec![json!({"kind": "user", "frequency_hz": null}); count],
        "inertia": {
            "mass": mass,
            "first_moment": times_mass(&invariants["a"]),
            "modal_first_moment": modes.iter().map(times_mass).collect::<Vec<_>>(),
            "second_moment": invariants["T"],
            "position_mode_moment": invariants["T_mu"],
            "mode_mode_moment": invariants["T_munu"],
        },
        "stiffness": invariants["K_ff"],
        "damping": vec![vec![0.0; count]; count],
        "markers": [],
    })
}

fn list(value: &Value) -> String {
    value.to_string()
}

/// The samples of a scene in `folder`.
fn run(folder: &Path, scene: &str) -> (Vec<String>, Vec<Sample>) {
    let path = folder.join("scene.toml");
    std::fs::write(&path, scene).unwrap();
    let scene = Scene::read(&path).unwrap_or_else(|error| panic!("{error}"));
    let mut samples = Vec::new();
    let summary = simulate(
        &scene,
        None,
        |sample| {
            samples.push(sample.clone());
            Ok(())
        },
        |_| (),
    )
    .unwrap();
    eprintln!("{:?}", summary.advance);
    eprintln!("{:?}", check(&scene).unwrap());
    (header(&scene), samples)
}

#[test]
fn the_flexible_pendulum_follows_the_reference() {
    let Some(file) = reference("traj_pendulum_beam_m4.json") else { return };
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("beam.json"), model(&file["invariants"]).to_string()).unwrap();
    // the first second is enough to see every mode, and short enough for a test
    let samples = &file["samples"].as_array().unwrap()[..6];
    let first = &samples[0];
    let last = samples.last().unwrap();
    let omega = {
        // inertial in the reference, body in the scene; the start is at identity or not
        let theta: Vec<f64> =
            first["theta"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
        let q = nalgebra::UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(
            theta[0], theta[1], theta[2], theta[3],
        ));
        let w: Vec<f64> = first["omega"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
        q.inverse_transform_vector(&nalgebra::Vector3::new(w[0], w[1], w[2]))
    };
    let interval = samples[1]["t"].as_f64().unwrap();
    for (integrator, step) in [("rk4", "step = 5e-5"), ("dopri5", "tolerance = 1e-9")] {
        let scene = format!(
            "[simulation]\nduration = {}\n{step}\nintegrator = \"{integrator}\"\ngravity = {}\noutput_step = {interval}\n\
             [bodies.beam]\nmodel = \"beam.json\"\nposition = {}\norientation = {}\nvelocity = {}\nangular_velocity = [{:?}, {:?}, {:?}]\n\
             modal_coordinates = {}\nmodal_rates = {}\n\
             [joints.pin]\nkind = \"spherical\"\nfirst = \"ground\"\nsecond = \"beam\"\n\
             [sensors.load]\nkind = \"reaction_force\"\nof = \"pin\"\n",
            last["t"],
            list(&file["gravity"]),
            list(&first["q_t"]),
            list(&first["theta"]),
            list(&first["v_t"]),
            omega.x,
            omega.y,
            omega.z,
            list(&first["q"]),
            list(&first["q_dot"]),
        );
        let (names, found) = run(folder.path(), &scene);
        assert_eq!(found.len(), samples.len());
        for (block, columns) in
            [("q", "beam.modal_coordinates."), ("reaction", "load."), ("theta", "beam.orientation.")]
        {
            let places: Vec<usize> =
                (0..names.len()).filter(|i| names[*i].starts_with(columns)).map(|i| i - 1).collect();
            let scale = samples
                .iter()
                .flat_map(|s| s[block].as_array().unwrap().iter().map(|x| x.as_f64().unwrap().abs()))
                .fold(0.0, f64::max);
            let mut worst = 0.0_f64;
            for (sample, expected) in found.iter().zip(samples) {
                assert!((sample.time - expected["t"].as_f64().unwrap()).abs() < 1e-12);
                let values: Vec<f64> = places.iter().map(|place| sample.values[*place]).collect();
                let expected: Vec<f64> =
                    expected[block].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
                let sign = if block == "theta" && values[0] * expected[0] < 0.0 { -1.0 } else { 1.0 };
                for (value, expected) in values.iter().zip(expected) {
                    worst = worst.max((sign * value - expected).abs() / scale);
                }
            }
            eprintln!("{integrator}, {block}: {worst:e}");
            assert!(worst < REFERENCE, "{integrator}, {block}: {worst:e}");
        }
    }
}
