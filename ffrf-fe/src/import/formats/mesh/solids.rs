//! What a mesh file supplies, gathered while it is read.

use std::collections::hash_map::Entry;
use std::collections::{BTreeMap, HashMap};

use crate::import::ImportError;
use crate::import::nodes::{NodeLookup, NodeTable};
use crate::import::text::source::Source;
use crate::{Element, ElementKind, Nodes};

/// Members of all groups, counted as often as they are named: some times a large model.
const MOST_MEMBERS: usize = 200_000_000;

/// Nodes, solids and named groups.
#[derive(Default)]
pub(super) struct Solids {
    pub(super) nodes: Nodes,
    pub(super) lookup: Option<NodeLookup>,
    elements: Vec<Element>,
    /// Where each element stands in the file.
    places: Vec<usize>,
    /// Rows of each named group, neither sorted nor each once.
    groups: BTreeMap<String, Vec<usize>>,
    /// Elements of each named group, neither sorted nor each once.
    element_groups: BTreeMap<String, Vec<usize>>,
    members: usize,
    /// Number of the element with these nodes, to find those that come twice.
    seen: HashMap<Vec<usize>, usize>,
}

impl Solids {
    /// Nodes without elements yet.
    pub(super) fn of(nodes: Nodes) -> Self {
        Self { nodes, ..Self::default() }
    }

    /// Closes the node table; node ids can be looked up from now on.
    pub(super) fn close_nodes(&mut self, source: &Source, places: &[usize]) -> Result<(), ImportError> {
        let mut sorted: Vec<(u64, usize)> =
            self.nodes.ids.iter().enumerate().map(|(row, &id)| (id, row)).collect();
        sorted.sort_unstable();
        if let Some(&[_, (id, row)]) = sorted.array_windows().find(|[one, next]| one.0 == next.0) {
            let line = source.line_of(places[row]);
            return Err(ImportError::DuplicateNode { path: source.path().to_path_buf(), line, id });
        }
        self.lookup = Some(NodeLookup::new(&self.nodes.ids));
        Ok(())
    }

    /// The row of a node.
    pub(super) fn row(&self, source: &Source, id: u64, place: usize) -> Result<usize, ImportError> {
        let Some(lookup) = &self.lookup else {
            return Err(source.expected(place, "the nodes before the elements"));
        };
        lookup.row(id).ok_or_else(|| ImportError::UnknownNode {
            path: source.path().to_path_buf(),
            line: source.line_of(place),
            id,
            nodes: lookup.len(),
        })
    }

    /// Adds a solid and gives its number; that of the other one as the error if another one has the same nodes.
    pub(super) fn add(&mut self, kind: ElementKind, nodes: Vec<usize>, place: usize) -> Result<usize, usize> {
        let mut corners = nodes.clone();
        corners.sort_unstable();
        match self.seen.entry(corners) {
            Entry::Occupied(other) => Err(*other.get()),
            Entry::Vacant(entry) => {
                let number = *entry.insert(self.elements.len());
                self.elements.push(Element { kind, nodes });
                self.places.push(place);
                Ok(number)
            }
        }
    }

    /// Adds solids to a group.
    pub(super) fn extend_element_group(&mut self, name: &str, numbers: &[usize]) {
        match self.element_groups.get_mut(name) {
            Some(group) => group.extend_from_slice(numbers),
            None => drop(self.element_groups.insert(name.to_owned(), numbers.to_vec())),
        }
    }

    /// Adds nodes to a group.
    pub(super) fn extend_group(
        &mut self,
        source: &Source,
        name: &str,
        rows: &[usize],
        place: usize,
    ) -> Result<(), ImportError> {
        self.members += rows.len();
        if self.members > MOST_MEMBERS {
            return Err(ImportError::TooMany {
                path: source.path().to_path_buf(),
                line: source.line_of(place),
                what: "nodes of physical groups",
                limit: MOST_MEMBERS as u64,
                found: self.members as u64,
            });
        }
        match self.groups.get_mut(name) {
            Some(group) => group.extend_from_slice(rows),
            None => drop(self.groups.insert(name.to_owned(), rows.to_vec())),
        }
        Ok(())
    }

    /// The node table.
    pub(super) fn finish(self, source: &Source) -> Result<NodeTable, ImportError> {
        let Self { mut nodes, elements, places, groups, mut element_groups, .. } = self;
        let mut attached = vec![false; nodes.len()];
        for &row in elements.iter().flat_map(|element| &element.nodes) {
            attached[row] = true;
        }
        for (name, mut rows) in groups {
            rows.sort_unstable();
            rows.dedup();
            nodes.sets.insert(name, rows);
        }
        for numbers in element_groups.values_mut() {
            numbers.sort_unstable();
            numbers.dedup();
        }
        let attached = (!elements.is_empty()).then_some(attached);
        let element_sets = element_groups;
        NodeTable { nodes, elements, element_places: places, element_sets, attached, ..NodeTable::default() }
            .check_size(source)
    }
}
