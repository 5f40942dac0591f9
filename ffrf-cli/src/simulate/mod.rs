//! `ffrf simulate`: a scene file to samples over time.

mod panels;

use std::fmt::Write as _;
use std::path::Path;
use std::time::{Duration, Instant};

use anyhow::{Context, Result};
use ffrf_host::analysis::largest_explicit_step;
use ffrf_host::scene::{Scene, StepChoice};
use ffrf_host::simulate::{
    Progress, SavedState, SceneCheck, SimulationError, Summary, check, header, simulate,
};

use crate::animation::{Show, Surface};
use crate::arguments::Simulate;
use crate::progress::ShareTeller;
use crate::results::{Columns, Format};
use crate::{animation, output, plots, view};

/// Runs the command.
pub fn run(arguments: &Simulate) -> Result<()> {
    let path = &arguments.scene;
    let scene = Scene::read(path).with_context(|| format!("{}", path.display()))?;
    if arguments.check {
        let found = check(&scene).with_context(|| format!("{}", path.display()))?;
        return output::say(&describe_check(&scene, &found));
    }
    // what cannot be written is refused before the work is done
    let format = arguments.output.as_deref().map(Format::of).transpose()?;
    if let Some(plot) = &arguments.plot {
        plots::refuse_other_pictures(plot)?;
    }
    if let Some(target) = &arguments.animation {
        view::expect_ending(target, view::ENDINGS)?;
    }
    let surfaces = read_surfaces(&scene, path, arguments.animation.is_some())?;
    let saved = arguments.load_state.as_deref().map(read_state).transpose()?;
    let mut columns = Columns { names: header(&scene), rows: Vec::new() };
    let begin = Instant::now();
    let teller = ShareTeller::new("simulate");
    let result = simulate(
        &scene,
        saved.as_ref(),
        |sample| {
            let mut row = Vec::with_capacity(1 + sample.values.len());
            row.push(sample.time);
            row.extend_from_slice(&sample.values);
            columns.rows.push(row);
            Ok(())
        },
        |Progress { time, share, steps }| teller.tell(share, &format!("t = {time:.4} s, {steps} steps")),
    );
    teller.end();
    let summary =
        result.map_err(|error| explain(&scene, error)).with_context(|| format!("{}", path.display()))?;
    let mut report = describe(&summary, begin.elapsed(), scene.settings.duration);
    let written = |target: &Path, report: &mut String| {
        let _ = writeln!(report, "written: {}", target.display());
    };
    let title = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    if let Some(target) = &arguments.plot {
        let times: Vec<f64> = columns.column(0).collect();
        let picture = plots::draw_histories(&title, "time / s", &times, &panels::panels(&scene, &columns))?;
        output::write(Some(target), &picture)?;
        written(target, &mut report);
    }
    if let Some(target) = &arguments.animation {
        let show = Show { playback: arguments.playback, deformation: arguments.deformation_scale };
        let (bytes, line) = animation::glb(&title, &scene, &columns, &surfaces, show)?;
        view::write(target, &title, &bytes)?;
        let _ = writeln!(report, "animation: {line}");
        written(target, &mut report);
    }
    if let (Some(target), Some(format)) = (&arguments.output, format) {
        output::write_bytes(target, &format.encode(&columns)?)?;
        written(target, &mut report);
        output::say_beside(target, &report)?;
    }
    if let Some(target) = &arguments.save_state {
        let state = serde_json::to_string_pretty(&summary.end)?;
        output::write(Some(target), &format!("{state}\n"))?;
    }
    Ok(())
}

/// What an explicit step that was refused could have been, by everything that is stiff in the scene.
fn explain(scene: &Scene, error: SimulationError) -> anyhow::Error {
    let StepChoice::Fixed(step) = scene.settings.step else { return error.into() };
    if !matches!(error, SimulationError::Step { .. }) {
        return error.into();
    }
    let limit = scene.assembled().ok().and_then(|(state, _)| {
        largest_explicit_step(scene, 0.0, &state, scene.settings.integrator).ok().flatten()
    });
    match limit {
        Some(limit) if limit < step => anyhow::anyhow!(
            "{error}\nmodes, joints and force elements together allow `{}` steps of at most {limit:.3e} s about the initial \
             state, the scene has {step:.3e} s",
            scene.settings.integrator.name()
        ),
        _ => error.into(),
    }
}

/// The surfaces that a scene names, of each body; none are read unless they are shown.
fn read_surfaces(scene: &Scene, path: &Path, shown: bool) -> Result<Vec<Option<Surface>>> {
    let folder = path.parent().unwrap_or_else(|| Path::new(""));
    let bodies = scene.surfaces.iter().zip(scene.mechanism.bodies());
    bodies
        .map(|(name, body)| match name {
            Some(name) if shown => Surface::read(&folder.join(name), body.mode_count()).map(Some),
            _ => Ok(None),
        })
        .collect()
}

fn read_state(path: &Path) -> Result<SavedState> {
    let text = std::fs::read_to_string(path).with_context(|| format!("{}", path.display()))?;
    serde_json::from_str(&text).with_context(|| format!("{}", path.display()))
}

fn describe(summary: &Summary, elapsed: Duration, duration: f64) -> String {
    let advance = &summary.advance;
    let mut text = format!(
        "steps: {} and {} shorter ones for samples, refused tries: {}, {:.3} s for {duration} s\n",
        advance.steps,
        advance.side_steps,
        advance.refused,
        elapsed.as_secs_f64()
    );
    let [position, velocity] = summary.initial_residuals;
    if position > 1e-12 || velocity > 1e-12 {
        let _ = writeln!(
            text,
            "the initial state missed the joints by {position:.3e} (m or rad) and {velocity:.3e} per second; it was moved \
             as little as possible, parts as a whole where that goes"
        );
    }
    let _ = writeln!(
        text,
        "largest drift of a step before it was corrected: {:.3e} (m or rad), {:.3e} per second",
        advance.drift.position, advance.drift.velocity
    );
    for event in &summary.events {
        let way = if event.rising { "rising" } else { "falling" };
        let _ = writeln!(text, "event {}: t = {:.9e} s, {way}", event.name, event.time);
    }
    for warning in &summary.spin {
        let _ = writeln!(text, "warning: {warning}");
    }
    if advance.iterations > 0 {
        let _ = writeln!(text, "most iterations of a step: {}", advance.iterations);
    }
    text
}

fn describe_check(scene: &Scene, found: &SceneCheck) -> String {
    let mut text = format!(
        "bodies: {}\njoints: {}\nvelocities: {}\nconstraint rows: {}, of which redundant: {}\ndegrees of freedom: {}\n",
        scene.body_names.join(", "),
        if scene.connection_names.is_empty() { "none".to_owned() } else { scene.connection_names.join(", ") },
        found.velocities,
        found.rows,
        found.redundant.len(),
        found.degrees_of_freedom
    );
    for body in &found.flying {
        let _ = writeln!(text, "  body {body} has no joint: it flies");
    }
    for row in &found.redundant {
        let _ = writeln!(text, "  redundant: {row}");
    }
    text.push_str("initial residuals (m or rad, and per second):\n");
    for (joint, [position, velocity]) in &found.residuals {
        let _ = writeln!(text, "  {joint}: {position:.3e}, {velocity:.3e}");
    }
    let [position, velocity] = found.assembled;
    let _ = writeln!(
        text,
        "once assembled: {position:.3e}, {velocity:.3e}; accelerations {:.3e} per second squared",
        found.accelerations
    );
    text
}
