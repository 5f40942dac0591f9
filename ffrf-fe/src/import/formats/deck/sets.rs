//! From node sets in labels, names and ranges to row numbers.

use std::collections::{BTreeMap, HashMap};

use super::limits;
use super::mesh::{Member, Place, RawSet};
use super::placed::{Placed, unknown};
use crate::import::ImportError;
use crate::import::text::source::Source;

/// Row numbers of a set are sorted and freed of repetitions whenever they have doubled, from this number on.
const FEW: usize = 64;

/// All sets of a deck, in row numbers, sorted.
pub(super) fn sets(
    placed: &[Placed<'_>],
    sources: &[Source],
) -> Result<BTreeMap<String, Vec<usize>>, ImportError> {
    let mut reader = SetReader::new(placed, sources);
    for part in placed {
        for set in &part.mesh.sets {
            let prefixed = reader.several && !part.mesh.name.is_empty();
            let name = if prefixed { format!("{}.{}", part.mesh.name, set.name) } else { set.name.clone() };
            reader.read(&name, set, part)?;
        }
    }
    Ok(reader.sets)
}

struct SetReader<'a> {
    sources: &'a [Source],
    /// Instances by name, upper case; of equal names the first.
    instances: HashMap<String, &'a Placed<'a>>,
    /// More than one instance: their sets have the name of the instance in front.
    several: bool,
    sets: BTreeMap<String, Vec<usize>>,
    /// Set names as first written, by upper case.
    names: HashMap<String, String>,
    /// Members met so far.
    members: usize,
}

impl<'a> SetReader<'a> {
    fn new(placed: &'a [Placed<'a>], sources: &'a [Source]) -> Self {
        let mut instances = HashMap::new();
        for part in placed {
            instances.entry(part.mesh.name.to_uppercase()).or_insert(part);
        }
        let several = placed.iter().filter(|part| !part.mesh.name.is_empty()).count() > 1;
        Self { sources, instances, several, sets: BTreeMap::new(), names: HashMap::new(), members: 0 }
    }

    fn read(&mut self, name: &str, set: &RawSet, own: &'a Placed<'a>) -> Result<(), ImportError> {
        let part = match (&set.instance, set.members.first()) {
            (Some(instance), Some(&(_, Place { source, at }))) => {
                self.instances.get(&instance.to_uppercase()).copied().ok_or_else(|| {
                    self.sources[source].expected(at, format!("a set of a known instance (not `{instance}`)"))
                })?
            }
            _ => own,
        };
        let mut rows = Rows::default();
        for (member, place) in &set.members {
            let before = rows.met;
            self.add(&mut rows, member, *place, part)?;
            self.members += rows.met - before;
            let source = &self.sources[place.source];
            limits::at_most(limits::SET_MEMBERS, self.members, "members of node sets", source, place.at)?;
        }
        self.names.entry(name.to_uppercase()).or_insert_with(|| name.to_owned());
        let known = self.sets.entry(name.to_owned()).or_default();
        known.append(&mut rows.rows);
        known.sort_unstable();
        known.dedup();
        Ok(())
    }

    fn add(
        &self,
        rows: &mut Rows,
        member: &Member,
        place: Place,
        part: &Placed<'_>,
    ) -> Result<(), ImportError> {
        match member {
            Member::Label(label) => {
                rows.push(part.row(*label).ok_or_else(|| unknown(self.sources, place, *label, part))?);
            }
            Member::Range(first, last, step) => {
                // A range may name labels that do not exist: Abaqus takes those that do.
                let (from, to) = part.labels_between(*first, *last);
                for &label in part.labels.get(from..to).unwrap_or_default() {
                    rows.met += 1;
                    if (label - first).is_multiple_of(*step) {
                        rows.rows.extend(part.row(label));
                    }
                }
                rows.tidy();
            }
            Member::Name(name) => {
                let in_instance = name.rsplit_once('.').and_then(|(instance, label)| {
                    self.instances.get(&instance.to_uppercase())?.row(label.parse().ok()?)
                });
                let by_name = || self.sets.get(self.names.get(&name.to_uppercase())?);
                match (in_instance, by_name()) {
                    (Some(row), _) => rows.push(row),
                    (None, Some(others)) => {
                        rows.met += others.len().max(1);
                        rows.rows.extend(others);
                        rows.tidy();
                    }
                    (None, None) => {
                        let expected = "a node id or the name of a node set given before";
                        return Err(self.sources[place.source].expected(place.at, expected));
                    }
                }
            }
        }
        Ok(())
    }
}

/// Row numbers that are gathered; memory stays in proportion to the different ones.
#[derive(Default)]
struct Rows {
    rows: Vec<usize>,
    /// Members met, repetitions counted.
    met: usize,
    /// Different rows when they were last counted.
    different: usize,
}

impl Rows {
    fn push(&mut self, row: usize) {
        self.met += 1;
        self.rows.push(row);
        self.tidy();
    }

    fn tidy(&mut self) {
        if self.rows.len() > 2 * self.different.max(FEW) {
            self.rows.sort_unstable();
            self.rows.dedup();
            self.different = self.rows.len();
        }
    }
}
