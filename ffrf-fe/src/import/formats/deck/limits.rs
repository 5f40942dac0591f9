//! How far a deck may grow when it is written out. A few lines can name sets, parts and files again and again.

use crate::import::ImportError;
use crate::import::text::source::Source;

/// Files that include files that include files.
pub(super) const INCLUDE_DEPTH: usize = 8;
/// Times that `*INCLUDE` may occur.
pub(super) const INCLUDES: usize = 1000;
/// Bytes that files included a second time may have in all.
pub(super) const REPEATED_BYTES: usize = 64 << 20;
/// Nodes, elements and set members of all parts and instances: some times a large model.
pub(super) const MESH_ITEMS: usize = 200_000_000;
/// Members of all node sets, counted as often as they are named.
pub(super) const SET_MEMBERS: usize = 200_000_000;

/// Refuses the first count beyond a limit.
pub(super) fn at_most(
    limit: usize,
    found: usize,
    what: &'static str,
    source: &Source,
    at: usize,
) -> Result<(), ImportError> {
    if found <= limit {
        return Ok(());
    }
    Err(ImportError::TooMany {
        path: source.path().to_path_buf(),
        line: source.line_of(at),
        what,
        limit: limit as u64,
        found: found as u64,
    })
}
