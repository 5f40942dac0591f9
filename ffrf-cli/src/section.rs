//! `ffrf reduce --section`: cuts where the transmitted force is observed.

use anyhow::{Context, Result};
use ffrf_fe::section::{SectionRequest, section_marker};
use ffrf_fe::{FeModel, ModeBasis};
use ffrf_model::ReducedBody;

use crate::arguments::Reduce;

/// Adds the section markers that are asked for.
pub fn add(body: &mut ReducedBody, model: &FeModel, basis: &ModeBasis, arguments: &Reduce) -> Result<()> {
    for section in &arguments.sections {
        let request =
            SectionRequest { name: section.name.clone(), point: section.point, normal: section.normal };
        let marker =
            section_marker(model, basis, &request).with_context(|| format!("--section {}", section.name))?;
        body.section_markers.push(marker);
    }
    Ok(())
}
