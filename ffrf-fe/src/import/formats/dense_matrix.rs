//! Dense matrices: mode shapes of the user's own and modal stiffness.

use std::path::Path;

use faer::Mat;

use super::matrix_file::read_dense;
use crate::import::matrix::raw_matrix::{Dense, ShapeCheck};
use crate::import::text::source::Source;
use crate::import::{INFLATED_LIMIT, ImportError};
use crate::tolerances::SYMMETRY_TOLERANCE;

/// Values of mode shapes up to which they are read: 4 GB.
const DENSE_VALUES: usize = 1 << 29;

/// Reads mode shapes Ψ from text, Matrix Market (array or coordinate) or NumPy.
///
/// Shape: 3N x M, rows x, y, z node by node. Units: as normalised by the user (1/√kg for mass-normalised modes).
/// Source: `docs/theory/README.md`, notation.
///
/// # Errors
/// A file that does not follow its format, has another number of rows, or more modes than rows.
pub fn read_mode_shapes(path: &Path, node_count: usize) -> Result<Mat<f64>, ImportError> {
    let rows = 3 * node_count;
    let check = |found: usize, columns: usize| {
        if found != rows {
            let expected = format!("{rows} rows (x, y, z of {node_count} nodes)");
            return Err(mismatch(path, expected, found, "rows"));
        }
        if columns == 0 {
            return Err(mismatch(path, "at least one mode".to_owned(), 0, "columns"));
        }
        if columns > rows {
            let expected = format!("at most {rows} modes, as many as degrees of freedom");
            return Err(mismatch(path, expected, columns, "columns"));
        }
        if rows.saturating_mul(columns) > DENSE_VALUES {
            let expected =
                format!("at most {} modes of {rows} rows ({DENSE_VALUES} values)", DENSE_VALUES / rows);
            return Err(mismatch(path, expected, columns, "columns"));
        }
        Ok(())
    };
    read(path, &check)
}

/// Reads a symmetric matrix of given size, such as the modal stiffness K_ff, from text, Matrix Market or NumPy.
///
/// Shape: size x size. Units: N/m over the square of the modes' unit.
///
/// # Errors
/// A file that does not follow its format, another size, or an asymmetric matrix.
pub fn read_square_matrix(path: &Path, size: usize) -> Result<Mat<f64>, ImportError> {
    let check = |rows: usize, columns: usize| {
        if rows != columns {
            return Err(ImportError::NotSquare { path: path.to_path_buf(), rows, columns });
        }
        if rows != size {
            return Err(mismatch(path, format!("{size} rows and columns"), rows, "rows"));
        }
        Ok(())
    };
    let matrix = read(path, &check)?;
    let largest = matrix.norm_max();
    for column in 0..size {
        for row in column + 1..size {
            let (value, mirrored) = (matrix[(row, column)], matrix[(column, row)]);
            let deviation = (value - mirrored).abs();
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
        }
    }
    Ok(matrix)
}

fn read(path: &Path, check: &ShapeCheck<'_>) -> Result<Mat<f64>, ImportError> {
    let source = Source::read(path, INFLATED_LIMIT)?;
    let Dense { rows, columns, values } = read_dense(&source, check)?;
    Ok(Mat::from_fn(rows, columns, |row, column| values[column * rows + row]))
}

fn mismatch(path: &Path, expected: String, found: usize, what: &'static str) -> ImportError {
    ImportError::SizeMismatch { path: path.to_path_buf(), expected, found, what }
}
