//! Writing files: whole or not at all; devices and pipes are written to, not replaced.

use std::ffi::{OsStr, OsString};
use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Symbolic links that are followed one after another before they count as a circle.
const LINKS: usize = 40;

/// Names that are tried for the temporary file. One is enough but where a killed process of the same number left some
/// behind that cannot be removed.
const NAMES: usize = 1000;

/// The number of the next temporary file. No number comes twice in a process: who looks for files left behind may still
/// hold the open file of a name that has been renamed since, and would remove its successor.
static NEXT: AtomicUsize = AtomicUsize::new(0);

/// Writes a file.
///
/// A regular file appears whole or not at all: the bytes go to a temporary file in the same folder that is then
/// renamed. It is called `.NAME.PROCESS-NUMBER.ffrf-tmp` and locked while it is written. One that a killed process left
/// behind has no lock: the next write of the same file removes it. A file that exists keeps its permissions, and a
/// symbolic link is followed. What is no regular file (a device, a named pipe) is written to, not replaced.
///
/// Errors: what the operating system says; `PermissionDenied` for a file that is marked as read-only.
pub fn write_file(path: impl AsRef<Path>, bytes: &[u8]) -> io::Result<()> {
    let path = path.as_ref();
    match fs::metadata(path) {
        Ok(existing) if existing.is_dir() => {
            Err(io::Error::new(ErrorKind::IsADirectory, "is a folder, expected the name of a file"))
        }
        Ok(existing) if existing.is_file() => {
            refuse_read_only(path, &existing)?;
            replace(&followed(path)?, bytes, Some(&existing))
        }
        Ok(_) => {
            let mut device = OpenOptions::new().write(true).open(path)?;
            device.write_all(bytes)?;
            device.flush()
        }
        Err(error) if error.kind() == ErrorKind::NotFound => replace(&followed(path)?, bytes, None),
        Err(error) => Err(error),
    }
}

/// Renaming asks for the permissions of the folder only: those of the file must be asked for.
fn refuse_read_only(path: &Path, existing: &Metadata) -> io::Result<()> {
    // The mark counts for those as well whom the operating system lets write nevertheless.
    if existing.permissions().readonly() {
        let message = "is read-only: remove it or choose another name";
        return Err(io::Error::new(ErrorKind::PermissionDenied, message));
    }
    OpenOptions::new().write(true).open(path).map(drop)
}

/// The file that a chain of symbolic links ends at, whether it exists or not.
fn followed(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_path_buf();
    for _ in 0..LINKS {
        match fs::read_link(&path) {
            // A relative target starts at the folder of the link.
            Ok(target) => path = path.parent().unwrap_or(Path::new("")).join(target),
            Err(_) => return Ok(path),
        }
    }
    Err(io::Error::new(ErrorKind::InvalidInput, "too many symbolic links"))
}

fn replace(path: &Path, bytes: &[u8], existing: Option<&Metadata>) -> io::Result<()> {
    let Some(name) = path.file_name() else {
        return Err(io::Error::new(ErrorKind::InvalidInput, "is not the name of a file"));
    };
    remove_left_behind(path, name);
    let temporary = Temporary::beside(path, name)?;
    let written = temporary.fill(bytes, existing).and_then(|()| fs::rename(&temporary.path, path));
    if written.is_err() {
        // Nothing more can be done if this fails as well; the first error is the one to report.
        let _ = fs::remove_file(&temporary.path);
    }
    written
}

/// A temporary file, locked as long as this value lives.
struct Temporary {
    path: PathBuf,
    file: File,
}

impl Temporary {
    /// Makes one in the folder of `path`, so that renaming does not cross file systems.
    fn beside(path: &Path, name: &OsStr) -> io::Result<Self> {
        for _ in 0..NAMES {
            let number = NEXT.fetch_add(1, Ordering::Relaxed);
            let temporary = path.with_file_name(temporary_name(name, std::process::id(), number));
            let file = match OpenOptions::new().write(true).create_new(true).open(&temporary) {
                Ok(file) => file,
                Err(error) if error.kind() == ErrorKind::AlreadyExists => continue,
                Err(error) => return Err(error),
            };
            match file.lock() {
                // Where files cannot be locked, what is left behind stays.
                Err(error) if error.kind() != ErrorKind::Unsupported => return Err(error),
                _ => {}
            }
            // Between its making and its locking another process may have taken the file for one left behind.
            if temporary.exists() {
                return Ok(Self { path: temporary, file });
            }
        }
        Err(io::Error::new(ErrorKind::AlreadyExists, "no name is left for a temporary file beside it"))
    }

    fn fill(&self, bytes: &[u8], existing: Option<&Metadata>) -> io::Result<()> {
        let mut file = &self.file;
        file.write_all(bytes)?;
        if let Some(existing) = existing {
            file.set_permissions(existing.permissions())?;
        }
        file.sync_all()
    }
}

const SUFFIX: &str = ".ffrf-tmp";

fn temporary_name(name: &OsStr, process: u32, number: usize) -> OsString {
    let mut temporary = OsString::from(".");
    temporary.push(name);
    temporary.push(format!(".{process}-{number}{SUFFIX}"));
    temporary
}

/// Whether a file is a temporary file for `name`.
fn is_temporary_of(name: &OsStr, file: &OsStr) -> bool {
    let inner = |file: &[u8], name: &[u8]| {
        let rest = file.strip_prefix(b".")?.strip_prefix(name)?.strip_prefix(b".")?;
        let numbers = rest.strip_suffix(SUFFIX.as_bytes())?;
        let dash = numbers.iter().position(|byte| *byte == b'-')?;
        let digits = |part: &[u8]| !part.is_empty() && part.iter().all(u8::is_ascii_digit);
        Some(digits(&numbers[..dash]) && digits(&numbers[dash + 1..]))
    };
    inner(file.as_encoded_bytes(), name.as_encoded_bytes()).unwrap_or(false)
}

/// Removes the temporary files of `name` that no process holds a lock on; what cannot be removed stays.
fn remove_left_behind(path: &Path, name: &OsStr) {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten().filter(|entry| is_temporary_of(name, &entry.file_name())) {
        // Not through links: what lies elsewhere is none of ours.
        if !entry.file_type().is_ok_and(|kind| kind.is_file()) {
            continue;
        }
        if let Ok(file) = OpenOptions::new().write(true).open(entry.path())
            && file.try_lock().is_ok()
        {
            let _ = fs::remove_file(entry.path());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_own_names_are_temporary() {
        let is = |file: &str| is_temporary_of(OsStr::new("body.json"), OsStr::new(file));
        assert!(is(".body.json.12-0.ffrf-tmp"));
        for other in [
            "body.json.12-0.ffrf-tmp",
            ".body.json.12.ffrf-tmp",
            ".body.json.-.ffrf-tmp",
            ".body.json.12-x.ffrf-tmp",
            ".other.json.12-0.ffrf-tmp",
            ".body.json.12-0.tmp",
            ".body.json",
        ] {
            assert!(!is(other), "{other}");
        }
        assert!(is(temporary_name(OsStr::new("body.json"), 7, 3).to_str().unwrap()));
    }
}
