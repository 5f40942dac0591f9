//! From parts and instances to one node table.

use std::collections::BTreeMap;

use super::mesh::{Member, Mesh, Place, RawSet};
use crate::import::nodes::{NodeLookup, NodeTable};
use crate::import::text::source::Source;
use crate::{Element, FeError, Nodes};

/// Where the nodes of one mesh went.
struct Placed<'a> {
    mesh: &'a Mesh,
    /// Row in the whole table of each node of the mesh.
    rows: Vec<usize>,
    lookup: NodeLookup,
}

/// Puts all meshes into one table. Where labels of two instances clash, those of the later one are raised by the
/// largest label before.
pub(super) fn assemble(meshes: Vec<Mesh>, sources: &[Source]) -> Result<NodeTable, FeError> {
    let mut nodes = Nodes::default();
    let mut placed: Vec<Placed<'_>> = Vec::new();
    for mesh in &meshes {
        let lookup = NodeLookup::new(&mesh.ids);
        let clash = placed.iter().any(|other| mesh.ids.iter().any(|&id| other.lookup.row(id).is_some()));
        let raise = if clash { nodes.ids.iter().copied().max().unwrap_or(0) } else { 0 };
        let mut rows = Vec::with_capacity(mesh.ids.len());
        for (local, &id) in mesh.ids.iter().enumerate() {
            // A table keeps the last of equal labels: an earlier one was given again.
            let last = lookup.row(id).unwrap_or(local);
            if last != local {
                if mesh.positions[last] != mesh.positions[local] {
                    let Place { source, at } = mesh.places[last];
                    let path = sources[source].path().to_path_buf();
                    return Err(FeError::DuplicateNode { path, line: sources[source].line_of(at), id });
                }
                rows.push(usize::MAX);
                continue;
            }
            rows.push(nodes.ids.len());
            nodes.ids.push(id + raise);
            nodes.positions.push(mesh.placement.apply(mesh.positions[local]));
        }
        placed.push(Placed { mesh, rows, lookup });
    }
    let elements = elements(&placed, sources, nodes.len())?;
    nodes.sets = sets(&placed, sources, nodes.len())?;
    let attached = meshes.iter().any(|mesh| !mesh.elements.is_empty()).then_some(elements.attached);
    Ok(NodeTable { nodes, elements: elements.drawable, attached, has_boundary: false })
}

impl Placed<'_> {
    fn row(&self, label: u64) -> Option<usize> {
        self.lookup.row(label).map(|local| self.rows[local])
    }
}

struct Elements {
    drawable: Vec<Element>,
    attached: Vec<bool>,
}

fn elements(placed: &[Placed<'_>], sources: &[Source], nodes: usize) -> Result<Elements, FeError> {
    let mut drawable = Vec::new();
    let mut attached = vec![false; nodes];
    for part in placed {
        for element in &part.mesh.elements {
            let mut rows = Vec::with_capacity(element.nodes.len());
            for &label in &element.nodes {
                match part.row(label) {
                    Some(row) => rows.push(row),
                    // Elements of other kinds may hold numbers that are no nodes.
                    None if element.kind.is_none() => {}
                    None => return Err(unknown(sources, element.place, label, part)),
                }
            }
            for &row in &rows {
                attached[row] = true;
            }
            drawable.extend(element.kind.map(|kind| Element { kind, nodes: rows }));
        }
    }
    Ok(Elements { drawable, attached })
}

fn sets(
    placed: &[Placed<'_>],
    sources: &[Source],
    nodes: usize,
) -> Result<BTreeMap<String, Vec<usize>>, FeError> {
    let several = placed.iter().filter(|part| !part.mesh.name.is_empty()).count() > 1;
    let mut sets: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for part in placed {
        for set in &part.mesh.sets {
            let prefixed = several && !part.mesh.name.is_empty();
            let name = if prefixed { format!("{}.{}", part.mesh.name, set.name) } else { set.name.clone() };
            let members = members(set, part, placed, &sets, sources)?;
            sets.entry(name).or_default().extend(members);
        }
    }
    for rows in sets.values_mut() {
        rows.sort_unstable();
        rows.dedup();
        debug_assert!(rows.last().is_none_or(|&row| row < nodes));
    }
    Ok(sets)
}

fn members(
    set: &RawSet,
    own: &Placed<'_>,
    placed: &[Placed<'_>],
    known: &BTreeMap<String, Vec<usize>>,
    sources: &[Source],
) -> Result<Vec<usize>, FeError> {
    let instance = |name: &str| placed.iter().find(|part| part.mesh.name.eq_ignore_ascii_case(name));
    let mut rows = Vec::new();
    let first_place = set.members.first().map(|member| member.1);
    let part = match (&set.instance, first_place) {
        (Some(name), Some(Place { source, at })) => instance(name).ok_or_else(|| {
            sources[source].expected(at, format!("a set of a known instance (not `{name}`)"))
        })?,
        _ => own,
    };
    for (member, place) in &set.members {
        match member {
            Member::Label(label) => {
                rows.push(part.row(*label).ok_or_else(|| unknown(sources, *place, *label, part))?);
            }
            Member::Range(first, last, step) => {
                // A range may name labels that do not exist: Abaqus takes those that do.
                let inside = part.mesh.ids.iter().filter(|&id| (*first..=*last).contains(id));
                let inside = inside.filter(|&id| (id - first) % step == 0);
                rows.extend(inside.filter_map(|&id| part.row(id)));
            }
            Member::Name(name) => {
                let in_instance = name
                    .rsplit_once('.')
                    .and_then(|(instance_name, label)| instance(instance_name)?.row(label.parse().ok()?));
                let by_name =
                    known.iter().find(|(other, _)| other.eq_ignore_ascii_case(name)).map(|(_, rows)| rows);
                match (in_instance, by_name) {
                    (Some(row), _) => rows.push(row),
                    (None, Some(others)) => rows.extend(others),
                    (None, None) => {
                        let expected = "a node id or the name of a node set given before";
                        return Err(sources[place.source].expected(place.at, expected));
                    }
                }
            }
        }
    }
    Ok(rows)
}

fn unknown(sources: &[Source], place: Place, id: u64, part: &Placed<'_>) -> FeError {
    let source = &sources[place.source];
    FeError::UnknownNode {
        path: source.path().to_path_buf(),
        line: source.line_of(place.at),
        id,
        nodes: part.mesh.ids.len(),
    }
}
