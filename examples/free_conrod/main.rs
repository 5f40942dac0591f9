//! A connecting rod torn off at engine speed: from a finite-element export to ten seconds of tumbling flight.
//!
//! ```text
//! cargo run --release --example free_conrod             10 s of flight
//! cargo run --release --example free_conrod -- 0.2      less of it
//! ```
//!
//! 1. Import what CalculiX exported, compute eight free-free modes, reduce.
//! 2. Compare with the committed model, and the code that the macro made of it with the finite-element nodes.
//! 3. Fly: spin about the axis of middle inertia (unstable, so the rod flips over and over) and a blow to the small end.
//! 4. Write plots (`.svg`) and a series for ParaView (`.pvd`) to `out/free_conrod`.

mod comparison;
mod flight;
mod part;
mod plot;
mod plots;
mod vtu;

use std::error::Error;
use std::fs;
use std::path::Path;

ffrf::flexible_body! {
    /// A steel connecting rod with its eight lowest free-free modes; the frame is at the centre of mass.
    pub struct Conrod {
        model: "models/conrod.ffrf.json",
    }
}

/// Number of modes of the committed model.
const M: usize = 8;
/// Number of velocities, 6 + M.
const N: usize = 6 + M;

fn main() -> Result<(), Box<dyn Error>> {
    let duration: f64 = match std::env::args().nth(1) {
        Some(text) => text.parse().map_err(|_| format!("expected a duration in seconds, found `{text}`"))?,
        None => 10.0,
    };
    let models = Path::new(env!("CARGO_MANIFEST_DIR")).join("models");

    println!("1. Import, modes, reduction");
    let part = part::import(&models.join("conrod/conrod.inp"))?;

    println!("\n2. Comparison with the committed model and with the nodes");
    comparison::with_committed(&part.body, &models.join("conrod.ffrf.json"))?;
    comparison::with_nodes(&part)?;

    println!("\n3. Flight");
    let record = flight::fly(duration)?;
    record.print_summary();

    println!("\n4. Pictures");
    let folder = Path::new("out/free_conrod");
    fs::create_dir_all(folder)?;
    plots::write(folder, &record, &part)?;
    vtu::write_series(folder, &record.frames, &part)?;
    Ok(())
}
