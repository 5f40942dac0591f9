//! gmsh: `.msh` in the formats 4.1 and 2.2, ASCII.
//!
//! Source: gmsh 4.15 reference manual, sections "MSH file format" and "MSH file format version 2 (Legacy)".

use super::element_types::{ElementType, Shape, element_type};
use super::entities::Groups;
use super::solids::Solids;
use crate::import::ImportError;
use crate::import::nodes::NodeTable;
use crate::import::text::cursor::{Cursor, Defect};
use crate::import::text::source::Source;

const NODE_LINE: &str = "`tag x y z` of a node";
const ELEMENT_LINE: &str = "`tag node node ...` of an element";
const LEGACY_ELEMENT: &str = "`tag type count-of-tags tags node node ...` of an element";

/// True if the first section, except for comments, is `$MeshFormat`.
pub(super) fn is_gmsh(bytes: &[u8]) -> bool {
    let bytes = bytes.trim_ascii_start();
    bytes.starts_with(b"$MeshFormat") || bytes.starts_with(b"$Comments")
}

/// Reads a mesh.
pub(super) fn read(source: &Source) -> Result<NodeTable, ImportError> {
    let mut reader = Reader {
        source,
        cursor: Cursor::new(source.bytes(), 0),
        is_legacy: false,
        solids: Solids::default(),
        groups: Groups::default(),
    };
    reader.sections()?;
    reader.solids.finish(source)
}

struct Reader<'a> {
    source: &'a Source,
    cursor: Cursor<'a>,
    /// Format 2.2.
    is_legacy: bool,
    solids: Solids,
    groups: Groups,
}

impl<'a> Reader<'a> {
    fn sections(&mut self) -> Result<(), ImportError> {
        let mut is_known = false;
        while let Some((place, name)) = self.section() {
            match name {
                "MeshFormat" => {
                    self.format()?;
                    is_known = true;
                }
                _ if !is_known && name != "Comments" => {
                    return Err(self.source.expected(place, "the section `$MeshFormat` first"));
                }
                "PhysicalNames" => self.physical_names()?,
                "Entities" => self.entities()?,
                "Nodes" => self.nodes()?,
                "Elements" => self.elements()?,
                "PartitionedEntities" => {
                    return Err(self.unsupported(place, "a partitioned mesh", "save it without partitions"));
                }
                "ParametricNodes" => {
                    let advice = "save the mesh with Mesh.SaveParametric = 0";
                    return Err(self.unsupported(place, "the section `$ParametricNodes`", advice));
                }
                _ => {
                    self.skip(place, name)?;
                    continue;
                }
            }
            self.end(name)?;
        }
        Ok(())
    }

    fn unsupported(&self, place: usize, feature: &str, advice: &'static str) -> ImportError {
        ImportError::Unsupported {
            path: self.source.path().to_path_buf(),
            line: self.source.line_of(place),
            feature: feature.to_owned(),
            advice,
        }
    }

    /// The start of the next section: its place and name.
    fn section(&mut self) -> Option<(usize, &'a str)> {
        let bytes = self.source.bytes();
        loop {
            let place = self.cursor.at;
            if place >= bytes.len() {
                return None;
            }
            let line = self.line();
            if let Some(name) = line.strip_prefix(b"$").filter(|name| !name.starts_with(b"End")) {
                return Some((place, std::str::from_utf8(name).unwrap_or("")));
            }
        }
    }

    /// The line that starts here, without blanks around it; the cursor goes behind it.
    fn line(&mut self) -> &'a [u8] {
        let start = self.cursor.at;
        self.cursor.next_line();
        self.source.bytes()[start..self.cursor.at].trim_ascii()
    }

    /// Goes behind the end of a section that is not read.
    fn skip(&mut self, place: usize, name: &str) -> Result<(), ImportError> {
        let end = format!("$End{name}");
        while self.cursor.at < self.source.bytes().len() {
            if self.line() == end.as_bytes() {
                return Ok(());
            }
        }
        Err(self.source.expected(place, format!("a line `{end}` behind this one")))
    }

    /// Asserts the end of a section.
    fn end(&mut self, name: &str) -> Result<(), ImportError> {
        let end = format!("$End{name}");
        loop {
            let place = self.cursor.at;
            match self.line() {
                b"" if self.cursor.at < self.source.bytes().len() => {}
                line if line == end.as_bytes() => return Ok(()),
                _ => return Err(self.source.expected(place, format!("`{end}`"))),
            }
        }
    }

    fn defect<T>(&self, result: Result<T, Defect>) -> Result<T, ImportError> {
        result.map_err(|defect| self.source.defect(&defect, self.solids.nodes.len()))
    }

    fn unsigned(&mut self, expected: &'static str) -> Result<u64, ImportError> {
        let read = self.cursor.unsigned(expected);
        self.defect(read)
    }

    fn float(&mut self, expected: &'static str) -> Result<f64, ImportError> {
        let read = self.cursor.float(expected);
        self.defect(read)
    }

    fn end_line(&mut self, expected: &'static str) -> Result<(), ImportError> {
        let read = self.cursor.end_line(expected);
        self.defect(read)
    }

    /// A dimension from 0 to 3.
    fn dimension(&mut self, expected: &'static str) -> Result<u8, ImportError> {
        self.cursor.skip_separators();
        let place = self.cursor.at;
        match self.unsigned(expected)? {
            dimension @ 0..=3 => Ok(dimension as u8),
            _ => Err(self.source.expected(place, "a dimension from 0 to 3")),
        }
    }

    fn format(&mut self) -> Result<(), ImportError> {
        const EXPECTED: &str = "the format, `4.1 0 8` or `2.2 0 8`";
        let place = self.cursor.at;
        let version = self.float(EXPECTED)?;
        self.is_legacy = match version {
            4.1 => false,
            2.0..=2.2 => true,
            _ => {
                let expected = "version 4.1 or 2.2 (Mesh.MshFileVersion = 4.1)";
                return Err(self.source.expected(place, expected));
            }
        };
        self.cursor.skip_separators();
        let place = self.cursor.at;
        if self.unsigned(EXPECTED)? != 0 {
            return Err(self.source.expected(place, "an ASCII file, mode 0 (Mesh.Binary = 0)"));
        }
        self.unsigned(EXPECTED)?;
        self.end_line(EXPECTED)
    }

    /// `dimension tag "name"`.
    fn physical_names(&mut self) -> Result<(), ImportError> {
        const EXPECTED: &str = "`dimension tag \"name\"` of a physical group";
        let count = self.unsigned("the number of physical names")?;
        self.end_line("the number of physical names alone")?;
        for _ in 0..count {
            let dimension = self.dimension(EXPECTED)?;
            let tag = self.unsigned(EXPECTED)?;
            self.cursor.skip_separators();
            let place = self.cursor.at;
            let name = self.line().strip_prefix(b"\"").and_then(|rest| rest.strip_suffix(b"\""));
            match name.and_then(|name| std::str::from_utf8(name).ok()) {
                Some(name) if !name.is_empty() => self.groups.set_name((dimension, tag), name.to_owned()),
                _ => return Err(self.source.expected(place, EXPECTED)),
            }
        }
        Ok(())
    }

    /// Points have one position, other entities a box; then the physical groups, which is all that is wanted.
    fn entities(&mut self) -> Result<(), ImportError> {
        const COUNTS: &str = "the numbers of points, curves, surfaces and volumes";
        const EXPECTED: &str = "`tag x y z [x y z] count groups ...` of an entity";
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = self.unsigned(COUNTS)?;
        }
        self.end_line(COUNTS)?;
        for (dimension, count) in (0_u8..).zip(counts) {
            for _ in 0..count {
                let tag = self.unsigned(EXPECTED)?;
                for _ in 0..if dimension == 0 { 3 } else { 6 } {
                    self.float(EXPECTED)?;
                }
                let mut groups = Vec::new();
                for _ in 0..self.unsigned(EXPECTED)? {
                    groups.push(self.oriented_tag(EXPECTED)?);
                }
                self.cursor.next_line();
                if !groups.is_empty() {
                    self.groups.set_entity((dimension, tag), groups);
                }
            }
        }
        Ok(())
    }

    /// A tag whose sign tells an orientation.
    fn oriented_tag(&mut self, expected: &'static str) -> Result<u64, ImportError> {
        self.cursor.skip_separators();
        if self.source.bytes().get(self.cursor.at) == Some(&b'-') {
            self.cursor.at += 1;
        }
        self.unsigned(expected)
    }

    fn nodes(&mut self) -> Result<(), ImportError> {
        let mut places = Vec::new();
        if self.is_legacy {
            let count = self.unsigned("the number of nodes")?;
            self.end_line("the number of nodes alone")?;
            for _ in 0..count {
                places.push(self.cursor.at);
                let tag = self.unsigned(NODE_LINE)?;
                let position = self.position()?;
                self.end_line(NODE_LINE)?;
                self.solids.nodes.ids.push(tag);
                self.solids.nodes.positions.push(position);
            }
        } else {
            const COUNTS: &str = "`blocks nodes least-tag greatest-tag`";
            const BLOCK: &str = "`dimension entity parametric count` of a block of nodes";
            let [blocks, nodes] = [self.unsigned(COUNTS)?, self.unsigned(COUNTS)?];
            self.cursor.next_line();
            for _ in 0..blocks {
                self.dimension(BLOCK)?;
                self.unsigned(BLOCK)?;
                self.unsigned(BLOCK)?;
                let count = self.unsigned(BLOCK)?;
                self.end_line(BLOCK)?;
                for _ in 0..count {
                    places.push(self.cursor.at);
                    let tag = self.unsigned("the tag of a node")?;
                    self.end_line("one tag of a node a line")?;
                    self.solids.nodes.ids.push(tag);
                }
                for _ in 0..count {
                    let position = self.position()?;
                    // coordinates on the curve or surface may follow
                    self.cursor.next_line();
                    self.solids.nodes.positions.push(position);
                }
            }
            if self.solids.nodes.len() as u64 != nodes {
                let expected = format!("{nodes} nodes, as announced, found {}", self.solids.nodes.len());
                return Err(self.source.expected(self.cursor.at, expected));
            }
        }
        self.solids.close_nodes(self.source, &places)
    }

    fn position(&mut self) -> Result<[f64; 3], ImportError> {
        const EXPECTED: &str = "the coordinates x y z of a node";
        Ok([self.float(EXPECTED)?, self.float(EXPECTED)?, self.float(EXPECTED)?])
    }

    fn elements(&mut self) -> Result<(), ImportError> {
        if self.is_legacy {
            return self.legacy_elements();
        }
        const COUNTS: &str = "`blocks elements least-tag greatest-tag`";
        const BLOCK: &str = "`dimension entity type count` of a block of elements";
        let [blocks, elements] = [self.unsigned(COUNTS)?, self.unsigned(COUNTS)?];
        self.cursor.next_line();
        let mut found = 0;
        for _ in 0..blocks {
            let place = self.cursor.at;
            let entity = (self.dimension(BLOCK)?, self.unsigned(BLOCK)?);
            let kind = self.element_type(BLOCK)?;
            let count = self.unsigned(BLOCK)?;
            self.end_line(BLOCK)?;
            let names = self.groups.names_of(entity);
            let (mut rows, mut solids) = (Vec::new(), Vec::new());
            for _ in 0..count {
                let place = self.cursor.at;
                self.unsigned(ELEMENT_LINE)?;
                let nodes = self.element_nodes(kind, ELEMENT_LINE)?;
                if !names.is_empty() {
                    rows.extend_from_slice(&nodes);
                }
                solids.extend(self.add(kind, nodes, place, false)?);
            }
            rows.sort_unstable();
            rows.dedup();
            for name in names {
                self.solids.extend_group(self.source, &name, &rows, place)?;
                self.solids.extend_element_group(&name, &solids);
            }
            found += count;
        }
        if found != elements {
            let expected = format!("{elements} elements, as announced, found {found}");
            return Err(self.source.expected(self.cursor.at, expected));
        }
        Ok(())
    }

    /// An element that is in several physical groups comes once for each of them.
    fn legacy_elements(&mut self) -> Result<(), ImportError> {
        let count = self.unsigned("the number of elements")?;
        self.end_line("the number of elements alone")?;
        for _ in 0..count {
            let place = self.cursor.at;
            self.unsigned(LEGACY_ELEMENT)?;
            let kind = self.element_type(LEGACY_ELEMENT)?;
            let mut group = 0;
            for number in 0..self.unsigned(LEGACY_ELEMENT)? {
                let tag = self.oriented_tag(LEGACY_ELEMENT)?;
                if number == 0 {
                    group = tag;
                }
            }
            let nodes = self.element_nodes(kind, LEGACY_ELEMENT)?;
            let name = (group != 0).then(|| self.groups.name((kind.dimension, group)));
            if let Some(name) = &name {
                self.solids.extend_group(self.source, name, &nodes, place)?;
            }
            if let (Some(solid), Some(name)) = (self.add(kind, nodes, place, true)?, name) {
                self.solids.extend_element_group(&name, &[solid]);
            }
        }
        Ok(())
    }

    fn element_type(&mut self, expected: &'static str) -> Result<ElementType, ImportError> {
        self.cursor.skip_separators();
        let place = self.cursor.at;
        let number = self.unsigned(expected)?;
        let Some(kind) = element_type(number) else {
            return Err(self.source.expected(place, "the number of an element type, 1 to 31"));
        };
        if let Shape::Unknown(advice) = kind.shape {
            let feature = format!("element type {number}, a solid of {} nodes,", kind.nodes);
            return Err(self.unsupported(place, &feature, advice));
        }
        Ok(kind)
    }

    /// Rows of the nodes on the rest of the line, in the order of the file.
    fn element_nodes(
        &mut self,
        kind: ElementType,
        expected: &'static str,
    ) -> Result<Vec<usize>, ImportError> {
        let mut rows = Vec::with_capacity(kind.nodes);
        for _ in 0..kind.nodes {
            self.cursor.skip_separators();
            let place = self.cursor.at;
            let tag = self.unsigned(expected)?;
            rows.push(self.solids.row(self.source, tag, place)?);
        }
        self.end_line(expected)?;
        Ok(rows)
    }

    /// The number of the solid; `None` for other elements.
    fn add(
        &mut self,
        kind: ElementType,
        nodes: Vec<usize>,
        place: usize,
        may_repeat: bool,
    ) -> Result<Option<usize>, ImportError> {
        let Shape::Solid(kind, order) = kind.shape else { return Ok(None) };
        let ordered = order.iter().map(|&at| nodes[at]).collect();
        match self.solids.add(kind, ordered, place) {
            Ok(number) => Ok(Some(number)),
            Err(other) if may_repeat => Ok(Some(other)),
            Err(_) => Err(self.source.expected(place, "each solid once, but another one has these nodes")),
        }
    }
}
