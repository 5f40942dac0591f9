//! From listed entries to a symmetric sparse matrix: duplicates summed, the missing triangle mirrored once.

use std::path::Path;

use faer::sparse::{SparseColMat, SymbolicSparseColMat};

use super::entries::Entries;
use super::raw_matrix::Storage;
use crate::{FeError, SparseMatrix};

/// Largest difference of mirrored entries, relative to the largest entry of the matrix. FE codes print 14 to 17
/// digits, so mirrored entries agree to 1e-13; a wrong entry differs by far more.
pub(crate) const SYMMETRY_TOLERANCE: f64 = 1e-9;

/// Compressed columns with rows ascending.
#[derive(Debug, Clone)]
pub(crate) struct Columns {
    starts: Vec<usize>,
    rows: Vec<u32>,
    values: Vec<f64>,
}

impl Columns {
    /// Sorts entries by two counting passes and sums duplicates in file order.
    pub(crate) fn from_entries(entries: &Entries, size: usize) -> Self {
        let mut starts = vec![0; size + 1];
        for (row, _, _) in entries.iter() {
            starts[row + 1] += 1;
        }
        accumulate(&mut starts);
        let mut next = starts.clone();
        let mut rows = vec![0_u32; entries.len()];
        let mut values = vec![0.0; entries.len()];
        for (row, column, value) in entries.iter() {
            let place = next[row];
            next[row] += 1;
            // `column` came from a u32.
            rows[place] = column as u32;
            values[place] = value;
        }
        let mut sorted = Columns { starts, rows, values }.transpose();
        sorted.sum_duplicates();
        sorted
    }

    fn size(&self) -> usize {
        self.starts.len() - 1
    }

    /// Rows and values of a column.
    fn column(&self, column: usize) -> (&[u32], &[f64]) {
        let range = self.starts[column]..self.starts[column + 1];
        (&self.rows[range.clone()], &self.values[range])
    }

    /// The transposed matrix; its rows come out ascending.
    fn transpose(&self) -> Self {
        let size = self.size();
        let mut starts = vec![0; size + 1];
        for &row in &self.rows {
            starts[row as usize + 1] += 1;
        }
        accumulate(&mut starts);
        let mut next = starts.clone();
        let mut rows = vec![0_u32; self.rows.len()];
        let mut values = vec![0.0; self.rows.len()];
        for column in 0..size {
            let (old_rows, old_values) = self.column(column);
            for (&row, &value) in old_rows.iter().zip(old_values) {
                let place = next[row as usize];
                next[row as usize] += 1;
                rows[place] = column as u32;
                values[place] = value;
            }
        }
        Columns { starts, rows, values }
    }

    fn sum_duplicates(&mut self) {
        let mut kept = 0;
        let mut begin = 0;
        for column in 0..self.size() {
            let end = self.starts[column + 1];
            let first = kept;
            for place in begin..end {
                if kept > first && self.rows[kept - 1] == self.rows[place] {
                    self.values[kept - 1] += self.values[place];
                } else {
                    self.rows[kept] = self.rows[place];
                    self.values[kept] = self.values[place];
                    kept += 1;
                }
            }
            begin = end;
            self.starts[column + 1] = kept;
        }
        self.rows.truncate(kept);
        self.values.truncate(kept);
    }

    /// Diagonal entry, if stored.
    pub(crate) fn diagonal(&self, index: usize) -> Option<f64> {
        let (rows, values) = self.column(index);
        rows.binary_search(&(index as u32)).ok().map(|place| values[place])
    }

    /// Sets all entries of these rows and columns to zero.
    pub(crate) fn clear(&mut self, cleared: &[bool]) {
        for column in 0..self.size() {
            for place in self.starts[column]..self.starts[column + 1] {
                if cleared[column] || cleared[self.rows[place] as usize] {
                    self.values[place] = 0.0;
                }
            }
        }
    }

    /// The symmetric matrix with both triangles, or the worst asymmetry.
    pub(crate) fn symmetric(&self, storage: Storage, path: &Path) -> Result<SparseMatrix, FeError> {
        let mirrored = self.transpose();
        let one_triangle = match storage {
            Storage::Full => false,
            Storage::OneTriangle => true,
            Storage::Undeclared => !self.has_mirrored_pair(&mirrored),
        };
        let largest = self.values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let mut worst = (0.0, 0, 0, 0.0, 0.0);
        let mut starts = Vec::with_capacity(self.size() + 1);
        let reserve = self.values.len() * if one_triangle { 2 } else { 1 };
        let mut rows: Vec<usize> = Vec::with_capacity(reserve);
        let mut values: Vec<f64> = Vec::with_capacity(reserve);
        starts.push(0);
        for column in 0..self.size() {
            for (row, here, there) in Union::new(self.column(column), mirrored.column(column)) {
                let value = if one_triangle {
                    if row == column { here } else { here + there }
                } else {
                    let deviation = (here - there).abs();
                    if deviation > worst.0 {
                        worst = (deviation, row, column, here, there);
                    }
                    0.5 * (here + there)
                };
                if value != 0.0 || row == column {
                    rows.push(row);
                    values.push(value);
                }
            }
            starts.push(rows.len());
        }
        let (deviation, row, column, value, mirrored) = worst;
        if deviation > SYMMETRY_TOLERANCE * largest {
            return Err(FeError::Asymmetric {
                path: path.to_path_buf(),
                row: row + 1,
                column: column + 1,
                value,
                mirrored,
                deviation: deviation / largest,
                tolerance: SYMMETRY_TOLERANCE,
            });
        }
        Ok(sparse(self.size(), starts, rows, values))
    }

    /// True if some off-diagonal entry and its mirror image are both stored.
    fn has_mirrored_pair(&self, mirrored: &Columns) -> bool {
        (0..self.size()).any(|column| {
            let (mut here, mut there) = (self.column(column).0, mirrored.column(column).0);
            while let (Some((&a, rest_here)), Some((&b, rest_there))) =
                (here.split_first(), there.split_first())
            {
                if a == b && a as usize != column {
                    return true;
                }
                if a <= b {
                    here = rest_here;
                }
                if b <= a {
                    there = rest_there;
                }
            }
            false
        })
    }
}

/// A faer matrix from compressed columns with ascending rows.
pub(crate) fn sparse(size: usize, starts: Vec<usize>, rows: Vec<usize>, values: Vec<f64>) -> SparseMatrix {
    SparseColMat::new(SymbolicSparseColMat::new_checked(size, size, starts, None, rows), values)
}

fn accumulate(counts: &mut [usize]) {
    let mut sum = 0;
    for count in counts {
        sum += *count;
        *count = sum;
    }
}

/// Walks two sorted columns and yields (row, value in the first, value in the second).
struct Union<'a> {
    here: (&'a [u32], &'a [f64]),
    there: (&'a [u32], &'a [f64]),
}

impl<'a> Union<'a> {
    fn new(here: (&'a [u32], &'a [f64]), there: (&'a [u32], &'a [f64])) -> Self {
        Union { here, there }
    }
}

impl Iterator for Union<'_> {
    type Item = (usize, f64, f64);

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        let row = match (self.here.0.first(), self.there.0.first()) {
            (Some(&a), Some(&b)) => a.min(b),
            (Some(&a), None) => a,
            (None, Some(&b)) => b,
            (None, None) => return None,
        };
        let take = |side: &mut (&[u32], &[f64])| match (side.0.first(), side.1.first()) {
            (Some(&first), Some(&value)) if first == row => {
                side.0 = &side.0[1..];
                side.1 = &side.1[1..];
                value
            }
            _ => 0.0,
        };
        let here = take(&mut self.here);
        let there = take(&mut self.there);
        Some((row as usize, here, there))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn columns(triplets: &[(u32, u32, f64)], size: usize) -> Columns {
        let entries = Entries::from_vectors(
            triplets.iter().map(|entry| entry.0).collect(),
            triplets.iter().map(|entry| entry.1).collect(),
            triplets.iter().map(|entry| entry.2).collect(),
        );
        Columns::from_entries(&entries, size)
    }

    fn dense(matrix: &SparseMatrix) -> Vec<Vec<f64>> {
        let dense = matrix.to_dense();
        (0..dense.nrows())
            .map(|row| (0..dense.ncols()).map(|column| dense[(row, column)]).collect())
            .collect()
    }

    const WANTED: [[f64; 3]; 3] = [[4.0, -1.0, 0.5], [-1.0, 3.0, 0.0], [0.5, 0.0, 2.0]];

    #[test]
    fn each_storage_expands_once() {
        let path = Path::new("k.mtx");
        let lower = [(0, 0, 4.0), (1, 0, -1.0), (2, 0, 0.25), (1, 1, 3.0), (2, 2, 2.0), (2, 0, 0.25)];
        let mixed = [(0, 1, -1.0), (2, 2, 2.0), (2, 0, 0.5), (1, 1, 3.0), (0, 0, 4.0)];
        let both =
            [(2, 0, 0.5), (0, 0, 4.0), (0, 1, -1.0), (1, 0, -1.0), (1, 1, 3.0), (0, 2, 0.5), (2, 2, 2.0)];
        for storage in [Storage::OneTriangle, Storage::Undeclared] {
            assert_eq!(dense(&columns(&lower, 3).symmetric(storage, path).unwrap()), WANTED);
            assert_eq!(dense(&columns(&mixed, 3).symmetric(storage, path).unwrap()), WANTED);
        }
        for storage in [Storage::Full, Storage::Undeclared] {
            assert_eq!(dense(&columns(&both, 3).symmetric(storage, path).unwrap()), WANTED);
        }
    }

    #[test]
    fn asymmetry_is_refused_with_its_place_and_size() {
        let entries = [(0, 0, 4.0), (0, 1, -1.0), (1, 0, -1.5), (1, 1, 3.0)];
        let error = columns(&entries, 2).symmetric(Storage::Undeclared, Path::new("k.mtx")).unwrap_err();
        let text = error.to_string();
        for part in ["k.mtx", "(2, 1)", "-1.5e0", "-1e0", "1.250e-1"] {
            assert!(text.contains(part), "{text} lacks {part}");
        }
        let lower_only = [(0, 0, 4.0), (1, 0, -1.5), (1, 1, 3.0)];
        assert!(columns(&lower_only, 2).symmetric(Storage::Full, Path::new("k.mtx")).is_err());
    }
}
