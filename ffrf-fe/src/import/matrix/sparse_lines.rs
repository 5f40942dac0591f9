//! Sorted entries of a square matrix in compressed lines: rows or columns, whichever the file lists.

use super::chunk::Chunk;
use super::entries::Entries;

/// Compressed lines with places ascending.
#[derive(Debug, Clone)]
pub(crate) struct SparseLines {
    /// What a line is.
    pub(crate) kind: LineKind,
    /// Where each line starts; one more than there are lines.
    pub(crate) starts: Vec<usize>,
    /// Place of each entry within its line.
    pub(crate) places: Vec<u32>,
    /// Value of each entry.
    pub(crate) values: Vec<f64>,
}

/// What a compressed line is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LineKind {
    /// SparseLines are rows, places are columns.
    Row,
    /// SparseLines are columns, places are rows.
    Column,
}

impl SparseLines {
    /// Sorts entries and sums duplicates in file order. Entries that come sorted are only taken over.
    pub(crate) fn from_entries(entries: Entries, size: usize) -> Self {
        let Chunk { rows, columns, values, order } = entries.joined();
        if order.by_rows {
            SparseLines {
                kind: LineKind::Row,
                starts: starts_of_sorted(&rows, size),
                places: columns,
                values,
            }
        } else if order.by_columns {
            let starts = starts_of_sorted(&columns, size);
            SparseLines { kind: LineKind::Column, starts, places: rows, values }
        } else {
            // Two counting passes: by column, then by row.
            let mut sorted = sort(&columns, size, |place| (rows[place], values[place])).transposed();
            sorted.sum_duplicates();
            sorted
        }
    }

    /// Number of lines.
    pub(crate) fn size(&self) -> usize {
        self.starts.len() - 1
    }

    /// Places and values of a line.
    #[inline]
    pub(crate) fn line(&self, line: usize) -> (&[u32], &[f64]) {
        let range = self.starts[line]..self.starts[line + 1];
        (&self.places[range.clone()], &self.values[range])
    }

    /// The same matrix with rows for columns and columns for rows; places come out ascending.
    pub(crate) fn transposed(&self) -> Self {
        let size = self.size();
        let mut starts = vec![0; size + 1];
        for &place in &self.places {
            starts[place as usize + 1] += 1;
        }
        accumulate(&mut starts);
        let mut next = starts.clone();
        let mut places = vec![0_u32; self.places.len()];
        let mut values = vec![0.0; self.places.len()];
        for line in 0..size {
            let (old_places, old_values) = self.line(line);
            for (&place, &value) in old_places.iter().zip(old_values) {
                let to = next[place as usize];
                next[place as usize] += 1;
                places[to] = line as u32;
                values[to] = value;
            }
        }
        let kind = match self.kind {
            LineKind::Row => LineKind::Column,
            LineKind::Column => LineKind::Row,
        };
        SparseLines { kind, starts, places, values }
    }

    fn sum_duplicates(&mut self) {
        let mut kept = 0;
        let mut begin = 0;
        for line in 0..self.size() {
            let end = self.starts[line + 1];
            let first = kept;
            for at in begin..end {
                if kept > first && self.places[kept - 1] == self.places[at] {
                    self.values[kept - 1] += self.values[at];
                } else {
                    self.places[kept] = self.places[at];
                    self.values[kept] = self.values[at];
                    kept += 1;
                }
            }
            begin = end;
            self.starts[line + 1] = kept;
        }
        self.places.truncate(kept);
        self.values.truncate(kept);
    }

    /// Diagonal entry, if stored.
    pub(crate) fn diagonal(&self, index: usize) -> Option<f64> {
        let (places, values) = self.line(index);
        places.binary_search(&(index as u32)).ok().map(|at| values[at])
    }

    /// Sets all entries of these rows and columns to zero.
    pub(crate) fn clear(&mut self, cleared: &[bool]) {
        if !cleared.contains(&true) {
            return;
        }
        for line in 0..self.size() {
            for at in self.starts[line]..self.starts[line + 1] {
                if cleared[line] || cleared[self.places[at] as usize] {
                    self.values[at] = 0.0;
                }
            }
        }
    }
}

/// Where each line starts in a list sorted by line.
fn starts_of_sorted(lines: &[u32], size: usize) -> Vec<usize> {
    let mut starts = Vec::with_capacity(size + 1);
    for (at, &line) in lines.iter().enumerate() {
        while starts.len() <= line as usize {
            starts.push(at);
        }
    }
    starts.resize(size + 1, lines.len());
    starts
}

/// Counting sort by line; `entry` is the place and the value of an entry.
fn sort(lines: &[u32], size: usize, entry: impl Fn(usize) -> (u32, f64)) -> SparseLines {
    let mut starts = vec![0; size + 1];
    for &line in lines {
        starts[line as usize + 1] += 1;
    }
    accumulate(&mut starts);
    let mut next = starts.clone();
    let mut places = vec![0_u32; lines.len()];
    let mut values = vec![0.0; lines.len()];
    for (at, &line) in lines.iter().enumerate() {
        let to = next[line as usize];
        next[line as usize] += 1;
        (places[to], values[to]) = entry(at);
    }
    SparseLines { kind: LineKind::Column, starts, places, values }
}

fn accumulate(counts: &mut [usize]) {
    let mut sum = 0;
    for count in counts {
        sum += *count;
        *count = sum;
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    pub(in crate::import) fn lines(triplets: &[(u32, u32, f64)], size: usize) -> SparseLines {
        let rows = triplets.iter().map(|entry| entry.0).collect();
        let columns = triplets.iter().map(|entry| entry.1).collect();
        let values = triplets.iter().map(|entry| entry.2).collect();
        SparseLines::from_entries(Entries::from_vectors(rows, columns, values), size)
    }

    fn triplets(lines: &SparseLines) -> Vec<(u32, u32, f64)> {
        let mut triplets = Vec::new();
        for line in 0..lines.size() {
            let (places, values) = lines.line(line);
            assert!(places.is_sorted_by(|a, b| a < b), "{places:?}");
            for (&place, &value) in places.iter().zip(values) {
                let line = line as u32;
                let (row, column) = if lines.kind == LineKind::Row { (line, place) } else { (place, line) };
                triplets.push((row, column, value));
            }
        }
        triplets.sort_by_key(|entry| (entry.0, entry.1));
        triplets
    }

    #[test]
    fn every_order_of_a_list_gives_the_same_lines() {
        // Row 2 and column 3 are empty.
        let sorted = [(0, 0, 1.0), (0, 2, 2.0), (1, 0, 3.0), (3, 1, 4.0), (3, 2, 5.0)];
        let by_rows = lines(&sorted, 5);
        assert_eq!((by_rows.kind, &by_rows.starts), (LineKind::Row, &vec![0, 2, 3, 3, 5, 5]));
        assert_eq!(triplets(&by_rows), sorted);
        assert_eq!(triplets(&by_rows.transposed()), sorted);
        let mut turned = sorted;
        turned.sort_by_key(|entry| (entry.1, entry.0));
        let by_columns = lines(&turned, 5);
        assert_eq!((by_columns.kind, &by_columns.starts), (LineKind::Column, &vec![0, 2, 3, 5, 5, 5]));
        assert_eq!(triplets(&by_columns), sorted);
        turned.swap(1, 3);
        let mixed = lines(&turned, 5);
        assert_eq!(triplets(&mixed), sorted);
        assert_eq!(lines(&[], 2).starts, [0, 0, 0]);
    }

    #[test]
    fn duplicates_are_summed_in_file_order() {
        // (1e16 + 1) - 1e16 is 0 in doubles, (1e16 - 1e16) + 1 is 1.
        let first = lines(&[(0, 1, 1e16), (0, 0, 7.0), (0, 1, 1.0), (0, 1, -1e16)], 2);
        assert_eq!(triplets(&first), [(0, 0, 7.0), (0, 1, 0.0)]);
        let second = lines(&[(0, 1, 1e16), (0, 1, -1e16), (0, 0, 7.0), (0, 1, 1.0)], 2);
        assert_eq!(triplets(&second), [(0, 0, 7.0), (0, 1, 1.0)]);
    }

    #[test]
    fn cleared_rows_and_columns_are_zero() {
        let mut matrix = lines(&[(0, 0, 1.0), (0, 1, 2.0), (1, 0, 2.0), (1, 1, 3.0)], 2);
        assert_eq!(matrix.diagonal(1), Some(3.0));
        matrix.clear(&[false, true]);
        assert_eq!(triplets(&matrix), [(0, 0, 1.0), (0, 1, 0.0), (1, 0, 0.0), (1, 1, 0.0)]);
    }
}
