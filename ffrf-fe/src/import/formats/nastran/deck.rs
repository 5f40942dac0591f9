//! Nastran bulk data: `GRID`, solid elements, `MAT1` and `SET1`. Other entries are skipped, except those that would change these.
//!
//! Source: MSC Nastran Quick Reference Guide, bulk data entries.

use std::collections::BTreeMap;

use super::card::{Card, visit_cards};
use crate::import::ImportError;
use crate::import::nodes::{NodeLookup, NodeTable};
use crate::import::text::source::Source;
use crate::{Elasticity, Element, ElementKind, Nodes, SolidMaterial};

/// Nodes of all elements and members of all sets: some times a large model.
const MOST_ITEMS: u64 = 200_000_000;

/// Order of the nodes of `CHEXA` as Abaqus and CalculiX have them: the middles of the upright edges come last there.
const HEXAHEDRON_20: [usize; 20] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15];

/// A solid element or a set in ids.
struct Listed {
    /// `None`: the nodes are marked as belonging to an element.
    kind: Option<ElementKind>,
    /// Ids with their places.
    nodes: Vec<(u64, usize)>,
}

/// What was read so far.
#[derive(Default)]
struct Deck {
    nodes: Nodes,
    places: Vec<usize>,
    elements: Vec<Listed>,
    sets: BTreeMap<u64, Vec<(u64, u64, usize)>>,
    materials: Vec<SolidMaterial>,
    items: u64,
}

/// Reads a deck, with or without executive and case control before `BEGIN BULK`.
pub(crate) fn read(source: &Source) -> Result<NodeTable, ImportError> {
    let mut deck = Deck::default();
    visit_cards(source, start_of_bulk(source.bytes()), |card| deck.take(source, card))?;
    let Deck { mut nodes, places, elements: listed, sets, materials, .. } = deck;
    // matrices without labels follow ascending numbers of grid points
    let mut order: Vec<usize> = (0..nodes.len()).collect();
    order.sort_by_key(|&row| nodes.ids[row]);
    if let Some(&[_, row]) = order.array_windows().find(|&&[one, next]| nodes.ids[one] == nodes.ids[next]) {
        let (line, id) = (source.line_of(places[row]), nodes.ids[row]);
        return Err(ImportError::DuplicateNode { path: source.path().to_path_buf(), line, id });
    }
    nodes.ids = order.iter().map(|&row| nodes.ids[row]).collect();
    nodes.positions = order.iter().map(|&row| nodes.positions[row]).collect();
    let lookup = NodeLookup::new(&nodes.ids);
    let row_of = |&(id, place): &(u64, usize)| {
        lookup.row(id).ok_or_else(|| ImportError::UnknownNode {
            path: source.path().to_path_buf(),
            line: source.line_of(place),
            id,
            nodes: lookup.len(),
        })
    };
    let mut attached = vec![false; nodes.len()];
    let has_elements = !listed.is_empty();
    let mut elements = Vec::new();
    for Listed { kind, nodes } in listed {
        let rows: Vec<usize> = nodes.iter().map(row_of).collect::<Result<_, _>>()?;
        for &row in &rows {
            attached[row] = true;
        }
        elements.extend(kind.map(|kind| Element { kind, nodes: rows }));
    }
    let mut members = 0;
    for (id, ranges) in sets {
        let mut rows = Vec::new();
        for (first, last, place) in ranges {
            if first == last {
                rows.push(row_of(&(first, place))?);
            } else {
                let from = nodes.ids.partition_point(|&id| id < first);
                let to = nodes.ids.partition_point(|&id| id <= last);
                members += (to - from) as u64;
                refuse_many(source, place, members)?;
                rows.extend(from..to);
            }
        }
        rows.sort_unstable();
        rows.dedup();
        nodes.sets.insert(format!("SET{id}"), rows);
    }
    let attached = has_elements.then_some(attached);
    NodeTable { nodes, elements, materials, attached, ..NodeTable::default() }.check_size(source)
}

/// Where the bulk data starts: behind the line `BEGIN BULK`, if there is one.
fn start_of_bulk(bytes: &[u8]) -> usize {
    let mut at = 0;
    for line in bytes.split_inclusive(|&byte| byte == b'\n') {
        at += line.len();
        let mut words = line.split(|byte| byte.is_ascii_whitespace()).filter(|word| !word.is_empty());
        let is = |word: Option<&[u8]>, name: &[u8]| word.is_some_and(|word| word.eq_ignore_ascii_case(name));
        if is(words.next(), b"BEGIN") && is(words.next(), b"BULK") {
            return at;
        }
    }
    0
}

/// Refuses the first count beyond the limit.
fn refuse_many(source: &Source, at: usize, found: u64) -> Result<(), ImportError> {
    if found <= MOST_ITEMS {
        return Ok(());
    }
    Err(ImportError::TooMany {
        path: source.path().to_path_buf(),
        line: source.line_of(at),
        what: "nodes of elements and sets",
        limit: MOST_ITEMS,
        found,
    })
}

impl Deck {
    fn take(&mut self, source: &Source, card: &Card<'_>) -> Result<(), ImportError> {
        let name = card.name();
        match name.as_str() {
            "GRID" => self.grid(source, card),
            "CTETRA" => {
                self.solid(source, card, &[(4, ElementKind::Tetrahedron4), (10, ElementKind::Tetrahedron10)])
            }
            "CHEXA" => {
                self.solid(source, card, &[(8, ElementKind::Hexahedron8), (20, ElementKind::Hexahedron20)])
            }
            "CPENTA" => self.solid(source, card, &[(6, ElementKind::Wedge6)]),
            "MAT1" => self.material(source, card),
            "SET1" => self.set(source, card),
            "GRDSET" => Err(unsupported(source, card, "write the coordinate systems into each GRID")),
            _ if name.starts_with("INCLUDE") => Err(unsupported(source, card, "join the files of the deck")),
            "CPYRAM" => Err(unsupported(source, card, "use CTETRA, CHEXA and CPENTA")),
            _ => Ok(()),
        }
    }

    fn grid(&mut self, source: &Source, card: &Card<'_>) -> Result<(), ImportError> {
        let id = card.number(source, 1, "the number of a grid point")?;
        for (field, advice) in [
            (2, "a position in basic coordinates (CP empty or 0)"),
            (6, "displacements in basic coordinates (CD empty or 0), in which the matrices must be"),
        ] {
            if !matches!(card.text(field), "" | "0") {
                return Err(source.expected(card.place(field), advice));
            }
        }
        let mut position = [0.0; 3];
        for (coordinate, field) in position.iter_mut().zip(3..) {
            if !card.text(field).is_empty() {
                *coordinate = card.real(source, field)?;
            }
        }
        self.nodes.ids.push(id);
        self.nodes.positions.push(position);
        self.places.push(card.place(1));
        Ok(())
    }

    fn solid(
        &mut self,
        source: &Source,
        card: &Card<'_>,
        kinds: &[(usize, ElementKind)],
    ) -> Result<(), ImportError> {
        let last = (3..card.len()).rev().find(|&field| !card.text(field).is_empty()).unwrap_or(2);
        let mut nodes = Vec::with_capacity(last - 2);
        for field in 3..=last {
            nodes.push((card.number(source, field, "the number of a grid point")?, card.place(field)));
        }
        let Some(&(_, kind)) = kinds.iter().find(|&&(count, _)| count == nodes.len()) else {
            let counts: Vec<String> = kinds.iter().map(|(count, _)| count.to_string()).collect();
            let expected =
                format!("{} grid points of {}, found {}", counts.join(" or "), card.name(), nodes.len());
            return Err(source.expected(card.place(0), expected));
        };
        if kind == ElementKind::Hexahedron20 {
            nodes = HEXAHEDRON_20.iter().map(|&place| nodes[place]).collect();
        }
        self.count(source, card, nodes.len())?;
        self.elements.push(Listed { kind: Some(kind), nodes });
        Ok(())
    }

    /// E and ν, or one of them from G = E / (2 (1 + ν)).
    fn material(&mut self, source: &Source, card: &Card<'_>) -> Result<(), ImportError> {
        let id = card.number(source, 1, "the number of a material")?;
        let given =
            |field: usize| (!card.text(field).is_empty()).then(|| card.real(source, field)).transpose();
        let (young, shear, poisson) = (given(2)?, given(3)?, given(4)?);
        let elasticity = match (young, shear, poisson) {
            (Some(youngs_modulus), _, Some(poisson_ratio)) => {
                Some(Elasticity { youngs_modulus, poisson_ratio })
            }
            (Some(youngs_modulus), Some(shear), None) if shear > 0.0 => {
                Some(Elasticity { youngs_modulus, poisson_ratio: youngs_modulus / (2.0 * shear) - 1.0 })
            }
            (None, Some(shear), Some(poisson_ratio)) => {
                Some(Elasticity { youngs_modulus: 2.0 * shear * (1.0 + poisson_ratio), poisson_ratio })
            }
            _ => None,
        };
        self.materials.push(SolidMaterial { name: format!("MAT1 {id}"), elasticity });
        Ok(())
    }

    /// `SET1 SID ID1 ID2 ...` or with `ID1 THRU ID2`.
    fn set(&mut self, source: &Source, card: &Card<'_>) -> Result<(), ImportError> {
        let id = card.number(source, 1, "the number of a set")?;
        let expected = "the number of a grid point, or THRU between two";
        let mut members: Vec<(u64, u64, usize)> = Vec::new();
        let mut through = false;
        for field in (2..card.len()).filter(|&field| !card.text(field).is_empty()) {
            if card.text(field).eq_ignore_ascii_case("THRU") && !through && !members.is_empty() {
                through = true;
                continue;
            }
            let number = card.number(source, field, expected)?;
            match members.last_mut() {
                Some(range) if through && range.0 < number => range.1 = number,
                Some(_) if through => {
                    return Err(source.expected(card.place(field), "a larger number behind THRU"));
                }
                _ => members.push((number, number, card.place(field))),
            }
            through = false;
        }
        self.count(source, card, members.len())?;
        self.sets.entry(id).or_default().extend(members);
        Ok(())
    }

    fn count(&mut self, source: &Source, card: &Card<'_>, items: usize) -> Result<(), ImportError> {
        self.items += items as u64;
        refuse_many(source, card.place(0), self.items)
    }
}

fn unsupported(source: &Source, card: &Card<'_>, advice: &'static str) -> ImportError {
    let feature = card.text(0).to_owned();
    let line = source.line_of(card.place(0));
    ImportError::Unsupported { path: source.path().to_path_buf(), line, feature, advice }
}
