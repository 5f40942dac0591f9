//! Fields of a deck's lines: keyword lines with continuation, comma-separated data, element types.

use super::keyword::Keyword;
use super::mesh::Member;
use crate::ElementKind;
use crate::import::nodes::TroubleKind;
use crate::import::text::cursor::Cursor;

/// The comma-separated fields of one line, empty ones left out.
pub(super) struct Fields {
    pub(super) fields: Vec<String>,
    /// True if the line ends with a comma, so that the next line may continue it.
    pub(super) open: bool,
}

/// Reads the rest of the line; the cursor stays before the line end.
pub(super) fn line_fields(bytes: &[u8], cursor: &mut Cursor<'_>) -> Fields {
    let start = cursor.at;
    let length = bytes[start..].iter().position(|&byte| byte == b'\n').unwrap_or(bytes.len() - start);
    cursor.at += length;
    let text = String::from_utf8_lossy(&bytes[start..start + length]);
    let text = text.trim();
    let fields = text.split(',').map(str::trim).filter(|field| !field.is_empty());
    Fields { fields: fields.map(str::to_owned).collect(), open: text.ends_with(',') }
}

/// Reads a keyword line with its continuation lines; the cursor goes to the line after them.
pub(super) fn keyword_at(bytes: &[u8], cursor: &mut Cursor<'_>) -> Keyword {
    let mut text = String::new();
    loop {
        let start = cursor.at;
        cursor.next_line();
        text.push_str(String::from_utf8_lossy(&bytes[start..cursor.at]).trim());
        if !text.ends_with(',') || cursor.at >= bytes.len() || bytes[cursor.at] == b'*' {
            break;
        }
    }
    Keyword::parse(text.trim_start_matches('*'))
}

/// Members of one data line of `*NSET`; `None` if a range has not two or three numbers.
pub(super) fn set_members(fields: &[String], generate: bool) -> Option<Vec<Member>> {
    if generate {
        let numbers: Option<Vec<u64>> = fields.iter().map(|field| field.parse().ok()).collect();
        return match *numbers?.as_slice() {
            [first, last] => Some(vec![Member::Range(first, last, 1)]),
            [first, last, step] if step > 0 => Some(vec![Member::Range(first, last, step)]),
            _ => None,
        };
    }
    let member = |field: &String| {
        field.parse().map_or_else(|_| Member::Name(field.trim_matches('"').to_owned()), Member::Label)
    };
    Some(fields.iter().map(member).collect())
}

/// Shape and number of nodes of an element type that can be drawn, with variants such as C3D8R or C3D10M.
pub(super) fn element_kind(name: &str) -> Option<(ElementKind, usize)> {
    let name = name.to_uppercase();
    let digits: String = name.strip_prefix("C3D")?.chars().take_while(char::is_ascii_digit).collect();
    match digits.as_str() {
        "4" => Some((ElementKind::Tetrahedron4, 4)),
        "6" => Some((ElementKind::Wedge6, 6)),
        "8" => Some((ElementKind::Hexahedron8, 8)),
        "10" => Some((ElementKind::Tetrahedron10, 10)),
        "20" => Some((ElementKind::Hexahedron20, 20)),
        _ => None,
    }
}

/// What is known against an element type, given in upper case. Source: docs/export/calculix.md, measured.
pub(super) fn element_trouble(name: &str) -> Option<TroubleKind> {
    match name {
        "C3D8I" => Some(TroubleKind::InternalNodes),
        "C3D20R" => Some(TroubleKind::SingularMass),
        _ if has_rotations(name) => Some(TroubleKind::Rotations),
        _ => None,
    }
}

/// Whether nodes of an element type, given in upper case, have rotations: beams and pipes (B31, PIPE32), shells (S4R, STRI3).
fn has_rotations(name: &str) -> bool {
    ["B", "PIPE", "S", "STRI"].iter().any(|start| {
        name.strip_prefix(start).is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
    })
}
