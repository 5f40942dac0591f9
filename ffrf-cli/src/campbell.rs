//! `ffrf campbell`: eigenfrequencies of a scene against the speed of rotation.

use std::fmt::Write as _;

use anyhow::{Context, Result};
use ffrf_host::analysis::{CampbellPoint, SpinFrame, SpinTarget, Whirl, campbell};
use ffrf_host::scene::Scene;

use crate::arguments::Campbell;
use crate::results::{Columns, Format};
use crate::{output, plots};

/// Runs the command.
pub fn run(arguments: &Campbell) -> Result<()> {
    let (path, target) = (&arguments.scene, &arguments.output);
    let format = Format::of(target)?;
    if let Some(plot) = &arguments.plot {
        plots::refuse_other_pictures(plot)?;
    }
    let in_scene = || format!("{}", path.display());
    let scene = Scene::read(path).with_context(in_scene)?;
    let speeds = arguments.speeds.even();
    let found = campbell(&scene, &SpinTarget::named(&scene, &arguments.spin), &speeds, None)
        .with_context(in_scene)?;
    let names = [
        "speed",
        "mode",
        "frequency_hz",
        "damping_ratio",
        "eigenvalue_real",
        "eigenvalue_imaginary",
        "whirl",
    ];
    let rows = found.points.iter().map(|point| {
        vec![
            point.speed,
            point.mode as f64,
            point.frequency_hz(),
            point.damping_ratio(),
            point.eigenvalue.re,
            point.eigenvalue.im,
            whirl_number(point.whirl),
        ]
    });
    let columns = Columns { names: names.map(str::to_owned).to_vec(), rows: rows.collect() };
    output::write_bytes(target, &format.encode(&columns)?)?;
    let in_space = found.frames.contains(&SpinFrame::Space);
    let mut report = format!("{} speeds, {} eigenvalues\n", speeds.len(), found.points.len());
    if in_space {
        report.push_str("computed in the rotating frame; circles are told as the inertial frame sees them\n");
    }
    for point in found.points.iter().filter(|point| grows(point)).take(1) {
        let _ = writeln!(
            report,
            "unstable from {} rad/s on: {} whirl at {:.4} Hz has the damping ratio {:.3e}",
            point.speed,
            point.whirl.name(),
            point.frequency_hz(),
            point.damping_ratio()
        );
    }
    let _ = writeln!(report, "written: {}", target.display());
    if let Some(plot) = &arguments.plot {
        output::write(Some(plot), &plots::draw_campbell(&found.points)?)?;
        let _ = writeln!(report, "written: {}", plot.display());
    }
    output::say_beside(target, &report)
}

/// Whether a vibration grows, by more than round-off.
fn grows(point: &CampbellPoint) -> bool {
    point.eigenvalue.im > 0.0 && point.damping_ratio() < -1e-6
}

/// The whirl as a number of a column: 1 forward, -1 backward, 0 planar, 2 axial, 3 as the rotating frame sees it.
fn whirl_number(whirl: Whirl) -> f64 {
    match whirl {
        Whirl::Forward => 1.0,
        Whirl::Backward => -1.0,
        Whirl::Axial => 2.0,
        Whirl::Rotating => 3.0,
        _ => 0.0,
    }
}
