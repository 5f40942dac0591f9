//! Input files that are stored gzip-compressed: `part.sti.gz` stands in for `part.sti`.

use std::ffi::OsString;
use std::io::{Error, ErrorKind, Read};
use std::path::{Path, PathBuf};

use flate2::read::MultiGzDecoder;

/// The path that is there: `path` itself or, if only that exists, `path` with `.gz` appended.
pub(crate) fn stored_path(path: &Path) -> PathBuf {
    let mut name: OsString = path.as_os_str().to_owned();
    name.push(".gz");
    let compressed = PathBuf::from(name);
    if !path.exists() && compressed.is_file() { compressed } else { path.to_path_buf() }
}

/// Whether a file of this name is to be inflated.
pub(crate) fn is_compressed(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("gz"))
}

/// The content of a gzip file; a damaged or truncated one is an error, and so is one of more than `limit` bytes.
pub(crate) fn inflate(stored: &[u8], limit: u64) -> Result<Vec<u8>, Error> {
    let invalid = |message| Error::new(ErrorKind::InvalidData, message);
    read_within(MultiGzDecoder::new(stored), limit).map_err(|error| match error {
        Unread::Beyond => {
            invalid(format!("{} bytes inflate to more than {limit} bytes, the limit", stored.len()))
        }
        Unread::Broken(error) => invalid(format!("not a complete gzip file: {error}")),
    })
}

/// Why an inflated content could not be read.
pub(crate) enum Unread {
    /// It is longer than the limit.
    Beyond,
    /// The stored bytes are damaged.
    Broken(Error),
}

/// All bytes of a reader whose length nobody knows, up to `limit`.
pub(crate) fn read_within(reader: impl Read, limit: u64) -> Result<Vec<u8>, Unread> {
    let mut content = Vec::new();
    let read = reader.take(limit.saturating_add(1)).read_to_end(&mut content).map_err(Unread::Broken)?;
    if read as u64 > limit { Err(Unread::Beyond) } else { Ok(content) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;

    fn deflate(content: &[u8]) -> Vec<u8> {
        let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::best());
        encoder.write_all(content).unwrap();
        encoder.finish().unwrap()
    }

    #[test]
    fn what_was_compressed_comes_back_and_a_truncated_file_does_not() {
        let content = b"1 1  7.7864829301614e+08\n".repeat(100);
        let stored = deflate(&content);
        assert_eq!(inflate(&stored, content.len() as u64).unwrap(), content);
        let error = inflate(&stored, content.len() as u64 - 1).unwrap_err();
        assert!(error.to_string().ends_with("inflate to more than 2499 bytes, the limit"), "{error}");
        let error = inflate(&stored[..stored.len() - 5], 1 << 20).unwrap_err();
        assert!(error.to_string().contains("not a complete gzip file"), "{error}");
    }

    #[test]
    fn the_plain_file_goes_before_the_compressed_one() {
        let folder = tempfile::tempdir().unwrap();
        let plain = folder.path().join("part.sti");
        let compressed = folder.path().join("part.sti.gz");
        assert_eq!(stored_path(&plain), plain, "neither is there: the error names the file asked for");
        std::fs::write(&compressed, deflate(b"1")).unwrap();
        assert_eq!(stored_path(&plain), compressed);
        std::fs::write(&plain, "1").unwrap();
        assert_eq!(stored_path(&plain), plain);
    }
}
