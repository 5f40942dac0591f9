//! `ffrf reduce`: finite-element files to a reduced body.

use anyhow::{Context, Result};
use ffrf_fe::Nodes;
use ffrf_fe::import::{read_square_matrix, source_file};
use ffrf_fe::reduction::{Damping, MarkerRequest, ReductionOptions, reduce};
use ffrf_model::ReducedBody;

use crate::arguments::{MarkerArgument, Reduce};
use crate::fe_input::node_rows;
use crate::{component_modes, describe, fe_input, modes};

/// Runs the command.
pub fn run(arguments: &Reduce) -> Result<()> {
    let mut model = fe_input::read(&arguments.files)?;
    println!("{}", fe_input::describe(&model));
    let mut options = options(arguments, &model.nodes)?;
    if !arguments.interfaces.interfaces.is_empty() {
        let (body, text) =
            modes::with_progress(|progress| component_modes::reduce(&model, arguments, &options, progress))?;
        println!("{text}");
        return finish(arguments, &body);
    }
    let solution = modes::solve(&model, &arguments.choice, None)?;
    if let Some(path) = &arguments.modal_stiffness {
        options.modal_stiffness = Some(read_square_matrix(path, solution.basis.modes.len())?);
    }
    let extra =
        [("mode shapes", &arguments.choice.mode_shapes), ("modal stiffness", &arguments.modal_stiffness)];
    for (role, path) in extra {
        if let Some(path) = path {
            model.sources.push(source_file(path, role)?);
        }
    }
    println!("{}", solution.report);
    finish(arguments, &reduce(&model, &solution.basis, &options)?)
}

/// Checks, writes and describes the body.
fn finish(arguments: &Reduce, body: &ReducedBody) -> Result<()> {
    let checks = body.check()?;
    checks.verdict()?;
    body.write(&arguments.output)?;
    println!("\n{}", describe::body(body));
    print!("{}", describe::checks(&checks));
    println!("written: {}", arguments.output.display());
    Ok(())
}

fn options(arguments: &Reduce, nodes: &Nodes) -> Result<ReductionOptions> {
    let damping = match (&arguments.damping_ratio, arguments.rayleigh) {
        (Some(ratios), _) => Damping::ModalRatio(ratios.clone()),
        (None, Some((alpha, beta))) => Damping::Rayleigh { alpha, beta },
        (None, None) => Damping::None,
    };
    Ok(ReductionOptions {
        title: arguments.title.clone().unwrap_or_else(|| arguments.files.name()),
        units: arguments.units.clone(),
        damping,
        markers: arguments.markers.iter().map(|marker| request(marker, nodes)).collect::<Result<_>>()?,
        modal_stiffness: None,
    })
}

fn request(marker: &MarkerArgument, nodes: &Nodes) -> Result<MarkerRequest> {
    let rows = node_rows(nodes, &marker.nodes).with_context(|| format!("--marker {}", marker.name))?;
    Ok(MarkerRequest { name: marker.name.clone(), nodes: rows })
}
