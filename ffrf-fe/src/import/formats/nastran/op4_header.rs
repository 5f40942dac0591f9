//! What stands before a matrix of `OUTPUT4`, and who reads its entries.

use crate::import::ImportError;

/// What stands before a matrix.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Header {
    pub(super) name: String,
    pub(super) rows: usize,
    pub(super) columns: usize,
    /// 1 and 2 are real, single and double; 3 and 4 complex.
    pub(super) kind: u64,
    /// Row numbers of strings have a word of their own.
    pub(super) is_big: bool,
    /// Where it stands.
    pub(super) place: usize,
}

impl Header {
    /// Words of 4 bytes that one number takes.
    pub(super) fn words(&self) -> usize {
        match self.kind {
            1 => 1,
            4 => 4,
            _ => 2,
        }
    }

    /// Row and number of words of a string of entries, whose first row is told in one integer of a small matrix.
    pub(super) fn small_string(marker: u64) -> Option<(usize, usize)> {
        let words = usize::try_from(marker / 65536).ok()?.checked_sub(1)?;
        let row = (marker % 65536) as usize;
        Some((row, words))
    }
}

/// What the walk over a file hands on: entries of a matrix that was asked for.
pub(super) trait Visitor {
    /// Whether the entries of this matrix are wanted.
    fn begins(&mut self, header: &Header) -> Result<bool, ImportError>;
    /// An entry, row and column from 1, at a place of the file.
    fn entry(&mut self, row: usize, column: usize, value: f64, place: usize) -> Result<(), ImportError>;
}
