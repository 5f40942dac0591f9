//! The results as one page for a browser: the data in it, and what draws and filters them.

use anyhow::Result;
use ffrf_host::tradeoff::{Finding, INSTRUCTIONS_PER_OPERATION, Reference};
use serde::Serialize;

use super::row::Row;
use super::target_counts::TargetCounts;
use crate::markup::escaped;
use crate::trade_text::describe_reference;

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

#[derive(Serialize)]
struct Data<'a> {
    title: &'a str,
    channels: Vec<ChannelData<'a>>,
    own_error: f64,
    /// Names of the cores that something was counted on.
    cores: Vec<&'a str>,
    rows: Vec<RowData>,
}

#[derive(Serialize)]
struct ChannelData<'a> {
    name: &'a str,
    unit: &'a str,
    scale: f64,
    own_error: f64,
}

#[derive(Serialize)]
struct RowData {
    modes: String,
    mode_count: usize,
    fidelity: String,
    scalar: &'static str,
    integrator: &'static str,
    step: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    failure: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    found: Option<FoundData>,
}

#[derive(Serialize)]
struct FoundData {
    steps: u64,
    errors: Vec<f64>,
    time: f64,
    operations: f64,
    operations_per_step: f64,
    instructions_per_step: f64,
    data: usize,
    stack: usize,
    /// For each core what was counted, if it was.
    on_cores: Vec<Option<CoreData>>,
}

#[derive(Serialize)]
struct CoreData {
    instructions: u64,
    /// Per simulated second.
    instructions_per_second: f64,
    code: u64,
    data: u64,
    stack: u64,
}

/// The page.
pub fn html(title: &str, reference: &Reference, rows: &[Row<'_>], counts: &TargetCounts) -> Result<String> {
    let channels = reference.channels.iter().zip(&reference.scales).zip(&reference.own_errors);
    let data = Data {
        title,
        channels: channels
            .map(|((channel, scale), own_error)| ChannelData {
                name: &channel.name,
                unit: channel.unit,
                scale: *scale,
                own_error: *own_error,
            })
            .collect(),
        own_error: reference.own_error(),
        cores: counts.cores().collect(),
        rows: rows.iter().map(|row| row_data(row, counts)).collect(),
    };
    // inside a script element only the end of one must not stand
    let json = serde_json::to_string(&data)?.replace('<', "\\u003c");
    let heading = escaped(title);
    let note = escaped(&describe_reference(reference));
    Ok(format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Trade-off: {heading}</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<header><h1>Speed for accuracy: {heading}</h1></header>\n\
         <main>\n<section id=\"controls\"></section>\n<section id=\"picture\"></section>\n\
         <section id=\"best\"></section>\n<section id=\"table\"></section>\n\
         <section class=\"note\"><h2>What errors are taken against</h2><pre>{note}</pre></section>\n</main>\n\
         <script id=\"data\" type=\"application/json\">{json}</script>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n"
    ))
}

fn row_data(row: &Row<'_>, counts: &TargetCounts) -> RowData {
    let one = &row.outcome.configuration;
    let failure = match &row.outcome.finding {
        Finding::Failed(reason) => Some(reason.clone()),
        Finding::Finished(_) => None,
    };
    let found = row.measured().map(|measured| FoundData {
        steps: measured.steps,
        errors: measured.errors.clone(),
        time: measured.time,
        operations: measured.operations_per_second(),
        operations_per_step: measured.operations_per_step(),
        instructions_per_step: INSTRUCTIONS_PER_OPERATION * measured.operations_per_step(),
        data: row.outcome.data_bytes().unwrap_or(0),
        stack: row.outcome.stack_bytes().unwrap_or(0),
        on_cores: counts
            .cores()
            .map(|core| {
                let cost = counts.cost(core, one)?;
                let per_second = cost.instructions as f64 / measured.step;
                Some(CoreData {
                    instructions: cost.instructions,
                    instructions_per_second: per_second,
                    code: cost.code,
                    data: cost.data(),
                    stack: cost.stack,
                })
            })
            .collect(),
    });
    RowData {
        modes: one.modes.to_string(),
        mode_count: one.modes.most(),
        fidelity: one.fidelity.to_string(),
        scalar: one.scalar.name(),
        integrator: one.integrator.name(),
        step: row.measured().map_or(one.step, |measured| measured.step),
        failure,
        found,
    }
}
