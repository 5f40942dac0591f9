//! What a plot of a simulation shows: sensors, modal coordinates, energies, drift.

use ffrf_host::scene::{Scene, SensorKind};

use crate::plots::Panel;
use crate::results::Columns;

/// Most modal coordinates in one panel: as many as there are colours.
const MODES: usize = 6;

/// Panels of all sensors, of positions if there are none, of modal coordinates, energies and drift.
pub(super) fn panels(scene: &Scene, columns: &Columns) -> Vec<Panel> {
    let mut panels: Vec<Panel> = scene
        .sensors
        .iter()
        .map(|sensor| {
            let (what, unit) = quantity(&sensor.kind);
            let lines = sensor.kind.columns().iter().map(|ending| {
                let name = if ending.is_empty() { &sensor.name } else { ending.trim_start_matches('.') };
                (name.to_owned(), format!("{}{ending}", sensor.name))
            });
            panel(columns, &sensor.name, &axis(what, unit), lines)
        })
        .collect();
    if panels.is_empty() {
        panels.extend(scene.body_names.iter().map(|body| {
            let lines = ["x", "y", "z"].map(|part| (part.to_owned(), format!("{body}.position.{part}")));
            panel(columns, &format!("frame of {body}"), "position / m", lines)
        }));
    }
    for (name, body) in scene.body_names.iter().zip(scene.mechanism.bodies()) {
        if body.mode_count() > 0 {
            let modes = 1..=body.mode_count().min(MODES);
            let lines = modes.map(|mode| (format!("{mode}"), format!("{name}.modal_coordinates.{mode}")));
            panels.push(panel(columns, &format!("modes of {name}"), "modal coordinate", lines));
        }
    }
    let kinds = ["kinetic", "elastic", "potential"];
    let mut energy = panel(
        columns,
        "energies",
        "energy / J",
        kinds.map(|kind| (kind.to_owned(), format!("energy.{kind}"))),
    );
    let total: Vec<f64> = (0..columns.rows.len())
        .map(|row| energy.lines.iter().filter_map(|(_, values)| values.get(row)).sum())
        .collect();
    let change = total.iter().map(|now| now - total.first().unwrap_or(&0.0)).collect();
    energy.lines.push(("total".to_owned(), total));
    panels.push(energy);
    panels.push(Panel {
        title: "total energy: change since the beginning".to_owned(),
        axis: "energy / J".to_owned(),
        logarithmic: false,
        lines: vec![("change".to_owned(), change)],
    });
    if !scene.connection_names.is_empty() {
        let lines = [("positions", "position"), ("velocities", "velocity")];
        let lines = lines.map(|(name, kind)| (name.to_owned(), format!("drift.{kind}")));
        let drift = panel(columns, "largest residual of the joints", "m, rad, and per second", lines);
        panels.push(Panel { logarithmic: true, ..drift });
    }
    panels
}

/// A panel of columns: names in the legend, names of the columns.
fn panel(
    columns: &Columns,
    title: &str,
    axis: &str,
    lines: impl IntoIterator<Item = (String, String)>,
) -> Panel {
    let lines = lines.into_iter().filter_map(|(shown, column)| {
        let index = columns.names.iter().position(|name| *name == column)?;
        Some((shown, columns.column(index).collect()))
    });
    Panel { title: title.to_owned(), axis: axis.to_owned(), logarithmic: false, lines: lines.collect() }
}

fn axis(what: &str, unit: &str) -> String {
    if unit.is_empty() { what.to_owned() } else { format!("{what} / {unit}") }
}

fn quantity(kind: &SensorKind) -> (&'static str, &'static str) {
    match kind {
        SensorKind::Position(_) => ("position", "m"),
        SensorKind::Velocity(_) => ("velocity", "m/s"),
        SensorKind::Acceleration(_) => ("acceleration", "m/s²"),
        SensorKind::Orientation(_) => ("Euler parameters", ""),
        SensorKind::Angle(_) => ("angle", "rad"),
        SensorKind::ReactionForce(_) => ("force", "N"),
        SensorKind::ReactionMoment(_) => ("moment", "N m"),
        SensorKind::Stress { .. } => ("stress", "N/m²"),
        SensorKind::SectionForce { .. } => ("section force and moment", "N, N m"),
    }
}
