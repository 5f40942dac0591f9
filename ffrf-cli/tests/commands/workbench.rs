//! Running the command in a folder of its own, and a small elastic part made of springs.
#![allow(dead_code, clippy::unwrap_used)]

use std::path::{Path, PathBuf};
use std::process::Command;

/// A temporary folder in which the command runs.
pub struct Workbench {
    folder: tempfile::TempDir,
}

/// What a run left behind.
pub struct Run {
    /// Exit code.
    pub code: i32,
    /// Standard output.
    pub stdout: String,
    /// Standard error.
    pub stderr: String,
}

impl Run {
    /// Asserts success and hands back the standard output.
    #[track_caller]
    pub fn succeeded(self) -> String {
        assert_eq!(self.code, 0, "stdout: {}\nstderr: {}", self.stdout, self.stderr);
        self.stdout
    }

    /// Asserts failure with this exit code and a message that holds each part.
    #[track_caller]
    pub fn failed(self, code: i32, parts: &[&str]) {
        assert_eq!(self.code, code, "stdout: {}\nstderr: {}", self.stdout, self.stderr);
        for part in parts {
            assert!(self.stderr.contains(part), "`{part}` is not in: {}", self.stderr);
        }
    }
}

impl Workbench {
    /// An empty folder.
    pub fn new() -> Self {
        Self { folder: tempfile::tempdir().unwrap() }
    }

    /// A folder with `X.txt`, `M.mtx`, `K.mtx` of a [part](Springs).
    pub fn with_part() -> Self {
        let bench = Self::new();
        let part = Springs::default();
        bench.write("X.txt", &part.nodes());
        bench.write("M.mtx", &part.mass());
        bench.write("K.mtx", &part.stiffness());
        bench
    }

    /// Path of a file.
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Writes a file.
    pub fn write(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).unwrap();
    }

    /// Reads a file.
    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap()
    }

    /// Runs `ffrf` with words separated by blanks.
    pub fn run(&self, words: &str) -> Run {
        self.run_words(words.split_whitespace())
    }

    /// Runs `ffrf` with these words.
    pub fn run_words<'a>(&self, words: impl IntoIterator<Item = &'a str>) -> Run {
        run_in(self.folder.path(), words)
    }

    /// Names of all files, sorted.
    pub fn files(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.folder.path()).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}

/// Runs `ffrf` with these words in any folder.
pub fn run_in<'a>(folder: &Path, words: impl IntoIterator<Item = &'a str>) -> Run {
    let output = Command::new(env!("CARGO_BIN_EXE_ffrf")).current_dir(folder).args(words).output().unwrap();
    Run {
        code: output.status.code().unwrap(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Point masses, each joined to each other by a spring: six rigid-body modes, all others elastic.
pub struct Springs {
    positions: Vec<[f64; 3]>,
}

impl Default for Springs {
    fn default() -> Self {
        let positions = vec![
            [0.0, 0.0, 0.0],
            [1.0, 0.1, 0.0],
            [0.2, 0.9, 0.1],
            [0.1, 0.2, 1.1],
            [1.2, 1.0, 0.9],
            [2.1, 0.3, 0.4],
        ];
        Self { positions }
    }
}

impl Springs {
    /// Node table.
    pub fn nodes(&self) -> String {
        self.positions.iter().map(|[x, y, z]| format!("{x} {y} {z}\n")).collect()
    }

    /// Scalar mass matrix, Matrix Market, symmetric.
    pub fn mass(&self) -> String {
        let count = self.positions.len();
        let mut text =
            format!("%%MatrixMarket matrix coordinate real symmetric\n{count} {count} {}\n", 2 * count - 1);
        for n in 1..=count {
            text.push_str(&format!("{n} {n} {}\n", 1.0 + 0.25 * n as f64));
            if n < count {
                text.push_str(&format!("{} {n} 0.125\n", n + 1));
            }
        }
        text
    }

    /// Stiffness matrix, Matrix Market, symmetric.
    pub fn stiffness(&self) -> String {
        let size = 3 * self.positions.len();
        let mut matrix = vec![vec![0.0; size]; size];
        for (n, a) in self.positions.iter().enumerate() {
            for (m, b) in self.positions.iter().enumerate().skip(n + 1) {
                let arm: Vec<f64> = (0..3).map(|i| b[i] - a[i]).collect();
                let square: f64 = arm.iter().map(|x| x * x).sum();
                for i in 0..3 {
                    for j in 0..3 {
                        let entry = 1e4 * (1.0 + n as f64) * arm[i] * arm[j] / square;
                        matrix[3 * n + i][3 * n + j] += entry;
                        matrix[3 * m + i][3 * m + j] += entry;
                        matrix[3 * n + i][3 * m + j] -= entry;
                        matrix[3 * m + i][3 * n + j] -= entry;
                    }
                }
            }
        }
        let mut text = format!(
            "%%MatrixMarket matrix coordinate real symmetric\n{size} {size} {}\n",
            size * (size + 1) / 2
        );
        for (i, row) in matrix.iter().enumerate() {
            for (j, entry) in row.iter().enumerate().take(i + 1) {
                text.push_str(&format!("{} {} {entry:e}\n", i + 1, j + 1));
            }
        }
        text
    }
}
