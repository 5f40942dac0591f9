//! The `ffrf` command: from finite-element files to a reduced body, to generated kernels, and checks of both.
//!
//! The binary calls [`run`].
//!
//! Exit codes: 0 done, 1 failed (bad input, failed check), 2 wrong usage. Results go to standard output or to
//! the file named by `-o`; errors and progress go to standard error.
#![forbid(unsafe_code)]

mod animation;
mod arguments;
mod budget;
mod campbell;
mod component_modes;
mod convert;
mod describe;
mod evaluate;
mod export;
mod fe_input;
mod generate;
mod inspect;
mod linearise;
mod markup;
mod modes;
mod output;
pub mod plan;
mod plan_on_target;
mod plan_reasons;
mod plan_within;
mod plots;
mod progress;
pub mod reduce;
pub mod report;
mod results;
mod sample_states;
mod section;
mod simulate;
mod states;
mod stiffening;
mod stress;
mod trade_text;
pub mod tradeoff;
mod transfer;
mod verify;
mod view;

use std::process::ExitCode;

use clap::Parser;

use arguments::{Arguments, Command};

/// Does what the command line of this process asks for.
///
/// The answer to `--help` and `--version` ends the process; wrong usage is exit code 2.
pub fn run() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) if error.use_stderr() => {
            output::complain(&error.render().to_string());
            return ExitCode::from(2);
        }
        // Help and version.
        Err(error) => error.exit(),
    };
    let result = match arguments.command {
        Command::Reduce(arguments) => reduce::run(&arguments),
        Command::Convert(arguments) => convert::run(&arguments),
        Command::Inspect(arguments) => inspect::run(&arguments),
        Command::Generate(arguments) => generate::run(&arguments),
        Command::Evaluate(arguments) => evaluate::run(&arguments),
        Command::Verify(arguments) => verify::run(&arguments),
        Command::Simulate(arguments) => simulate::run(&arguments),
        Command::Export(arguments) => export::run(&arguments),
        Command::Linearise(arguments) => linearise::run(&arguments),
        Command::Campbell(arguments) => campbell::run(&arguments),
        Command::Budget(arguments) => budget::run(&arguments),
        Command::Plan(arguments) => plan::run(&arguments),
        Command::Tradeoff(arguments) => tradeoff::run(&arguments),
        Command::View(arguments) => view::run(&arguments),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            output::complain(&format!("error: {}\n", report::chain(&error)));
            ExitCode::FAILURE
        }
    }
}
