//! The arguments of `ffrf simulate`.

use std::path::PathBuf;

use clap::Args;

/// Arguments of `ffrf simulate`.
#[derive(Debug, Args)]
pub struct Simulate {
    /// Scene file (TOML).
    pub scene: PathBuf,
    /// Write samples to this file: .csv, .npz or .parquet.
    #[arg(short, long, required_unless_present = "check")]
    pub output: Option<PathBuf>,
    /// Draw sensors, energies and drift over time to this file (SVG).
    #[arg(long, value_name = "PLOT.svg", conflicts_with = "check")]
    pub plot: Option<PathBuf>,
    /// Explain the scene and do not simulate: degrees of freedom, redundant rows, initial residuals.
    #[arg(long)]
    pub check: bool,
    /// Write the state at the end to this file, to the last bit.
    #[arg(long)]
    pub save_state: Option<PathBuf>,
    /// Begin with a saved state instead of that of the scene.
    #[arg(long)]
    pub load_state: Option<PathBuf>,
}
