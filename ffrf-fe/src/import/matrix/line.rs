//! One line of a matrix file: its indices, and lines that hold no entry.

use crate::import::text::cursor::{Cursor, Defect, DefectKind};
use crate::import::text::ordinary;

/// Reads one index of a line: a row number, or a node with its direction.
pub(crate) trait ReadIndex: Sync {
    /// What a line looks like, for messages.
    const LINE: &'static str;

    /// Reads an index that is written as usual and lies within bounds; returns it counted from 0, and the offset of
    /// the next token. `None` leaves the line to [`Self::read`].
    fn read_short(&self, bytes: &[u8], at: usize) -> Option<(u32, usize)>;

    /// Reads an index and returns it counted from 0.
    fn read(&self, cursor: &mut Cursor<'_>) -> Result<u32, Defect>;
}

/// Row and column numbers from 1.
pub(crate) struct RowNumber {
    /// Largest number allowed.
    pub(crate) limit: usize,
}

impl ReadIndex for RowNumber {
    const LINE: &'static str = "`row column value`";

    #[inline(always)]
    fn read_short(&self, bytes: &[u8], at: usize) -> Option<(u32, usize)> {
        let (number, next) = ordinary::index(bytes, at)?;
        let index = number.wrapping_sub(1);
        ((index as usize) < self.limit).then_some((index, next))
    }

    fn read(&self, cursor: &mut Cursor<'_>) -> Result<u32, Defect> {
        cursor.skip_separators();
        let at = cursor.at;
        let number = cursor.unsigned(Self::LINE)?;
        match u32::try_from(number) {
            Ok(number) if number >= 1 && number as usize <= self.limit => Ok(number - 1),
            _ => Err(Defect { at, kind: DefectKind::ExpectedIndex(self.limit) }),
        }
    }
}

/// Goes over an empty line or a comment; false if the line holds data.
#[inline]
pub(crate) fn skip_blank_or_comment(bytes: &[u8], cursor: &mut Cursor<'_>) -> bool {
    cursor.skip_separators();
    match bytes.get(cursor.at) {
        None => true,
        Some(b'\n' | b'*' | b'%' | b'#' | b'!') => {
            cursor.next_line();
            true
        }
        Some(_) => false,
    }
}
