//! What is written of a sweep: tables, pictures and the page.

use std::path::Path;

use anyhow::Result;
use ffrf_host::tradeoff::{Outcome, Reference};

use super::target_counts::TargetCounts;
use super::{page, row, table};
use crate::{output, plots};

/// Name of the page in the folder of a sweep.
pub const PAGE: &str = "report.html";

/// Tables, pictures and the page.
pub fn write_all(
    folder: &Path,
    title: &str,
    reference: &Reference,
    outcomes: &[Outcome],
    counts: &TargetCounts,
) -> Result<()> {
    let rows = row::rows(outcomes);
    let write = |name: &str, text: &str| output::write(Some(&folder.join(name)), text);
    write("table.txt", &table::text(title, reference, &rows, counts))?;
    write("table.csv", &table::csv(reference, &rows, counts))?;
    for (name, cost) in [("time", plots::COST_TIME), ("operations", plots::COST_OPERATIONS)] {
        let points: Vec<plots::TradePoint> = rows
            .iter()
            .filter_map(|row| {
                let measured = row.measured()?;
                let one = &row.outcome.configuration;
                let by_time = name == "time";
                Some(plots::TradePoint {
                    series: one.integrator.name().to_owned(),
                    line: format!(
                        "{} {} {} {}",
                        one.modes,
                        one.fidelity,
                        one.scalar.name(),
                        one.integrator.name()
                    ),
                    cost: if by_time { measured.time } else { measured.operations_per_second() },
                    error: measured.error(),
                    on_front: row.on_front[usize::from(!by_time)],
                })
            })
            .collect();
        // a sweep of which nothing came has no picture
        if points.is_empty() {
            continue;
        }
        let own = reference.own_error();
        write(
            &format!("work_precision_{name}.svg"),
            &plots::draw_work_precision(title, cost, &points, own)?,
        )?;
        write(&format!("pareto_{name}.svg"), &plots::draw_pareto(title, cost, &points, own)?)?;
    }
    write(PAGE, &page::html(title, reference, &rows, counts)?)
}
