//! Matrix entries as a file lists them, read in parallel.

use super::chunk::{Chunk, Order};
use super::line::{ReadIndex, skip_blank_or_comment};
use crate::import::text::cursor::{Cursor, Defect, DefectKind};

/// Files below this size are read by one thread: starting a thread costs about as much as reading this.
const PARALLEL_BYTES: usize = 1 << 20;

/// Bytes at the start that show how long the lines of a file are.
const SAMPLE_BYTES: usize = 4096;

/// Entries (row, column, value), indices from 0, in file order; not summed, not mirrored.
#[derive(Debug, Clone, Default)]
pub(crate) struct Entries {
    chunks: Vec<Chunk>,
}

impl Entries {
    /// Reads all lines from `start` to the end of `bytes`. Empty lines and lines that start with `*`, `%`, `#` or
    /// `!` are skipped.
    pub(crate) fn read<I: ReadIndex>(bytes: &[u8], start: usize, index: &I) -> Result<Self, Defect> {
        let pieces = match std::thread::available_parallelism() {
            Ok(threads) if bytes.len() - start > PARALLEL_BYTES => threads.get().min(8),
            _ => 1,
        };
        Self::read_pieces(bytes, start, index, pieces)
    }

    /// Reads the lines in so many pieces at once. The result, and the defect if there is one, are those of one
    /// piece: pieces end at line ends, are kept in file order, and the first one with a defect decides.
    fn read_pieces<I: ReadIndex>(
        bytes: &[u8],
        start: usize,
        index: &I,
        pieces: usize,
    ) -> Result<Self, Defect> {
        let bounds = line_bounds(bytes, start, pieces);
        let per_byte = entries_per_byte(&bytes[start..]);
        let room = |bytes: usize| (bytes as f64 * per_byte) as usize + 8;
        let read =
            |from: usize, to: usize, room: usize| Chunk::with_capacity(room).read(&bytes[..to], from, index);
        let chunks: Result<Vec<Chunk>, Defect> = std::thread::scope(|scope| {
            let workers: Vec<_> = bounds
                .windows(2)
                .skip(1)
                .map(|ends| (ends[0], ends[1]))
                .map(|(from, to)| (from, scope.spawn(move || read(from, to, room(to - from)))))
                .collect();
            // The first chunk has room for the others, which are appended to it in the end.
            let first = read(bounds[0], bounds[1], room(bytes.len() - start));
            let unread = |from| Err(Defect { at: from, kind: DefectKind::Expected("a readable piece") });
            let others = workers.into_iter().map(|(from, work)| work.join().unwrap_or_else(|_| unread(from)));
            std::iter::once(first).chain(others).collect()
        });
        Ok(Entries { chunks: chunks? })
    }

    /// Entries from three vectors of the same length.
    pub(crate) fn from_vectors(rows: Vec<u32>, columns: Vec<u32>, values: Vec<f64>) -> Self {
        Entries { chunks: vec![Chunk::from_vectors(rows, columns, values)] }
    }

    /// All entries in one piece.
    pub(crate) fn joined(self) -> Chunk {
        let order = self.order();
        let mut chunks = self.chunks.into_iter();
        let mut whole = chunks.next().unwrap_or_else(|| Chunk::with_capacity(0));
        for chunk in chunks {
            whole.rows.extend_from_slice(&chunk.rows);
            whole.columns.extend_from_slice(&chunk.columns);
            whole.values.extend_from_slice(&chunk.values);
        }
        whole.order = order;
        whole
    }

    /// The order of all entries.
    pub(crate) fn order(&self) -> Order {
        self.chunks.iter().fold(Order::default(), |order, chunk| match chunk.first() {
            Some(first) => order.followed_by(first, chunk.order),
            None => order,
        })
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
        self.order().extent
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
            chunk.renumber(map);
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

/// About how many entries a byte of the file holds; the first lines are rather shorter than the later ones.
fn entries_per_byte(bytes: &[u8]) -> f64 {
    let sample = &bytes[..bytes.len().min(SAMPLE_BYTES)];
    let lines = 1 + sample.iter().filter(|&&byte| byte == b'\n').count();
    // The shortest entry is `1 1 1` and a line end.
    (lines as f64 / sample.len().max(1) as f64).min(1.0 / 6.0)
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
    use super::super::line::RowNumber;
    use super::super::sparse_lines::SparseLines;
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

    const TEXT: &str = "* a comment\n1 1 2.0\r\n\n 2,1, -1.5e-3\n1 2 0.1\n% more\n1 2 0.2\n1 2 0.3\n3 3 7";

    /// Numbers of pieces whose ends fall within every token, on line ends, and several into one line.
    fn counts() -> impl Iterator<Item = usize> {
        (1..20).chain([TEXT.len() / 2, TEXT.len(), 2 * TEXT.len()])
    }

    fn pieces(text: &str, pieces: usize) -> Result<Entries, Defect> {
        Entries::read_pieces(text.as_bytes(), 0, &RowNumber { limit: 3 }, pieces)
    }

    #[test]
    fn pieces_that_end_anywhere_give_the_entries_of_one_piece() {
        let expected = [(0, 0, 2.0), (1, 0, -1.5e-3), (0, 1, 0.1), (0, 1, 0.2), (0, 1, 0.3), (2, 2, 7.0)];
        for count in counts() {
            for text in [TEXT.to_owned(), format!("{TEXT}\n"), TEXT.replace('\n', "\r\n")] {
                let entries = pieces(&text, count).unwrap();
                assert_eq!(entries.iter().collect::<Vec<_>>(), expected, "{count} pieces");
                assert_eq!(entries.order(), pieces(&text, 1).unwrap().order(), "{count} pieces");
                let whole = entries.joined();
                assert_eq!(whole.values, expected.map(|entry| entry.2), "{count} pieces");
                assert_eq!((whole.rows.len(), whole.columns.len()), (6, 6));
            }
        }
    }

    #[test]
    fn duplicates_in_different_pieces_are_summed_in_file_order() {
        // (0.1 + 0.2) + 0.3 and 0.1 + (0.2 + 0.3) differ in the last digit.
        let sum = |count| SparseLines::from_entries(pieces(TEXT, count).unwrap(), 3).values;
        assert!(sum(1).contains(&((0.1 + 0.2) + 0.3)), "{:?}", sum(1));
        for count in counts() {
            let (one, many) = (sum(1), sum(count));
            assert!(one.iter().zip(&many).all(|(a, b)| a.to_bits() == b.to_bits()), "{count}: {many:?}");
        }
    }

    #[test]
    fn the_first_of_several_defects_is_reported_whatever_the_pieces() {
        let late = TEXT.replace("3 3 7", "3 x 7");
        let at = late.find('x').unwrap();
        let both = late.replace("1 2 0.2", "1 4 0.2");
        let first = both.find("4 0.2").unwrap();
        for count in counts() {
            let defect = pieces(&late, count).unwrap_err();
            assert_eq!(defect, Defect { at, kind: DefectKind::Expected(RowNumber::LINE) }, "{count}");
            let defect = pieces(&both, count).unwrap_err();
            assert_eq!(defect, Defect { at: first, kind: DefectKind::ExpectedIndex(3) }, "{count}");
        }
    }

    #[test]
    fn the_first_defect_is_reported_at_its_offset() {
        let text = b"1 1 2.0\n1 0 1.0\n9 9 9\n";
        let defect = Entries::read(text, 0, &RowNumber { limit: 3 }).unwrap_err();
        assert_eq!(defect, Defect { at: 10, kind: DefectKind::ExpectedIndex(3) });
    }
}
