//! Entries of Nastran's bulk data: fields of 8 or 16 characters, or with commas between, over several lines.

use crate::import::ImportError;
use crate::import::text::source::Source;

/// Width of a small field, and of the first and last of a line with large ones.
const SMALL: usize = 8;
/// Width of a large field.
const LARGE: usize = 16;

/// One entry: the text of each field, and where it stands in the file. The name of the entry is field 0.
#[derive(Default)]
pub(super) struct Card<'a> {
    fields: Vec<(&'a str, usize)>,
    start: usize,
}

impl<'a> Card<'a> {
    /// The name in upper case, without the mark of large fields.
    pub(super) fn name(&self) -> String {
        self.text(0).trim_end_matches('*').trim_end().to_ascii_uppercase()
    }

    /// The text of a field without blanks; empty if there is none.
    pub(super) fn text(&self, field: usize) -> &'a str {
        self.fields.get(field).map_or("", |&(text, _)| text)
    }

    /// Where a field stands, or its entry if it does not.
    pub(super) fn place(&self, field: usize) -> usize {
        self.fields.get(field).map_or(self.start, |&(_, place)| place)
    }

    /// Number of fields.
    pub(super) fn len(&self) -> usize {
        self.fields.len()
    }

    /// A positive integer.
    pub(super) fn number(&self, source: &Source, field: usize, expected: &str) -> Result<u64, ImportError> {
        match self.text(field).parse() {
            Ok(number) if number > 0 => Ok(number),
            _ => Err(source.expected(self.place(field), expected)),
        }
    }

    /// A finite real number as Nastran writes it: `1.5D+3` and `1.5+3` as well.
    pub(super) fn real(&self, source: &Source, field: usize) -> Result<f64, ImportError> {
        let text = self.text(field).replace(['D', 'd'], "E");
        let exponent = text
            .char_indices()
            .skip(1)
            .find(|&(at, sign)| matches!(sign, '+' | '-') && !text[..at].ends_with(['E', 'e']));
        let text = match exponent {
            Some((at, _)) => format!("{}E{}", &text[..at], &text[at..]),
            None => text,
        };
        let is_number = text.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first));
        match text.parse::<f64>() {
            Ok(value) if value.is_finite() && is_number => Ok(value),
            _ => Err(source.expected(self.place(field), "a finite real number")),
        }
    }
}

/// Hands the entries from a place of the file on to `visit`, one after the other, until the end of the file or `ENDDATA`.
pub(super) fn visit_cards<'a>(
    source: &'a Source,
    from: usize,
    mut visit: impl FnMut(&Card<'a>) -> Result<(), ImportError>,
) -> Result<(), ImportError> {
    let mut card = Card::default();
    let mut start = from;
    for whole in source.bytes()[from..].split_inclusive(|&byte| byte == b'\n') {
        let place = start;
        start += whole.len();
        let line = whole.split(|&byte| byte == b'$').next().unwrap_or_default().trim_ascii_end();
        if line.is_empty() {
            continue;
        }
        let line = match std::str::from_utf8(line) {
            Ok(line) if line.is_ascii() && !line.contains('\0') => line,
            _ => return Err(source.expected(place, "a line of ASCII text (outside of comments)")),
        };
        let (name, data) = fields(line, place);
        if name.is_empty() || name.starts_with(['+', '*']) {
            if card.fields.is_empty() {
                return Err(source.expected(place, "an entry of the bulk data before its continuation"));
            }
            card.fields.extend(data);
            continue;
        }
        if !card.fields.is_empty() {
            visit(&card)?;
        }
        if name.eq_ignore_ascii_case("ENDDATA") {
            return Ok(());
        }
        card.fields.clear();
        card.start = place;
        card.fields.push((name, place));
        card.fields.extend(data);
    }
    if card.fields.is_empty() { Ok(()) } else { visit(&card) }
}

/// The name on a line, and its fields of data with their places. Marks of continuation are left out, and fields that are empty at
/// the end of a line are kept, as they count.
fn fields(line: &str, start: usize) -> (&str, Vec<(&str, usize)>) {
    let trimmed = |from: usize, to: usize| {
        let text = line.get(from..to.min(line.len())).unwrap_or("");
        let blanks = text.len() - text.trim_start().len();
        (text.trim(), start + from.min(line.len()) + blanks)
    };
    if line.contains(',') {
        let mut from = 0;
        let ends = line.match_indices(',').map(|(at, _)| at).chain([line.len()]);
        let mut fields = ends.map(|to| {
            let field = trimmed(from, to);
            from = to + 1;
            field
        });
        let (name, _) = fields.next().unwrap_or(("", start));
        let mut data: Vec<_> = fields.collect();
        data.resize(if is_large(name) { 4 } else { 8 }, ("", start + line.len()));
        return (name, data);
    }
    let (name, _) = trimmed(0, SMALL);
    let (width, count) = if is_large(name) { (LARGE, 4) } else { (SMALL, 8) };
    (name, (0..count).map(|k| trimmed(SMALL + k * width, SMALL + (k + 1) * width)).collect())
}

fn is_large(name: &str) -> bool {
    name.ends_with('*') || name.starts_with('*')
}
