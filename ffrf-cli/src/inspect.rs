//! `ffrf inspect`: what a reduced body holds, and what its kernels cost.

use anyhow::{Context, Result};
use ffrf_model::ReducedBody;

use crate::arguments::Inspect;
use crate::{describe, generate};

/// Runs the command.
pub fn run(arguments: &Inspect) -> Result<()> {
    let mut body = ReducedBody::read(&arguments.model)?;
    if let Some(count) = arguments.modes {
        body = body.with_modes(count).with_context(|| format!("{}", arguments.model.display()))?;
    }
    let checks = body.check()?;
    println!("{}", describe::body(&body));
    println!("{}", describe::mode_table(&body));
    println!("{}", describe::checks(&checks));
    print!("{}", generate::account(&body).with_context(|| format!("{}", arguments.model.display()))?);
    checks.verdict().with_context(|| format!("{}", arguments.model.display()))
}
