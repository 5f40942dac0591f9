//! Everything that leaves the command: results, reports for people, and complaints.
//!
//! Results are whole files or none ([`ffrf_model::write_file`]). Reports and complaints carry text from input files:
//! here, and only here, control characters are escaped, so that no file can steer the terminal that it is shown on.
//! A reader that has seen enough (`ffrf inspect ... | head`) is no failure: what follows is dropped.

use std::io::{self, ErrorKind, Write};
use std::path::Path;

use anyhow::{Context, Result};

/// Writes a result, as it is, to a file or to standard output.
pub fn write(path: Option<&Path>, text: &str) -> Result<()> {
    match path {
        Some(path) => write_bytes(path, text.as_bytes()),
        None => print(io::stdout().lock(), text.as_bytes()).context("standard output"),
    }
}

/// Writes a result of bytes, as it is, to a file or to standard output.
pub fn write_bytes(path: &Path, bytes: &[u8]) -> Result<()> {
    if is_standard_output(path) {
        return print(io::stdout().lock(), bytes).context("standard output");
    }
    ffrf_model::write_file(path, bytes).with_context(|| format!("{}: cannot be written", path.display()))
}

/// Prints a report for people on standard output.
pub fn say(text: &str) -> Result<()> {
    print(io::stdout().lock(), printable(text).as_bytes()).context("standard output")
}

/// Prints a report beside a result: on standard output, or on standard error if the result goes to standard output.
pub fn say_beside(result: &Path, text: &str) -> Result<()> {
    if is_standard_output(result) {
        complain(text);
        return Ok(());
    }
    say(text)
}

/// Prints a message on standard error; there is nowhere left to report it if that fails.
pub fn complain(text: &str) {
    let _ = io::stderr().lock().write_all(printable(text).as_bytes());
}

/// The names of standard output. What is opened by such a name has a position of its own in a file that the shell
/// redirected to, and would overwrite what is already there.
fn is_standard_output(path: &Path) -> bool {
    ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"].iter().any(|name| path == Path::new(name))
}

fn print(mut stream: impl Write, bytes: &[u8]) -> io::Result<()> {
    match stream.write_all(bytes).and_then(|()| stream.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}

/// The lines of the text, each as [`ffrf_model::printable`] shows it.
fn printable(text: &str) -> String {
    text.split('\n').map(ffrf_model::printable).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_stay_and_other_control_characters_are_shown() {
        assert_eq!(printable("a\u{1b}[31m\r\tb\nÄ²\n"), "a\\u{1b}[31m\\u{d}\\u{9}b\nÄ²\n");
    }

    #[test]
    fn a_reader_that_went_away_is_no_failure_and_a_full_disk_is_one() {
        struct Fails(ErrorKind);
        impl Write for Fails {
            fn write(&mut self, _: &[u8]) -> io::Result<usize> {
                Err(self.0.into())
            }
            fn flush(&mut self) -> io::Result<()> {
                Ok(())
            }
        }
        print(Fails(ErrorKind::BrokenPipe), b"text").unwrap();
        print(Fails(ErrorKind::StorageFull), b"text").unwrap_err();
    }
}
