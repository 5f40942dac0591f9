//! From listed entries to a symmetric sparse matrix: duplicates summed, the missing triangle mirrored once.

use std::path::Path;

use faer::sparse::{SparseColMat, SymbolicSparseColMat};

use super::raw_matrix::Storage;
use super::sparse_lines::{LineKind, SparseLines};
use super::triangles::{self, Agreement};
use crate::SparseMatrix;
use crate::import::ImportError;
use crate::tolerances::SYMMETRY_TOLERANCE;

impl SparseLines {
    /// The symmetric matrix with both triangles, or the worst asymmetry.
    pub(crate) fn symmetric(self, storage: Storage, path: &Path) -> Result<SparseMatrix, ImportError> {
        let (before, behind) = triangles::sides(&self);
        let one_sided = !(before && behind);
        if one_sided && storage != Storage::Full {
            return Ok(matrix(triangles::without_zeros(triangles::expand(&self))));
        }
        if storage != Storage::OneTriangle
            && let Some(Agreement { deviation }) = triangles::compare(&self)
        {
            if deviation == 0.0 {
                return Ok(matrix(triangles::without_zeros(self)));
            }
            if deviation <= SYMMETRY_TOLERANCE * self.largest() {
                return Ok(matrix(triangles::without_zeros(triangles::average(self))));
            }
        }
        self.united(storage, path)
    }

    /// Largest magnitude of an entry.
    fn largest(&self) -> f64 {
        self.values.iter().fold(0.0_f64, |most, value| most.max(value.abs()))
    }

    /// The same for any pattern: unites each column with the row of the same number.
    fn united(self, storage: Storage, path: &Path) -> Result<SparseMatrix, ImportError> {
        let (columns, mirrored) = match self.kind {
            LineKind::Column => {
                let mirrored = self.transposed();
                (self, mirrored)
            }
            LineKind::Row => (self.transposed(), self),
        };
        let one_triangle = match storage {
            Storage::Full => false,
            Storage::OneTriangle => true,
            Storage::Undeclared => !columns.has_mirrored_pair(&mirrored),
        };
        let largest = columns.largest();
        let mut worst = (0.0, 0, 0, 0.0, 0.0);
        let mut starts = Vec::with_capacity(columns.size() + 1);
        let reserve = columns.values.len() * if one_triangle { 2 } else { 1 };
        let mut rows: Vec<usize> = Vec::with_capacity(reserve);
        let mut values: Vec<f64> = Vec::with_capacity(reserve);
        starts.push(0);
        for column in 0..columns.size() {
            for (row, here, there) in Union::new(columns.line(column), mirrored.line(column)) {
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
            return Err(ImportError::Asymmetric {
                path: path.to_path_buf(),
                row: row + 1,
                column: column + 1,
                value,
                mirrored,
                deviation: deviation / largest,
                tolerance: SYMMETRY_TOLERANCE,
            });
        }
        Ok(sparse(columns.size(), starts, rows, values))
    }

    /// True if some off-diagonal entry and its mirror image are both stored.
    fn has_mirrored_pair(&self, mirrored: &SparseLines) -> bool {
        (0..self.size()).any(|column| {
            let (mut here, mut there) = (self.line(column).0, mirrored.line(column).0);
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

fn matrix(lines: SparseLines) -> SparseMatrix {
    let places = lines.places.iter().map(|&place| place as usize).collect();
    sparse(lines.size(), lines.starts, places, lines.values)
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
    use super::super::entries::Entries;
    use super::*;

    fn columns(triplets: &[(u32, u32, f64)], size: usize) -> SparseLines {
        let entries = Entries::from_vectors(
            triplets.iter().map(|entry| entry.0).collect(),
            triplets.iter().map(|entry| entry.1).collect(),
            triplets.iter().map(|entry| entry.2).collect(),
        );
        SparseLines::from_entries(entries, size)
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

    /// The general way and the short ways must give the same bits, in every order of the list.
    #[test]
    fn the_short_ways_agree_with_the_general_one() {
        let path = Path::new("k.mtx");
        let size = 7_u32;
        let value = |i: u32, j: u32| f64::from((i.min(j) * 31 + i.max(j) * 17) % 11) / 7.0 - 0.5;
        let noise = |i: u32, j: u32| if i < j { 1.0 + 1e-13 } else { 1.0 };
        let stored = |i: u32, j: u32| i == j || (i + j) % 3 == 1;
        let places: Vec<_> =
            (0..size).flat_map(|i| (0..size).map(move |j| (i, j))).filter(|&(i, j)| stored(i, j)).collect();
        for (noisy, keep, storage) in [
            (false, (true, true), Storage::Full),
            (true, (true, true), Storage::Full),
            (true, (true, true), Storage::Undeclared),
            (false, (true, false), Storage::OneTriangle),
            (false, (false, true), Storage::OneTriangle),
            (false, (true, false), Storage::Undeclared),
        ] {
            let mut list: Vec<_> = places
                .iter()
                .filter(|&&(i, j)| i == j || if i > j { keep.0 } else { keep.1 })
                .map(|&(i, j)| (i, j, value(i, j) * if noisy { noise(i, j) } else { 1.0 }))
                .collect();
            let general = columns(&list, size as usize).united(storage, path).unwrap();
            for turn in 0..3 {
                match turn {
                    0 => {}
                    1 => list.sort_by_key(|entry| (entry.1, entry.0)),
                    _ => list.rotate_left(5),
                }
                let short = columns(&list, size as usize).symmetric(storage, path).unwrap();
                assert_eq!(short.col_ptr(), general.col_ptr());
                assert_eq!(short.row_idx(), general.row_idx());
                let bits =
                    |matrix: &SparseMatrix| matrix.val().iter().map(|v| v.to_bits()).collect::<Vec<_>>();
                assert_eq!(bits(&short), bits(&general));
            }
        }
    }
}
