//! `ffrf generate`: the code that the macro makes, as text.

use std::fmt::Write;

use anyhow::{Context, Result};
use ffrf_codegen::{GenerateOptions, Strategy};
use ffrf_model::ReducedBody;

use crate::arguments::Generate;
use crate::output;

/// Runs the command.
pub fn run(arguments: &Generate) -> Result<()> {
    let body = ReducedBody::read(&arguments.model)?;
    let source_name = arguments.model.file_name().map(|name| name.to_string_lossy().into_owned());
    let options = GenerateOptions {
        name: arguments.name.clone(),
        source_name: source_name.unwrap_or_default(),
        modes: arguments.modes,
        ..GenerateOptions::default()
    };
    let code =
        ffrf_codegen::generate(&body, &options).with_context(|| format!("{}", arguments.model.display()))?;
    output::write(arguments.output.as_deref(), &code.text)
}

/// The layout found in a body and the operations of each kernel.
pub fn account(body: &ReducedBody) -> Result<String> {
    let report = ffrf_codegen::generate(body, &GenerateOptions::default())?.report;
    let mut text = String::from("layout found\n");
    for (invariant, structure, _) in report.layout.entries() {
        let _ = writeln!(text, "  {invariant:<28}{structure}");
    }
    text.push_str("\noperations per call\n");
    for kernel in &report.kernels {
        let _ = writeln!(text, "  {:<28}{}", kernel.name, kernel.counts);
    }
    if let Some(lanes) = &report.lanes {
        let _ =
            writeln!(text, "\noperations per call of the kernels in loops ({lanes}), counted as statements");
        let statements = GenerateOptions { strategy: Strategy::StraightLine, ..GenerateOptions::default() };
        let all = ffrf_codegen::generate(body, &statements)?.report.kernels;
        let printed = |name: &str| report.kernels.iter().any(|kernel| kernel.name == name);
        for kernel in all.iter().filter(|kernel| !printed(kernel.name)) {
            let _ = writeln!(text, "  {:<28}{}", kernel.name, kernel.counts);
        }
    }
    Ok(text)
}
