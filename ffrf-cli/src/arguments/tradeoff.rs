//! The arguments of `ffrf tradeoff` and `ffrf plan`.

use std::path::PathBuf;

use clap::Args;
use ffrf_codegen::{Fidelity, ScalarType};
use ffrf_host::scene::Integrator;
use ffrf_host::tradeoff::Quantity;

/// Arguments of `ffrf tradeoff`.
#[derive(Debug, Args)]
pub struct Tradeoff {
    /// Scene file (TOML).
    pub scene: PathBuf,
    /// Write everything into this folder; a sweep that was interrupted goes on there.
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Numbers of modes, of every flexible body that has so many (default: 0, 1, 2, 4, 8, ... and all).
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub modes: Option<Vec<usize>>,
    /// Fidelities (default: constant, linear, full).
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_fidelity)]
    pub fidelity: Option<Vec<Fidelity>>,
    /// Number types: f64, f32 (default: both).
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_scalar)]
    pub scalar: Option<Vec<ScalarType>>,
    /// Integrators by their names in scene files (default: rk4, linearly_implicit, generalized_alpha).
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_integrator)]
    pub integrator: Option<Vec<Integrator>>,
    /// Longest steps in s (default: five, from the interval between samples down by factors of four).
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_positive)]
    pub step: Option<Vec<f64>>,
    /// Take errors in this: a sensor, `reaction` (all joints) or `energy`. Repeatable (default: every sensor).
    #[arg(long, value_name = "QUANTITY")]
    pub quantity: Vec<Quantity>,
    /// Relative tolerance per step of the reference, which has all modes and terms.
    #[arg(long, value_name = "TOLERANCE", default_value_t = 1e-10, value_parser = parse_positive)]
    pub reference_tolerance: f64,
    /// Runs at a time (default: one for each core).
    #[arg(long, value_name = "COUNT", value_parser = parse_count)]
    pub threads: Option<usize>,
}

/// Arguments of `ffrf plan`.
#[derive(Debug, Args)]
pub struct Plan {
    /// Scene file (TOML).
    pub scene: PathBuf,
    /// The budget: the largest error over time, over the scale of each quantity.
    #[arg(long, value_name = "ERROR", value_parser = parse_positive, required_unless_present = "time_per_step")]
    pub error: Option<f64>,
    /// The budget: the time that one step may take on the target (s); with `--operations-per-second`.
    #[arg(long, value_name = "SECONDS", value_parser = parse_positive, conflicts_with = "error", requires = "operations_per_second")]
    pub time_per_step: Option<f64>,
    /// Floating-point operations of compiled code that the target does in a second: its clock over cycles per instruction and
    /// about six instructions for each operation.
    #[arg(long, value_name = "RATE", value_parser = parse_positive, requires = "time_per_step")]
    pub operations_per_second: Option<f64>,
    /// The step with `--time-per-step`, the period of a control loop (s; default: the step of the scene).
    #[arg(long, value_name = "SECONDS", value_parser = parse_positive, requires = "time_per_step")]
    pub step: Option<f64>,
    /// Take errors in this: a sensor, `reaction` (all joints) or `energy`. Repeatable (default: every sensor).
    #[arg(long, value_name = "QUANTITY")]
    pub quantity: Vec<Quantity>,
    /// Integrators to choose from (default: rk4, dopri5, linearly_implicit, generalized_alpha).
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_integrator)]
    pub integrator: Option<Vec<Integrator>>,
    /// Number types to choose from: f64, f32 (default: both; f32 where its rounding is small against the budget).
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_scalar)]
    pub scalar: Option<Vec<ScalarType>>,
    /// Run what was planned, and compare with a reference that is more exact than that of the plan.
    #[arg(long)]
    pub measure: bool,
    /// Write the plan to this file instead of standard output.
    #[arg(short, long, value_name = "PLAN.txt")]
    pub output: Option<PathBuf>,
}

/// A level, or terms separated by commas.
pub fn parse_fidelity(text: &str) -> Result<Fidelity, String> {
    text.trim().parse().map_err(|error: ffrf_codegen::fidelity::FidelityError| error.to_string())
}

/// The name of a number type.
pub fn parse_scalar(text: &str) -> Result<ScalarType, String> {
    let found = ScalarType::from_name(text.trim()).filter(|scalar| *scalar != ScalarType::Generic);
    found.ok_or_else(|| "expected f64 or f32".to_owned())
}

/// The name of an integrator, as in scene files.
pub fn parse_integrator(text: &str) -> Result<Integrator, String> {
    let found = Integrator::ALL.iter().find(|(name, _)| *name == text.trim());
    let known = || Integrator::ALL.map(|(name, _)| name).join(", ");
    found.map(|(_, integrator)| *integrator).ok_or_else(|| format!("expected one of {}", known()))
}

pub(super) fn parse_positive(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(number) if number > 0.0 && number.is_finite() => Ok(number),
        _ => Err(format!("expected a positive number, found {text}")),
    }
}

fn parse_count(text: &str) -> Result<usize, String> {
    text.parse()
        .ok()
        .filter(|count| *count > 0)
        .ok_or_else(|| format!("expected a count from 1, found {text}"))
}
