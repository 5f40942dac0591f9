//! The library that goes into an FMU: where it is found.
//!
//! Cargo builds it with the command, into the folder `deps` beside it; who installs the command elsewhere puts the library
//! beside it, names it, or lets it be built from the sources.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail};
use ffrf_fmu::MARK;
use ffrf_fmu::description::Fmi;

use crate::arguments::ExportFmu;

/// The bytes of the library, and where it was found. Errors: there is none of this version.
pub fn find(arguments: &ExportFmu) -> Result<(Vec<u8>, PathBuf)> {
    if let Some(path) = &arguments.library {
        return Ok((read(path)?, path.clone()));
    }
    if let Some(sources) = &arguments.sources {
        let path = build(sources)?;
        return Ok((read(&path)?, path));
    }
    let program = std::env::current_exe().context("where this program is")?;
    let folder = program.parent().unwrap_or_else(|| Path::new(""));
    let name = file_name();
    let mut seen = Vec::new();
    for place in [folder.join("deps").join(&name), folder.join(&name), folder.join("../lib").join(&name)] {
        if !place.exists() {
            seen.push(format!("{}: nothing", place.display()));
            continue;
        }
        match read(&place) {
            Ok(bytes) => return Ok((bytes, place)),
            Err(error) => seen.push(format!("{error:#}")),
        }
    }
    bail!(
        "no library for the FMU was found:\n  {}\nexpected `{name}` of version {} beside this program: `cargo build --release \
         -p ffrf-fmu` in the ffrf sources makes it; or name it by --library, or name the sources by --sources",
        seen.join("\n  "),
        env!("CARGO_PKG_VERSION")
    )
}

/// Where the binary of an FMU lies in it, for this platform.
pub fn place(fmi: Fmi, identifier: &str) -> String {
    format!("binaries/{}/{identifier}{}", platform(fmi), std::env::consts::DLL_SUFFIX)
}

/// The name of the platform in FMUs of a version of the standard.
fn platform(fmi: Fmi) -> String {
    let (architecture, system) = (std::env::consts::ARCH, std::env::consts::OS);
    match fmi {
        Fmi::Three => {
            let system = if system == "macos" { "darwin" } else { system };
            format!("{architecture}-{system}")
        }
        Fmi::Two => {
            let system = match system {
                "macos" => "darwin",
                "windows" => "win",
                other => other,
            };
            format!("{system}{}", usize::BITS)
        }
    }
}

fn file_name() -> String {
    format!("{}ffrf_fmu{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX)
}

/// A library of this version. Errors: it cannot be read, or is another file.
fn read(path: &Path) -> Result<Vec<u8>> {
    let bytes = std::fs::read(path).with_context(|| format!("{}", path.display()))?;
    if !bytes.windows(MARK.len()).any(|window| window == MARK.as_bytes()) {
        bail!("{}: expected an {}, found another file", path.display(), MARK.trim_end_matches(';'));
    }
    Ok(bytes)
}

/// Builds the library from the sources; gives its path.
fn build(sources: &Path) -> Result<PathBuf> {
    let manifest = sources.join("Cargo.toml");
    if !manifest.is_file() {
        bail!(
            "--sources {}: expected the folder of the ffrf sources, found no Cargo.toml",
            sources.display()
        );
    }
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let built = Command::new(cargo)
        .args(["build", "--release", "--package", "ffrf-fmu", "--message-format", "json-render-diagnostics"])
        .arg("--manifest-path")
        .arg(&manifest)
        .stderr(Stdio::inherit())
        .output()
        .context("cargo, which builds the library")?;
    if !built.status.success() {
        bail!("cargo could not build the library: {}", built.status);
    }
    let name = file_name();
    let mut files = built.stdout.split(|byte| *byte == b'\n').filter_map(|line| {
        let message: serde_json::Value = serde_json::from_slice(line).ok()?;
        let files = message.get("filenames")?.as_array()?.clone();
        files.iter().filter_map(|file| file.as_str().map(PathBuf::from)).find(|file| file.ends_with(&name))
    });
    files.next_back().with_context(|| format!("cargo built no {name}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_file_is_no_library() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("libffrf_fmu.so");
        std::fs::write(&path, "ffrf-fmu library of version 0.0.0;").unwrap();
        let error = read(&path).unwrap_err().to_string();
        assert!(error.contains("expected an ffrf-fmu library of version"), "{error}");
        std::fs::write(&path, [b"\x7fELF", MARK.as_bytes(), b"\0"].concat()).unwrap();
        read(&path).unwrap();
    }
}
