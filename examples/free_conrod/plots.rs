//! The three plots of the flight: energy, spin, modal amplitudes.

use std::error::Error;
use std::path::Path;

use crate::M;
use crate::flight::{FINE_UNTIL, FRAMES_UNTIL, Record, Sample};
use crate::part::Part;
use crate::plot::{Axes, Line, Panel, Size, draw};

const SIZE: Size = Size { width: 1100, height: 340, legend_width: 210 };

/// Points per line over the whole flight.
const POINTS: usize = 1000;

/// Writes `energy.svg`, `spin.svg` and `modal_amplitudes.svg`.
pub fn write(folder: &Path, record: &Record, part: &Part) -> Result<(), Box<dyn Error>> {
    for (name, panels) in [
        ("energy.svg", energy(record)),
        ("spin.svg", spin(record)),
        ("modal_amplitudes.svg", modal_amplitudes(record, part)),
    ] {
        let path = folder.join(name);
        draw(&path, SIZE, &panels)?;
        println!("  written: {}", path.display());
    }
    Ok(())
}

fn line(name: &str, samples: &[Sample], value: impl Fn(&Sample) -> f64) -> Line {
    Line::new(name, samples.iter().map(|sample| (sample.time, value(sample))))
}

/// Every so many samples of the whole flight.
fn sparse(record: &Record) -> Vec<Sample> {
    record.coarse.iter().step_by(record.coarse.len().div_ceil(POINTS)).copied().collect()
}

fn panel(title: String, y: &str, lines: Vec<Line>) -> Panel {
    Panel { title, x: "time / s".to_owned(), y: y.to_owned(), axes: Axes::Signals, lines }
}

fn energy(record: &Record) -> Vec<Panel> {
    let start = record.coarse[0].kinetic_energy;
    let whole = sparse(record);
    vec![
        panel(
            format!(
                "Energy, first {:.0} ms: in a flip the stretch gives its energy to the motion",
                1e3 * FRAMES_UNTIL
            ),
            "energy / J",
            vec![
                line("kinetic, change since the start", &record.frames, |s| s.kinetic_energy - start),
                line("elastic", &record.frames, |s| s.elastic_energy),
            ],
        ),
        panel(
            "Drift of the total energy, whole flight".to_owned(),
            "relative drift",
            vec![line("energy", &whole, |s| record.energy_drift(s))],
        ),
    ]
}

fn spin(record: &Record) -> Vec<Panel> {
    let component = |name, i: usize| line(name, &record.frames, move |s| s.state.angular_velocity[i]);
    let whole = sparse(record);
    vec![
        panel(
            format!("Angular velocity in the body frame, first {:.0} ms", 1e3 * FRAMES_UNTIL),
            "angular velocity / (rad/s)",
            vec![
                component("x, along the rod", 0),
                component("y, middle inertia", 1),
                component("z, along the bores", 2),
            ],
        ),
        panel(
            "Drift of the momenta, whole flight".to_owned(),
            "relative drift",
            vec![
                line("linear momentum", &whole, |s| record.momentum_drift(s)[0]),
                line("angular momentum", &whole, |s| record.momentum_drift(s)[1]),
            ],
        ),
    ]
}

/// Modal coordinates as the largest displacement that each alone makes, in µm.
fn modal_amplitudes(record: &Record, part: &Part) -> Vec<Panel> {
    let unit = |mu: usize| {
        let mut q = [0.0; M];
        q[mu] = 1.0;
        1e6 * part.largest_displacement(&q)
    };
    let scale: [f64; M] = std::array::from_fn(unit);
    let name =
        |mu: usize| format!("mode {}, {:.0} Hz", mu + 1, part.body.modes[mu].frequency_hz.unwrap_or(0.0));
    let window = record.coarse.len().div_ceil(POINTS / 5).max(1);
    let peak = |samples: &[Sample], mu: usize| {
        samples.iter().map(|s| (scale[mu] * s.state.modal_coordinates[mu]).abs()).fold(0.0, f64::max)
    };
    // Small motions need a scale of their own to be seen beside large ones.
    let largest = (0..M).map(|mu| peak(&record.fine, mu)).fold(0.0, f64::max);
    let (large, small): (Vec<usize>, Vec<usize>) =
        (0..M).partition(|&mu| peak(&record.fine, mu) > largest / 3.0);
    let ringing = |title: String, modes: &[usize]| {
        let signal = |&mu: &usize| {
            line(&name(mu), &record.fine, |s| scale[mu] * s.state.modal_coordinates[mu]).coloured(mu)
        };
        panel(title, "displacement / µm", modes.iter().map(signal).collect())
    };
    let envelope = |mu: usize| {
        let chunks = record.coarse.chunks_exact(window);
        Line::new(name(mu), chunks.map(|chunk| (chunk[0].time, peak(chunk, mu))))
    };
    let mut panels = vec![ringing(
        format!("Modal displacement, first {:.0} ms: ringing after the blow", 1e3 * FINE_UNTIL),
        &large,
    )];
    if !small.is_empty() {
        panels.push(ringing("The smaller ones of the same time".to_owned(), &small));
    }
    panels.push(panel(
        "Largest modal displacement in consecutive windows, whole flight".to_owned(),
        "displacement / µm",
        (0..M).map(envelope).collect(),
    ));
    panels
}
