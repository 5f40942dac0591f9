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
    /// Write the motion as one page that a browser plays (.html), or as one animated model for Blender and others (.glb).
    #[arg(long, value_name = "MOTION.html", conflicts_with = "check")]
    pub animation: Option<PathBuf>,
    /// How long the animation plays, in s (default: as long as the motion, but from 2 to 60 s).
    #[arg(long, value_name = "SECONDS", requires = "animation", value_parser = parse_positive)]
    pub playback: Option<f64>,
    /// Factor of the deformation drawn in the animation.
    #[arg(long, value_name = "FACTOR", requires = "animation", default_value_t = 1.0, value_parser = parse_positive)]
    pub deformation_scale: f64,
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

fn parse_positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number > 0.0 && number.is_finite() => Ok(number),
        _ => Err(format!("expected a positive number, found {text}")),
    }
}
