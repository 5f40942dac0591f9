//! A `.npz` file: a zip archive of `.npy` files, stored or deflated as NumPy writes them.

use std::io::{self, Cursor, Read};

use npyz::NpyFile;
use zip::ZipArchive;
use zip::result::ZipError;

/// The arrays of one archive, by name without the ending `.npy`.
pub(crate) struct NpzArchive<'a> {
    zip: ZipArchive<Cursor<&'a [u8]>>,
    names: Vec<String>,
}

impl<'a> NpzArchive<'a> {
    /// Reads the directory of the archive.
    pub(crate) fn new(bytes: &'a [u8]) -> io::Result<Self> {
        let zip = ZipArchive::new(Cursor::new(bytes))?;
        let names =
            zip.file_names().filter_map(|name| Some(name.ok()?.strip_suffix(".npy")?.to_owned())).collect();
        Ok(Self { zip, names })
    }

    /// Names of the arrays.
    pub(crate) fn array_names(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(String::as_str)
    }

    /// The array of this name; `None` if there is none.
    pub(crate) fn by_name(&mut self, name: &str) -> io::Result<Option<NpyFile<Cursor<Vec<u8>>>>> {
        let mut entry = match self.zip.by_name(&format!("{name}.npy")) {
            Ok(entry) => entry,
            Err(ZipError::FileNotFound) => return Ok(None),
            Err(error) => return Err(error.into()),
        };
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes)?;
        NpyFile::new(Cursor::new(bytes)).map(Some)
    }
}
