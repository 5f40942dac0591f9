//! A matrix that is expanded in the modal coordinates: M(q) = M0 + q_l M1_l.

use crate::import::ImportError;
use crate::import::text::source::Source;

/// Entries of M0 or M1 as they are listed, with the place of each.
#[derive(Debug, Clone)]
pub(super) struct Entry<const K: usize> {
    /// Indices from 1, as in the file.
    pub index: [usize; K],
    pub value: f64,
    pub at: usize,
}

/// One matrix of a file.
#[derive(Debug, Clone)]
pub(super) struct Taylor {
    /// What the matrix is called, for messages.
    pub name: &'static str,
    /// Where its block starts.
    pub at: usize,
    pub order: usize,
    pub rows: usize,
    pub columns: usize,
    /// 0 zero, 1 diagonal, 2 symmetric, 3 any, 4 unit matrix.
    pub structure: usize,
    pub zeroth: Vec<Entry<2>>,
    pub first: Vec<Entry<3>>,
}

/// Which index of `m1(., ., .)` counts the modes. The definition says the second; some writers put it last.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ModeIndex {
    Second,
    Third,
}

impl Taylor {
    /// Whether an expansion of first order is given. Not so if it is announced and all of it is zero.
    pub fn has_first(&self) -> bool {
        self.order > 0 && self.first.iter().any(|entry| entry.value != 0.0)
    }

    /// Refuses another size, before anything of this size is allocated.
    pub fn expect_size(&self, source: &Source, rows: usize, columns: usize) -> Result<(), ImportError> {
        if (self.rows, self.columns) == (rows, columns) {
            return Ok(());
        }
        let Self { name, rows: found_rows, columns: found_columns, .. } = self;
        Err(source.expected(
            self.at,
            format!("`{name}` of {rows} rows and {columns} columns, found {found_rows} and {found_columns}"),
        ))
    }

    /// M0, row by row.
    pub fn zeroth(&self, source: &Source) -> Result<Vec<f64>, ImportError> {
        let mut matrix = vec![0.0; self.rows * self.columns];
        if self.structure == 4 {
            for k in 0..self.rows.min(self.columns) {
                matrix[k * self.columns + k] = 1.0;
            }
        }
        for Entry { index: [row, column], value, at } in &self.zeroth {
            let (name, rows, columns) = (self.name, self.rows, self.columns);
            if !(1..=rows).contains(row) || !(1..=columns).contains(column) {
                return Err(source.expected(*at, format!("m0 of `{name}` within {rows} x {columns}")));
            }
            matrix[(row - 1) * columns + column - 1] = *value;
            if self.structure == 2 && *column <= rows && *row <= columns {
                matrix[(column - 1) * columns + row - 1] = *value;
            }
        }
        Ok(matrix)
    }

    /// M1, at [mode][row][column] in one list; zero if the expansion is of order zero.
    pub fn first(&self, modes: usize, index: ModeIndex) -> Vec<f64> {
        let mut matrices = vec![0.0; modes * self.rows * self.columns];
        if self.order == 0 {
            return matrices;
        }
        for entry in &self.first {
            let (row, mode, column) = entry.place(index);
            let mut set = |row: usize, column: usize| {
                let place = ((mode - 1) * self.rows + row - 1) * self.columns + column - 1;
                if let Some(slot) = matrices.get_mut(place) {
                    *slot = entry.value;
                }
            };
            set(row, column);
            if self.structure == 2 && column <= self.rows && row <= self.columns {
                set(column, row);
            }
        }
        matrices
    }

    /// Whether every index of M1 is within the matrix.
    fn misplaced(&self, modes: usize, index: ModeIndex) -> Option<&Entry<3>> {
        self.first.iter().find(|entry| {
            let (row, mode, column) = entry.place(index);
            let within = (1..=self.rows).contains(&row)
                && (1..=modes).contains(&mode)
                && (1..=self.columns).contains(&column);
            !within
        })
    }
}

impl Entry<3> {
    /// Row, mode, column.
    fn place(&self, index: ModeIndex) -> (usize, usize, usize) {
        let [row, second, third] = self.index;
        match index {
            ModeIndex::Second => (row, second, third),
            ModeIndex::Third => (row, third, second),
        }
    }
}

/// Finds which index counts the modes: the second, unless an index would then be too large.
///
/// Errors: an index that is too large in either reading.
pub(super) fn mode_index<'a>(
    source: &Source,
    matrices: impl Iterator<Item = &'a Taylor> + Clone,
    modes: usize,
) -> Result<ModeIndex, ImportError> {
    let misplaced = |index: ModeIndex| {
        let mut all = matrices.clone();
        all.find_map(|matrix| matrix.misplaced(modes, index).map(|entry| (matrix, entry)))
    };
    let Some((matrix, entry)) = misplaced(ModeIndex::Second) else { return Ok(ModeIndex::Second) };
    if misplaced(ModeIndex::Third).is_none() {
        return Ok(ModeIndex::Third);
    }
    let Taylor { name, rows, columns, .. } = matrix;
    Err(source.expected(
        entry.at,
        format!("m1(row, mode, column) of `{name}` within {rows} rows, {modes} modes, {columns} columns"),
    ))
}
