//! Matrix entries as a file lists them, read in parallel.

use super::scan::{Cursor, Defect, DefectKind};

/// Files below this size are read by one thread: starting a thread costs about as much as reading this.
const PARALLEL_BYTES: usize = 1 << 20;

/// Entries (row, column, value), indices from 0, in file order; not summed, not mirrored.
#[derive(Debug, Clone, Default)]
pub(crate) struct Entries {
    chunks: Vec<Chunk>,
}

/// The entries of one piece of a file.
#[derive(Debug, Clone, Default)]
struct Chunk {
    rows: Vec<u32>,
    columns: Vec<u32>,
    values: Vec<f64>,
}

/// Reads one index of a line: a row number, or a node with its direction.
pub(crate) trait ReadIndex: Sync {
    /// What a line looks like, for messages.
    const LINE: &'static str;

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

    #[inline]
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

impl Entries {
    /// Reads all lines from `start` to the end of `bytes`. Empty lines and lines that start with `*`, `%`, `#` or
    /// `!` are skipped.
    pub(crate) fn read<I: ReadIndex>(bytes: &[u8], start: usize, index: &I) -> Result<Self, Defect> {
        let threads = match std::thread::available_parallelism() {
            Ok(threads) if bytes.len() - start > PARALLEL_BYTES => threads.get().min(8),
            _ => 1,
        };
        let bounds = line_bounds(bytes, start, threads);
        let chunks: Result<Vec<Chunk>, Defect> = if threads == 1 {
            bounds.windows(2).map(|ends| read_chunk(&bytes[..ends[1]], ends[0], index)).collect()
        } else {
            std::thread::scope(|scope| {
                let workers: Vec<_> = bounds
                    .windows(2)
                    .map(|ends| {
                        let (from, piece) = (ends[0], &bytes[..ends[1]]);
                        (from, scope.spawn(move || read_chunk(piece, from, index)))
                    })
                    .collect();
                let unread = |from| Err(Defect { at: from, kind: DefectKind::Expected("a readable piece") });
                workers.into_iter().map(|(from, work)| work.join().unwrap_or_else(|_| unread(from))).collect()
            })
        };
        Ok(Entries { chunks: chunks? })
    }

    /// Entries from three vectors of the same length.
    pub(crate) fn from_vectors(rows: Vec<u32>, columns: Vec<u32>, values: Vec<f64>) -> Self {
        Entries { chunks: vec![Chunk { rows, columns, values }] }
    }

    pub(crate) fn len(&self) -> usize {
        self.chunks.iter().map(|chunk| chunk.values.len()).sum()
    }

    /// All (row, column, value) in file order.
    #[inline]
    pub(crate) fn iter(&self) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
        self.chunks.iter().flat_map(|chunk| {
            let indices = chunk.rows.iter().zip(&chunk.columns);
            indices.zip(&chunk.values).map(|((&row, &column), &value)| (row as usize, column as usize, value))
        })
    }

    /// One more than the largest index; 0 without entries.
    pub(crate) fn extent(&self) -> usize {
        self.iter().map(|(row, column, _)| row.max(column) + 1).max().unwrap_or(0)
    }

    /// Which of the first `size` indices occur as a row or column.
    pub(crate) fn present(&self, size: usize) -> Vec<bool> {
        let mut present = vec![false; size];
        for (row, column, _) in self.iter() {
            for index in [row, column] {
                if let Some(flag) = present.get_mut(index) {
                    *flag = true;
                }
            }
        }
        present
    }

    /// Replaces every index `i` by `map[i]`; every index must be below the map's length.
    pub(crate) fn renumber(&mut self, map: &[u32]) {
        for chunk in &mut self.chunks {
            for index in chunk.rows.iter_mut().chain(&mut chunk.columns) {
                *index = map[*index as usize];
            }
        }
    }
}

/// Splits `bytes[start..]` at line ends into about equal pieces.
fn line_bounds(bytes: &[u8], start: usize, pieces: usize) -> Vec<usize> {
    let length = bytes.len() - start;
    let mut bounds = vec![start];
    for piece in 1..pieces {
        let mut cursor = Cursor::new(bytes, start + length / pieces * piece);
        cursor.next_line();
        bounds.push(cursor.at);
    }
    bounds.push(bytes.len());
    bounds
}

fn read_chunk<I: ReadIndex>(bytes: &[u8], start: usize, index: &I) -> Result<Chunk, Defect> {
    // An entry takes 12 bytes at least in practice; a wrong guess costs one reallocation.
    let guess = (bytes.len() - start) / 20;
    let mut chunk = Chunk {
        rows: Vec::with_capacity(guess),
        columns: Vec::with_capacity(guess),
        values: Vec::with_capacity(guess),
    };
    let mut cursor = Cursor::new(bytes, start);
    while cursor.at < bytes.len() {
        if skip_blank_or_comment(bytes, &mut cursor) {
            continue;
        }
        let row = index.read(&mut cursor)?;
        let column = index.read(&mut cursor)?;
        let value = cursor.float(I::LINE)?;
        cursor.end_line(I::LINE)?;
        chunk.rows.push(row);
        chunk.columns.push(column);
        chunk.values.push(value);
    }
    Ok(chunk)
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

/// Byte offset of data line number `wanted` (from 0) after `start`.
pub(crate) fn offset_of_data_line(bytes: &[u8], start: usize, wanted: usize) -> usize {
    let mut cursor = Cursor::new(bytes, start);
    let mut seen = 0;
    while cursor.at < bytes.len() {
        if skip_blank_or_comment(bytes, &mut cursor) {
            continue;
        }
        if seen == wanted {
            return cursor.at;
        }
        seen += 1;
        cursor.next_line();
    }
    bytes.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_threads_read_what_one_reads() {
        let mut text = String::from("* a comment\n\n");
        let mut expected = Vec::new();
        for k in 0..120_000_usize {
            let (row, column, value) = (k % 977, k % 31, k as f64 * 0.37 - 5.0);
            text += &format!("{} {}  {value:e}\n", row + 1, column + 1);
            expected.push((row, column, value));
        }
        assert!(text.len() > PARALLEL_BYTES);
        let entries = Entries::read(text.as_bytes(), 0, &RowNumber { limit: 977 }).unwrap();
        assert_eq!(entries.iter().collect::<Vec<_>>(), expected);
        assert_eq!(entries.extent(), 977);
    }

    #[test]
    fn the_first_defect_is_reported_at_its_offset() {
        let text = b"1 1 2.0\n1 0 1.0\n9 9 9\n";
        let defect = Entries::read(text, 0, &RowNumber { limit: 3 }).unwrap_err();
        assert_eq!(defect, Defect { at: 10, kind: DefectKind::ExpectedIndex(3) });
    }
}
