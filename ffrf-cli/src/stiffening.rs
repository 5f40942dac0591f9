//! `ffrf reduce --geometric-stiffness`: what inertial loads add to the stiffness of a body.

use anyhow::{Context, Result};
use ffrf_fe::geometric_stiffness::{PrestressSupport, geometric_stiffness, marker_load_stiffness};
use ffrf_fe::units::Conversion;
use ffrf_fe::{Elasticity, FeModel, ModeBasis};
use ffrf_model::{Marker, ReducedBody};

use crate::arguments::{ModeChoice, StiffeningChoice};
use crate::fe_input::node_rows;

/// How the part is held while inertial loads strain it: as its modes are.
pub fn support(model: &FeModel, choice: &ModeChoice) -> Result<PrestressSupport> {
    Ok(match &choice.clamp {
        Some(clamp) => {
            PrestressSupport::Clamped { nodes: node_rows(&model.nodes, clamp).context("--clamp")? }
        }
        None => PrestressSupport::MeanAxes,
    })
}

/// Constants of the command line in the units of the body.
pub fn elasticity(given: Option<(f64, f64)>, conversion: Option<Conversion>) -> Option<Elasticity> {
    let (youngs_modulus, poisson_ratio) = given?;
    let elasticity = Elasticity { youngs_modulus, poisson_ratio };
    Some(conversion.map_or(elasticity, |conversion| conversion.elasticity(elasticity)))
}

/// Adds geometric stiffness to the body if it is asked for.
pub fn add(
    body: &mut ReducedBody,
    model: &FeModel,
    basis: &ModeBasis,
    support: &PrestressSupport,
    choice: &StiffeningChoice,
    conversion: Option<Conversion>,
) -> Result<()> {
    if !choice.geometric_stiffness {
        return Ok(());
    }
    let given = elasticity(choice.elastic, conversion);
    let mut stiffness = geometric_stiffness(model, basis, support, given).context("--geometric-stiffness")?;
    let markers = choice.load_stiffness.iter().map(|name| {
        body.markers.iter().find(|marker| marker.name == *name).with_context(|| {
            let known: Vec<&str> = body.markers.iter().map(|marker| marker.name.as_str()).collect();
            format!("--load-stiffness {name}: no such marker or interface; there are: {}", known.join(", "))
        })
    });
    let markers: Vec<&Marker> = markers.collect::<Result<_>>()?;
    stiffness.marker_loads =
        marker_load_stiffness(model, basis, support, given, &markers).context("--load-stiffness")?;
    body.geometric_stiffness = Some(stiffness);
    Ok(())
}
