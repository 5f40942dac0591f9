//! Samples over time as files; the ending of a file's name says in which format.

mod csv;
mod mat;
mod npz;
mod parquet;

use std::ffi::OsStr;
use std::path::Path;

use anyhow::{Result, bail};

pub use mat::mat;
pub use npz::{Array, archive};

/// Named columns of equal length, kept row by row.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Columns {
    /// Names of the columns.
    pub names: Vec<String>,
    /// Rows, one number for each column.
    pub rows: Vec<Vec<f64>>,
}

impl Columns {
    /// The numbers of column `index`, from top to bottom.
    pub fn column(&self, index: usize) -> impl Iterator<Item = f64> + '_ {
        self.rows.iter().filter_map(move |row| row.get(index).copied())
    }
}

/// A format of samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Text, 17 significant digits.
    Csv,
    /// NumPy, one array for each column.
    Npz,
    /// Apache Parquet, one column of doubles for each.
    Parquet,
}

impl Format {
    /// The format of a file by the ending of its name; text where there is none, as in `/dev/stdout`.
    ///
    /// Errors: an ending that says something else.
    pub fn of(path: &Path) -> Result<Self> {
        match path.extension().map(OsStr::to_string_lossy).as_deref() {
            None | Some("csv") => Ok(Self::Csv),
            Some("npz") => Ok(Self::Npz),
            Some("parquet") => Ok(Self::Parquet),
            Some(other) => {
                bail!(
                    "{}: expected a name that ends in .csv, .npz or .parquet, found .{other}",
                    path.display()
                )
            }
        }
    }

    /// The bytes of a file of this format. Errors: the columns have no place in it.
    pub fn encode(self, columns: &Columns) -> Result<Vec<u8>> {
        match self {
            Self::Csv => Ok(csv::encode(columns)),
            Self::Npz => {
                let arrays = columns.names.iter().enumerate().map(|(index, name)| {
                    (
                        name.clone(),
                        Array::Numbers {
                            shape: vec![columns.rows.len()],
                            values: columns.column(index).collect(),
                        },
                    )
                });
                archive(arrays)
            }
            Self::Parquet => Ok(parquet::encode(columns)),
        }
    }
}
