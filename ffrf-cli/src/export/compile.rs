//! The binary of an FMU from its own sources in C.

use std::io::ErrorKind;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, bail};
use ffrf_fmu::Sources;

use crate::output;

/// Compilers that are tried where none is named.
const COMPILERS: [&str; 3] = ["cc", "gcc", "clang"];

/// Every warning is an error: what goes into the FMU must be compiled by others as it is here. Products and sums are rounded
/// each, as on the desktop.
const FLAGS: [&str; 10] = [
    "-std=c99",
    "-O2",
    "-ffp-contract=off",
    "-Wall",
    "-Wextra",
    "-Wconversion",
    "-Werror",
    "-fPIC",
    "-fvisibility=hidden",
    "-shared",
];

/// The bytes of the binary, and the compiler that made it; none where no compiler is named and none is found.
///
/// Errors: the named compiler cannot be run, or a compiler does not accept the sources.
pub fn compile(sources: &Sources, compiler: Option<&str>) -> Result<Option<(Vec<u8>, String)>> {
    let runs = |compiler: &str| Command::new(compiler).arg("--version").output().is_ok();
    let compiler = match compiler {
        Some("none") => return Ok(None),
        Some(named) => named,
        None => match COMPILERS.into_iter().find(|compiler| runs(compiler)) {
            Some(found) => found,
            None => return Ok(None),
        },
    };
    let folder = Workplace::new().context("a folder for the compiler")?;
    for (name, text) in &sources.files {
        output::write(Some(&folder.0.join(name)), text)?;
    }
    let compiled = sources.files.iter().take(sources.compiled).map(|(name, _)| name);
    let binary = "binary";
    let run = Command::new(compiler)
        .args(FLAGS)
        .args(compiled)
        .args(["-lm", "-o", binary])
        .current_dir(&folder.0)
        .output()
        .with_context(|| format!("--compiler {compiler}"))?;
    if !run.status.success() {
        bail!("{compiler} does not accept the sources of the FMU:\n{}", String::from_utf8_lossy(&run.stderr));
    }
    let path = folder.0.join(binary);
    let bytes = std::fs::read(&path).with_context(|| format!("{}", path.display()))?;
    Ok(Some((bytes, compiler.to_owned())))
}

/// A folder for the compiler, which goes with this.
struct Workplace(PathBuf);

impl Workplace {
    /// Makes one that nobody else has. Errors: there can be none among temporary files.
    fn new() -> std::io::Result<Self> {
        let mut number = 0_u32;
        loop {
            let name = format!("ffrf-{}-{number}", std::process::id());
            let path = std::env::temp_dir().join(name);
            match std::fs::create_dir(&path) {
                Ok(()) => return Ok(Self(path)),
                Err(error) if error.kind() == ErrorKind::AlreadyExists && number < TRIES => number += 1,
                Err(error) => return Err(error),
            }
        }
    }
}

impl Drop for Workplace {
    fn drop(&mut self) {
        // what cannot be removed is left to the system, as other temporary files
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// Names that are tried for a folder: others may be left by runs that were killed.
const TRIES: u32 = 1000;
