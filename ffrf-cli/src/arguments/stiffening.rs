//! Geometric stiffness on the command line.

use clap::Args;

/// Whether the body gets geometric stiffness, and from which material.
#[derive(Debug, Args)]
#[command(next_help_heading = "Geometric stiffness")]
pub struct StiffeningChoice {
    /// Compute what the stresses of centrifugal, angular and linear acceleration add to the stiffness of the modes: needs the
    /// elements of a deck. Bodies that turn near or above their lowest frequency need it.
    #[arg(long, conflicts_with = "mode_shapes")]
    pub geometric_stiffness: bool,
    /// Markers and interfaces whose forces and moments stiffen the body or let it buckle: with --geometric-stiffness, the stress
    /// stiffness of unit loads there is computed as well.
    #[arg(long, value_name = "MARKER", value_delimiter = ',', requires = "geometric_stiffness")]
    pub load_stiffness: Vec<String>,
    /// Young's modulus and Poisson's ratio of the whole part, in the units of the files (default: *ELASTIC of the deck); for
    /// --geometric-stiffness and --stress.
    #[arg(long, value_name = "E,NU", value_parser = super::parse_pair, allow_hyphen_values = true)]
    pub elastic: Option<(f64, f64)>,
}
