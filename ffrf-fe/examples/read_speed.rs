//! How fast matrices are read: generates files of a million entries and prints MB/s for each format.
//!
//! Run with `cargo run --release -p ffrf-fe --example read_speed`.

use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

use ffrf_fe::Nodes;
use ffrf_fe::import::read_matrix;

/// Rows of the matrix; with 81 entries a row (linear hexahedra) both triangles have a million entries.
const NODES: usize = 4_116;
/// Entries of a row on each side of the diagonal.
const HALF_BAND: usize = 40;
const RUNS: usize = 7;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::temp_dir().join(format!("ffrf-read-speed-{}", std::process::id()));
    std::fs::create_dir_all(&folder)?;
    let size = 3 * NODES;
    let ids: Vec<u64> = (1..=NODES as u64).collect();
    let nodes = Nodes { positions: vec![[0.0; 3]; NODES], ids, ..Nodes::default() };
    println!(
        "{:<34} {:>9} {:>7} {:>9} {:>9} {:>8}",
        "format", "entries", "MB", "bytes ms", "read ms", "MB/s"
    );
    for (name, text) in [
        ("Matrix Market, symmetric", matrix_market(size, "symmetric")),
        ("Matrix Market, general", matrix_market(size, "general")),
        (
            "list, row col value",
            lines(size, true, |row, column, value| format!("{row} {column}  {value:.15e}\n")),
        ),
        ("list, node dof node dof value", lines(size, true, labelled)),
        (
            "list, 17 digits (Python repr)",
            lines(size, true, |row, column, value| format!("{row} {column} {value}\n")),
        ),
    ] {
        let path = folder.join("matrix.mtx");
        std::fs::write(&path, &text)?;
        report(name, &path, &nodes)?;
    }
    std::fs::remove_dir_all(&folder)?;
    Ok(())
}

/// Prints the best of some runs: reading the bytes alone, and reading the matrix.
fn report(name: &str, path: &Path, nodes: &Nodes) -> Result<(), Box<dyn std::error::Error>> {
    let (mut bytes_time, mut read_time) = (f64::INFINITY, f64::INFINITY);
    let (mut bytes, mut entries) = (0, 0);
    for _ in 0..RUNS {
        let start = Instant::now();
        bytes = std::fs::read(path)?.len();
        bytes_time = bytes_time.min(start.elapsed().as_secs_f64());
        let start = Instant::now();
        entries = read_matrix(path, nodes)?.compute_nnz();
        read_time = read_time.min(start.elapsed().as_secs_f64());
    }
    let megabytes = bytes as f64 / 1e6;
    println!(
        "{name:<34} {entries:>9} {megabytes:>7.1} {:>9.1} {:>9.1} {:>8.0}",
        bytes_time * 1e3,
        read_time * 1e3,
        megabytes / read_time
    );
    Ok(())
}

fn value(row: usize, column: usize) -> f64 {
    let (low, high) = (row.min(column), row.max(column));
    // Irregular digits, as an export has them.
    1.0e9 * ((low * 7919 + high * 104_729) as f64).sin() + if low == high { 1.0e12 } else { 0.0 }
}

/// Lines for all entries (`both`) or the lower triangle, row and column from 1.
fn lines(size: usize, both: bool, line: impl Fn(usize, usize, f64) -> String) -> String {
    let mut text = String::new();
    for row in 0..size {
        let last = if both { (row + HALF_BAND).min(size - 1) } else { row };
        for column in row.saturating_sub(HALF_BAND)..=last {
            text += &line(row + 1, column + 1, value(row, column));
        }
    }
    text
}

fn labelled(row: usize, column: usize, value: f64) -> String {
    let dof = |index: usize| ((index - 1) / 3 + 1, (index - 1) % 3 + 1);
    let ((a, i), (b, j)) = (dof(row), dof(column));
    format!("{a},{i}, {b},{j}, {value:.15e}\n")
}

fn matrix_market(size: usize, symmetry: &str) -> String {
    let body =
        lines(size, symmetry == "general", |row, column, value| format!("{row} {column} {value:.15e}\n"));
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "%%MatrixMarket matrix coordinate real {symmetry}\n{size} {size} {}",
        body.lines().count()
    );
    text + &body
}
