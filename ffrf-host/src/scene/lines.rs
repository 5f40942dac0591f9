//! On which line of a scene file each key stands.

use std::collections::BTreeMap;

use toml::de::{DeTable, DeValue};

/// Lines of keys by their paths, as in `bodies.rod.mass`; counted from one.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Lines(BTreeMap<String, usize>);

impl Lines {
    /// Of every key in a parsed text.
    pub(super) fn of(text: &str, table: &DeTable<'_>) -> Self {
        let mut lines = BTreeMap::new();
        collect(text, "", table, &mut lines);
        Self(lines)
    }

    /// The line of a key, or of the closest table around it that the file has.
    pub fn of_key(&self, key: &str) -> Option<usize> {
        let mut path = key;
        loop {
            if let Some(line) = self.0.get(path) {
                return Some(*line);
            }
            path = path.rsplit_once('.')?.0;
        }
    }
}

/// The line of a place in a text, counted from one.
pub(super) fn line_at(text: &str, place: usize) -> usize {
    1 + text.bytes().take(place).filter(|byte| *byte == b'\n').count()
}

fn collect(text: &str, path: &str, table: &DeTable<'_>, lines: &mut BTreeMap<String, usize>) {
    for (key, value) in table {
        let name = key.get_ref();
        let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
        lines.entry(path.clone()).or_insert_with(|| line_at(text, key.span().start));
        if let DeValue::Table(inner) = value.get_ref() {
            collect(text, &path, inner, lines);
        }
    }
}
