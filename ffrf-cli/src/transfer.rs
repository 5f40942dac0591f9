//! `ffrf reduce --transfer-up-to`: how well a basis, and others beside it, follow the full model over frequency.

use std::fmt::Write as _;

use anyhow::{Context, Result, bail};
use ffrf_fe::FeModel;
use ffrf_fe::component_modes::{
    ComponentBasis, ComponentModes, ComponentRequest, ModeSelection, TransferPoint, compare_bases,
    component_modes,
};

use crate::arguments::InterfaceChoice;
use crate::plots::{self, Curve};

/// Table of the truncation error over frequency, and its plot.
pub fn compare(
    model: &FeModel,
    modes: &ComponentModes,
    request: &ComponentRequest,
    choice: &InterfaceChoice,
    limit: f64,
) -> Result<String> {
    if !(limit.is_finite() && limit > 0.0) {
        bail!("--transfer-up-to: expected a frequency above 0 Hz, found {limit}");
    }
    let count = choice.transfer_points.max(1);
    let frequencies: Vec<f64> = (1..=count).map(|i| limit * i as f64 / count as f64).collect();
    let size = modes.basis.modes.len();
    let mut names = vec![name(request.basis, size)];
    let mut others = Vec::new();
    for &basis in choice.transfer_bases.iter().flat_map(|bases| &bases.0) {
        if basis == request.basis {
            continue;
        }
        let other = same_size(model, modes, request, basis)
            .with_context(|| format!("--transfer-bases: {basis} modes"))?;
        names.push(name(basis, other.basis.modes.len()));
        others.push(other);
    }
    let bases: Vec<&ComponentModes> = std::iter::once(modes).chain(&others).collect();
    let points = compare_bases(model, &bases, &frequencies).context("interface transfer functions")?;
    let curves: Vec<Curve> = names.into_iter().zip(points).collect();
    if let Some(path) = &choice.transfer_plot {
        let picture = plots::draw_transfer(&curves)?;
        ffrf_model::write_file(path, picture.as_bytes())
            .with_context(|| format!("{}: cannot be written", path.display()))?;
    }
    Ok(if choice.transfer_bases.is_some() { table_of_bases(&curves)? } else { table(&curves) })
}

fn name(basis: ComponentBasis, modes: usize) -> String {
    format!("{basis}, {modes} modes")
}

/// The modes of another basis for the same interfaces, as many as `modes` has if its static shapes are no more.
fn same_size(
    model: &FeModel,
    modes: &ComponentModes,
    request: &ComponentRequest,
    basis: ComponentBasis,
) -> Result<ComponentModes> {
    let shapes = basis.static_shapes(request.interfaces.len(), modes.report.rigid_modes);
    let size = modes.basis.modes.len();
    let request = ComponentRequest {
        basis,
        normal_modes: size.saturating_sub(shapes + request.static_loads.len()),
        selection: ModeSelection::default(),
        ..request.clone()
    };
    Ok(component_modes(model, &request, &mut |_| {})?)
}

fn table(curves: &[Curve]) -> String {
    let mut text = String::from(
        "interface transfer functions, elastic part, each motion relative to its static compliance\n\
         frequency/Hz    full model       reduced         error\n",
    );
    for TransferPoint { frequency_hz, full, reduced, error } in curves.iter().flat_map(|(_, points)| points) {
        text.push_str(&format!("{frequency_hz:>12.3}  {full:>12.6e}  {reduced:>12.6e}  {error:>12.3e}\n"));
    }
    text
}

/// Errors of several bases, a table that documents can take as it is.
fn table_of_bases(curves: &[Curve]) -> Result<String> {
    let mut text = String::from(
        "error of the interface transfer functions, elastic part, each motion relative to its static compliance\n\n\
         | frequency/Hz |",
    );
    for (name, _) in curves {
        write!(text, " {name} |")?;
    }
    text.push_str("\n| ---: |");
    text.push_str(&" ---: |".repeat(curves.len()));
    text.push('\n');
    let rows = curves.first().map_or(0, |(_, points)| points.len());
    for row in 0..rows {
        let points: Vec<&TransferPoint> = curves.iter().filter_map(|(_, points)| points.get(row)).collect();
        let frequency = points.first().map_or(0.0, |point| point.frequency_hz);
        write!(text, "| {frequency:.1} |")?;
        for point in points {
            write!(text, " {:.1e} |", point.error)?;
        }
        text.push('\n');
    }
    Ok(text)
}
