//! From the mode choice on the command line to a mode basis, with a progress bar on long solves.

use std::time::Duration;

use anyhow::{Context, Result, bail};
use ffrf_fe::FeModel;
use ffrf_fe::import::read_mode_shapes;
use ffrf_fe::modes::{ModeRequest, ModeSolution, Progress, compute_modes, user_modes};
use indicatif::{ProgressBar, ProgressStyle};

use crate::arguments::ModeChoice;
use crate::fe_input::node_rows;

/// The modes that were asked for; `default_count` eigenmodes if the command line names none.
pub fn solve(model: &FeModel, choice: &ModeChoice, default_count: Option<usize>) -> Result<ModeSolution> {
    if let Some(path) = &choice.mode_shapes {
        let shapes = read_mode_shapes(path, model.nodes.len())?;
        return user_modes(model, shapes).with_context(|| format!("{}", path.display()));
    }
    let Some(count) = choice.modes.or(default_count) else {
        bail!("give --mode-shapes or --modes");
    };
    let request = match &choice.clamp {
        Some(clamp) => ModeRequest::clamped(count, node_rows(&model.nodes, clamp).context("--clamp")?),
        None => ModeRequest::free_free(count),
    };
    with_progress(|progress| compute_modes(model, &request, progress))
        .context("the modes could not be computed")
}

/// Runs a computation of modes and shows its progress.
pub fn with_progress<R>(compute: impl FnOnce(&mut dyn FnMut(Progress)) -> R) -> R {
    let bar = progress_bar();
    let result = compute(&mut |progress| show(&bar, progress));
    bar.finish_and_clear();
    result
}

/// A bar on standard error; hidden if that is not a terminal.
fn progress_bar() -> ProgressBar {
    let bar = ProgressBar::new(0);
    let style = ProgressStyle::with_template("{spinner} modes: {msg} [{bar:30}] {pos}/{len} {elapsed}");
    // The template is constant; should it ever be wrong, the plain bar serves.
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

fn show(bar: &ProgressBar, progress: Progress) {
    bar.set_message(progress.stage.to_string());
    bar.set_length(progress.total as u64);
    bar.set_position(progress.done as u64);
}
