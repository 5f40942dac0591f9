//! The entries of one piece of a file, and their order.

use super::line::{ReadIndex, skip_blank_or_comment};
use crate::import::text::cursor::{Cursor, Defect};
use crate::import::text::ordinary;

/// Entries in file order, indices from 0.
#[derive(Debug, Clone)]
pub(crate) struct Chunk {
    pub(crate) rows: Vec<u32>,
    pub(crate) columns: Vec<u32>,
    pub(crate) values: Vec<f64>,
    pub(crate) order: Order,
}

/// What is known of the order and the extent of a list of entries.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Order {
    /// Strictly ascending by row, then by column: sorted and without duplicates.
    pub(crate) by_rows: bool,
    /// Strictly ascending by column, then by row.
    pub(crate) by_columns: bool,
    /// Some entry lies below the diagonal.
    pub(crate) below: bool,
    /// Some entry lies above the diagonal.
    pub(crate) above: bool,
    /// One more than the largest index; 0 without entries.
    pub(crate) extent: usize,
    /// Least position that the next entry may have in either order.
    next: [u64; 2],
}

impl Default for Order {
    /// The order of no entries.
    fn default() -> Self {
        Order { by_rows: true, by_columns: true, below: false, above: false, extent: 0, next: [0; 2] }
    }
}

impl Order {
    /// Takes note of the next entry.
    #[inline]
    pub(crate) fn note(&mut self, row: u32, column: u32) {
        let (by_rows, by_columns) = (position(row, column), position(column, row));
        self.by_rows &= by_rows >= self.next[0];
        self.by_columns &= by_columns >= self.next[1];
        self.next = [by_rows + 1, by_columns + 1];
        self.below |= row > column;
        self.above |= row < column;
        self.extent = self.extent.max(row.max(column) as usize + 1);
    }

    /// The order of these entries followed by others, of which the first is at `first`.
    pub(crate) fn followed_by(self, first: (u32, u32), rest: Order) -> Order {
        let mut joint = self;
        joint.note(first.0, first.1);
        Order {
            by_rows: joint.by_rows && rest.by_rows,
            by_columns: joint.by_columns && rest.by_columns,
            below: joint.below || rest.below,
            above: joint.above || rest.above,
            extent: joint.extent.max(rest.extent),
            next: rest.next,
        }
    }
}

/// Compares as (major, minor) does; indices are below 2^32 - 1.
#[inline]
fn position(major: u32, minor: u32) -> u64 {
    u64::from(major) << 32 | u64::from(minor)
}

impl Chunk {
    /// An empty chunk with room for `entries`.
    pub(crate) fn with_capacity(entries: usize) -> Self {
        Chunk {
            rows: Vec::with_capacity(entries),
            columns: Vec::with_capacity(entries),
            values: Vec::with_capacity(entries),
            order: Order::default(),
        }
    }

    /// Entries from three vectors of the same length.
    pub(crate) fn from_vectors(rows: Vec<u32>, columns: Vec<u32>, values: Vec<f64>) -> Self {
        let mut chunk = Chunk { rows, columns, values, order: Order::default() };
        chunk.find_order();
        chunk
    }

    /// Reads the lines of `bytes` from `start` on.
    pub(crate) fn read<I: ReadIndex>(
        mut self,
        bytes: &[u8],
        start: usize,
        index: &I,
    ) -> Result<Self, Defect> {
        let mut at = start;
        while at < bytes.len() {
            let (row, column, value, next) = match short_line(bytes, at, index) {
                Some(line) => line,
                None => {
                    let mut cursor = Cursor::new(bytes, at);
                    let line = any_line(bytes, &mut cursor, index)?;
                    at = cursor.at;
                    let Some((row, column, value)) = line else { continue };
                    (row, column, value, at)
                }
            };
            at = next;
            self.rows.push(row);
            self.columns.push(column);
            self.values.push(value);
        }
        self.find_order();
        Ok(self)
    }

    /// Replaces every index `i` by `map[i]`; every index must be below the map's length.
    pub(crate) fn renumber(&mut self, map: &[u32]) {
        for index in self.rows.iter_mut().chain(&mut self.columns) {
            *index = map[*index as usize];
        }
        self.find_order();
    }

    fn find_order(&mut self) {
        let mut order = Order::default();
        for (&row, &column) in self.rows.iter().zip(&self.columns) {
            order.note(row, column);
        }
        self.order = order;
    }

    /// Row and column of the first entry.
    pub(crate) fn first(&self) -> Option<(u32, u32)> {
        Some((*self.rows.first()?, *self.columns.first()?))
    }
}

/// Row, column and value of a line that is written as usual, and the offset of the next line.
#[inline(always)]
fn short_line<I: ReadIndex>(bytes: &[u8], at: usize, index: &I) -> Option<(u32, u32, f64, usize)> {
    let (row, at) = index.read_short(bytes, ordinary::token(bytes, at)?)?;
    let (column, at) = index.read_short(bytes, at)?;
    let (value, at) = ordinary::last_float(bytes, at)?;
    Some((row, column, value, at))
}

/// Row, column and value of any line, `None` for an empty one or a comment; goes to the next line.
#[cold]
#[inline(never)]
fn any_line<I: ReadIndex>(
    bytes: &[u8],
    cursor: &mut Cursor<'_>,
    index: &I,
) -> Result<Option<(u32, u32, f64)>, Defect> {
    if skip_blank_or_comment(bytes, cursor) {
        return Ok(None);
    }
    let row = index.read(cursor)?;
    let column = index.read(cursor)?;
    let value = cursor.float(I::LINE)?;
    cursor.end_line(I::LINE)?;
    Ok(Some((row, column, value)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order(places: &[(u32, u32)]) -> Order {
        let (rows, columns) = places.iter().copied().unzip();
        Chunk::from_vectors(rows, columns, vec![1.0; places.len()]).order
    }

    #[test]
    fn order_is_seen() {
        let rows = order(&[(0, 0), (0, 2), (1, 0), (1, 1), (4, 0)]);
        assert!(rows.by_rows && !rows.by_columns && rows.below && rows.above);
        assert_eq!(rows.extent, 5);
        let columns = order(&[(0, 0), (2, 0), (1, 1), (2, 1), (4, 3)]);
        assert!(!columns.by_rows && columns.by_columns && columns.below && !columns.above);
        let twice = order(&[(0, 0), (0, 0), (0, 1)]);
        assert!(!twice.by_rows && !twice.by_columns && !twice.below && twice.above);
        let none = order(&[]);
        assert!(none.by_rows && none.by_columns && none.extent == 0);
    }

    #[test]
    fn the_order_of_a_whole_is_that_of_its_parts_and_of_the_seam() {
        for (first, second) in [
            (vec![(0, 0), (0, 1)], vec![(0, 2), (1, 0)]),
            (vec![(0, 0), (0, 1)], vec![(0, 1), (1, 0)]),
            (vec![(0, 0), (1, 0)], vec![(2, 0), (1, 1)]),
            (vec![(3, 3)], vec![(2, 2)]),
            (vec![], vec![(2, 1), (7, 2)]),
        ] {
            let joint = order(&first).followed_by(second[0], order(&second));
            assert_eq!(joint, order(&[first, second].concat()));
        }
    }
}
