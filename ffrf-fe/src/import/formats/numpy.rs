//! NumPy `.npy` arrays and `.npz` archives, dense or as `scipy.sparse.save_npz` writes them.

use std::collections::HashSet;
use std::io::{Cursor, Read};

use ffrf_model::printable;
use npyz::{DType, NpyFile, Order, TypeChar};

use super::npy_header::{self, NPY_MAGIC};
use super::npz_archive::NpzArchive;
use super::text_table;
use crate::import::ImportError;
use crate::import::matrix::entries::Entries;
use crate::import::matrix::raw_matrix::{Dense, Numbering, RawMatrix, ShapeCheck, Storage};
use crate::import::nodes::NodeTable;
use crate::import::text::source::Source;

/// First bytes of a `.npz` file, which is a zip archive.
pub(crate) const NPZ_MAGIC: &[u8] = b"PK\x03\x04";

/// True if the file is a NumPy array or archive.
pub(crate) fn is_numpy(bytes: &[u8]) -> bool {
    bytes.starts_with(NPY_MAGIC) || bytes.starts_with(NPZ_MAGIC)
}

/// Reads a square matrix, dense or sparse, from a `.npy` or `.npz` file.
pub(crate) fn read_square(source: Source) -> Result<RawMatrix, ImportError> {
    if source.bytes().starts_with(NPZ_MAGIC) {
        let mut archive = open(&source)?;
        if archive.array_names().any(|name| name == "format") {
            let (size, entries) = sparse_entries(&source, &mut archive)?;
            return Ok(RawMatrix {
                source,
                entries,
                size,
                storage: Storage::Full,
                numbering: Numbering::Declared,
            });
        }
    }
    let dense = read_dense(&source, &[], &|_, _| Ok(()))?;
    let size = RawMatrix::square(&source, dense.rows, dense.columns)?;
    let (mut rows, mut columns, mut values) = (Vec::new(), Vec::new(), Vec::new());
    for (place, &value) in dense.values.iter().enumerate() {
        if value != 0.0 {
            rows.push(index(&source, "", place % size)?);
            columns.push(index(&source, "", place / size)?);
            values.push(value);
        }
    }
    let entries = Entries::from_vectors(rows, columns, values);
    Ok(RawMatrix { source, entries, size, storage: Storage::Full, numbering: Numbering::Declared })
}

/// Reads a dense array of one or two dimensions; a vector is one column. In an archive the array is the first of
/// `names` that exists, or the only one.
pub(crate) fn read_dense(
    source: &Source,
    names: &[&str],
    check: &ShapeCheck<'_>,
) -> Result<Dense, ImportError> {
    if source.bytes().starts_with(NPZ_MAGIC) {
        let mut archive = open(source)?;
        let present: Vec<String> = archive.array_names().map(str::to_owned).collect();
        let wanted = names.iter().find(|name| present.iter().any(|have| have == *name));
        let name = match (wanted, present.as_slice()) {
            (Some(name), _) => (*name).to_owned(),
            (None, [only]) => only.clone(),
            (None, _) => {
                let expected = format!("one array, or one named {}", names.join(" or "));
                return Err(defect(source, "", expected, present.join(", ")));
            }
        };
        return dense_array(source, &name, array(source, &mut archive, &name)?, check);
    }
    npy_header::check(source.bytes()).map_err(|found| defect(source, "", found.expected, found.found))?;
    let file = NpyFile::new(source.bytes()).map_err(|error| unreadable(source, "", &error))?;
    dense_array(source, "", file, check)
}

/// Reads nodes: N x 3, or N x 4 with ids in the first column.
pub(crate) fn read_nodes(source: &Source) -> Result<NodeTable, ImportError> {
    let Dense { rows, columns, values } = read_dense(source, &["nodes", "X", "x"], &|_, _| Ok(()))?;
    let offset = match columns {
        3 => 0,
        4 => 1,
        _ => return Err(defect(source, "", "3 columns x y z, or 4 with ids first", columns.to_string())),
    };
    let position = |row: usize| std::array::from_fn(|i| values[(offset + i) * rows + row]);
    let mut table = text_table::plain_nodes((0..rows).map(position).collect());
    if offset == 1 {
        for (id, &value) in table.nodes.ids.iter_mut().zip(&values[..rows]) {
            if value < 0.0 || value.fract() != 0.0 || value > u32::MAX.into() {
                return Err(defect(source, "", "node ids in the first column", value.to_string()));
            }
            *id = value as u64;
        }
        let mut seen = HashSet::with_capacity(rows);
        if let Some(row) = table.nodes.ids.iter().position(|&id| !seen.insert(id)) {
            let (path, id) = (source.path().to_path_buf(), table.nodes.ids[row]);
            return Err(ImportError::RepeatedNode { path, row: row + 1, id });
        }
    }
    table.check_size(source)
}

fn open(source: &Source) -> Result<NpzArchive<'_>, ImportError> {
    NpzArchive::new(source.bytes(), source.inflated_limit()).map_err(|error| unreadable(source, "", &error))
}

fn array(
    source: &Source,
    archive: &mut NpzArchive<'_>,
    name: &str,
) -> Result<NpyFile<Cursor<Vec<u8>>>, ImportError> {
    let found = archive.by_name(name).map_err(|error| unreadable(source, name, &error))?;
    found.ok_or_else(|| defect(source, name, "an array of this name", "none"))
}

fn dense_array<R: Read>(
    source: &Source,
    name: &str,
    file: NpyFile<R>,
    check: &ShapeCheck<'_>,
) -> Result<Dense, ImportError> {
    let (rows, columns) = match *file.shape() {
        [rows] => (rows, 1),
        [rows, columns] => (rows, columns),
        _ => return Err(defect(source, name, "one or two dimensions", format!("{:?}", file.shape()))),
    };
    let (rows, columns) = (length(source, name, rows)?, length(source, name, columns)?);
    check(rows, columns)?;
    let by_rows = file.order() == Order::C && columns > 1;
    let values = floats(source, name, file)?;
    let values = if by_rows {
        (0..rows * columns).map(|place| values[place % rows * columns + place / rows]).collect()
    } else {
        values
    };
    Ok(Dense { rows, columns, values })
}

/// All values of an array as floats.
fn floats<R: Read>(source: &Source, name: &str, file: NpyFile<R>) -> Result<Vec<f64>, ImportError> {
    let announced = length(source, name, file.len())?;
    let kind = number_kind(&file.dtype());
    let values: std::io::Result<Vec<f64>> = match kind {
        Some((TypeChar::Float, 8)) => file.into_vec(),
        Some((TypeChar::Float, 4)) => {
            file.into_vec::<f32>().map(|values| values.into_iter().map(f64::from).collect())
        }
        Some((TypeChar::Int, 8)) => {
            // Integers beyond 2^53 do not occur as coordinates, masses or stiffnesses.
            file.into_vec::<i64>().map(|values| values.into_iter().map(|value| value as f64).collect())
        }
        Some((TypeChar::Int, 4)) => {
            file.into_vec::<i32>().map(|values| values.into_iter().map(f64::from).collect())
        }
        _ => return Err(defect(source, name, REAL_NUMBERS, file.dtype().descr())),
    };
    let values = values.map_err(|error| unreadable(source, name, &error))?;
    if values.len() != announced {
        return Err(defect(source, name, format!("{announced} values"), values.len().to_string()));
    }
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(values),
        Some(place) => Err(ImportError::NonFinite {
            path: source.path().to_path_buf(),
            line: place + 1,
            found: format!("{} (position in the array)", values[place]),
        }),
    }
}

const REAL_NUMBERS: &str = "real numbers (f8, f4, i8 or i4)";

fn number_kind(dtype: &DType) -> Option<(TypeChar, u64)> {
    match dtype {
        DType::Plain(kind) => Some((kind.type_char(), kind.size_field())),
        _ => None,
    }
}

/// The entries of a matrix in the layout of `scipy.sparse.save_npz`: csr, csc or coo.
fn sparse_entries(source: &Source, archive: &mut NpzArchive<'_>) -> Result<(usize, Entries), ImportError> {
    let values = floats(source, "data", array(source, archive, "data")?)?;
    let shape = integers(source, archive, "shape")?;
    let &[rows, columns] = shape.as_slice() else {
        return Err(defect(source, "shape", "two numbers", shape.len().to_string()));
    };
    let size = RawMatrix::square(source, rows, columns)?;
    let present = |archive: &NpzArchive<'_>, name: &str| archive.array_names().any(|have| have == name);
    let (rows, columns) = if present(archive, "row") && present(archive, "col") {
        (integers(source, archive, "row")?, integers(source, archive, "col")?)
    } else if present(archive, "indices") && present(archive, "indptr") {
        let inner = integers(source, archive, "indices")?;
        let starts = integers(source, archive, "indptr")?;
        let ordered = starts.windows(2).all(|pair| pair[0] <= pair[1]);
        if starts.len() != size + 1 || !ordered || starts.last() != Some(&inner.len()) {
            let expected = format!("{} ascending numbers up to {}", size + 1, inner.len());
            return Err(defect(source, "indptr", expected, format!("{} numbers", starts.len())));
        }
        let mut outer = Vec::with_capacity(inner.len());
        for (line, pair) in starts.windows(2).enumerate() {
            outer.extend(std::iter::repeat_n(line, pair[1] - pair[0]));
        }
        // The matrix must be symmetric, so rows of csr and columns of csc may stand for each other.
        (outer, inner)
    } else {
        let expected = "arrays `row`, `col` or `indices`, `indptr` (scipy.sparse csr, csc or coo)";
        return Err(defect(source, "", expected, archive.array_names().collect::<Vec<_>>().join(", ")));
    };
    if rows.len() != values.len() || columns.len() != values.len() {
        let expected = format!("{} values, one per index", rows.len());
        return Err(defect(source, "data", expected, values.len().to_string()));
    }
    let narrow = |indices: Vec<usize>| -> Result<Vec<u32>, ImportError> {
        let checked = indices.into_iter().map(|value| {
            let inside = if value < size { u32::try_from(value).ok() } else { None };
            inside
                .ok_or_else(|| defect(source, "indices", format!("indices below {size}"), value.to_string()))
        });
        checked.collect()
    };
    Ok((size, Entries::from_vectors(narrow(rows)?, narrow(columns)?, values)))
}

/// A vector of non-negative integers, stored as i4 or i8.
fn integers(source: &Source, archive: &mut NpzArchive<'_>, name: &str) -> Result<Vec<usize>, ImportError> {
    let file = array(source, archive, name)?;
    let values: std::io::Result<Vec<i64>> = match number_kind(&file.dtype()) {
        Some((TypeChar::Int, 8)) => file.into_vec(),
        Some((TypeChar::Int, 4)) => {
            file.into_vec::<i32>().map(|values| values.into_iter().map(i64::from).collect())
        }
        _ => return Err(defect(source, name, "integers (i4 or i8)", file.dtype().descr())),
    };
    let values = values.map_err(|error| unreadable(source, name, &error))?;
    let counted = values.into_iter().map(|value| {
        usize::try_from(value).map_err(|_| defect(source, name, "no negative number", value.to_string()))
    });
    counted.collect()
}

fn length(source: &Source, name: &str, value: u64) -> Result<usize, ImportError> {
    // An array larger than the address space of 32-bit row numbers is no matrix of this program.
    usize::try_from(value)
        .ok()
        .filter(|&length| length <= u32::MAX as usize)
        .ok_or_else(|| defect(source, name, "at most 2^32 values", value.to_string()))
}

fn index(source: &Source, name: &str, value: usize) -> Result<u32, ImportError> {
    u32::try_from(value).map_err(|_| defect(source, name, "at most 2^32 rows", value.to_string()))
}

fn defect(
    source: &Source,
    array: &str,
    expected: impl Into<String>,
    found: impl Into<String>,
) -> ImportError {
    ImportError::Array {
        path: source.path().to_path_buf(),
        array: printable(array),
        expected: printable(&expected.into()),
        found: printable(&found.into()),
    }
}

fn unreadable(source: &Source, array: &str, error: &std::io::Error) -> ImportError {
    defect(source, array, "a complete NumPy array", error.to_string())
}
