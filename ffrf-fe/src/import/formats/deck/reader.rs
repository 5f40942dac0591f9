//! Goes through the lines of a deck and sorts data by the keyword they follow.

use std::path::Path;

use super::fields::{element_kind, element_trouble, keyword_at, line_fields, set_members};
use super::keyword::Keyword;
use super::limits;
use super::mesh::{Member, Mesh, Place, Placement, RawElement, RawSet};
use crate::import::ImportError;
use crate::import::nodes::ElementTrouble;
use crate::import::text::compressed::stored_path;
use crate::import::text::cursor::Cursor;
use crate::import::text::source::Source;
use crate::{Elasticity, ElementKind, SolidMaterial};

/// What a deck holds.
#[derive(Debug)]
pub(super) struct Deck {
    /// Instances in file order, then the assembly or flat deck itself.
    pub(super) meshes: Vec<Mesh>,
    pub(super) sources: Vec<Source>,
    pub(super) has_boundary: bool,
    pub(super) materials: Vec<SolidMaterial>,
    pub(super) troubles: Vec<ElementTrouble>,
}

/// What the data lines after a keyword mean.
#[derive(Debug)]
enum Data {
    Skip,
    Nodes { set: Option<String> },
    Elements { kind: Option<(ElementKind, usize)> },
    Set { generate: bool },
    Placement { lines: usize },
    Elastic { lines: usize },
}

#[derive(Debug, Default)]
struct Reader {
    parts: Vec<Mesh>,
    instances: Vec<Mesh>,
    root: Mesh,
    /// The part or instance that is open.
    open: Option<Mesh>,
    sources: Vec<Source>,
    has_boundary: bool,
    materials: Vec<SolidMaterial>,
    troubles: Vec<ElementTrouble>,
    /// Numbers of the files that are being read, each included by the one before.
    within: Vec<usize>,
    /// Times that a file was included.
    includes: usize,
    /// Bytes of files that had been read before.
    repeated_bytes: usize,
    /// Nodes, and what instances copy.
    items: usize,
    inflated_limit: u64,
}

pub(super) fn read(path: &Path, inflated_limit: u64) -> Result<Deck, ImportError> {
    let mut reader = Reader { inflated_limit, ..Reader::default() };
    reader.sources.push(Source::read(path, inflated_limit)?);
    reader.file(0)?;
    // A part without instance stands for itself.
    let mut meshes = if reader.instances.is_empty() { reader.parts } else { reader.instances };
    meshes.push(reader.root);
    let Reader { sources, has_boundary, materials, troubles, .. } = reader;
    Ok(Deck { meshes, sources, has_boundary, materials, troubles })
}

impl Reader {
    /// Reads the file of this number.
    fn file(&mut self, number: usize) -> Result<(), ImportError> {
        self.within.push(number);
        let content = self.sources[number].content();
        let bytes = content.bytes();
        let mut cursor = Cursor::new(bytes, 0);
        let mut data = Data::Skip;
        let mut element: Option<RawElement> = None;
        while cursor.at < bytes.len() {
            cursor.skip_separators();
            let place = Place { source: number, at: cursor.at };
            let rest = &bytes[cursor.at..];
            if rest.is_empty() || rest.starts_with(b"\n") || rest.starts_with(b"**") {
                cursor.next_line();
            } else if rest.starts_with(b"*") {
                self.refuse_short_element(element.take())?;
                let keyword = keyword_at(bytes, &mut cursor);
                if keyword.name == "INCLUDE" {
                    self.include(keyword.get("INPUT").unwrap_or_default(), place)?;
                    data = Data::Skip;
                } else {
                    data = self.keyword(&keyword, place)?;
                }
            } else {
                self.data_line(&mut data, &mut element, bytes, &mut cursor, place)?;
                cursor.next_line();
            }
        }
        self.within.pop();
        self.refuse_short_element(element)
    }

    /// Reads a file that a line of another names, relative to the folder of that one.
    fn include(&mut self, input: &str, place: Place) -> Result<(), ImportError> {
        let source = &self.sources[place.source];
        limits::at_most(
            limits::INCLUDE_DEPTH,
            self.within.len(),
            "files included in each other",
            source,
            place.at,
        )?;
        self.includes += 1;
        limits::at_most(limits::INCLUDES, self.includes, "included files", source, place.at)?;
        let path = source.path().parent().unwrap_or(Path::new("")).join(input);
        let known = self.sources.iter().position(|known| known.path() == stored_path(&path));
        match known {
            Some(number) if self.within.contains(&number) => {
                Err(source.expected(place.at, format!("a file that does not include itself (not `{input}`)")))
            }
            Some(number) => {
                self.repeated_bytes += self.sources[number].bytes().len();
                let what = "bytes of files included again";
                limits::at_most(limits::REPEATED_BYTES, self.repeated_bytes, what, source, place.at)?;
                self.file(number)
            }
            None => {
                self.sources.push(Source::read(&path, self.inflated_limit)?);
                self.file(self.sources.len() - 1)
            }
        }
    }

    /// Counts nodes, and what an instance copies of its part.
    fn count(&mut self, more: usize, place: Place) -> Result<(), ImportError> {
        self.items = self.items.saturating_add(more);
        let what = "nodes, elements and set members of all instances";
        limits::at_most(limits::MESH_ITEMS, self.items, what, &self.sources[place.source], place.at)
    }

    /// Notes the first elements of a type that makes trouble.
    fn note_trouble(&mut self, element: &str, place: Place) {
        let element = element.to_uppercase();
        let Some(kind) = element_trouble(&element) else { return };
        if self.troubles.iter().all(|known| known.element != element) {
            let source = &self.sources[place.source];
            let (path, line) = (source.path().to_path_buf(), source.line_of(place.at));
            self.troubles.push(ElementTrouble { element, path, line, kind });
        }
    }

    fn mesh(&mut self) -> &mut Mesh {
        self.open.as_mut().unwrap_or(&mut self.root)
    }

    /// Acts on a keyword and says what its data lines are.
    fn keyword(&mut self, keyword: &Keyword, place: Place) -> Result<Data, ImportError> {
        let unsupported = |sources: &[Source], advice| {
            let source = &sources[place.source];
            Err(ImportError::Unsupported {
                path: source.path().to_path_buf(),
                line: source.line_of(place.at),
                feature: format!("*{}", keyword.name),
                advice,
            })
        };
        Ok(match keyword.name.as_str() {
            "PART" => {
                let name = keyword.get("NAME").unwrap_or_default().to_owned();
                self.open = Some(Mesh { name, ..Mesh::default() });
                Data::Skip
            }
            "END PART" => {
                self.parts.extend(self.open.take());
                Data::Skip
            }
            "INSTANCE" => {
                let part = keyword.get("PART").unwrap_or_default();
                let name = keyword.get("NAME").unwrap_or_default().to_owned();
                let found = self.parts.iter().find(|known| known.name.eq_ignore_ascii_case(part)).cloned();
                let Some(mesh) = found else {
                    let expected = format!("an instance of a part defined before (not `{part}`)");
                    return Err(self.sources[place.source].expected(place.at, expected));
                };
                self.count(mesh.items(), place)?;
                self.open = Some(Mesh { name, ..mesh });
                Data::Placement { lines: 0 }
            }
            "END INSTANCE" => {
                self.instances.extend(self.open.take());
                Data::Skip
            }
            "NODE" if keyword.get("SYSTEM").is_some_and(|kind| !kind.eq_ignore_ascii_case("R")) => {
                return unsupported(&self.sources, "write the nodes in rectangular coordinates");
            }
            "NODE" if keyword.has("INPUT") => {
                return unsupported(&self.sources, "write the nodes into the deck, or use *INCLUDE");
            }
            "SYSTEM" | "NGEN" | "NFILL" | "NCOPY" | "NMAP" => {
                return unsupported(&self.sources, "write all nodes out with *NODE in the global system");
            }
            "NODE" => Data::Nodes { set: keyword.get("NSET").map(str::to_owned) },
            "ELEMENT" => {
                let name = keyword.get("TYPE").unwrap_or_default();
                self.note_trouble(name, place);
                Data::Elements { kind: element_kind(name) }
            }
            // A set made of element sets is left out: asking for it later names it as unknown.
            "NSET" if !keyword.has("ELSET") => {
                let name = keyword.get("NSET").unwrap_or_default().to_owned();
                let instance = keyword.get("INSTANCE").map(str::to_owned);
                self.mesh().sets.push(RawSet { name, instance, members: Vec::new() });
                Data::Set { generate: keyword.has("GENERATE") }
            }
            "MATERIAL" => {
                let name = keyword.get("NAME").unwrap_or_default().to_owned();
                self.materials.push(SolidMaterial { name, elasticity: None });
                Data::Skip
            }
            "ELASTIC" if is_isotropic(keyword) => Data::Elastic { lines: 0 },
            "BOUNDARY" => {
                self.has_boundary = true;
                Data::Skip
            }
            _ => Data::Skip,
        })
    }

    fn data_line(
        &mut self,
        data: &mut Data,
        element: &mut Option<RawElement>,
        bytes: &[u8],
        cursor: &mut Cursor<'_>,
        place: Place,
    ) -> Result<(), ImportError> {
        let number = place.source;
        match data {
            Data::Skip => Ok(()),
            Data::Nodes { set } => {
                let line = "`id, x, y, z`";
                let read = read_node(cursor, line);
                let (id, position) = read.map_err(|defect| self.sources[number].defect(&defect, 0))?;
                self.count(1, place)?;
                let mesh = self.mesh();
                mesh.ids.push(id);
                mesh.positions.push(position);
                mesh.places.push(place);
                if let Some(name) = set {
                    let open = mesh.sets.last().is_some_and(|last| last.name == *name);
                    if !open {
                        let name = name.clone();
                        mesh.sets.push(RawSet { name, instance: None, members: Vec::new() });
                    }
                    if let Some(last) = mesh.sets.last_mut() {
                        last.members.push((Member::Label(id), place));
                    }
                }
                Ok(())
            }
            Data::Elements { kind } => {
                let wanted = kind.map_or(usize::MAX, |(_, nodes)| nodes);
                let mut continued = element.is_some();
                let mut current = element.take().unwrap_or(RawElement {
                    kind: kind.map(|(kind, _)| kind),
                    nodes: Vec::new(),
                    place,
                });
                let line = line_fields(bytes, cursor);
                for token in &line.fields {
                    match token.parse::<u64>() {
                        Ok(_) if !continued => continued = true, // the element's own label
                        Ok(node) => current.nodes.push(node),
                        Err(_) if kind.is_none() => {}
                        Err(_) => {
                            let expected = "element and node ids (integers)";
                            return Err(self.sources[number].expected(place.at, expected));
                        }
                    }
                }
                let more = if kind.is_some() { current.nodes.len() < wanted } else { line.open };
                if more {
                    *element = Some(current);
                } else if kind.is_some() && current.nodes.len() > wanted {
                    let expected = format!("{wanted} nodes (here: {})", current.nodes.len());
                    return Err(self.sources[number].expected(place.at, expected));
                } else {
                    self.mesh().elements.push(current);
                }
                Ok(())
            }
            Data::Set { generate } => {
                let members = set_members(&line_fields(bytes, cursor).fields, *generate);
                let Some(members) = members else {
                    return Err(
                        self.sources[number].expected(place.at, "`first, last, step` of a node range")
                    );
                };
                if let Some(set) = self.mesh().sets.last_mut() {
                    set.members.extend(members.into_iter().map(|member| (member, place)));
                }
                Ok(())
            }
            Data::Elastic { lines } => {
                let fields = line_fields(bytes, cursor).fields;
                let read: Option<Vec<f64>> = fields.iter().take(2).map(|field| decimal(field)).collect();
                let elasticity = match read.as_deref() {
                    Some(&[youngs_modulus, poisson_ratio]) => {
                        Some(Elasticity { youngs_modulus, poisson_ratio })
                    }
                    _ => None,
                };
                // Constants on more lines are those of other temperatures.
                if let Some(material) = self.materials.last_mut() {
                    material.elasticity = elasticity.filter(|_| *lines == 0);
                }
                *lines += 1;
                Ok(())
            }
            Data::Placement { lines } => {
                let read: Option<Vec<f64>> =
                    line_fields(bytes, cursor).fields.iter().map(|field| field.parse().ok()).collect();
                let finite = read.filter(|values| values.iter().all(|value: &f64| value.is_finite()));
                let placement = &mut self.mesh().placement;
                match (*lines, finite.as_deref()) {
                    (0, Some(&[x, y, z])) => {
                        *placement = Placement { translation: [x, y, z], rotation: None }
                    }
                    (1, Some(&[ax, ay, az, bx, by, bz, angle])) => {
                        placement.rotation = Some(([ax, ay, az], [bx, by, bz], angle));
                    }
                    _ => {
                        let expected = "a translation of 3 numbers, then a rotation of 7 numbers";
                        return Err(self.sources[number].expected(place.at, expected));
                    }
                }
                *lines += 1;
                Ok(())
            }
        }
    }

    /// An element that a keyword or the end of the file interrupts.
    fn refuse_short_element(&mut self, element: Option<RawElement>) -> Result<(), ImportError> {
        match element {
            Some(RawElement { kind: Some(_), nodes, place }) => {
                let expected = format!("an element with all its nodes (only {} given)", nodes.len());
                Err(self.sources[place.source].expected(place.at, expected))
            }
            Some(other) => {
                self.mesh().elements.push(other);
                Ok(())
            }
            None => Ok(()),
        }
    }
}

fn is_isotropic(keyword: &Keyword) -> bool {
    keyword.get("TYPE").is_none_or(|kind| kind.to_uppercase().starts_with("ISO"))
}

/// A number, which Fortran may have written as `2.1D11`.
fn decimal(field: &str) -> Option<f64> {
    field.replace(['d', 'D'], "e").parse().ok().filter(|value: &f64| value.is_finite())
}

fn read_node(
    cursor: &mut Cursor<'_>,
    line: &'static str,
) -> Result<(u64, [f64; 3]), crate::import::text::cursor::Defect> {
    let id = cursor.unsigned(line)?;
    let mut position = [0.0; 3];
    for coordinate in &mut position {
        cursor.skip_separators();
        // Coordinates at the end of a line may be left out and are zero.
        if cursor.at_line_end() {
            break;
        }
        *coordinate = cursor.float(line)?;
    }
    Ok((id, position))
}
