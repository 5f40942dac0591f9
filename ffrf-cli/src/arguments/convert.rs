//! `ffrf convert` on the command line.

use std::path::PathBuf;

use clap::Args;
use ffrf_model::Units;

/// `ffrf convert`
#[derive(Debug, Args)]
pub struct Convert {
    /// What to read: a reduced body (*.ffrf.json), MBDyn's modal data (*.fem) or standard input data (*.SID_FEM, *.sid).
    #[arg(value_name = "INPUT")]
    pub input: PathBuf,
    /// Which units another program's file is in: `SI`, or length, mass, time such as `mm,t,s` (default: not known).
    #[arg(long, value_name = "UNITS")]
    pub units: Option<Units>,
    /// What to write: a body if another format is read, another format if a body is read.
    #[arg(short, long, value_name = "OUTPUT")]
    pub output: PathBuf,
}
