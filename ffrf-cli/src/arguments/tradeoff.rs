//! The arguments of `ffrf tradeoff` and `ffrf plan`.

use std::path::PathBuf;

use clap::Args;
use ffrf_codegen::{Fidelity, ScalarType};
use ffrf_host::scene::Integrator;
use ffrf_host::tradeoff::{ModeValues, Quantity};

use super::Core;

/// Arguments of `ffrf tradeoff`.
#[derive(Debug, Args)]
pub struct Tradeoff {
    /// Scene file (TOML).
    pub scene: PathBuf,
    /// Write everything into this folder; a sweep that was interrupted goes on there.
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Modes of every flexible body that has them: numbers of the first ones, and lists from 0 in brackets, as `0,2,[0+5]`
    /// (default: 0, 1, 2, 4, 8, ... and all). `BODY=LIST` is for one body; repeatable, and lists of several bodies are combined.
    /// Bodies that are not named have what the list without a name says, or all their modes.
    #[arg(long, value_name = "[BODY=]LIST")]
    pub modes: Vec<ModeValues>,
    /// Fidelities (default: those of constant, linear, unstiffened, full that all bodies hold and that differ).
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
    /// Relative tolerance per step of the reference, which has all modes, and every term that all bodies hold.
    #[arg(long, value_name = "TOLERANCE", default_value_t = 1e-10, value_parser = parse_positive)]
    pub reference_tolerance: f64,
    /// Take errors against this model of a flexible body, with all its modes, in the place of the one of the scene: a reduction with
    /// more modes, or all, of the same part in the same frame, with the markers that the scene names. Repeatable.
    #[arg(long, value_name = "BODY=MODEL", value_parser = parse_named_model)]
    pub reference_model: Vec<NamedModel>,
    /// Also count what a step of each configuration takes of these cores: instructions, bytes of code, data and stack. A program
    /// is built for each number of modes, fidelity, scalar and integrator (rk4, linearly_implicit) and run in the emulator.
    #[arg(long, value_name = "CORE,...", value_delimiter = ',')]
    pub target: Vec<Core>,
    /// Folder of the ffrf sources, whose `firmware/` has what programs on the target need (with --target).
    #[arg(long, value_name = "FOLDER", default_value = ".", requires = "target")]
    pub sources: PathBuf,
    /// Where programs are written and built (with --target; default: firmware/target/budget in the sources).
    #[arg(long, value_name = "FOLDER", requires = "target")]
    pub folder: Option<PathBuf>,
    /// Runs at a time (default: one for each core).
    #[arg(long, value_name = "COUNT", value_parser = parse_count)]
    pub threads: Option<usize>,
}

/// A model of a body of a scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedModel {
    /// Name of the body.
    pub body: String,
    /// Its model file.
    pub file: PathBuf,
}

fn parse_named_model(text: &str) -> Result<NamedModel, String> {
    match text.split_once('=') {
        Some((body, file)) if !body.is_empty() && !file.is_empty() => {
            Ok(NamedModel { body: body.to_owned(), file: file.into() })
        }
        _ => Err("expected BODY=MODEL.ffrf.json".to_owned()),
    }
}

/// Arguments of `ffrf plan`.
#[derive(Debug, Args)]
pub struct Plan {
    /// Scene file (TOML).
    pub scene: PathBuf,
    /// The budget: the largest error over time, over the scale of each quantity.
    #[arg(long, value_name = "ERROR", value_parser = parse_positive, required_unless_present_any = ["time_per_step", "target"])]
    pub error: Option<f64>,
    /// The budget: the time that one step may take on the target (s); with `--operations-per-second`.
    #[arg(long, value_name = "SECONDS", value_parser = parse_positive, conflicts_with = "error", requires = "operations_per_second")]
    pub time_per_step: Option<f64>,
    /// Floating-point operations of compiled code that the target does in a second: its clock over cycles per instruction and
    /// about six instructions for each operation.
    #[arg(long, value_name = "RATE", value_parser = parse_positive, requires = "time_per_step", conflicts_with_all = ["error", "target"])]
    pub operations_per_second: Option<f64>,
    /// The step with `--time-per-step`, the period of a control loop (s; default: the step of the scene).
    #[arg(long, value_name = "SECONDS", value_parser = parse_positive, requires = "time_per_step", conflicts_with_all = ["error", "target"])]
    pub step: Option<f64>,
    /// The budget: a tick of a controller on this core, in which the steps of the tick must end.
    #[arg(long, value_name = "CORE", conflicts_with_all = ["error", "time_per_step"])]
    pub target: Option<Core>,
    /// What a target is, and where instructions are counted.
    #[command(flatten)]
    pub on_target: OnTarget,
    /// Take errors in this: a sensor, `reaction` (all joints) or `energy`. Repeatable (default: every sensor).
    #[arg(long, value_name = "QUANTITY")]
    pub quantity: Vec<Quantity>,
    /// Integrators to choose from (default: rk4, dopri5, linearly_implicit, generalized_alpha; with --target those of fixed
    /// cost, rk4 and linearly_implicit).
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_integrator)]
    pub integrator: Option<Vec<Integrator>>,
    /// Number types to choose from: f64, f32 (default: both; f32 where its rounding is small against the budget).
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_scalar)]
    pub scalar: Option<Vec<ScalarType>>,
    /// Run what was planned, and compare with a reference that is more exact than that of the plan; with --target also count
    /// its instructions in the emulator, and plan again where they are not what was predicted.
    #[arg(long)]
    pub measure: bool,
    /// Write the plan to this file instead of standard output.
    #[arg(short, long, value_name = "PLAN.txt")]
    pub output: Option<PathBuf>,
}

/// Budgets that a target has no part in. An argument that requires another which one of these excludes would be taken and not
/// read, so that each names them.
const OTHER_BUDGETS: [&str; 2] = ["error", "time_per_step"];

/// The target of `ffrf plan --target`.
#[derive(Debug, Args)]
pub struct OnTarget {
    /// The period of the controller (s).
    #[arg(long, value_name = "SECONDS", value_parser = parse_positive, default_value_t = 1e-3, requires = "target", conflicts_with_all = OTHER_BUDGETS)]
    pub tick: f64,
    /// The clock of the core (Hz; default: 168e6 for cortex-m4f, 480e6 for cortex-m7).
    #[arg(long, value_name = "HZ", value_parser = parse_positive, requires = "target", conflicts_with_all = OTHER_BUDGETS)]
    pub clock: Option<f64>,
    /// Cycles that an instruction takes on average, memory included: 1 at best, measure it on your board.
    #[arg(long, value_name = "CYCLES", value_parser = parse_positive, default_value_t = 2.0, requires = "target", conflicts_with_all = OTHER_BUDGETS)]
    pub cycles_per_instruction: f64,
    /// The share of a tick that there is for the steps.
    #[arg(long, value_name = "SHARE", value_parser = parse_share, default_value_t = 1.0, requires = "target", conflicts_with_all = OTHER_BUDGETS)]
    pub share: f64,
    /// Folder of the ffrf sources, whose `firmware/` has what programs on the target need (with --measure).
    #[arg(long, value_name = "FOLDER", default_value = ".", requires_all = ["target", "measure"], conflicts_with_all = OTHER_BUDGETS)]
    pub sources: PathBuf,
    /// Where programs are written and built (with --measure; default: firmware/target/budget in the sources).
    #[arg(long, value_name = "FOLDER", requires_all = ["target", "measure"], conflicts_with_all = OTHER_BUDGETS)]
    pub folder: Option<PathBuf>,
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

fn parse_share(text: &str) -> Result<f64, String> {
    parse_positive(text)
        .ok()
        .filter(|share| *share <= 1.0)
        .ok_or_else(|| format!("expected a share above 0 and up to 1, found {text}"))
}

fn parse_count(text: &str) -> Result<usize, String> {
    text.parse()
        .ok()
        .filter(|count| *count > 0)
        .ok_or_else(|| format!("expected a count from 1, found {text}"))
}
