//! The file format `*.ffrf.json`: strict reading, bit-exact and diff-friendly writing.

use std::path::Path;

use serde::Deserialize;
use serde_json::error::Category;

use crate::{CheckReport, ModelError, ReducedBody, SCHEMA_VERSION, write_file};

impl ReducedBody {
    /// Reads a body from JSON text: a checked body or a refusal.
    ///
    /// Strict: an unknown version, a missing, unknown or mistyped field, a number that is not finite and a
    /// list of the wrong length are errors that name the field by its full path. Every number is read to the
    /// nearest `f64`, so that reading what [`to_json`](Self::to_json) wrote gives the same bits.
    ///
    /// Errors: [`ModelError`], all variants but `Io` and `File`; `Inconsistent` for a body that fails its
    /// [`check`](Self::check).
    pub fn from_json(text: &str) -> Result<Self, ModelError> {
        let (body, report) = Self::from_json_with_report(text)?;
        report.verdict()?;
        Ok(body)
    }

    /// As [`from_json`](Self::from_json), but leaves the verdict of the checks to the caller: for tools that show what
    /// is wrong with a body.
    ///
    /// Errors: those of [`from_json`](Self::from_json) but `Inconsistent`.
    pub fn from_json_with_report(text: &str) -> Result<(Self, CheckReport), ModelError> {
        check_version(text)?;
        let mut reader = serde_json::Deserializer::from_str(text);
        let body: Self = serde_path_to_error::deserialize(&mut reader).map_err(field_error)?;
        reader.end().map_err(|error| syntax_error(&error))?;
        let report = body.check()?;
        Ok((body, report))
    }

    /// Writes the body as JSON text, one row of each matrix on a line.
    ///
    /// The same body gives the same text, to the byte.
    ///
    /// Errors: `NotFinite`, `Length`, `Version`.
    pub fn to_json(&self) -> Result<String, ModelError> {
        self.check_shape()?;
        let pretty = serde_json::to_string_pretty(self).map_err(|error| syntax_error(&error))?;
        Ok(join_rows(&pretty))
    }

    /// Reads a body from a file: a checked body or a refusal; see [`from_json`](Self::from_json).
    ///
    /// Errors: `Io` and `File`, which both name the file.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ModelError> {
        let path = path.as_ref();
        let (body, report) = Self::read_with_report(path)?;
        report.verdict().map_err(|source| at_fault(path, source))?;
        Ok(body)
    }

    /// As [`read`](Self::read), but leaves the verdict of the checks to the caller; see
    /// [`from_json_with_report`](Self::from_json_with_report).
    ///
    /// Errors: `Io` and `File`, which both name the file.
    pub fn read_with_report(path: impl AsRef<Path>) -> Result<(Self, CheckReport), ModelError> {
        let path = path.as_ref();
        let text = std::fs::read_to_string(path).map_err(|source| io_error(path, source))?;
        Self::from_json_with_report(&text).map_err(|source| at_fault(path, source))
    }

    /// Writes the body to a file by [`write_file`]; see [`to_json`](Self::to_json).
    ///
    /// Errors: `Io`, or what [`to_json`](Self::to_json) reports.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), ModelError> {
        let path = path.as_ref();
        let text = self.to_json()?;
        write_file(path, text.as_bytes()).map_err(|source| io_error(path, source))
    }
}

/// The version stands before everything else: other versions may have other fields.
fn check_version(text: &str) -> Result<(), ModelError> {
    #[derive(Deserialize)]
    struct VersionOnly {
        schema_version: u64,
    }
    let mut reader = serde_json::Deserializer::from_str(text);
    let found: VersionOnly = serde_path_to_error::deserialize(&mut reader).map_err(field_error)?;
    if found.schema_version == u64::from(SCHEMA_VERSION) {
        Ok(())
    } else {
        Err(ModelError::Version { found: found.schema_version, known: SCHEMA_VERSION })
    }
}

fn syntax_error(error: &serde_json::Error) -> ModelError {
    ModelError::Syntax { line: error.line(), column: error.column(), message: bare_message(error) }
}

/// The message without " at line L column C", which the error variants carry as numbers.
fn bare_message(error: &serde_json::Error) -> String {
    let message = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    message.strip_suffix(&place).unwrap_or(&message).to_owned()
}

fn field_error(error: serde_path_to_error::Error<serde_json::Error>) -> ModelError {
    let path = error.path().to_string();
    let error = error.into_inner();
    let message = bare_message(&error);
    let parent = (path != ".").then_some(path);
    let number_out_of_range = message == "number out of range";
    if error.classify() != Category::Data && !number_out_of_range {
        return syntax_error(&error);
    }
    // A missing or repeated field is reported at the object that it is missing from or repeated in.
    let named = ["missing field `", "duplicate field `"]
        .iter()
        .find_map(|prefix| message.strip_prefix(prefix)?.strip_suffix('`'));
    let field = match (parent, named) {
        (Some(parent), Some(name)) => format!("{parent}.{name}"),
        (None, Some(name)) => name.to_owned(),
        (Some(parent), None) => parent,
        (None, None) => "the file".to_owned(),
    };
    let message = if number_out_of_range { "the number is not finite in f64".to_owned() } else { message };
    ModelError::Field { field, message, line: error.line(), column: error.column() }
}

/// Puts each innermost list of a pretty-printed text on one line.
///
/// Strings cannot mislead it: the printer escapes line breaks, so a line that ends in `[` opens a list.
fn join_rows(pretty: &str) -> String {
    let mut joined = String::with_capacity(pretty.len());
    let mut lines = pretty.lines().peekable();
    while let Some(line) = lines.next() {
        joined.push_str(line);
        let opens_row = line.ends_with('[') && lines.peek().is_some_and(|next| is_scalar_line(next));
        if opens_row {
            let mut first = true;
            for entry in lines.by_ref() {
                let entry = entry.trim_start();
                if entry.starts_with(']') {
                    joined.push_str(entry);
                    break;
                }
                if !first {
                    joined.push(' ');
                }
                joined.push_str(entry);
                first = false;
            }
        }
        joined.push('\n');
    }
    joined
}

fn is_scalar_line(line: &str) -> bool {
    !line.trim_start().starts_with(['[', '{'])
}

fn at_fault(path: &Path, source: ModelError) -> ModelError {
    ModelError::File { path: path.to_path_buf(), source: Box::new(source) }
}

fn io_error(path: &Path, source: std::io::Error) -> ModelError {
    ModelError::Io { path: path.to_path_buf(), source }
}
