//! Physical groups of gmsh: which entities they hold, and their names.

use std::collections::BTreeMap;

/// Dimension and tag of an entity or a physical group.
pub(super) type Tag = (u8, u64);

/// Physical groups of a file.
#[derive(Debug, Default)]
pub(super) struct Groups {
    names: BTreeMap<Tag, String>,
    /// Groups of each entity (format 4.1).
    of_entity: BTreeMap<Tag, Vec<u64>>,
}

impl Groups {
    pub(super) fn set_name(&mut self, group: Tag, name: String) {
        self.names.insert(group, name);
    }

    pub(super) fn set_entity(&mut self, entity: Tag, groups: Vec<u64>) {
        self.of_entity.insert(entity, groups);
    }

    /// Names of the groups that an entity belongs to.
    pub(super) fn names_of(&self, (dimension, tag): Tag) -> Vec<String> {
        let groups = self.of_entity.get(&(dimension, tag)).map_or(&[][..], Vec::as_slice);
        groups.iter().map(|&group| self.name((dimension, group))).collect()
    }

    /// The name of a group, or one made of its dimension and tag.
    pub(super) fn name(&self, group: Tag) -> String {
        self.names.get(&group).cloned().unwrap_or_else(|| {
            let (dimension, tag) = group;
            let word =
                ["point", "curve", "surface", "volume"].get(usize::from(dimension)).unwrap_or(&"group");
            format!("{word}_{tag}")
        })
    }
}
