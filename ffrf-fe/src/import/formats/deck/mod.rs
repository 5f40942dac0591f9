//! Input decks of Abaqus and CalculiX: nodes, solid elements, node sets, parts and instances.
//!
//! Materials are read for what they say about isotropic elasticity. Every other keyword is skipped, except those that would make nodes this reader does not see.

mod assemble;
mod fields;
mod keyword;
mod limits;
mod mesh;
mod placed;
mod reader;
mod sets;

use std::path::Path;

use crate::import::ImportError;
use crate::import::nodes::NodeTable;
use crate::import::text::source::Source;

/// Reads a deck and the files it includes.
pub(crate) fn read(path: &Path, inflated_limit: u64) -> Result<(NodeTable, Vec<Source>), ImportError> {
    let reader::Deck { meshes, sources, has_boundary, materials, troubles } =
        reader::read(path, inflated_limit)?;
    let table = assemble::assemble(&meshes, &sources)?;
    let Some(first) = sources.first() else {
        return Err(ImportError::NoNodes { path: path.to_path_buf() });
    };
    let table = NodeTable { has_boundary, materials, troubles, ..table }.check_size(first)?;
    Ok((table, sources))
}

#[cfg(test)]
mod tests;
