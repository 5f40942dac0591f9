//! `ffrf linearise`: a scene to a linear system, its eigenmodes and its frequency response.

use std::ffi::OsStr;
use std::fmt::Write as _;
use std::path::Path;

use anyhow::{Context, Result, bail};
use ffrf_host::analysis::{
    Drives, Eigenmode, StateSpace, eigenmodes, equilibrium, frequency_response, linearise,
};
use ffrf_host::scene::Scene;
use ffrf_host::simulate::SavedState;

use crate::arguments::{Linearise, StateChoice};
use crate::plots::Panel;
use crate::results::{Array, Columns, Format, archive, mat};
use crate::{output, plots};

/// Runs the command.
pub fn run(arguments: &Linearise) -> Result<()> {
    let path = &arguments.scene;
    if let Some(target) = &arguments.output {
        refuse_other_endings(target)?;
    }
    if let Some(plot) = &arguments.response_plot {
        plots::refuse_other_pictures(plot)?;
    }
    let scene = Scene::read(path).with_context(|| format!("{}", path.display()))?;
    let in_scene = || format!("{}", path.display());
    let mut report = String::new();
    let (time, state, drives) = match (&arguments.load_state, arguments.at) {
        (Some(saved), _) => {
            let text = std::fs::read_to_string(saved).with_context(|| format!("{}", saved.display()))?;
            let saved: SavedState =
                serde_json::from_str(&text).with_context(|| format!("{}", saved.display()))?;
            (saved.time, saved.states(&scene).with_context(in_scene)?, Drives::Moving)
        }
        (None, StateChoice::Initial) => (0.0, scene.assembled().with_context(in_scene)?.0, Drives::Moving),
        (None, StateChoice::Rest) => {
            let rest = equilibrium(&scene).with_context(in_scene)?;
            let _ = writeln!(
                report,
                "state of rest, with drives held: {} iterations, accelerations of {:.1e} are left",
                rest.iterations, rest.residual
            );
            if let Some(target) = &arguments.save_state {
                let text = serde_json::to_string_pretty(&rest.saved(&scene))?;
                output::write(Some(target), &format!("{text}\n"))?;
                let _ = writeln!(report, "written: {}", target.display());
            }
            (rest.time, rest.state, Drives::Held)
        }
    };
    let system = linearise(&scene, time, &state, drives).with_context(in_scene)?;
    let modes = eigenmodes(&system.a).with_context(in_scene)?;
    report.push_str(&describe(&system, &modes));
    if let Some(target) = &arguments.output {
        output::write_bytes(target, &encode(target, &system, &modes)?)?;
        let _ = writeln!(report, "written: {}", target.display());
    }
    if let Some(range) = arguments.frequencies {
        respond(arguments, &system, &range.geometric(), &mut report).with_context(in_scene)?;
    }
    output::say(&report)
}

fn refuse_other_endings(path: &Path) -> Result<()> {
    match path.extension().map(OsStr::to_string_lossy).as_deref() {
        Some("npz" | "mat") => Ok(()),
        _ => bail!("{}: expected a name that ends in .npz or .mat", path.display()),
    }
}

fn describe(system: &StateSpace, modes: &[Eigenmode]) -> String {
    let mut text = format!(
        "degrees of freedom: {}, inputs: {}, outputs: {}\n",
        system.a.nrows() / 2,
        list(&system.inputs),
        list(&system.outputs)
    );
    let left = system.accelerations.norm();
    if left > 1e-6 {
        let _ =
            writeln!(text, "the state is no equilibrium: accelerations of {left:.3e} (by kinetic energy)");
    }
    text.push_str("mode   frequency/Hz   damping ratio   eigenvalue (1/s)\n");
    for (index, mode) in modes.iter().enumerate() {
        let (frequency, damping, value) = (mode.frequency_hz(), mode.damping_ratio(), mode.eigenvalue);
        let _ = writeln!(
            text,
            "{:>4} {frequency:>14.6} {damping:>15.6e}   {:.6e} {:+.6e} i",
            index + 1,
            value.re,
            value.im
        );
    }
    text
}

fn list(names: &[String]) -> String {
    if names.is_empty() { "none".to_owned() } else { names.join(", ") }
}

/// The arrays of a file, in both formats.
fn encode(path: &Path, system: &StateSpace, modes: &[Eigenmode]) -> Result<Vec<u8>> {
    let matrix = |name: &str, rows: usize, columns: usize, entry: &dyn Fn(usize, usize) -> f64| {
        let entries = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
        let values = entries.map(|(i, j)| entry(i, j)).collect();
        (name.to_owned(), Array::Numbers { shape: vec![rows, columns], values })
    };
    let list = |name: &str, of: &dyn Fn(&Eigenmode) -> f64| {
        (name.to_owned(), Array::Numbers { shape: vec![modes.len()], values: modes.iter().map(of).collect() })
    };
    let shapes: Vec<_> = modes.iter().map(|mode| system.basis.map(Into::into) * &mode.vector).collect();
    let (rows, columns) = (system.basis.nrows(), modes.len());
    let mut arrays = Vec::new();
    for (name, found) in [
        ("A", &system.a),
        ("B", &system.b),
        ("C", &system.c),
        ("D", &system.d),
        ("basis", &system.basis),
        ("projection", &system.projection),
    ] {
        arrays.push(matrix(name, found.nrows(), found.ncols(), &|i, j| found[(i, j)]));
    }
    arrays.extend([
        list("eigenvalues_real", &|mode| mode.eigenvalue.re),
        list("eigenvalues_imaginary", &|mode| mode.eigenvalue.im),
        list("frequencies_hz", &Eigenmode::frequency_hz),
        list("damping_ratios", &Eigenmode::damping_ratio),
        matrix("modes_real", rows, columns, &|i, j| shapes[j][i].re),
        matrix("modes_imaginary", rows, columns, &|i, j| shapes[j][i].im),
        ("coordinates".to_owned(), Array::Texts(system.coordinates.clone())),
        ("inputs".to_owned(), Array::Texts(system.inputs.clone())),
        ("outputs".to_owned(), Array::Texts(system.outputs.clone())),
    ]);
    if path.extension().is_some_and(|ending| ending == "mat") { Ok(mat(arrays)) } else { archive(arrays) }
}

/// The frequency response as a table and as a picture.
fn respond(
    arguments: &Linearise,
    system: &StateSpace,
    frequencies: &[f64],
    report: &mut String,
) -> Result<()> {
    if system.inputs.is_empty() || system.outputs.is_empty() {
        bail!("a frequency response needs a force or moment with a direction, and a sensor, in the scene");
    }
    let responses = frequency_response(system, frequencies)?;
    let pairs: Vec<(usize, usize, String)> = system
        .inputs
        .iter()
        .enumerate()
        .flat_map(|(j, input)| {
            system.outputs.iter().enumerate().map(move |(i, output)| (i, j, format!("{output}/{input}")))
        })
        .collect();
    let mut columns = Columns { names: vec!["frequency".to_owned()], rows: Vec::new() };
    for (_, _, name) in &pairs {
        columns.names.extend([format!("{name}.real"), format!("{name}.imaginary")]);
    }
    for (frequency, response) in frequencies.iter().zip(&responses) {
        let entries = pairs.iter().flat_map(|(i, j, _)| [response[(*i, *j)].re, response[(*i, *j)].im]);
        columns.rows.push(std::iter::once(*frequency).chain(entries).collect());
    }
    if let Some(target) = &arguments.response {
        output::write_bytes(target, &Format::of(target)?.encode(&columns)?)?;
        let _ = writeln!(report, "written: {}", target.display());
    }
    if let Some(target) = &arguments.response_plot {
        let mut panels = Vec::new();
        for (j, input) in system.inputs.iter().enumerate() {
            let of = |value: &dyn Fn(usize) -> Vec<f64>| -> Vec<(String, Vec<f64>)> {
                let lines = pairs.iter().filter(|pair| pair.1 == j).map(|pair| pair.0);
                lines.map(|i| (system.outputs[i].clone(), value(i))).collect()
            };
            let entries = |i: usize| responses.iter().map(move |response| response[(i, j)]);
            let panel = |title: String, axis: &str, logarithmic: bool, lines| Panel {
                title,
                axis: axis.to_owned(),
                logarithmic,
                lines,
            };
            let moving = |(_, values): &(String, Vec<f64>)| values.iter().any(|value| *value > 0.0);
            let sizes: Vec<_> =
                of(&|i| entries(i).map(|entry| entry.norm()).collect()).into_iter().filter(moving).collect();
            let shown: Vec<String> = sizes.iter().map(|(name, _)| name.clone()).collect();
            let phases = of(&|i| entries(i).map(|entry| entry.arg().to_degrees()).collect());
            let phases = phases.into_iter().filter(|(name, _)| shown.contains(name)).collect();
            panels.push(panel(format!("response to {input}"), "magnitude", true, sizes));
            panels.push(panel(format!("phase to {input}"), "phase / °", false, phases));
        }
        let decades: Vec<f64> = frequencies.iter().map(|frequency| frequency.log10()).collect();
        let axis = "log10 of frequency / Hz";
        output::write(Some(target), &plots::draw_histories("frequency response", axis, &decades, &panels)?)?;
        let _ = writeln!(report, "written: {}", target.display());
    }
    Ok(())
}
