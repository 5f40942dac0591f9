//! `ffrf convert` on the command line.

use std::path::PathBuf;

use clap::Args;
use ffrf_model::Units;

/// `ffrf convert`
#[derive(Debug, Args)]
pub struct Convert {
    /// What to read: a reduced body (*.ffrf.json) or MBDyn's modal data (*.fem).
    #[arg(value_name = "INPUT")]
    pub input: PathBuf,
    /// Which units a file of MBDyn is in: `SI`, or length, mass, time such as `mm,t,s` (default: not known).
    #[arg(long, value_name = "UNITS")]
    pub units: Option<Units>,
    /// What to write: the other of the two.
    #[arg(short, long, value_name = "OUTPUT")]
    pub output: PathBuf,
}
