//! One pendulum in absolute coordinates (ACF), generalised modes (GCMS) and the floating frame (FFRF).
//!
//! Prints and draws how their motions converge to each other: with the step, with the modes, and with the amplitude
//! for what a formulation neglects. The figures stand in `docs/theory`.
//!
//! `cargo run --example equivalence [folder for the figures]`

mod bodies;
mod pendulum;
#[path = "../free_conrod/plot.rs"]
mod plot;

use std::error::Error;
use std::path::{Path, PathBuf};

use ffrf_fe::formulations::corotated::{CorotatedModel, Frame};
use pendulum::{Formulation, Pendulum, largest_distance};
use plot::{Axes, Line, Panel, Size, draw};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args()
        .nth(1)
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/theory/figures"), PathBuf::from);
    std::fs::create_dir_all(&folder)?;
    same_motion(&folder)?;
    step_size(&folder)?;
    number_of_modes(&folder)?;
    amplitude(&folder)?;
    println!("figures in {}", folder.display());
    Ok(())
}

/// Height of the tip over time in all formulations.
fn same_motion(folder: &Path) -> Result<(), Box<dyn Error>> {
    let pendulum = Pendulum::new(bodies::beam([6, 1, 1])?, 1.0);
    let time = 1.2;
    let mut lines = Vec::new();
    for (name, formulation, steps) in [
        ("ACF, 84 coordinates", Formulation::absolute(), 1200),
        ("GCMS, 8 modes", Formulation::Generalized { modes: 8 }, 1200),
        ("FFRF, 2 modes", Formulation::Floating { modes: 2 }, 2400),
        ("FFRF, all 78 modes", Formulation::Floating { modes: 78 }, 2400),
    ] {
        let path = pendulum.tip_path(&formulation, time, steps)?;
        lines.push(Line::new(name, path.iter().step_by(steps / 200).map(|(t, x)| (*t, x[2]))));
    }
    chart(
        &folder.join("same_motion.svg"),
        Axes::Linear,
        ["Height of the tip of a soft spinning beam held at a corner", "t / s", "z / m"],
        lines,
    )
}

/// Largest distance of the tips over time, against the step of the implicit rule.
fn step_size(folder: &Path) -> Result<(), Box<dyn Error>> {
    let mut lines = Vec::new();
    for (name, model, modes, time) in
        [("beam", bodies::beam([2, 1, 1])?, 30, 0.5), ("three bars", bodies::three_bars()?, 3, 0.5)]
    {
        let pendulum = Pendulum::new(model, 1.0);
        let truth = pendulum.tip_path(&Formulation::Floating { modes }, time, 6400)?;
        for (kind, formulation) in
            [("ACF", Formulation::absolute()), ("GCMS", Formulation::Generalized { modes })]
        {
            let mut points = Vec::new();
            for steps in [200, 400, 800, 1600, 3200] {
                let error = largest_distance(&truth, &pendulum.tip_path(&formulation, time, steps)?);
                points.push((time / steps as f64, error));
            }
            let order = slope(&points[points.len() - 2..]);
            println!(
                "{name}, {kind} against FFRF with all {modes} modes: order {order:.2} in the step, {}",
                listed(&points)
            );
            lines.push(Line::new(format!("{name}: {kind}, order {order:.2}"), points));
        }
    }
    chart(
        &folder.join("step_size.svg"),
        Axes::Logarithmic,
        ["Against the floating frame with all modes", "step / s", "largest distance of the tips / m"],
        lines,
    )
}

/// Largest distance of the tips against the number of modes, the whole mesh being the truth.
fn number_of_modes(folder: &Path) -> Result<(), Box<dyn Error>> {
    let pendulum = Pendulum::new(bodies::beam([6, 1, 1])?, 1.0);
    let (time, steps) = (0.4, 400);
    let truth = pendulum.tip_path(&Formulation::absolute(), time, steps)?;
    let mut lines = Vec::new();
    for (name, counts) in [("GCMS", &[1, 2, 4, 8, 16, 32][..]), ("FFRF", &[1, 2, 4, 8, 16, 32, 64, 78][..])] {
        let mut points = Vec::new();
        for &modes in counts {
            let (formulation, factor) = match name {
                "GCMS" => (Formulation::Generalized { modes }, 1),
                _ => (Formulation::Floating { modes }, 4),
            };
            let path = pendulum.tip_path(&formulation, time, factor * steps)?;
            points.push((modes as f64, largest_distance(&truth, &path).max(1e-16)));
        }
        println!("{name} against ACF by modes: {}", listed(&points));
        lines.push(Line::new(name, points));
    }
    chart(
        &folder.join("number_of_modes.svg"),
        Axes::Logarithmic,
        ["Free-free modes against the whole mesh", "modes M", "largest distance of the tips / m"],
        lines,
    )
}

/// Distance of the tips relative to the deformation, against the deformation: gravity and spin² scale with it.
fn amplitude(folder: &Path) -> Result<(), Box<dyn Error>> {
    let model = bodies::beam([2, 1, 1])?;
    let (time, steps) = (0.25, 6400);
    let three_points = Frame::three_points(CorotatedModel::absolute(&model)?.reference.as_ref(), [0, 2, 3])?;
    let variants = [
        ("mean frame with f_nl", Formulation::absolute()),
        ("mean frame without f_nl", Formulation::Absolute { frame: None, nonlinear_term: false }),
        ("frame by three nodes", Formulation::Absolute { frame: Some(three_points), nonlinear_term: true }),
    ];
    let mut lines: Vec<Line> = variants.iter().map(|(name, _)| Line::new(*name, [])).collect();
    for scale in [1.0, 0.3, 0.1, 0.03, 0.01, 0.003, 0.001] {
        let pendulum = Pendulum::new(model.clone(), scale);
        let truth = pendulum.tip_path(&Formulation::Floating { modes: 30 }, time, steps / 2)?;
        let rigid = pendulum.tip_path(&Formulation::Floating { modes: 0 }, time, steps / 2)?;
        let deformation = largest_distance(&truth, &rigid);
        for (line, (_, formulation)) in lines.iter_mut().zip(&variants) {
            let path = pendulum.tip_path(formulation, time, steps)?;
            line.points.push((deformation, largest_distance(&truth, &path) / deformation));
        }
    }
    for line in &mut lines {
        let order = slope(&line.points[line.points.len() - 3..]);
        println!(
            "{}: relative difference of order {order:.2} in the amplitude, {}",
            line.name,
            listed(&line.points)
        );
        line.name = format!("{}, slope {order:.2}", line.name);
    }
    chart(
        &folder.join("amplitude.svg"),
        Axes::Logarithmic,
        ["ACF against FFRF with all modes", "deviation from rigid motion / m", "distance / deviation"],
        lines,
    )
}

/// Draws one panel with its title, its x and its y.
fn chart(path: &Path, axes: Axes, names: [&str; 3], lines: Vec<Line>) -> Result<(), Box<dyn Error>> {
    let [title, x, y] = names.map(str::to_owned);
    let panel = Panel { title, x, y, axes, lines };
    draw(path, Size { width: 900, height: 420, legend_width: 260 }, &[panel])
}

fn listed(points: &[(f64, f64)]) -> String {
    points.iter().map(|(x, y)| format!("({x:.1e}, {y:.1e})")).collect::<Vec<_>>().join(" ")
}

/// Slope between the first and the last point in double logarithmic axes.
fn slope(points: &[(f64, f64)]) -> f64 {
    match (points.first(), points.last()) {
        (Some(a), Some(b)) => (b.1 / a.1).ln() / (b.0 / a.0).ln(),
        _ => f64::NAN,
    }
}
