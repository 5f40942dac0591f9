//! On which line of a scene file each key stands.

use std::collections::BTreeMap;

use toml::de::{DeTable, DeValue};

/// Lines of keys by their paths, as in `bodies.rod.mass`; counted from one.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Lines(BTreeMap<String, usize>);

impl Lines {
    /// Of every key in a parsed text.
    pub(super) fn of(text: &str, table: &DeTable<'_>) -> Self {
        let ends: Vec<usize> = text.match_indices('\n').map(|(place, _)| place).collect();
        let mut lines = BTreeMap::new();
        collect(&ends, "", table, &mut lines);
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

/// `ends`: where lines end in the text.
fn collect(ends: &[usize], path: &str, table: &DeTable<'_>, lines: &mut BTreeMap<String, usize>) {
    for (key, value) in table {
        let name = key.get_ref();
        let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
        lines.entry(path.clone()).or_insert_with(|| 1 + ends.partition_point(|end| *end < key.span().start));
        if let DeValue::Table(inner) = value.get_ref() {
            collect(ends, &path, inner, lines);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_stand_on_their_lines() {
        let text = "# first\n[a]\nb = 1\n\n[a.c]\nd = [\n 1,\n]\ne.f = 2\n";
        let lines = Lines::of(text, DeTable::parse(text).unwrap().get_ref());
        let found = ["a", "a.b", "a.c.d", "a.c.e.f", "a.c.g", "a.c.d.h", "x"].map(|key| lines.of_key(key));
        assert_eq!(found, [Some(2), Some(3), Some(6), Some(9), Some(5), Some(6), None]);
        assert_eq!(line_at(text, 8), 2);
    }
}
