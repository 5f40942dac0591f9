//! `ffrf tradeoff`: a scene in many configurations, their errors and their cost.

mod page;
mod row;
mod store;
mod table;

use std::path::Path;

use anyhow::{Context, Result};
use ffrf_codegen::{Fidelity, ScalarType};
use ffrf_host::scene::Integrator;
use ffrf_host::tradeoff::{Axes, Done, Finding, Outcome, Reference, ReferenceOptions, Study, sweep};

use crate::arguments::Tradeoff;
use crate::progress::ShareTeller;
use crate::{output, plots};
use store::{Asked, Store};

/// Runs the command.
pub fn run(arguments: &Tradeoff) -> Result<()> {
    let path = &arguments.scene;
    let in_scene = || format!("{}", path.display());
    let study = Study::read(path).with_context(in_scene)?;
    let channels = study.channels(&arguments.quantity).with_context(in_scene)?;
    let configurations = axes(&study, arguments).configurations();
    let asked = Asked::of(path, &study, &arguments.quantity, arguments.reference_tolerance)?;
    let store = Store::open(&arguments.output, &asked)?;
    let reference = match store.reference(channels)? {
        Some(reference) => reference,
        None => {
            output::complain("the reference is computed\n");
            let options = ReferenceOptions { tolerance: arguments.reference_tolerance };
            let reference =
                Reference::compute(&study, &arguments.quantity, options).with_context(in_scene)?;
            store.keep_reference(&reference)?;
            reference
        }
    };
    let known = store.outcomes(&configurations)?;
    let threads =
        arguments.threads.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from));
    let teller = ShareTeller::new("tradeoff");
    let outcomes = sweep(&study, &reference, &configurations, &known, threads, &mut |outcome, done| {
        store.keep(outcome)?;
        let Done { done, total } = done;
        teller.tell(done as f64 / total as f64, &format!("{done} of {total} runs"));
        Ok(())
    });
    teller.end();
    let outcomes = outcomes.with_context(in_scene)?;
    let title = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    write_all(&arguments.output, &title, &reference, &outcomes)?;
    let failed = outcomes.iter().filter(|outcome| matches!(outcome.finding, Finding::Failed(_))).count();
    output::say(&format!(
        "{} runs, {} of them here before, {failed} failed\n{}written: {}\n",
        outcomes.len(),
        known.len(),
        crate::trade_text::describe_reference(&reference),
        arguments.output.join("report.html").display()
    ))
}

/// Tables, pictures and the page.
fn write_all(folder: &Path, title: &str, reference: &Reference, outcomes: &[Outcome]) -> Result<()> {
    let rows = row::rows(outcomes);
    let write = |name: &str, text: &str| output::write(Some(&folder.join(name)), text);
    write("table.txt", &table::text(title, reference, &rows))?;
    write("table.csv", &table::csv(reference, &rows))?;
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
    write("report.html", &page::html(title, reference, &rows)?)
}

/// The axes that are given, and for the others what is usual.
fn axes(study: &Study, arguments: &Tradeoff) -> Axes {
    let most = study.most_modes();
    let doubled = std::iter::successors(Some(1), |modes| Some(2 * modes)).take_while(|modes| *modes < most);
    let usual_modes = || std::iter::once(0).chain(doubled).chain((most > 0).then_some(most)).collect();
    let usual_steps = || (0..STEPS).map(|k| study.interval() / STEP_FACTOR.powi(k)).collect();
    let or = |given: &Option<Vec<Integrator>>| given.clone().unwrap_or_else(|| INTEGRATORS.to_vec());
    Axes {
        modes: arguments.modes.clone().unwrap_or_else(usual_modes),
        fidelities: arguments
            .fidelity
            .clone()
            .unwrap_or_else(|| vec![Fidelity::Constant, Fidelity::Linear, Fidelity::Full]),
        scalars: arguments.scalar.clone().unwrap_or_else(|| vec![ScalarType::F64, ScalarType::F32]),
        integrators: or(&arguments.integrator),
        steps: arguments.step.clone().unwrap_or_else(usual_steps),
    }
}

/// The usual steps: so many, each this much smaller than the one before.
const STEPS: i32 = 5;
const STEP_FACTOR: f64 = 4.0;

/// One explicit method, and the two that take stiff modes implicitly.
const INTEGRATORS: [Integrator; 3] =
    [Integrator::Rk4, Integrator::LinearlyImplicit, Integrator::GeneralizedAlpha];
