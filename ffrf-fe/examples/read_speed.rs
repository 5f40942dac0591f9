//! How fast matrices are read: generates files of a million entries and prints MB/s for each format.
//!
//! Columns: reading the bytes alone; the same with their SHA-256, as the provenance of a model needs it; reading the
//! matrix, and how many times the bytes alone that takes; matrix and hash side by side, as in `read_model`.
//! Best of some runs, so that file and memory are warm. The last columns are what a command sees that reads a file once:
//! each run is a process of its own, into fresh memory; medians.
//!
//! Measured on 2026-11-22, 2 cores of an AMD EPYC (Zen 4): a million entries (15 to 36 MB) in 14 to 42 ms, 860 to
//! 1250 MB/s, 8 to 12 times the bytes alone from the page cache; their SHA-256 takes 10 to 25 ms. In a new process 50 to
//! 93 ms, 290 to 440 MB/s, 2.8 to 4.3 times the bytes alone (12 to 33 ms): fresh memory costs both.
//!
//! Run with `cargo run --release -p ffrf-fe --example read_speed`.

use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use ffrf_fe::Nodes;
use ffrf_fe::import::{read_matrix, source_file};

/// Rows of the matrix; with 81 entries a row (linear hexahedra) both triangles have a million entries.
const NODES: usize = 4_116;
/// Entries of a row on each side of the diagonal.
const HALF_BAND: usize = 40;
const RUNS: usize = 21;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    if let [what, path] = words.as_slice() {
        return once(what, Path::new(path));
    }
    let folder = std::env::temp_dir().join(format!("ffrf-read-speed-{}", std::process::id()));
    std::fs::create_dir_all(&folder)?;
    let size = 3 * NODES;
    let nodes = nodes();
    println!(
        "{:<30} {:>8} {:>5} {:>9} {:>10} {:>8} {:>5} {:>6} {:>10}   {:>9} {:>8} {:>5} {:>6}",
        "format",
        "entries",
        "MB",
        "bytes ms",
        "SHA-256 ms",
        "read ms",
        "MB/s",
        "times",
        "read + SHA",
        "new bytes",
        "new read",
        "MB/s",
        "times"
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

fn nodes() -> Nodes {
    let ids: Vec<u64> = (1..=NODES as u64).collect();
    Nodes { positions: vec![[0.0; 3]; NODES], ids, ..Nodes::default() }
}

/// What a process of its own does: reads the bytes or the matrix once and prints the milliseconds.
fn once(what: &str, path: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let nodes = nodes();
    let time = match what {
        "bytes" => milliseconds(|| Ok(std::fs::read(path)?))?,
        "matrix" => milliseconds(|| Ok(read_matrix(path, &nodes)?))?,
        _ => return Err(format!("expected `bytes` or `matrix`, found `{what}`").into()),
    };
    println!("{time}");
    Ok(())
}

/// Median of some processes that read a file once.
fn new_process(what: &str, path: &Path) -> Result<f64, Box<dyn std::error::Error>> {
    let mut times = Vec::with_capacity(RUNS);
    for _ in 0..RUNS {
        let output = Command::new(std::env::current_exe()?).arg(what).arg(path).output()?;
        times.push(String::from_utf8(output.stdout)?.trim().parse::<f64>()?);
    }
    times.sort_by(f64::total_cmp);
    Ok(times[RUNS / 2])
}

/// Prints the best of some runs of each way to read a file.
fn report(name: &str, path: &Path, nodes: &Nodes) -> Result<(), Box<dyn std::error::Error>> {
    let mut entries = 0;
    let [mut bytes, mut hash, mut read, mut both] = [f64::INFINITY; 4];
    for _ in 0..RUNS {
        bytes = bytes.min(milliseconds(|| Ok(std::fs::read(path)?))?);
        hash = hash.min(milliseconds(|| Ok(source_file(path, "matrix")?))?);
        read = read.min(milliseconds(|| {
            entries = read_matrix(path, nodes)?.compute_nnz();
            Ok(())
        })?);
        both = both.min(milliseconds(|| {
            std::thread::scope(|scope| {
                let hash = scope.spawn(|| source_file(path, "matrix"));
                read_matrix(path, nodes)?;
                hash.join().map_err(|_| "the hash failed")??;
                Ok(())
            })
        })?);
    }
    let (new_bytes, new_read) = (new_process("bytes", path)?, new_process("matrix", path)?);
    let megabytes = std::fs::metadata(path)?.len() as f64 / 1e6;
    println!(
        "{name:<30} {entries:>8} {megabytes:>5.1} {bytes:>9.1} {hash:>10.1} {read:>8.1} {:>5.0} {:>6.1} {both:>10.1}   {new_bytes:>9.1} {new_read:>8.1} {:>5.0} {:>6.1}",
        megabytes / read * 1e3,
        read / bytes,
        megabytes / new_read * 1e3,
        new_read / new_bytes,
    );
    Ok(())
}

/// Time of some work and of dropping its result.
fn milliseconds<T>(
    work: impl FnOnce() -> Result<T, Box<dyn std::error::Error>>,
) -> Result<f64, Box<dyn std::error::Error>> {
    let start = Instant::now();
    drop(work()?);
    Ok(start.elapsed().as_secs_f64() * 1e3)
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
