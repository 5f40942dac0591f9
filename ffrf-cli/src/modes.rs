//! From the mode choice on the command line to a mode basis.

use anyhow::{Context, Result, bail};
use ffrf_fe::FeModel;
use ffrf_fe::import::read_mode_shapes;
use ffrf_fe::modes::{ModeRequest, ModeSolution, Progress, compute_modes, user_modes};
use ffrf_fe::units::Conversion;

use crate::arguments::ModeChoice;
use crate::fe_input::node_rows;
use crate::progress::Teller;

/// The modes that were asked for, those of a file converted; `default_count` eigenmodes if the command line names none.
pub fn solve(
    model: &FeModel,
    choice: &ModeChoice,
    default_count: Option<usize>,
    conversion: Option<Conversion>,
    progress: &mut dyn FnMut(Progress),
) -> Result<ModeSolution> {
    if let Some(path) = &choice.mode_shapes {
        let mut shapes = read_mode_shapes(path, model.nodes.len())?;
        if let Some(conversion) = conversion {
            conversion.shapes(&mut shapes);
        }
        return user_modes(model, shapes).with_context(|| format!("{}", path.display()));
    }
    let Some(count) = choice.modes.or(default_count) else {
        bail!("give --mode-shapes or --modes");
    };
    let request = match &choice.clamp {
        Some(clamp) => ModeRequest::clamped(count, node_rows(&model.nodes, clamp).context("--clamp")?),
        None => ModeRequest::free_free(count),
    };
    compute_modes(model, &request, progress).context("the modes could not be computed")
}

/// Runs a computation of modes and tells its progress on standard error.
pub fn with_progress<R>(compute: impl FnOnce(&mut dyn FnMut(Progress)) -> R) -> R {
    let teller = Teller::new();
    compute(&mut |progress| teller.tell(progress))
}
