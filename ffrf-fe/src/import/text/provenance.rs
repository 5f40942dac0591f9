//! Name and hash of a file that the import itself does not read as part of the model.

use std::path::Path;

use ffrf_model::SourceFile;

use super::source::Source;
use crate::import::ImportError;

/// Name and hash of a file, such as one with mode shapes, for the provenance of a body.
///
/// # Errors
/// A file that cannot be read.
pub fn source_file(path: &Path, role: &str) -> Result<SourceFile, ImportError> {
    Ok(Source::stored(path)?.finish(role))
}
