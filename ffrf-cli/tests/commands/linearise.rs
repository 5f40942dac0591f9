//! `ffrf linearise` and `ffrf campbell` as a user runs them.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::io::Cursor;
use std::process::Output;

use super::program::{ffrf, scene};

fn said(run: &Output) -> String {
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    String::from_utf8_lossy(&run.stdout).into_owned()
}

#[test]
fn the_crane_comes_to_rest_and_its_load_sways() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let (matrices, table, picture, rest) = (at("c.npz"), at("r.csv"), at("r.svg"), at("rest.json"));
    let range = ["--frequencies", "0.05,5,40"];
    let run = ffrf(
        &[
            &["linearise", &scene("crane.toml"), "-o", &matrices, "--response", &table],
            &["--response-plot", &picture, "--save-state", &rest][..],
            &range[..],
        ]
        .concat(),
    );
    let text = said(&run);
    // slewing, and of the load two ways of swaying and three free rotations
    assert!(text.contains("degrees of freedom: 6, inputs: wind"), "{text}");
    let mut archive = zip::ZipArchive::new(Cursor::new(std::fs::read(&matrices).unwrap())).unwrap();
    let npy = |archive: &mut zip::ZipArchive<_>, name: &str| {
        let npy = npyz::NpyFile::new(archive.by_name(name).unwrap()).unwrap();
        (npy.shape().to_vec(), npy.into_vec::<f64>().unwrap())
    };
    let (shape, a) = npy(&mut archive, "A.npy");
    assert_eq!(shape, [12, 12]);
    assert!(a.iter().all(|x| x.is_finite()));
    // in the plane of the boom nothing gives: the load is a pendulum on its cable, under gravity and a little wind
    let (_, frequencies) = npy(&mut archive, "frequencies_hz.npy");
    let sway = (9.81_f64.hypot(20.0 / 300.0) / 3.0).sqrt() / std::f64::consts::TAU;
    assert!(frequencies.iter().any(|f| (f - sway).abs() < 1e-6), "{frequencies:?} {sway}");
    let response = std::fs::read_to_string(&table).unwrap();
    assert!(response.starts_with("frequency,load.x/wind.real,"), "{response}");
    assert_eq!(response.lines().count(), 41);
    assert!(std::fs::read_to_string(&picture).unwrap().contains("response to wind"));
    // where the boom has stopped for a moment, the load sways and the drive accelerates: no state of rest
    let (samples, moved) = (at("crane.csv"), at("moved.json"));
    said(&ffrf(&["simulate", &scene("crane.toml"), "-o", &samples, "--save-state", &moved]));
    let moved = ffrf(&["linearise", &scene("crane.toml"), "--load-state", &moved]);
    assert!(said(&moved).contains("no equilibrium"));
}

#[test]
fn a_campbell_diagram_is_a_table_and_a_picture() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let (table, picture) = (at("c.csv"), at("c.svg"));
    let file = scene("rotor.toml");
    let run = ffrf(&[
        "campbell", &file, "--spin", "rotor", "--speeds", "0,600,4", "-o", &table, "--plot", &picture,
    ]);
    assert!(said(&run).contains("4 speeds"));
    let text = std::fs::read_to_string(&table).unwrap();
    assert!(text.starts_with("speed,mode,frequency_hz,damping_ratio,"));
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|line| line.split(',').map(|x| x.parse().unwrap()).collect()).collect();
    // forward tilt rises with speed, backward tilt falls
    let highest =
        |speed: f64| rows.iter().filter(|row| row[0] == speed).map(|row| row[2]).fold(0.0_f64, f64::max);
    assert!(highest(0.0) < highest(200.0) && highest(200.0) < highest(600.0));
    assert!(std::fs::read_to_string(&picture).unwrap().contains("backward"));
    let wrong = ffrf(&["campbell", &file, "--spin", "stator", "--speeds", "0,600,4", "-o", &table]);
    let said = String::from_utf8_lossy(&wrong.stderr).into_owned();
    assert_eq!(wrong.status.code(), Some(1));
    assert!(said.contains("`stator`") && said.contains("rotor"), "{said}");
    let wrong = ffrf(&["campbell", &file, "--spin", "rotor", "--speeds", "9,1,4", "-o", &table]);
    assert_eq!(wrong.status.code(), Some(2));
}
