//! Input decks of Abaqus and CalculiX: nodes, solid elements, node sets, parts and instances.
//!
//! Every other keyword is skipped, except those that would make nodes this reader does not see.

mod assemble;
mod fields;
mod keyword;
mod mesh;
mod reader;

use std::path::Path;

use crate::FeError;
use crate::import::nodes::NodeTable;
use crate::import::text::source::Source;

/// Reads a deck and the files it includes.
pub(crate) fn read(path: &Path) -> Result<(NodeTable, Vec<Source>), FeError> {
    let reader::Deck { meshes, sources, has_boundary } = reader::read(path)?;
    let table = assemble::assemble(meshes, &sources)?;
    let Some(first) = sources.first() else {
        return Err(FeError::NoNodes { path: path.to_path_buf() });
    };
    let table = NodeTable { has_boundary, ..table }.check_size(first)?;
    Ok((table, sources))
}

#[cfg(test)]
mod tests;
