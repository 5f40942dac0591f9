//! Nastran matrices by degree of freedom: `DMIG` entries of a punch file or bulk data, in small, large and free fields.
//!
//! Source: MSC Nastran Quick Reference Guide, bulk data entry DMIG. Real square and symmetric matrices; of several in one
//! file, the one whose name starts as its role asks for: `K` or `M`.

use super::card::{Card, visit_cards};
use crate::import::ImportError;
use crate::import::matrix::entries::Entries;
use crate::import::matrix::raw_matrix::{Dense, MatrixRole, Numbering, RawMatrix, ShapeCheck, Storage};
use crate::import::nodes::NodeLookup;
use crate::import::text::source::Source;

/// Form of a square matrix in a header.
const SQUARE: u64 = 1;
/// Form of a symmetric matrix, of which one triangle is listed.
const SYMMETRIC: u64 = 6;
/// Types of real numbers, single and double.
const REAL: [u64; 2] = [1, 2];

/// True if a line starts with `DMIG`, in a file whose first line that is no comment starts with a letter: matrices of other
/// formats never do.
pub(crate) fn is_dmig(bytes: &[u8]) -> bool {
    let mut lines = bytes.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    let mut data = lines.by_ref().skip_while(|line| line.is_empty() || line.starts_with(b"$"));
    let Some(first) = data.next().filter(|line| line[0].is_ascii_alphabetic()) else { return false };
    let is_entry = |line: &[u8]| line.get(..4).is_some_and(|word| word.eq_ignore_ascii_case(b"DMIG"));
    is_entry(first) || data.any(is_entry)
}

/// Name and form of the matrix.
struct Header {
    name: String,
    form: u64,
}

/// Reads the matrix of a role; grid points are looked up in `nodes`.
pub(crate) fn read(source: Source, nodes: &NodeLookup, role: MatrixRole) -> Result<RawMatrix, ImportError> {
    let mut names = names(&source)?;
    let at = super::chosen(&source, &names, role)?;
    let (wanted, _) = names.swap_remove(at);
    let mut header: Option<Header> = None;
    let (mut rows, mut columns, mut values) = (Vec::new(), Vec::new(), Vec::new());
    visit_cards(&source, 0, |card| {
        if card.name() != "DMIG" || card.text(1) != wanted {
            return Ok(());
        }
        let Some(known) = &header else {
            header = Some(read_header(&source, card)?);
            return Ok(());
        };
        if card.text(2) == "0" {
            return Err(source.expected(card.place(2), format!("one header of the matrix `{wanted}`")));
        }
        let column = degree(&source, card, [2, 3], nodes)?;
        for first in (5..card.len()).step_by(4) {
            if (first..first + 4).all(|field| card.text(field).is_empty()) {
                continue;
            }
            let row = degree(&source, card, [first, first + 1], nodes)?;
            let value = card.real(&source, first + 2)?;
            // of a symmetric matrix either triangle may be listed, column by column
            let (row, column) =
                if known.form == SYMMETRIC && row < column { (column, row) } else { (row, column) };
            rows.push(row);
            columns.push(column);
            values.push(value);
        }
        Ok(())
    })?;
    let Some(header) = header else {
        return Err(source.expected(0, "a header `DMIG NAME 0 IFO TIN TOUT`"));
    };
    if rows.is_empty() {
        return Err(source.expected(source.bytes().len(), format!("columns of the matrix `{}`", header.name)));
    }
    let storage = if header.form == SYMMETRIC { Storage::OneTriangle } else { Storage::Full };
    let entries = Entries::from_vectors(rows, columns, values);
    Ok(RawMatrix { source, entries, size: 3 * nodes.len(), storage, numbering: Numbering::Named })
}

/// Such a file has a matrix of grid points, no columns of numbers.
pub(crate) fn refuse_dense(source: &Source, _: &ShapeCheck<'_>) -> Result<Dense, ImportError> {
    Err(source.expected(0, "columns of numbers (`DMIG` entries are read as mass or stiffness)"))
}

/// Names of all matrices with their places.
fn names(source: &Source) -> Result<Vec<(String, usize)>, ImportError> {
    let mut found: Vec<(String, usize)> = Vec::new();
    visit_cards(source, 0, |card| {
        let name = card.text(1);
        if card.name() == "DMIG" && found.iter().all(|(known, _)| known != name) {
            found.push((name.to_owned(), card.place(1)));
        }
        Ok(())
    })?;
    Ok(found)
}

fn read_header(source: &Source, card: &Card<'_>) -> Result<Header, ImportError> {
    if card.text(2) != "0" {
        let expected = "the header of a matrix, `DMIG NAME 0 IFO TIN TOUT`, first";
        return Err(source.expected(card.place(2), expected));
    }
    let form = card.text(3).parse().ok().filter(|form| [SQUARE, SYMMETRIC].contains(form));
    let Some(form) = form else {
        return Err(source.expected(card.place(3), "a form IFO of 1 (square) or 6 (symmetric)"));
    };
    if !card.text(4).parse().is_ok_and(|kind| REAL.contains(&kind)) {
        return Err(source.expected(card.place(4), "real numbers, a type TIN of 1 or 2"));
    }
    Ok(Header { name: card.text(1).to_owned(), form })
}

/// The row of a grid point and its component.
fn degree(
    source: &Source,
    card: &Card<'_>,
    [grid, component]: [usize; 2],
    nodes: &NodeLookup,
) -> Result<u32, ImportError> {
    let id = card.number(source, grid, "the number of a grid point")?;
    let Some(row) = nodes.row(id) else {
        let line = source.line_of(card.place(grid));
        let path = source.path().to_path_buf();
        return Err(ImportError::UnknownNode { path, line, id, nodes: nodes.len() });
    };
    match card.text(component).parse::<u32>() {
        // rows are below 2^32 / 3, see `NodeTable::check_size`
        Ok(direction @ 1..=3) => Ok(3 * row as u32 + direction - 1),
        _ => Err(source
            .expected(card.place(component), "a component from 1 to 3: parts of solids, without rotations")),
    }
}
