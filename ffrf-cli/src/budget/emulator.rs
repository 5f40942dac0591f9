//! Building a program for a core, and running it in the emulator.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail};

use crate::arguments::Core;

const TARGET: &str = "thumbv7em-none-eabihf";

impl Core {
    fn cpu(self) -> &'static str {
        match self {
            Self::CortexM4F => "cortex-m4",
            Self::CortexM7 => "cortex-m7",
        }
    }

    /// A board that the emulator knows with this core.
    fn machine(self) -> &'static str {
        match self {
            Self::CortexM4F => "mps2-an386",
            Self::CortexM7 => "mps2-an500",
        }
    }
}

/// One measured piece of work.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Measured {
    /// What it is.
    pub name: String,
    /// The most instructions of one call.
    pub most: u64,
    /// Their mean over all calls.
    pub mean: u64,
    /// Stack that a call touches. Units: bytes.
    pub stack: u64,
}

/// What a program printed.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Run {
    /// What was measured, in order.
    pub measured: Vec<Measured>,
    /// Size of model and state. Units: bytes.
    pub state: u64,
}

impl Run {
    /// The most stack of all that was measured.
    pub fn most_stack(&self) -> u64 {
        self.measured.iter().map(|one| one.stack).max().unwrap_or(0)
    }

    fn parse(text: &str) -> Result<Self> {
        let mut run = Self::default();
        for line in text.lines() {
            let words: Vec<&str> = line.split(' ').collect();
            let number = |word: &str| word.parse::<u64>().with_context(|| format!("`{line}`"));
            match words.as_slice() {
                ["measured", name, most, mean, stack] => run.measured.push(Measured {
                    name: (*name).to_owned(),
                    most: number(most)?,
                    mean: number(mean)?,
                    stack: number(stack)?,
                }),
                ["state", bytes] => run.state = number(bytes)?,
                _ => bail!("the program printed `{line}`"),
            }
        }
        if run.measured.is_empty() {
            bail!("the program printed nothing");
        }
        Ok(run)
    }
}

/// Builds a binary of the package in `folder`; where it is. `CARGO`, `RUSTC`, `CARGO_TARGET_DIR` and `FFRF_BUILD_FLAGS`
/// (flags for cargo, as `-Zbuild-std=core`) are those of the caller's environment.
pub fn build(folder: &Path, core: Core, name: &str) -> Result<PathBuf> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| folder.join("target"), PathBuf::from);
    let flags = std::env::var("FFRF_BUILD_FLAGS").unwrap_or_default();
    let output = Command::new(&cargo)
        .args(["build", "--quiet", "--release", "--target", TARGET, "--bin", name, "--manifest-path"])
        .arg(folder.join("Cargo.toml"))
        .args(flags.split_whitespace())
        .env("CARGO_TARGET_DIR", &target)
        .env("RUSTFLAGS", format!("-C target-cpu={}", core.cpu()))
        .stdin(Stdio::null())
        .output()
        .with_context(|| format!("{} cannot be run", cargo.display()))?;
    if !output.status.success() {
        let text = String::from_utf8_lossy(&output.stderr);
        if text.contains("a_panic_is_reachable") {
            bail!("a panic is reachable in `{name}`, so that it does not link:\n{text}");
        }
        bail!("`{name}` cannot be built (see firmware/run.sh for what is needed):\n{text}");
    }
    Ok(target.join(TARGET).join("release").join(name))
}

/// Runs a program, one instruction after the other.
pub fn emulate(program: &Path, core: Core) -> Result<Run> {
    let output = Command::new("qemu-system-arm")
        .args([
            "-machine",
            core.machine(),
            "-cpu",
            core.cpu(),
            "-nographic",
            "-monitor",
            "none",
            "-serial",
            "null",
        ])
        .args(["-icount", "shift=6", "-semihosting-config", "enable=on,target=native", "-kernel"])
        .arg(program)
        .stdin(Stdio::null())
        .output()
        .context("qemu-system-arm cannot be run; firmware/run.sh installs it on Debian")?;
    let text = String::from_utf8_lossy(&output.stdout);
    if !output.status.success() {
        bail!(
            "the emulated program failed ({}): {text}{}",
            output.status,
            String::from_utf8_lossy(&output.stderr)
        );
    }
    Run::parse(&text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_program_prints_is_read() {
        let run = Run::parse("state 40\nmeasured step 100 90 512\n").unwrap();
        assert_eq!((run.state, run.most_stack()), (40, 512));
        assert_eq!(run.measured[0].mean, 90);
        for wrong in ["", "state 40", "measured step 1 2", "measured step 1 2 x", "hard fault"] {
            assert!(Run::parse(wrong).is_err(), "{wrong}");
        }
    }
}
