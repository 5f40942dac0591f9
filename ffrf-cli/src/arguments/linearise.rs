//! The arguments of `ffrf linearise` and `ffrf campbell`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

/// Arguments of `ffrf linearise`.
#[derive(Debug, Args)]
pub struct Linearise {
    /// Scene file (TOML).
    pub scene: PathBuf,
    /// Write A, B, C, D, the basis, eigenvalues and mode shapes to this file: .npz or .mat.
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// The state to linearise about.
    #[arg(long, value_enum, default_value_t = StateChoice::Rest)]
    pub at: StateChoice,
    /// Linearise about a saved state instead, at its time.
    #[arg(long, value_name = "STATE.json", conflicts_with = "at")]
    pub load_state: Option<PathBuf>,
    /// Write the state of rest to this file, to begin a simulation with.
    #[arg(long, value_name = "STATE.json", conflicts_with = "load_state")]
    pub save_state: Option<PathBuf>,
    /// Write the frequency response of every sensor to every force and moment of the scene to this file (CSV).
    #[arg(long, value_name = "RESPONSE.csv", requires = "frequencies")]
    pub response: Option<PathBuf>,
    /// Draw the frequency response to this file (SVG).
    #[arg(long, value_name = "RESPONSE.svg", requires = "frequencies")]
    pub response_plot: Option<PathBuf>,
    /// Frequencies of the response in Hz, spaced by a constant factor.
    #[arg(long, value_name = "FROM,TO,COUNT", value_parser = parse_range)]
    pub frequencies: Option<Range>,
}

/// Which state of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum StateChoice {
    /// Where the mechanism comes to rest, with drives held as they are at time zero.
    Rest,
    /// The initial state, assembled.
    Initial,
}

/// Arguments of `ffrf campbell`.
#[derive(Debug, Args)]
pub struct Campbell {
    /// Scene file (TOML).
    pub scene: PathBuf,
    /// What turns: a revolute or cylindrical joint on the ground (its drive gets the speed), or a body, about the axis of its
    /// angular velocity in the scene.
    #[arg(long, value_name = "NAME")]
    pub spin: String,
    /// Speeds in rad/s, evenly spaced.
    #[arg(long, value_name = "FROM,TO,COUNT", value_parser = parse_range)]
    pub speeds: Range,
    /// Write eigenfrequencies, damping and whirl to this file: .csv, .npz or .parquet.
    #[arg(short, long, value_name = "OUT")]
    pub output: PathBuf,
    /// Draw the diagram to this file (SVG).
    #[arg(long, value_name = "PLOT.svg")]
    pub plot: Option<PathBuf>,
}

/// `FROM,TO,COUNT`
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// The first.
    pub from: f64,
    /// The last.
    pub to: f64,
    /// How many.
    pub count: usize,
}

impl Range {
    /// Evenly spaced.
    pub fn even(self) -> Vec<f64> {
        self.shares().map(|share| self.from + share * (self.to - self.from)).collect()
    }

    /// Spaced by a constant factor.
    pub fn geometric(self) -> Vec<f64> {
        self.shares().map(|share| self.from * (self.to / self.from).powf(share)).collect()
    }

    fn shares(self) -> impl Iterator<Item = f64> {
        let last = self.count.saturating_sub(1).max(1) as f64;
        (0..self.count).map(move |k| k as f64 / last)
    }
}

fn parse_range(text: &str) -> Result<Range, String> {
    let expected = || format!("expected FROM,TO,COUNT with 0 <= FROM <= TO and COUNT >= 1, found {text}");
    let parts: Vec<&str> = text.split(',').collect();
    let [from, to, count] = parts[..] else { return Err(expected()) };
    let number = |text: &str| text.trim().parse::<f64>().map_err(|_| expected());
    let count = count.trim().parse().map_err(|_| expected())?;
    let range = Range { from: number(from)?, to: number(to)?, count };
    let ordered = range.from >= 0.0 && range.to >= range.from && range.to.is_finite();
    if ordered && count >= 1 { Ok(range) } else { Err(expected()) }
}
