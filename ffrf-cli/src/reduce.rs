//! `ffrf reduce`: finite-element files to a reduced body.

use std::path::Path;

use anyhow::{Context, Result};
use ffrf_fe::import::{read_square_matrix, source_file};
use ffrf_fe::reduction::{Damping, MODE_SHAPES, MarkerRequest, ReductionOptions, reduce};
use ffrf_fe::{FeModel, ModeBasis, Nodes};
use ffrf_host::picture::Shape;
use ffrf_model::ReducedBody;

use crate::animation::{body_glb, skin};
use crate::arguments::{MarkerArgument, Reduce};
use crate::fe_input::node_rows;
use crate::{component_modes, describe, fe_input, modes, output, stiffening, stress, view};

/// Runs the command.
pub fn run(arguments: &Reduce) -> Result<()> {
    if let Some(target) = &arguments.view {
        view::expect_ending(target, view::ENDINGS)?;
    }
    if let Some(target) = &arguments.sheet {
        view::expect_ending(target, &[".svg"])?;
    }
    let mut model = fe_input::read(&arguments.files)?;
    let say = |text: &str| output::say_beside(&arguments.output, text);
    say(&format!("{}\n", fe_input::describe(&model)))?;
    if let Some(remark) = arguments.files.body_units().and_then(fe_input::remark_on_time) {
        say(&format!("{remark}\n"))?;
    }
    let mut options = options(arguments, &model.nodes)?;
    if !arguments.interfaces.interfaces.is_empty() {
        let (body, basis, text) =
            modes::with_progress(|progress| component_modes::reduce(&model, arguments, &options, progress))?;
        say(&format!("{text}\n"))?;
        draw(arguments, &model, &basis, &body)?;
        return finish(arguments, &body);
    }
    let solution = modes::solve(&model, &arguments.choice, None, arguments.files.conversion())?;
    if let Some(path) = &arguments.modal_stiffness {
        let mut stiffness = read_square_matrix(path, solution.basis.modes.len())?;
        if let Some(conversion) = arguments.files.conversion() {
            conversion.modal_stiffness(&mut stiffness);
        }
        options.modal_stiffness = Some(stiffness);
    }
    let extra =
        [(MODE_SHAPES, &arguments.choice.mode_shapes), ("modal stiffness", &arguments.modal_stiffness)];
    for (role, path) in extra {
        if let Some(path) = path {
            model.sources.push(source_file(path, role)?);
        }
    }
    say(&format!("{}\n", solution.report))?;
    let first = solution.report.modes.first().and_then(|mode| mode.frequency_hz);
    fe_input::warn_of_units(&model, arguments.files.body_units(), first);
    let mut body = reduce(&model, &solution.basis, &options)?;
    let support = stiffening::support(&model, &arguments.choice)?;
    let conversion = arguments.files.conversion();
    stiffening::add(&mut body, &model, &solution.basis, &support, &arguments.stiffening, conversion)?;
    stress::add(&mut body, &model, &solution.basis, arguments)?;
    draw(arguments, &model, &solution.basis, &body)?;
    finish(arguments, &body)
}

/// Writes the pictures that are asked for.
fn draw(arguments: &Reduce, model: &FeModel, basis: &ModeBasis, body: &ReducedBody) -> Result<()> {
    let wanted = [&arguments.surface, &arguments.view, &arguments.sheet];
    if wanted.iter().all(|target| target.is_none()) {
        return Ok(());
    }
    let surface = skin(model, basis)?;
    let said = |target: &Path| {
        let Shape { points, triangles, .. } = &surface.0;
        let text = format!(
            "surface of {} points, {} triangles; written: {}\n",
            points.len(),
            triangles.len(),
            target.display()
        );
        output::say_beside(&arguments.output, &text)
    };
    if let Some(target) = &arguments.surface {
        output::write_bytes(target, &surface.encode()?)?;
        said(target)?;
    }
    if let Some(target) = &arguments.view {
        view::write(target, &body.title, &body_glb(body, &surface.0))?;
        said(target)?;
    }
    if let Some(target) = &arguments.sheet {
        output::write(Some(target), &view::draw_sheet(body, &surface.0)?)?;
        said(target)?;
    }
    Ok(())
}

/// Checks, writes and describes the body.
fn finish(arguments: &Reduce, body: &ReducedBody) -> Result<()> {
    let say = |text: &str| output::say_beside(&arguments.output, text);
    let checks = body.check()?;
    checks.verdict()?;
    output::write(Some(&arguments.output), &body.to_json()?)?;
    say(&format!("\n{}\n{}", describe::body(body), describe::checks(&checks)))?;
    say(&format!("written: {}\n", arguments.output.display()))
}

fn options(arguments: &Reduce, nodes: &Nodes) -> Result<ReductionOptions> {
    let damping = match (&arguments.damping_ratio, arguments.rayleigh, &arguments.damping_bands) {
        (Some(ratios), ..) => Damping::ModalRatio(ratios.clone()),
        (None, Some((alpha, beta)), _) => Damping::Rayleigh { alpha, beta },
        (None, None, Some(bands)) => bands.clone(),
        (None, None, None) => Damping::None,
    };
    Ok(ReductionOptions {
        title: arguments.title.clone().unwrap_or_else(|| arguments.files.name()),
        units: arguments.files.body_units(),
        damping,
        markers: arguments.markers.iter().map(|marker| request(marker, nodes)).collect::<Result<_>>()?,
        modal_stiffness: None,
    })
}

fn request(marker: &MarkerArgument, nodes: &Nodes) -> Result<MarkerRequest> {
    let rows = node_rows(nodes, &marker.nodes).with_context(|| format!("--marker {}", marker.name))?;
    Ok(MarkerRequest { name: marker.name.clone(), nodes: rows })
}
