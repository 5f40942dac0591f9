//! A `.npz` file: a zip archive of `.npy` files, stored or deflated as NumPy writes them.

use std::io::{self, Cursor, Error, ErrorKind};

use npyz::NpyFile;
use zip::ZipArchive;
use zip::result::ZipError;

use super::npy_header;
use crate::import::text::compressed::{Unread, read_within};

/// The arrays of one archive, by name without the ending `.npy`.
pub(crate) struct NpzArchive<'a> {
    zip: ZipArchive<Cursor<&'a [u8]>>,
    names: Vec<String>,
    inflated_limit: u64,
}

impl<'a> NpzArchive<'a> {
    /// Reads the directory of the archive.
    pub(crate) fn new(bytes: &'a [u8], inflated_limit: u64) -> io::Result<Self> {
        let zip = ZipArchive::new(Cursor::new(bytes))?;
        let names =
            zip.file_names().filter_map(|name| Some(name.ok()?.strip_suffix(".npy")?.to_owned())).collect();
        Ok(Self { zip, names, inflated_limit })
    }

    /// Names of the arrays.
    pub(crate) fn array_names(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(String::as_str)
    }

    /// The array of this name; `None` if there is none.
    pub(crate) fn by_name(&mut self, name: &str) -> io::Result<Option<NpyFile<Cursor<Vec<u8>>>>> {
        let entry = match self.zip.by_name(&format!("{name}.npy")) {
            Ok(entry) => entry,
            Err(ZipError::FileNotFound) => return Ok(None),
            Err(error) => return Err(error.into()),
        };
        let limit = self.inflated_limit;
        let invalid = |message| Error::new(ErrorKind::InvalidData, message);
        let bytes = read_within(entry, limit).map_err(|unread| match unread {
            Unread::Beyond => invalid(format!("it inflates to more than {limit} bytes, the limit")),
            Unread::Broken(error) => error,
        })?;
        npy_header::check(&bytes)
            .map_err(|defect| invalid(format!("expected {}, found {}", defect.expected, defect.found)))?;
        NpyFile::new(Cursor::new(bytes)).map(Some)
    }
}
