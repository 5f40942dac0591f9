//! The blocks of a file: `part`, `modal`, `refmod`, `frame` with its nodes, and matrices.

use super::taylor::{Entry, Taylor};
use crate::import::ImportError;
use crate::import::text::cursor::Cursor;
use crate::import::text::source::Source;

/// More than a body of this kind has: every matrix of second order in the modes is held whole.
const MOST_MODES: usize = 1000;

/// Matrices of the body, in the order in which they are written.
pub(crate) const MATRICES: [&str; 11] =
    ["mdCM", "J", "Ct", "Cr", "Me", "Gr", "Ge", "Oe", "ksigma", "Ke", "De"];
/// Matrices of a node.
const OF_NODE: [&str; 5] = ["origin", "phi", "psi", "AP", "sigma"];

/// A file as it is written.
#[derive(Debug)]
pub(super) struct File {
    /// The first line, which says how many nodes and modes there are, and what else its writer wanted to say.
    pub header: String,
    pub mass: f64,
    /// Names of the modes.
    pub modes: Vec<String>,
    pub nodes: Vec<Node>,
    pub matrices: Vec<Taylor>,
}

/// A node: what it is called, and its matrices.
#[derive(Debug)]
pub(super) struct Node {
    pub at: usize,
    pub name: String,
    pub matrices: Vec<Taylor>,
}

/// One line that is not empty: its place, and key and value of `key = value`, or its words.
struct Line<'a> {
    at: usize,
    key: &'a str,
    value: Option<&'a str>,
}

struct Lines<'a> {
    source: &'a Source,
    at: usize,
}

impl<'a> Lines<'a> {
    fn next(&mut self) -> Result<Option<Line<'a>>, ImportError> {
        let bytes = self.source.bytes();
        while self.at < bytes.len() {
            let start = self.at;
            let length =
                bytes[start..].iter().position(|&byte| byte == b'\n').map_or(bytes.len() - start, |n| n + 1);
            self.at += length;
            // What a header says besides its numbers may be in any encoding.
            let line = bytes[start..start + length].trim_ascii();
            if line.is_empty() {
                continue;
            }
            let at = start + bytes[start..].iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(0);
            let Ok(text) = std::str::from_utf8(line) else {
                return Err(self.source.expected(at, "text"));
            };
            let (key, value) = match text.split_once('=') {
                Some((key, value)) => (key.trim(), Some(value.trim())),
                None => (text, None),
            };
            return Ok(Some(Line { at, key, value }));
        }
        Ok(None)
    }

    /// The next line, in a block that is not closed yet.
    fn within(&mut self, block: &str) -> Result<Line<'a>, ImportError> {
        match self.next()? {
            Some(line) => Ok(line),
            None => Err(self.source.expected(self.at, format!("`end {block}`"))),
        }
    }

    fn integer(&self, line: &Line<'a>, what: &str) -> Result<usize, ImportError> {
        let value = line.value.and_then(|value| value.parse().ok());
        value.ok_or_else(|| self.source.expected(line.at, format!("{what} = a whole number")))
    }

    fn float(&self, line: &Line<'a>) -> Result<f64, ImportError> {
        let value = line.value.unwrap_or_default();
        let mut cursor = Cursor::new(value.as_bytes(), 0);
        let read = cursor.float("a number").and_then(|number| cursor.end_line("a number").map(|()| number));
        read.map_err(|mut defect| {
            // The value is a part of the file, and `at` counts from its start.
            let line = &self.source.bytes()[line.at..];
            let before = line.iter().position(|&byte| byte == b'=').map_or(0, |k| k + 1);
            let blanks = line[before..].iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
            defect.at += self.at_of(line) + before + blanks;
            self.source.defect(&defect, 0)
        })
    }

    /// Offset of a rest of the file.
    fn at_of(&self, rest: &[u8]) -> usize {
        self.source.bytes().len() - rest.len()
    }
}

impl File {
    /// Reads the blocks; what the matrices say is not looked at.
    ///
    /// Errors: what does not follow the format, with its line.
    pub fn read(source: &Source) -> Result<Self, ImportError> {
        let mut lines = Lines { source, at: 0 };
        let bytes = source.bytes();
        let end = bytes.iter().position(|&byte| byte == b'\n').unwrap_or(bytes.len());
        let header = String::from_utf8_lossy(&bytes[..end]).trim().to_owned();
        let has_header = header != "part";
        if has_header {
            lines.at = end;
        }
        expect(&mut lines, "part")?;
        expect(&mut lines, "new modal")?;
        let (mut mass, mut modes) = (None, Vec::new());
        let (mut nodes, mut matrices): (Vec<Node>, Vec<Taylor>) = (Vec::new(), Vec::new());
        loop {
            let line = lines.within("modal")?;
            match line.key {
                "end modal" => break,
                "refmod" => (mass, modes) = refmod(&mut lines)?,
                "frame" | "new frame" => nodes.append(&mut frame(&mut lines)?),
                key => {
                    let Some(name) = MATRICES.into_iter().find(|name| *name == key) else {
                        let expected = format!("refmod, frame, {} or end modal", MATRICES.join(", "));
                        return Err(source.expected(line.at, expected));
                    };
                    if matrices.iter().any(|matrix| matrix.name == name) {
                        return Err(source.expected(line.at, "each matrix once"));
                    }
                    matrices.push(taylor(&mut lines, name, line.at)?);
                }
            }
        }
        let Some(mass) = mass else { return Err(source.expected(lines.at, "refmod with mass and nelastq")) };
        if has_header {
            let numbers = header.split(|c: char| !c.is_ascii_digit()).filter(|word| !word.is_empty());
            let counts: Vec<usize> = numbers.take(2).filter_map(|word| word.parse().ok()).collect();
            if counts != [nodes.len(), modes.len()] {
                let (nodes, modes) = (nodes.len(), modes.len());
                let expected = format!("the numbers of nodes and modes that follow, {nodes} and {modes}");
                return Err(source.expected(0, expected));
            }
        }
        Ok(Self { header: if has_header { header } else { String::new() }, mass, modes, nodes, matrices })
    }
}

fn expect(lines: &mut Lines<'_>, word: &str) -> Result<(), ImportError> {
    match lines.next()? {
        Some(line) if line.key == word => Ok(()),
        Some(line) => Err(lines.source.expected(line.at, format!("`{word}`"))),
        None => Err(lines.source.expected(lines.at, format!("`{word}`"))),
    }
}

/// Mass, and names of the modes.
fn refmod(lines: &mut Lines<'_>) -> Result<(Option<f64>, Vec<String>), ImportError> {
    let (mut mass, mut count) = (None, None);
    let mut names: Vec<(usize, String)> = Vec::new();
    loop {
        let line = lines.within("refmod")?;
        match line.key {
            "mass" => mass = Some(lines.float(&line)?),
            "nelastq" => {
                let found = lines.integer(&line, "nelastq")?;
                if !(1..=MOST_MODES).contains(&found) {
                    return Err(lines.source.expected(line.at, format!("nelastq = 1 to {MOST_MODES}")));
                }
                count = Some(found);
            }
            "end refmod" => {
                names.sort_by_key(|(number, _)| *number);
                let numbers = names.iter().map(|(number, _)| *number);
                if count.is_none_or(|count| !numbers.eq(1..=count)) {
                    let expected = "nelastq, and as many ielastq numbered from 1 before `end refmod`";
                    return Err(lines.source.expected(line.at, expected));
                }
                return Ok((mass, names.into_iter().map(|(_, name)| name).collect()));
            }
            key if key.starts_with("ielastq") => {
                let [number] = indices(lines, &line)?;
                names.push((number, line.value.unwrap_or_default().to_owned()));
            }
            _ => return Err(lines.source.expected(line.at, "mass, nelastq, ielastq or end refmod")),
        }
    }
}

fn frame(lines: &mut Lines<'_>) -> Result<Vec<Node>, ImportError> {
    let mut nodes = Vec::new();
    loop {
        let line = lines.within("frame")?;
        match line.key {
            "new node" => {
                let name = line.value.unwrap_or_default().to_owned();
                nodes.push(Node { at: line.at, name, matrices: node(lines)? });
            }
            "end frame" => return Ok(nodes),
            _ => return Err(lines.source.expected(line.at, "new node or end frame")),
        }
    }
}

fn node(lines: &mut Lines<'_>) -> Result<Vec<Taylor>, ImportError> {
    let mut matrices = Vec::new();
    loop {
        let line = lines.within("node")?;
        match (line.key, line.value) {
            ("end node", _) => return Ok(matrices),
            ("rframe", reference) => {
                let reference = reference.unwrap_or_default();
                if !reference.is_empty() && reference != "body ref" {
                    return Err(lines.source.expected(line.at, "rframe = body ref"));
                }
            }
            (key, _) => match OF_NODE.into_iter().find(|name| *name == key) {
                Some(name) => matrices.push(taylor(lines, name, line.at)?),
                None => {
                    let expected = format!("rframe, {} or end node", OF_NODE.join(", "));
                    return Err(lines.source.expected(line.at, expected));
                }
            },
        }
    }
}

fn taylor(lines: &mut Lines<'_>, name: &'static str, at: usize) -> Result<Taylor, ImportError> {
    let [mut order, mut rows, mut columns, mut structure] = [None; 4];
    let (mut zeroth, mut first) = (Vec::new(), Vec::new());
    loop {
        let line = lines.within(name)?;
        match line.key {
            "order" => order = Some(lines.integer(&line, "order")?),
            "nrow" => rows = Some(lines.integer(&line, "nrow")?),
            "ncol" => columns = Some(lines.integer(&line, "ncol")?),
            "structure" => structure = Some(lines.integer(&line, "structure")?),
            "nq" | "nqn" => {
                lines.integer(&line, "nq")?;
            }
            key if key.starts_with("m0") => {
                let index = indices(lines, &line)?;
                zeroth.push(Entry { index, value: lines.float(&line)?, at: line.at });
            }
            key if key.starts_with("m1") => {
                let index = indices(lines, &line)?;
                first.push(Entry { index, value: lines.float(&line)?, at: line.at });
            }
            key if key.strip_prefix("end ").is_some_and(|end| end.trim() == name) => {
                let (Some(order), Some(rows), Some(columns), Some(structure)) =
                    (order, rows, columns, structure)
                else {
                    let expected = format!("order, nrow, ncol and structure before `end {name}`");
                    return Err(lines.source.expected(line.at, expected));
                };
                if order > 1 || structure > 4 {
                    let expected = format!("`{name}` of order 0 or 1 and a structure of 0 to 4");
                    return Err(lines.source.expected(at, expected));
                }
                return Ok(Taylor { name, at, order, rows, columns, structure, zeroth, first });
            }
            _ => {
                let expected = format!("order, nrow, ncol, nq, nqn, structure, m0, m1 or end {name}");
                return Err(lines.source.expected(line.at, expected));
            }
        }
    }
}

/// The numbers in the brackets of `name( 1, 2)`.
fn indices<const K: usize>(lines: &Lines<'_>, line: &Line<'_>) -> Result<[usize; K], ImportError> {
    let inner = line.key.split_once('(').and_then(|(_, rest)| rest.split_once(')')).map(|(inner, _)| inner);
    let numbers: Vec<usize> =
        inner.unwrap_or_default().split(',').filter_map(|word| word.trim().parse().ok()).collect();
    let expected = || lines.source.expected(line.at, format!("{K} indices from 1 in brackets"));
    numbers.try_into().map_err(|_| expected())
}
