//! The flags of `ffrf budget`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use ffrf_codegen::DEFAULT_LAYOUT_TOLERANCE;

use super::code::parse_tolerance;

/// A core that is emulated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Core {
    /// Single-precision hardware; double precision in software.
    #[value(name = "cortex-m4f")]
    CortexM4F,
    /// Double-precision hardware.
    #[value(name = "cortex-m7")]
    CortexM7,
}

/// A scalar that a microcontroller computes with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum TargetScalar {
    /// Single precision.
    F32,
    /// Double precision.
    F64,
}

/// An integrator of fixed cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum TargetIntegrator {
    /// Explicit, order four.
    #[value(name = "rk4")]
    RungeKutta,
    /// Stiff modes implicit, order two.
    #[value(name = "linearly_implicit")]
    LinearlyImplicit,
}

/// `ffrf budget`
#[derive(Debug, Args)]
pub struct Budget {
    /// A reduced body, or a scene (*.toml).
    #[arg(value_name = "MODEL|SCENE")]
    pub file: PathBuf,
    /// For which core; both if nothing is said.
    #[arg(long, value_delimiter = ',', value_name = "CORE,...")]
    pub target: Vec<Core>,
    /// In which scalar; both if nothing is said.
    #[arg(long, value_delimiter = ',', value_name = "SCALAR,...")]
    pub scalar: Vec<TargetScalar>,
    /// Use the first N modes of a body; a scene says it itself.
    #[arg(long, value_name = "N")]
    pub modes: Option<usize>,
    /// Below which size, relative to its Gram scale, an entry of an invariant counts as zero.
    #[arg(long, value_name = "X", default_value_t = DEFAULT_LAYOUT_TOLERANCE, value_parser = parse_tolerance)]
    pub layout_tolerance: f64,
    /// Which step is counted.
    #[arg(long, default_value = "rk4")]
    pub integrator: TargetIntegrator,
    /// Accelerations of a scene in straight-line code, as `ffrf generate SCENE` prints them: f64, explicit methods.
    #[arg(long)]
    pub straight_line: bool,
    /// Its size (s); half of the largest stable one for rk4, one millisecond else, or what a scene says.
    #[arg(long, value_name = "SECONDS")]
    pub step: Option<f64>,
    /// How rustc optimises: 2 and 3 for speed, s and z for size.
    #[arg(long, default_value = "3", value_parser = ["1", "2", "3", "s", "z"])]
    pub opt_level: String,
    /// Folder of the ffrf sources, whose `firmware/` has what programs on the target need.
    #[arg(long, value_name = "FOLDER", default_value = ".")]
    pub sources: PathBuf,
    /// Where the programs are written and built (default: firmware/target/budget in the sources).
    #[arg(long, value_name = "FOLDER")]
    pub folder: Option<PathBuf>,
}
