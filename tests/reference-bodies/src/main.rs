//! Compares bodies that the macro baked in with the reference cases in the folder given as argument.

mod bodies;
mod compare;
mod states;
mod trajectory;

use std::process::ExitCode;

/// The reference folder and the number of failed comparisons.
pub struct Run {
    folder: std::path::PathBuf,
    failures: usize,
}

impl Run {
    /// Reads a JSON file of the reference folder.
    pub fn read(&self, file: &str) -> serde_json::Value {
        let text = std::fs::read_to_string(self.folder.join(file)).expect("reference file is readable");
        serde_json::from_str(&text).expect("reference file is JSON")
    }

    /// Notes one comparison.
    pub fn check(&mut self, what: &str, deviation: f64, tolerance: f64) {
        let fails = deviation.is_nan() || deviation > tolerance;
        println!("{what:<56} {deviation:9.2e} (at most {tolerance:.0e}){}", if fails { "  FAILED" } else { "" });
        self.failures += usize::from(fails);
    }
}

fn main() -> ExitCode {
    let folder = std::env::args_os().nth(1).expect("usage: reference-bodies FOLDER").into();
    let mut run = Run { folder, failures: 0 };
    bodies::check_all(&mut run);
    println!("{} comparisons failed", run.failures);
    ExitCode::from(u8::from(run.failures > 0))
}
