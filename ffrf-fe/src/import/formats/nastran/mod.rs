//! Nastran: the deck (grid points, solid elements, materials, sets) and matrices: by degree of freedom (`DMIG`), by columns (`OUTPUT4`).

mod card;
pub(crate) mod deck;
pub(crate) mod dmig;
pub(crate) mod op4;
mod op4_binary;
mod op4_header;
mod op4_text;

use crate::import::ImportError;
use crate::import::matrix::raw_matrix::MatrixRole;
use crate::import::text::source::Source;

/// Which of the matrices of a file, by names with their places: the only one, or the only one whose name starts as its role asks for.
fn chosen(source: &Source, found: &[(String, usize)], role: MatrixRole) -> Result<usize, ImportError> {
    if found.len() == 1 {
        return Ok(0);
    }
    let names = || found.iter().map(|(name, _)| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let Some(initial) = role.initial() else {
        let at = found.get(1).map_or(0, |&(_, place)| place);
        return Err(source.expected(at, format!("one matrix, found {}", names())));
    };
    let fits = |name: &str| name.starts_with([initial, initial.to_ascii_lowercase()]);
    let mut fitting = (0..found.len()).filter(|&at| fits(&found[at].0));
    match (fitting.next(), fitting.next()) {
        (Some(only), None) => Ok(only),
        (_, second) => {
            let at = second.map_or(0, |second| found[second].1);
            let text = format!("one matrix whose name starts with `{initial}` among {}", names());
            Err(source.expected(at, text))
        }
    }
}
