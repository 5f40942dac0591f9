//! A file in memory, hashed in the background while it is read.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread::JoinHandle;

use ffrf_model::{SourceFile, printable};
use sha2::{Digest, Sha256};

use super::compressed::{inflate, is_compressed, stored_path};
use super::cursor::{Defect, DefectKind};
use crate::import::ImportError;

/// Longest excerpt of a file that an error message quotes.
const EXCERPT: usize = 60;

/// The bytes of one input file.
#[derive(Debug)]
pub(crate) struct Source {
    path: PathBuf,
    /// As stored; the provenance is the hash of these.
    stored: Arc<Vec<u8>>,
    /// The content: the stored bytes, inflated if they are compressed.
    bytes: Content,
    hash: Option<JoinHandle<String>>,
    inflated_limit: u64,
}

/// The content of a file, shared with its [`Source`].
#[derive(Debug, Clone)]
pub(crate) struct Content(Arc<Vec<u8>>);

impl Content {
    /// The content, without a byte-order mark.
    pub(crate) fn bytes(&self) -> &[u8] {
        self.0.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&self.0)
    }
}

impl Source {
    /// Reads the file whole, or the one with `.gz` after its name, and starts hashing it.
    pub(crate) fn read(path: &Path, inflated_limit: u64) -> Result<Self, ImportError> {
        let mut source = Self::read_unhashed(path, inflated_limit)?;
        source.start_hash();
        Ok(source)
    }

    /// Reads the file whole, or the one with `.gz` after its name. For large files, which all cores scan: the hash
    /// is started once they are scanned, by [`Self::start_hash`], or else comes with [`Self::finish`].
    pub(crate) fn read_unhashed(path: &Path, inflated_limit: u64) -> Result<Self, ImportError> {
        let mut source = Self::stored(path)?;
        source.inflated_limit = inflated_limit;
        if is_compressed(&source.path) {
            let inflated = inflate(&source.stored, inflated_limit);
            let inflated =
                inflated.map_err(|error| ImportError::Io { path: source.path.clone(), source: error })?;
            source.bytes = Content(Arc::new(inflated));
        }
        Ok(source)
    }

    /// The file as stored, not inflated: for its name and hash alone.
    pub(crate) fn stored(path: &Path) -> Result<Self, ImportError> {
        let path = stored_path(path);
        let stored = match std::fs::read(&path) {
            Ok(bytes) => Arc::new(bytes),
            Err(source) => return Err(ImportError::Io { path, source }),
        };
        Ok(Source { path, bytes: Content(Arc::clone(&stored)), stored, hash: None, inflated_limit: 0 })
    }

    /// Hashes the bytes on a thread of their own, unless this has been done.
    pub(crate) fn start_hash(&mut self) {
        if self.hash.is_none() {
            let shared = Arc::clone(&self.stored);
            self.hash = std::thread::Builder::new().spawn(move || sha256(&shared)).ok();
        }
    }

    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// The content, without a byte-order mark.
    pub(crate) fn bytes(&self) -> &[u8] {
        self.bytes.bytes()
    }

    /// The content, to be kept beside the source.
    pub(crate) fn content(&self) -> Content {
        self.bytes.clone()
    }

    /// Largest inflated size of what is compressed in this file. Units: bytes.
    pub(crate) fn inflated_limit(&self) -> u64 {
        self.inflated_limit
    }

    /// File name and hash, for the provenance.
    pub(crate) fn finish(self, role: &str) -> SourceFile {
        let hashed = self.hash.and_then(|handle| handle.join().ok());
        SourceFile {
            role: role.to_owned(),
            file: self.path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default(),
            sha256: hashed.unwrap_or_else(|| sha256(&self.stored)),
        }
    }

    /// Line number, from 1, of a byte offset.
    pub(crate) fn line_of(&self, at: usize) -> usize {
        let bytes = self.bytes();
        1 + bytes[..at.min(bytes.len())].iter().filter(|&&byte| byte == b'\n').count()
    }

    /// Number of the last line that holds anything.
    pub(crate) fn last_line(&self) -> usize {
        let bytes = self.bytes();
        let end = bytes.iter().rposition(|byte| !byte.is_ascii_whitespace()).unwrap_or(0);
        self.line_of(end)
    }

    /// What stands at a place, for a message: the token and its line.
    fn excerpt(&self, at: usize) -> String {
        let bytes = self.bytes();
        let at = at.min(bytes.len());
        let start = bytes[..at].iter().rposition(|&byte| byte == b'\n').map_or(0, |before| before + 1);
        let end = bytes[at..].iter().position(|&byte| byte == b'\n').map_or(bytes.len(), |after| at + after);
        let line = String::from_utf8_lossy(&bytes[start..end]);
        let shown: String = line.trim().chars().take(EXCERPT).collect();
        let token = String::from_utf8_lossy(&bytes[at..end]);
        let token: String =
            token.split([' ', '\t', ',', '\r']).next().unwrap_or("").chars().take(EXCERPT).collect();
        match (token.is_empty(), shown.is_empty()) {
            (true, true) if at >= bytes.len() => "the end of the file".to_owned(),
            (true, true) => "an empty line".to_owned(),
            (true, false) => format!("the end of the line `{}`", printable(&shown)),
            (false, _) if token == shown => format!("`{}`", printable(&token)),
            (false, _) => format!("`{}` in `{}`", printable(&token), printable(&shown)),
        }
    }

    /// An error of the form file, line, expected, found.
    pub(crate) fn expected(&self, at: usize, expected: impl Into<String>) -> ImportError {
        ImportError::Parse {
            path: self.path.clone(),
            line: self.line_of(at),
            expected: printable(&expected.into()),
            found: self.excerpt(at),
        }
    }

    /// Turns a defect of the scan into an error; `nodes` is the size of the node table, if there is one.
    pub(crate) fn defect(&self, defect: &Defect, nodes: usize) -> ImportError {
        let at = defect.at;
        match defect.kind {
            DefectKind::Expected(expected) => self.expected(at, expected),
            DefectKind::ExpectedIndex(limit) => self.expected(at, format!("an index from 1 to {limit}")),
            DefectKind::NonFinite => ImportError::NonFinite {
                path: self.path.clone(),
                line: self.line_of(at),
                found: self.excerpt(at),
            },
            DefectKind::UnknownNode(id) => {
                ImportError::UnknownNode { path: self.path.clone(), line: self.line_of(at), id, nodes }
            }
        }
    }

    /// The file ends too early.
    pub(crate) fn truncated(&self, what: &'static str, expected: usize, found: usize) -> ImportError {
        ImportError::Truncated { path: self.path.clone(), line: self.last_line(), what, expected, found }
    }
}

fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hash_and_line_numbers_of_a_known_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("abc.txt");
        std::fs::write(&path, "abc").unwrap();
        let source = Source::read(&path, 0).unwrap();
        assert_eq!(source.line_of(2), 1);
        let file = source.finish("nodes");
        assert_eq!(file.file, "abc.txt");
        // FIPS 180-2, appendix B.1
        assert_eq!(file.sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }

    #[test]
    fn a_missing_file_is_named() {
        let error = Source::read(Path::new("no/such/file.mtx"), 0).unwrap_err();
        assert!(error.to_string().starts_with("no/such/file.mtx: "), "{error}");
    }
}
