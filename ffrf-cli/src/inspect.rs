//! `ffrf inspect`: what a reduced body holds, and what its kernels cost.

use anyhow::{Context, Result};
use ffrf_codegen::{Fidelity, GenerateOptions};
use ffrf_model::ReducedBody;

use crate::arguments::Inspect;
use crate::{describe, generate, output};

/// Runs the command.
pub fn run(arguments: &Inspect) -> Result<()> {
    let (mut body, mut checks) = ReducedBody::read_with_report(&arguments.model)?;
    if let Some(selection) = &arguments.modes {
        body =
            body.with_selected_modes(selection).with_context(|| format!("{}", arguments.model.display()))?;
        checks = body.check()?;
    }
    output::say(&format!("{}\n", describe::body(&body)))?;
    output::say(&format!("{}\n", describe::mode_table(&body)))?;
    output::say(&format!("{}\n", describe::checks(&checks)))?;
    // What is wrong is shown above; the generator takes no such body.
    checks.verdict().with_context(|| format!("{}", arguments.model.display()))?;
    let fidelity = arguments.fidelity.clone().unwrap_or_else(|| Fidelity::richest(body.second_order_terms));
    if fidelity != arguments.fidelity.clone().unwrap_or_default() {
        output::say(&format!("at fidelity {fidelity}, the richest that the body has\n\n"))?;
    }
    let options = GenerateOptions {
        fidelity,
        layout_tolerance: arguments.layout_tolerance,
        ..GenerateOptions::default()
    };
    let account = generate::account(&body, &options);
    output::say(&account.with_context(|| format!("{}", arguments.model.display()))?)
}
