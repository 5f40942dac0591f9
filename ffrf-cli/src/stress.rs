//! `ffrf reduce --stress`: places where stress is observed.

use anyhow::{Context, Result};
use ffrf_fe::stress::{StressRequest, stress_marker};
use ffrf_fe::{FeModel, ModeBasis, PartElasticity};
use ffrf_model::ReducedBody;

use crate::arguments::Reduce;
use crate::fe_input::node_rows;
use crate::stiffening;

/// Adds the stress markers that are asked for.
pub fn add(body: &mut ReducedBody, model: &FeModel, basis: &ModeBasis, arguments: &Reduce) -> Result<()> {
    if arguments.stress.is_empty() {
        return Ok(());
    }
    let elasticity = match stiffening::elasticity(arguments.stiffening.elastic, arguments.files.conversion())
    {
        Some(given) => given.into(),
        None => PartElasticity::of_model(model).context("--stress")?,
    };
    for marker in &arguments.stress {
        let about = || format!("--stress {}", marker.name);
        let nodes = node_rows(&model.nodes, &marker.nodes).with_context(about)?;
        let request = StressRequest { name: marker.name.clone(), nodes };
        let marker = stress_marker(model, basis, &elasticity, &request).with_context(about)?;
        body.stress_markers.push(marker);
    }
    Ok(())
}
