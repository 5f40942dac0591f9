//! VTK: unstructured grids in XML, `.vtu`.
//!
//! Source: "VTK XML file formats" and "VTKFileFormats" of the documentation of VTK 9.

use std::collections::BTreeMap;

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use super::solids::Solids;
use super::vtu_array::{Array, Container, Encoding};
use crate::import::ImportError;
use crate::import::nodes::NodeTable;
use crate::import::text::source::Source;
use crate::{ElementKind, Nodes};

/// Different values of an integer array up to which each is a group; more are numbers, not groups.
const MOST_GROUPS: usize = 64;

/// True for an XML file.
pub(super) fn is_xml(bytes: &[u8]) -> bool {
    let bytes = bytes.trim_ascii_start();
    bytes.starts_with(b"<?xml") || bytes.starts_with(b"<VTKFile")
}

/// Reads the grid of one piece.
pub(super) fn read(source: &Source) -> Result<NodeTable, ImportError> {
    let document = Document::read(source)?;
    let place = document.place;
    let of = |section: &str, name: Option<&str>| {
        let fits =
            |array: &&Array<'_>| array.section == section && name.is_none_or(|name| array.name == name);
        document.arrays.iter().find(fits).ok_or_else(|| {
            let name = name.map(|name| format!(" `{name}`")).unwrap_or_default();
            source.expected(place, format!("a DataArray{name} in <{section}>"))
        })
    };
    let container = &document.container;
    let points = of("Points", None)?;
    let coordinates = container.floats(source, points)?;
    let (positions, rest) = coordinates.as_chunks::<3>();
    points.must_hold(source, "coordinates", document.points.saturating_mul(3), coordinates.len())?;
    if !rest.is_empty() {
        return Err(source.expected(points.place, "three coordinates of each point"));
    }
    let nodes = Nodes {
        ids: (0..positions.len() as u64).collect(),
        positions: positions.to_vec(),
        ..Nodes::default()
    };
    let mut solids = Solids::of(nodes);

    let connectivity = of("Cells", Some("connectivity"))?;
    let members = container.integers(source, connectivity)?;
    let offsets_array = of("Cells", Some("offsets"))?;
    let offsets = container.integers(source, offsets_array)?;
    offsets_array.must_hold(source, "offsets", document.cells, offsets.len())?;
    let types_array = of("Cells", Some("types"))?;
    let types = container.integers(source, types_array)?;
    types_array.must_hold(source, "types", document.cells, types.len())?;
    let mut cells: Vec<&[i64]> = Vec::with_capacity(types.len());
    let mut from = 0;
    for (number, &to) in offsets.iter().enumerate() {
        let cell = usize::try_from(to).ok().and_then(|to| members.get(from..to).map(|cell| (to, cell)));
        let Some((to, cell)) = cell else {
            let expected = format!("offsets that ascend to {}, found {to} of cell {number}", members.len());
            return Err(source.expected(offsets_array.place, expected));
        };
        if let Some(row) = cell.iter().find(|&&row| row < 0 || row as usize >= document.points) {
            let expected = format!(
                "points from 0 to {}, found {row} in cell {number}",
                document.points.saturating_sub(1)
            );
            return Err(source.expected(connectivity.place, expected));
        }
        cells.push(cell);
        from = to;
    }
    let mut solid_of_cell = vec![None; cells.len()];
    for (number, (&kind, &cell)) in types.iter().zip(&cells).enumerate() {
        let Some((kind, nodes)) = solid(source, types_array.place, kind)? else { continue };
        if cell.len() != nodes {
            let expected = format!("{nodes} points of cell {number}, found {}", cell.len());
            return Err(source.expected(connectivity.place, expected));
        }
        let added = solids.add(kind, cell.iter().map(|&row| row as usize).collect(), connectivity.place);
        solid_of_cell[number] = added.ok();
        if added.is_err() {
            let expected = format!("each solid once, but another one has the points of cell {number}");
            return Err(source.expected(connectivity.place, expected));
        }
    }
    for array in &document.arrays {
        let is_of_cells = match array.section.as_str() {
            "PointData" => false,
            "CellData" => true,
            _ => continue,
        };
        if array.components != 1 || !array.is_integer() {
            continue;
        }
        let values = container.integers(source, array)?;
        let expected = if is_of_cells { document.cells } else { document.points };
        array.must_hold(source, "values", expected, values.len())?;
        for (name, items) in groups(&array.name, &values) {
            if is_of_cells {
                let numbers: Vec<usize> = items.iter().filter_map(|&cell| solid_of_cell[cell]).collect();
                solids.extend_element_group(&name, &numbers);
            }
            let rows: Vec<usize> = if is_of_cells {
                let mut rows: Vec<usize> =
                    items.iter().flat_map(|&cell| cells[cell].iter().map(|&row| row as usize)).collect();
                rows.sort_unstable();
                rows.dedup();
                rows
            } else {
                items
            };
            solids.extend_group(source, &name, &rows, array.place)?;
        }
    }
    solids.finish(source)
}

/// An array of 0 and 1 is one group; of a few other numbers, each of them is one.
fn groups(name: &str, values: &[i64]) -> Vec<(String, Vec<usize>)> {
    let mut groups: BTreeMap<i64, Vec<usize>> = BTreeMap::new();
    for (item, &value) in values.iter().enumerate() {
        groups.entry(value).or_default().push(item);
        if groups.len() > MOST_GROUPS {
            return Vec::new();
        }
    }
    if groups.keys().all(|value| [0, 1].contains(value)) {
        return groups.remove(&1).map(|items| (name.to_owned(), items)).into_iter().collect();
    }
    groups.into_iter().map(|(value, items)| (format!("{name}_{value}"), items)).collect()
}

/// Kind and number of points of a solid; `None` for points, lines and surfaces.
fn solid(source: &Source, place: usize, kind: i64) -> Result<Option<(ElementKind, usize)>, ImportError> {
    Ok(Some(match kind {
        10 => (ElementKind::Tetrahedron4, 4),
        12 => (ElementKind::Hexahedron8, 8),
        24 => (ElementKind::Tetrahedron10, 10),
        25 => (ElementKind::Hexahedron20, 20),
        1..=9 | 21..=23 | 28 | 30 | 34 | 35 | 36 => return Ok(None),
        _ => {
            return Err(ImportError::Unsupported {
                path: source.path().to_path_buf(),
                line: source.line_of(place),
                feature: format!("cell type {kind}"),
                advice: "use types 10 and 24 (tetrahedra), 12 and 25 (hexahedra)",
            });
        }
    }))
}

/// What the tags of the file say.
struct Document<'a> {
    points: usize,
    cells: usize,
    /// Where the piece starts.
    place: usize,
    arrays: Vec<Array<'a>>,
    container: Container<'a>,
}

impl<'a> Document<'a> {
    fn read(source: &'a Source) -> Result<Self, ImportError> {
        let bytes = source.bytes();
        let mut reader = Reader::from_reader(bytes);
        let mut container = None;
        let mut piece: Option<(usize, usize, usize)> = None;
        let mut arrays: Vec<Array<'a>> = Vec::new();
        let mut sections: Vec<String> = Vec::new();
        loop {
            let place = reader.buffer_position() as usize;
            let event = reader.read_event();
            let event =
                event.map_err(|error| source.expected(place, format!("XML of a .vtu file ({error})")))?;
            let (start, is_empty) = match &event {
                Event::Start(start) => (start, false),
                Event::Empty(start) => (start, true),
                Event::End(_) => {
                    sections.pop();
                    continue;
                }
                Event::Eof => break,
                _ => continue,
            };
            let tag = Tag { source, place, start };
            let name = String::from_utf8_lossy(start.name().as_ref()).into_owned();
            match name.as_str() {
                "VTKFile" => container = Some(Container::new(source, place, |name| tag.attribute(name))?),
                "Piece" if piece.is_some() => {
                    return Err(
                        source.expected(place, "one <Piece> (gather the parts of a distributed grid)")
                    );
                }
                "Piece" => piece = Some((tag.number("NumberOfPoints")?, tag.number("NumberOfCells")?, place)),
                "DataArray" => {
                    let section = sections.last().cloned().unwrap_or_default();
                    let mut array = Array::new(source, place, section, |name| tag.attribute(name))?;
                    if !is_empty && array.encoding != Encoding::Appended {
                        let from = reader.buffer_position() as usize;
                        let length = bytes[from..].iter().position(|&byte| byte == b'<');
                        array.text_start = from;
                        array.text = &bytes[from..from + length.unwrap_or(bytes.len() - from)];
                    }
                    arrays.push(array);
                }
                "AppendedData" => {
                    // raw bytes follow: the tags end here
                    let from = reader.buffer_position() as usize;
                    let mark = bytes[from..].iter().position(|&byte| byte == b'_');
                    let Some(mark) = mark else {
                        return Err(source.expected(place, "`_` before appended data"));
                    };
                    let is_raw = tag.attribute("encoding")?.as_deref() == Some("raw");
                    if let Some(container) = &mut container {
                        Container::append(container, &bytes[from + mark + 1..], is_raw);
                    }
                    break;
                }
                _ => {}
            }
            if !is_empty {
                sections.push(name);
            }
        }
        let Some(container) = container else {
            return Err(source.expected(0, "<VTKFile type=\"UnstructuredGrid\">"));
        };
        let Some((points, cells, place)) = piece else {
            return Err(source.expected(bytes.len(), "a <Piece> of the grid"));
        };
        Ok(Self { points, cells, place, arrays, container })
    }
}

/// A tag with its place.
struct Tag<'t, 'a> {
    source: &'t Source,
    place: usize,
    start: &'t BytesStart<'a>,
}

impl Tag<'_, '_> {
    fn attribute(&self, name: &str) -> Result<Option<String>, ImportError> {
        let broken = || self.source.expected(self.place, format!("a readable attribute {name}"));
        let found = self.start.try_get_attribute(name).map_err(|_| broken())?;
        found
            .map(|found| found.unescape_value().map(|text| text.into_owned()).map_err(|_| broken()))
            .transpose()
    }

    fn number(&self, name: &str) -> Result<usize, ImportError> {
        let text = self.attribute(name)?;
        text.and_then(|text| text.trim().parse().ok())
            .ok_or_else(|| self.source.expected(self.place, format!("a number as attribute {name}")))
    }
}
