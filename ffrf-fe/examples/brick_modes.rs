//! Modes of a solid steel brick of 92,000 degrees of freedom: seconds and memory of each phase.
//!
//! `cargo run --release -p ffrf-fe --example brick_modes -- [--divisions 130x17x12] [--modes 20] [--clamped]
//! [--threads 2] [--write FOLDER] [--no-solve]`. With `--clamped`, the face x = 0 is held. With `--write`, K, M_s and
//! the rows of the held nodes are written as plain arrays for other programs (`benches/peers/brick.sh`).

#[path = "measured/mod.rs"]
mod measured;

use std::error::Error;
use std::fs;
use std::path::PathBuf;
use std::time::Instant;

use ffrf_fe::elements::{Material, brick};
use ffrf_fe::modes::{ModeRequest, compute_modes};

use measured::{Phases, peak_megabytes, write_indices, write_matrix};

struct Options {
    divisions: [usize; 3],
    modes: usize,
    clamped: bool,
    threads: usize,
    write: Option<PathBuf>,
    solve: bool,
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = parse()?;
    let start = Instant::now();
    // Edges in the proportion of the divisions: nearly cubic elements of one centimetre.
    let lengths = options.divisions.map(|division| 0.01 * division as f64);
    let model = brick(lengths, options.divisions, &Material::STEEL)?;
    let assembly = start.elapsed().as_secs_f64();
    let entries = model.stiffness.as_ref().map_or(0, |stiffness| stiffness.compute_nnz());
    println!(
        "{} nodes, {} degrees of freedom, {entries} entries of K",
        model.nodes.len(),
        3 * model.nodes.len()
    );
    println!("assembly {assembly:.2} s, peak memory {:.0} MB", peak_megabytes());
    let face: Vec<usize> =
        (0..model.nodes.len()).filter(|&node| model.nodes.positions[node][0] == 0.0).collect();
    if let (Some(folder), Some(stiffness)) = (&options.write, &model.stiffness) {
        fs::create_dir_all(folder)?;
        write_matrix(folder, "K", stiffness)?;
        write_matrix(folder, "M", &model.mass)?;
        write_indices(&folder.join("face"), &face)?;
    }
    if !options.solve {
        return Ok(());
    }
    let request = if options.clamped {
        ModeRequest::clamped(options.modes, face)
    } else {
        ModeRequest::free_free(options.modes)
    };
    let request = ModeRequest { threads: options.threads, ..request };
    let mut phases = Phases::begin();
    let start = Instant::now();
    let solution = compute_modes(&model, &request, &mut |progress| phases.enter(progress))?;
    let seconds = start.elapsed().as_secs_f64();
    phases.close();
    println!("{}", solution.report);
    let residuals = solution.report.modes.iter().filter_map(|mode| mode.residual);
    println!("largest_residual {:.1e}", residuals.fold(0.0_f64, f64::max));
    println!("solve_seconds {seconds:.3}");
    println!("peak_megabytes {:.1}", peak_megabytes());
    for mode in &solution.report.modes {
        println!("frequency_hz {:?}", mode.frequency_hz.unwrap_or(f64::NAN));
    }
    Ok(())
}

fn parse() -> Result<Options, Box<dyn Error>> {
    let mut options =
        Options { divisions: [130, 17, 12], modes: 20, clamped: false, threads: 0, write: None, solve: true };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or(format!("{word} needs a value"));
        match word.as_str() {
            "--divisions" => {
                let parts: Vec<usize> = value()?.split('x').map(str::parse).collect::<Result<_, _>>()?;
                options.divisions =
                    parts.try_into().map_err(|_| "--divisions needs three numbers, as 130x17x12")?;
            }
            "--modes" => options.modes = value()?.parse()?,
            "--clamped" => options.clamped = true,
            "--threads" => options.threads = value()?.parse()?,
            "--write" => options.write = Some(value()?.into()),
            "--no-solve" => options.solve = false,
            _ => return Err(format!("unknown option {word}").into()),
        }
    }
    Ok(options)
}
