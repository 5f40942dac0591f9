//! Writing results: whole files or none.

use std::io::Write;
use std::path::Path;

use anyhow::{Context, Result};

/// Writes text to a file by way of a temporary file in the same folder, or to standard output.
pub fn write(path: Option<&Path>, text: &str) -> Result<()> {
    match path {
        Some(path) => {
            write_file(path, text).with_context(|| format!("{}: cannot be written", path.display()))
        }
        None => std::io::stdout().lock().write_all(text.as_bytes()).context("standard output"),
    }
}

fn write_file(path: &Path, text: &str) -> std::io::Result<()> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".ffrf-").suffix(".tmp");
    #[cfg(unix)]
    {
        // Readable by others as far as the user's mask allows, as any file that a program makes.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(folder)?;
    file.write_all(text.as_bytes())?;
    file.as_file().sync_all()?;
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}
