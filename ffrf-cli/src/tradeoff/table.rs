//! The results as text and as columns.

use std::fmt::Write as _;

use ffrf_host::tradeoff::{Finding, INSTRUCTIONS_PER_OPERATION, Reference};

use super::row::{Row, modes_width};
use super::target_counts::{TargetCounts, lines};
use crate::budget::StepOnTarget;
use crate::trade_text::describe_reference;

/// A table for people, the cheapest first; what failed stands at its end.
pub fn text(title: &str, reference: &Reference, rows: &[Row<'_>], counts: &TargetCounts) -> String {
    let mut text = format!("{title}\n\n{}\n", describe_reference(reference));
    text.push_str(LEGEND);
    let wide = modes_width(rows.iter().map(|row| &row.outcome.configuration));
    let _ = writeln!(
        text,
        "\n{:>wide$} {:<14} {:<6} {:<24} {:>10} {:>9} {:>8} {:>10} {:>11} {:>12} {:>8} {:>8}  front",
        "modes",
        "fidelity",
        "scalar",
        "integrator",
        "step/s",
        "error",
        "time",
        "operations",
        "op. a step",
        "instr. a step",
        "data/B",
        "stack/B"
    );
    let mut finished: Vec<&Row<'_>> = rows.iter().filter(|row| row.measured().is_some()).collect();
    let cost = |row: &Row<'_>| row.measured().map_or(f64::NAN, |m| m.operations_per_second());
    finished.sort_by(|a, b| cost(a).total_cmp(&cost(b)));
    for row in finished {
        let (one, Some(measured)) = (&row.outcome.configuration, row.measured()) else { continue };
        let mark = match row.on_front {
            [true, true] => "both",
            [true, false] => "time",
            [false, true] => "operations",
            [false, false] => "",
        };
        let line = format!(
            "{:>wide$} {:<14} {:<6} {:<24} {:>10.3e} {:>9.2e} {:>8.2e} {:>10.3e} {:>11.3e} {:>12.1e} {:>8} {:>8}  {mark}",
            one.modes,
            one.fidelity.to_string(),
            one.scalar.name(),
            one.integrator.name(),
            measured.step,
            measured.error(),
            measured.time,
            measured.operations_per_second(),
            measured.operations_per_step(),
            INSTRUCTIONS_PER_OPERATION * measured.operations_per_step(),
            row.outcome.data_bytes().unwrap_or(0),
            row.outcome.stack_bytes().unwrap_or(0),
        );
        let _ = writeln!(text, "{}", line.trim_end());
    }
    for row in rows {
        let one = &row.outcome.configuration;
        if let Finding::Failed(reason) = &row.outcome.finding {
            let _ = writeln!(
                text,
                "{:>wide$} {:<14} {:<6} {:<24} {:>10.3e} failed: {}",
                one.modes,
                one.fidelity.to_string(),
                one.scalar.name(),
                one.integrator.name(),
                one.step,
                ffrf_model::printable(reason)
            );
        }
    }
    for core in counts.cores() {
        text.push_str(&lines(core, counts, rows.iter().map(|row| row.outcome)));
    }
    text
}

/// What the columns are.
const LEGEND: &str = "\
error: the largest over the quantities and over time, over the scale of the quantity
time: processor time of this machine per simulated second, bodies of run-time size; another run gives another
operations: floating-point operations of compiled code per simulated second, and per step; body kernels are counted by
  the generator, joints and solve are estimated from the sizes of their blocks
instr.: instructions per step, estimated from the operations
data: numbers of the bodies, counted; stack: estimated
front: no other is both cheaper and more exact
bytes of code, and instructions, data and stack of a whole program, are measured on a core alone: --target CORE
";

/// What is counted on a core, in `table.csv` behind its name: code without the program's frame, data kept between steps (tables,
/// model and state), stack that a step touches and at most can.
const ON_A_CORE: [&str; 5] =
    ["instructions_per_step", "code_bytes", "data_bytes", "stack_bytes", "stack_bytes_at_most"];

/// Every outcome as a line of comma-separated values.
pub fn csv(reference: &Reference, rows: &[Row<'_>], counts: &TargetCounts) -> String {
    let mut text = String::from(
        "modes,fidelity,scalar,integrator,longest_step,step,steps,error,time_per_second,operations_per_second,\
         evaluations_per_step,operations_per_step,instructions_per_step_estimated,data_bytes,stack_bytes_estimated,\
         front_time,front_operations",
    );
    let cores: Vec<&str> = counts.cores().collect();
    for core in &cores {
        for column in ON_A_CORE {
            let _ = write!(text, ",{core}.{column}");
        }
    }
    for channel in &reference.channels {
        let _ = write!(text, ",error.{}", channel.name);
    }
    text.push_str(",failure\n");
    for row in rows {
        let one = &row.outcome.configuration;
        // a list of terms has commas
        let fidelity = one.fidelity.to_string().replace(", ", "+");
        let modes = one.modes.to_string().replace(", ", "+");
        let _ =
            write!(text, "{modes},{fidelity},{},{},{:e}", one.scalar.name(), one.integrator.name(), one.step);
        match &row.outcome.finding {
            Finding::Finished(measured) => {
                let _ = write!(
                    text,
                    ",{:e},{},{:e},{:e},{:e},{},{:e},{:e},{},{},{},{}",
                    measured.step,
                    measured.steps,
                    measured.error(),
                    measured.time,
                    measured.operations_per_second(),
                    measured.evaluations,
                    measured.operations_per_step(),
                    INSTRUCTIONS_PER_OPERATION * measured.operations_per_step(),
                    row.outcome.data_bytes().unwrap_or(0),
                    row.outcome.stack_bytes().unwrap_or(0),
                    u8::from(row.on_front[0]),
                    u8::from(row.on_front[1])
                );
                for core in &cores {
                    match counts.cost(core, one) {
                        Some(cost) => {
                            let StepOnTarget { instructions, code, stack, stack_bound, .. } = cost;
                            let bound = stack_bound.map_or(String::new(), |bound| bound.to_string());
                            let data = cost.data();
                            let _ = write!(text, ",{instructions},{code},{data},{stack},{bound}");
                        }
                        None => text.push_str(&",".repeat(ON_A_CORE.len())),
                    }
                }
                for error in &measured.errors {
                    let _ = write!(text, ",{error:e}");
                }
                text.push_str(",\n");
            }
            Finding::Failed(reason) => {
                let columns = 13 + ON_A_CORE.len() * cores.len() + reference.channels.len();
                text.push_str(&",".repeat(columns));
                let _ = writeln!(text, "\"{}\"", ffrf_model::printable(reason).replace('"', "\"\""));
            }
        }
    }
    text
}
