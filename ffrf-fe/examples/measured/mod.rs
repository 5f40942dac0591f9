//! What the examples of large parts share: seconds and memory of each stage, and matrices as plain arrays for other programs.

use std::fs::{self, File};
use std::io::{BufWriter, Write as _};
use std::path::Path;
use std::time::Instant;

use ffrf_fe::SparseMatrix;
use ffrf_fe::modes::{Progress, Stage};

/// Prints seconds and memory of each stage as it ends; stages are told apart by progress reports.
pub struct Phases {
    last: Instant,
    stage: Stage,
}

impl Phases {
    /// The first stage begins.
    pub fn begin() -> Self {
        Self { last: Instant::now(), stage: Stage::Ordering }
    }

    pub fn enter(&mut self, progress: Progress) {
        if progress.stage != self.stage {
            self.close();
            self.stage = progress.stage;
        }
    }

    pub fn close(&mut self) {
        let seconds = self.last.elapsed().as_secs_f64();
        println!("{} {seconds:.2} s, peak memory {:.0} MB", self.stage, peak_megabytes());
        self.last = Instant::now();
    }
}

/// Compressed columns as three little-endian arrays: `NAME.starts`, `NAME.rows` (u64) and `NAME.values` (f64).
pub fn write_matrix(folder: &Path, name: &str, matrix: &SparseMatrix) -> std::io::Result<()> {
    write_indices(&folder.join(format!("{name}.starts")), matrix.symbolic().col_ptr())?;
    write_indices(&folder.join(format!("{name}.rows")), matrix.symbolic().row_idx())?;
    write_numbers(&folder.join(format!("{name}.values")), matrix.val())
}

pub fn write_numbers(path: &Path, numbers: &[f64]) -> std::io::Result<()> {
    let mut file = BufWriter::new(File::create(path)?);
    numbers.iter().try_for_each(|value| file.write_all(&value.to_le_bytes()))?;
    file.flush()
}

pub fn write_indices(path: &Path, indices: &[usize]) -> std::io::Result<()> {
    let mut file = BufWriter::new(File::create(path)?);
    indices.iter().try_for_each(|&index| file.write_all(&(index as u64).to_le_bytes()))?;
    file.flush()
}

/// Largest resident memory of this process so far, where the system tells it; 0 elsewhere.
pub fn peak_megabytes() -> f64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let kilobytes = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))
        .and_then(|rest| rest.split_whitespace().next())
        .and_then(|number| number.parse::<f64>().ok());
    kilobytes.unwrap_or(0.0) / 1024.0
}
