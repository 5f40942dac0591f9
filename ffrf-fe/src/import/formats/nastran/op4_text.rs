//! `OUTPUT4` as text.

use super::op4_header::{Header, Visitor};
use crate::import::ImportError;
use crate::import::text::source::Source;

const HEADER: &str = "`columns rows form type name format` of a matrix of OUTPUT4";
const COLUMN: &str = "`column row words` before the entries of a column";

/// True if the first line is the header of a matrix.
pub(super) fn is_text(bytes: &[u8]) -> bool {
    let line = bytes.split(|&byte| byte == b'\n').next().unwrap_or_default();
    line.len() < 120 && line.is_ascii() && parse_header(&String::from_utf8_lossy(line), 0).is_some()
}

/// The header and the width of a number, as its format says: `1P,3E23.16`.
fn parse_header(line: &str, place: usize) -> Option<(Header, usize)> {
    let number = |field: usize| line.get(8 * field..8 * field + 8)?.trim().parse::<i64>().ok();
    let (columns, rows, _form, kind) = (number(0)?, number(1)?, number(2)?, number(3)?);
    let name = line.get(32..40)?.trim().to_owned();
    let (_, width) = line.get(40..)?.trim().rsplit_once(['E', 'D', 'e', 'd'])?;
    let width = width.split('.').next()?.parse::<usize>().ok().filter(|width| (8..=40).contains(width))?;
    let size = |number: i64| u32::try_from(number).ok().filter(|&size| size > 0).map(|size| size as usize);
    let header = Header {
        name,
        rows: size(rows.checked_abs()?)?,
        columns: size(columns)?,
        kind: u64::try_from(kind).ok().filter(|kind| (1..=4).contains(kind))?,
        is_big: rows < 0,
        place,
    };
    Some((header, width))
}

/// Walks over all matrices.
pub(super) fn visit(source: &Source, visitor: &mut impl Visitor) -> Result<(), ImportError> {
    let mut lines = Lines { source, at: 0 };
    while let Some((place, line)) = lines.next()? {
        let Some((header, width)) = parse_header(line, place) else {
            return Err(source.expected(place, HEADER));
        };
        let wanted = visitor.begins(&header)?;
        loop {
            let Some((place, line)) = lines.next()? else {
                let text = format!("column {} that ends the matrix `{}`", header.columns + 1, header.name);
                return Err(source.expected(source.bytes().len(), text));
            };
            let [column, row, words] = integers(line)
                .filter(|numbers| numbers.len() == 3)
                .map_or(Err(source.expected(place, COLUMN)), |numbers| {
                    Ok([numbers[0], numbers[1], numbers[2]])
                })?;
            let is_last = column == header.columns + 1;
            if column == 0 || column > header.columns + 1 {
                let text = format!("a column from 1 to {}", header.columns + 1);
                return Err(source.expected(place, text));
            }
            if is_last {
                lines.values(width, 1)?;
                break;
            }
            let mut walk = Walk { lines: &mut lines, header: &header, width, column, wanted };
            if row > 0 {
                walk.dense(row, words, place, visitor)?;
            } else {
                walk.strings(words, place, visitor)?;
            }
        }
    }
    Ok(())
}

/// The integers of a line, if it holds nothing else.
fn integers(line: &str) -> Option<Vec<usize>> {
    line.split_ascii_whitespace().map(|word| word.parse().ok()).collect()
}

struct Walk<'w, 's> {
    lines: &'w mut Lines<'s>,
    header: &'w Header,
    width: usize,
    column: usize,
    wanted: bool,
}

impl Walk<'_, '_> {
    /// A column from its first row that is not zero to its last. Writers count numbers, or words of 4 bytes.
    fn dense(
        &mut self,
        row: usize,
        count: usize,
        place: usize,
        visitor: &mut impl Visitor,
    ) -> Result<(), ImportError> {
        let values = self.lines.values(self.width, count)?;
        if values.len() != count && values.len() * self.header.words() != count {
            let text =
                format!("{count} numbers or words of column {}, found {} numbers", self.column, values.len());
            return Err(self.lines.source.expected(place, text));
        }
        self.hand_on(row, &values, place, visitor)
    }

    /// Strings of entries, each behind a line that tells its first row and its length.
    fn strings(&mut self, words: usize, place: usize, visitor: &mut impl Visitor) -> Result<(), ImportError> {
        let mut read = 0;
        while read < words {
            let Some((place, line)) = self.lines.next()? else {
                return Err(self.lines.source.expected(place, format!("{words} words, found {read}")));
            };
            let numbers = integers(line).unwrap_or_default();
            let string = match (self.header.is_big, numbers.as_slice()) {
                (true, &[length, row]) => length.checked_sub(1).map(|words| (row, words, 2)),
                (false, &[marker]) => Header::small_string(marker as u64).map(|(row, words)| (row, words, 1)),
                _ => None,
            };
            let Some((row, length, marker)) = string.filter(|&(row, length, _)| row > 0 && length > 0) else {
                return Err(self.lines.source.expected(place, "length and row of a string of entries"));
            };
            let count = length / self.header.words();
            let values = self.lines.values(self.width, count)?;
            if values.len() != count {
                let text = format!("{count} numbers of a string of entries, found {}", values.len());
                return Err(self.lines.source.expected(place, text));
            }
            self.hand_on(row, &values, place, visitor)?;
            read += length + marker;
        }
        Ok(())
    }

    fn hand_on(
        &self,
        row: usize,
        values: &[f64],
        place: usize,
        visitor: &mut impl Visitor,
    ) -> Result<(), ImportError> {
        // of a complex number both parts are counted
        let rows = values.len() * 2 / self.header.words().max(2);
        if row == 0 || rows > self.header.rows || row > self.header.rows + 1 - rows.max(1) {
            let text = format!("rows from 1 to {} in column {}", self.header.rows, self.column);
            return Err(self.lines.source.expected(place, text));
        }
        if !self.wanted {
            return Ok(());
        }
        values
            .iter()
            .enumerate()
            .try_for_each(|(at, &value)| visitor.entry(row + at, self.column, value, place))
    }
}

/// The lines that hold anything.
struct Lines<'a> {
    source: &'a Source,
    at: usize,
}

impl<'a> Lines<'a> {
    fn next(&mut self) -> Result<Option<(usize, &'a str)>, ImportError> {
        let bytes = self.source.bytes();
        while self.at < bytes.len() {
            let place = self.at;
            let length = bytes[place..]
                .iter()
                .position(|&byte| byte == b'\n')
                .map_or(bytes.len() - place, |at| at + 1);
            self.at += length;
            let line = &bytes[place..place + length];
            if line.trim_ascii().is_empty() {
                continue;
            }
            return match std::str::from_utf8(line) {
                Ok(line) if line.is_ascii() => Ok(Some((place, line.trim_end()))),
                _ => Err(self.source.expected(place, "a line of ASCII text")),
            };
        }
        Ok(None)
    }

    /// The numbers of the lines from here, up to `most`, until a line of integers.
    fn values(&mut self, width: usize, most: usize) -> Result<Vec<f64>, ImportError> {
        let mut values = Vec::new();
        while values.len() < most {
            let start = self.at;
            let Some((place, line)) = self.next()? else { break };
            if !line.contains('.') {
                self.at = start;
                break;
            }
            let mut from = 0;
            while from < line.len() && values.len() < most {
                let to = (from + width).min(line.len());
                let text = line[from..to].trim().replace(['D', 'd'], "E");
                let Ok(value) = text.parse::<f64>() else {
                    return Err(self
                        .source
                        .expected(place + from, format!("a number in {width} characters")));
                };
                values.push(value);
                from = to;
            }
        }
        Ok(values)
    }
}
