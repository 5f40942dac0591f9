//! The `ffrf` command; see the library `ffrf_cli`.
#![forbid(unsafe_code)]

use std::process::ExitCode;

fn main() -> ExitCode {
    ffrf_cli::run()
}
