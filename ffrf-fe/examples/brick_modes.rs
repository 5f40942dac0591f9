//! Modes of a solid steel brick of 92,000 degrees of freedom: seconds and memory of each phase.
//!
//! `cargo run --release -p ffrf-fe --example brick_modes -- [--divisions 130x17x12] [--modes 20] [--clamped]
//! [--threads 2] [--write FOLDER] [--no-solve]`. With `--clamped`, the face x = 0 is held. With `--write`, K, M_s and
//! the rows of the held nodes are written as plain arrays for other programs (`benches/peers/brick.sh`).

use std::error::Error;
use std::fs::{self, File};
use std::io::{BufWriter, Write as _};
use std::path::{Path, PathBuf};
use std::time::Instant;

use ffrf_fe::SparseMatrix;
use ffrf_fe::elements::{Material, brick};
use ffrf_fe::modes::{ModeRequest, Progress, Stage, compute_modes};

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
    let mut phases = Phases { last: Instant::now(), stage: Stage::Ordering, lines: Vec::new() };
    let start = Instant::now();
    let solution = compute_modes(&model, &request, &mut |progress| phases.enter(progress))?;
    let seconds = start.elapsed().as_secs_f64();
    phases.close();
    for line in &phases.lines {
        println!("{line}");
    }
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

/// Seconds of each stage, told apart by progress reports.
struct Phases {
    last: Instant,
    stage: Stage,
    lines: Vec<String>,
}

impl Phases {
    fn enter(&mut self, progress: Progress) {
        if progress.stage != self.stage {
            self.close();
            self.stage = progress.stage;
        }
    }

    fn close(&mut self) {
        self.lines.push(format!(
            "{} {:.2} s, peak memory {:.0} MB",
            self.stage,
            self.last.elapsed().as_secs_f64(),
            peak_megabytes()
        ));
        self.last = Instant::now();
    }
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

/// Compressed columns as three little-endian arrays: `NAME.starts`, `NAME.rows` (u64) and `NAME.values` (f64).
fn write_matrix(folder: &Path, name: &str, matrix: &SparseMatrix) -> std::io::Result<()> {
    write_indices(&folder.join(format!("{name}.starts")), matrix.symbolic().col_ptr())?;
    write_indices(&folder.join(format!("{name}.rows")), matrix.symbolic().row_idx())?;
    let mut file = BufWriter::new(File::create(folder.join(format!("{name}.values")))?);
    matrix.val().iter().try_for_each(|value| file.write_all(&value.to_le_bytes()))?;
    file.flush()
}

fn write_indices(path: &Path, indices: &[usize]) -> std::io::Result<()> {
    let mut file = BufWriter::new(File::create(path)?);
    indices.iter().try_for_each(|&index| file.write_all(&(index as u64).to_le_bytes()))?;
    file.flush()
}

/// Largest resident memory of this process so far, where the system tells it; 0 elsewhere.
fn peak_megabytes() -> f64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let kilobytes = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))
        .and_then(|rest| rest.split_whitespace().next())
        .and_then(|number| number.parse::<f64>().ok());
    kilobytes.unwrap_or(0.0) / 1024.0
}
