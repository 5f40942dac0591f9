//! Record groups of MBDyn's modal data files.

use std::collections::BTreeMap;

use crate::import::ImportError;
use crate::import::text::cursor::Cursor;
use crate::import::text::source::Source;

/// More than a modal joint has; each takes a row of every square matrix.
const MOST_MODES: usize = 10_000;

const GROUP: &[u8] = b"** RECORD GROUP";

/// The record groups of a file.
pub(super) struct Records<'a> {
    source: &'a Source,
    /// Where each group starts and ends: its first line of data, and the next group.
    groups: BTreeMap<usize, (usize, usize)>,
    pub(super) labels: Vec<&'a str>,
    pub(super) nodes: usize,
    pub(super) modes: usize,
}

impl<'a> Records<'a> {
    /// Finds the groups, and reads the first two.
    pub(super) fn read(source: &'a Source) -> Result<Self, ImportError> {
        let bytes = source.bytes();
        let mut groups = BTreeMap::new();
        let mut last = None;
        let mut at = 0;
        for line in bytes.split_inclusive(|&byte| byte == b'\n') {
            let start = at;
            at += line.len();
            let Some(rest) = line.strip_prefix(GROUP) else { continue };
            let digits =
                rest.trim_ascii_start().split(|byte| !byte.is_ascii_digit()).next().unwrap_or_default();
            let Some(number) = std::str::from_utf8(digits).ok().and_then(|text| text.parse::<usize>().ok())
            else {
                return Err(source.expected(start, "`** RECORD GROUP N`"));
            };
            if let Some(last) = last.replace(number)
                && let Some((_, end)) = groups.get_mut(&last)
            {
                *end = start;
            }
            if groups.insert(number, (at, bytes.len())).is_some() {
                return Err(source.expected(start, "each record group once"));
            }
        }
        let mut records = Self { source, groups, labels: Vec::new(), nodes: 0, modes: 0 };
        let header = records.words(1)?;
        let counts: Vec<usize> = header.iter().skip(1).map_while(|(word, _)| word.parse().ok()).collect();
        let &[nodes, normal, attached, constraint, rejected] = counts.as_slice() else {
            return Err(records.fault(1, "a revision and the numbers of nodes, of normal, attachment and constraint modes, and of rejected ones"));
        };
        let modes = [attached, constraint].into_iter().try_fold(normal, usize::checked_add);
        let Some(modes) = modes
            .and_then(|modes| modes.checked_sub(rejected))
            .filter(|modes| (1..=MOST_MODES).contains(modes))
        else {
            return Err(records.fault(1, format!("1 to {MOST_MODES} modes")));
        };
        records.labels = records.words(2)?.into_iter().map(|(word, _)| word).collect();
        if records.labels.len() != nodes {
            return Err(records.fault(2, format!("{nodes} labels of nodes, found {}", records.labels.len())));
        }
        (records.nodes, records.modes) = (nodes, modes);
        Ok(records)
    }

    pub(super) fn has(&self, group: usize) -> bool {
        self.groups.contains_key(&group)
    }

    /// Where the data of a group start; the end of the file without it.
    pub(super) fn place(&self, group: usize) -> usize {
        self.groups.get(&group).map_or(self.source.bytes().len(), |&(start, _)| start)
    }

    /// An error about a group.
    pub(super) fn fault(&self, group: usize, expected: impl AsRef<str>) -> ImportError {
        self.source.expected(self.place(group), format!("in record group {group}, {}", expected.as_ref()))
    }

    /// A group that must be there.
    pub(super) fn missing(&self, group: &str) -> ImportError {
        self.source.expected(self.source.bytes().len(), format!("record group {group}"))
    }

    /// The words of a group outside of comments, with their places.
    fn words(&self, group: usize) -> Result<Vec<(&'a str, usize)>, ImportError> {
        let Some(&(start, end)) = self.groups.get(&group) else {
            return Err(self.missing(&group.to_string()));
        };
        let mut words = Vec::new();
        let mut at = start;
        for line in self.source.bytes()[start..end].split_inclusive(|&byte| byte == b'\n') {
            let place = at;
            at += line.len();
            if line.trim_ascii_start().starts_with(b"**") {
                continue;
            }
            let Ok(text) = std::str::from_utf8(line) else {
                return Err(self.source.expected(place, "text"));
            };
            let mut from = 0;
            for word in text.split_ascii_whitespace() {
                let offset = text[from..].find(word).unwrap_or(0) + from;
                from = offset + word.len();
                words.push((word, place + offset));
            }
        }
        Ok(words)
    }

    /// The numbers of a group.
    pub(super) fn numbers(&self, group: usize, count: usize) -> Result<Vec<f64>, ImportError> {
        let words = self.words(group)?;
        if words.len() != count {
            return Err(self.fault(group, format!("{count} numbers, found {}", words.len())));
        }
        let number = |(word, place): (&str, usize)| {
            let mut cursor = Cursor::new(word.as_bytes(), 0);
            let read = cursor.float("a number").and_then(|value| cursor.end_line("a number").map(|()| value));
            read.map_err(|mut defect| {
                defect.at += place;
                self.source.defect(&defect, 0)
            })
        };
        words.into_iter().map(number).collect()
    }
}
