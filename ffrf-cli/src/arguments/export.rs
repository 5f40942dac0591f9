//! The arguments of `ffrf export`.

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};

/// `ffrf export`
#[derive(Debug, Args)]
pub struct Export {
    /// As what.
    #[command(subcommand)]
    pub format: ExportFormat,
}

/// What a scene can be exported as.
#[derive(Debug, Subcommand)]
pub enum ExportFormat {
    /// A functional mock-up unit for co-simulation (FMI 3.0 or 2.0), for this platform.
    #[command(after_help = EXAMPLE)]
    Fmu(ExportFmu),
}

const EXAMPLE: &str = "\
Examples:
  ffrf export fmu crane.toml -o crane.fmu
  ffrf export fmu crane.toml --fmi 2 -o crane.fmu
  ffrf export fmu crane.toml --c-sources -o crane.fmu";

/// A version of the Functional Mock-up Interface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum FmiVersion {
    /// FMI 2.0.
    #[value(name = "2", alias = "2.0")]
    Two,
    /// FMI 3.0.
    #[value(name = "3", alias = "3.0")]
    Three,
}

/// Arguments of `ffrf export fmu`.
#[derive(Debug, Args)]
pub struct ExportFmu {
    /// Scene file (TOML).
    pub scene: PathBuf,
    /// Where to write the FMU.
    #[arg(short, long, value_name = "PART.fmu")]
    pub output: PathBuf,
    /// Version of the standard.
    #[arg(long, default_value = "3")]
    pub fmi: FmiVersion,
    /// Name of the model (default: that of the scene file).
    #[arg(long)]
    pub name: Option<String>,
    /// The library that goes into the FMU (default: that of this version beside this program).
    #[arg(long, value_name = "FILE")]
    pub library: Option<PathBuf>,
    /// Build the library with cargo from this folder of the ffrf sources.
    #[arg(long, value_name = "FOLDER", conflicts_with = "library")]
    pub sources: Option<PathBuf>,
    /// Put the mechanism inside as C sources, with a binary made of them, in place of the library and the scene: for scenes
    /// that `ffrf generate --language c` prints.
    #[arg(long, conflicts_with_all = ["library", "sources"])]
    pub c_sources: bool,
    /// The C compiler that makes the binary of the sources, or `none` for sources without one (default: cc, gcc or clang).
    #[arg(long, value_name = "CC", requires = "c_sources")]
    pub compiler: Option<String>,
}
