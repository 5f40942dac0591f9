//! The files of a model as the user names them, and the way from them to a model.

use std::path::{Path, PathBuf};

use super::formats::calculix::RowMap;
use super::formats::{ansys, calculix, deck, matrix_file, numpy, text_table};
use super::matrix::raw_matrix::RawMatrix;
use super::model;
use super::nodes::{NodeLookup, NodeTable};
use super::text::compressed::stored_path;
use super::text::source::Source;
use crate::{FeError, FeModel};

/// What the user named on the command line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModelFiles {
    /// Where the nodes come from.
    pub nodes: NodeSource,
    /// Mass matrix, 3N x 3N or N x N. `None`: the `.mas` file beside a CalculiX deck; an error otherwise.
    pub mass: Option<PathBuf>,
    /// Stiffness matrix, 3N x 3N. `None`: the `.sti` file beside a CalculiX deck, if there is one.
    pub stiffness: Option<PathBuf>,
}

/// Node sources.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum NodeSource {
    /// Text, `x y z` a line; node ids are row numbers from 0.
    Text(PathBuf),
    /// NumPy `.npy` or `.npz` (array `nodes`, `X` or the only one): N x 3, or N x 4 with ids first.
    Numpy(PathBuf),
    /// Abaqus input deck.
    Abaqus(PathBuf),
    /// CalculiX input deck; `.sti`, `.mas` and `.dof` of the same stem beside it.
    Calculix(PathBuf),
    /// ANSYS node table `id x y z`.
    Ansys {
        /// The table.
        nodes: PathBuf,
        /// Node of each block of three matrix rows. `None`: the order of the table.
        mapping: Option<PathBuf>,
    },
}

/// Reads and checks a model.
///
/// Node rows follow the node file, except with an ANSYS mapping, where they follow the matrices. Nodes that no
/// element and no matrix uses are left out.
///
/// # Errors
/// Whatever makes the files unusable, with file, line and numbers: see [`FeError`].
pub fn read_model(files: &ModelFiles) -> Result<FeModel, FeError> {
    let Nodes { mut table, sources, row_map } = read_nodes(&files.nodes)?;
    let lookup = NodeLookup::new(&table.nodes.ids);
    let beside = |extension: &str| match &files.nodes {
        NodeSource::Calculix(deck) => {
            Some(deck.with_extension(extension)).filter(|path| stored_path(path).exists())
        }
        _ => None,
    };
    let Some(mass_path) = files.mass.clone().or_else(|| beside("mas")) else {
        let advice = match &files.nodes {
            NodeSource::Calculix(deck) => format!("expected {}", deck.with_extension("mas").display()),
            _ => "name it with --mass".to_owned(),
        };
        return Err(FeError::MissingFile { role: "mass", advice });
    };
    let read = |path: &Path| -> Result<RawMatrix, FeError> {
        let mut raw = match &row_map {
            Some(map) => calculix::read_matrix(path, &lookup, map)?,
            None => matrix_file::read(path, &lookup)?,
        };
        raw.source.start_hash();
        Ok(raw)
    };
    let mut mass = read(&mass_path)?;
    let stiffness = files.stiffness.clone().or_else(|| beside("sti"));
    let mut stiffness = stiffness.map(|path| read(&path)).transpose()?;
    model::drop_unused_nodes(&mut table, &mut mass, stiffness.as_mut(), row_map.is_some());
    let parts = model::assemble(&table, &mut mass, stiffness.as_mut())?;

    let mut hashed: Vec<_> = sources.into_iter().map(|(role, source)| source.finish(role)).collect();
    hashed.extend(row_map.map(|map| map.source.finish("degrees of freedom")));
    hashed.push(mass.source.finish("mass"));
    hashed.extend(stiffness.map(|raw| raw.source.finish("stiffness")));
    Ok(FeModel {
        nodes: table.nodes,
        mass: parts.mass.matrix,
        mass_anisotropy: parts.mass.anisotropy,
        stiffness: parts.stiffness,
        fixed_dofs: parts.fixed_dofs,
        elements: table.elements,
        sources: hashed,
    })
}

struct Nodes {
    table: NodeTable,
    sources: Vec<(&'static str, Source)>,
    row_map: Option<RowMap>,
}

fn read_nodes(nodes: &NodeSource) -> Result<Nodes, FeError> {
    let (table, sources, row_map) = match nodes {
        NodeSource::Text(path) => {
            let source = Source::read(path)?;
            (text_table::read_nodes(&source)?, vec![("nodes", source)], None)
        }
        NodeSource::Numpy(path) => {
            let source = Source::read(path)?;
            (numpy::read_nodes(&source)?, vec![("nodes", source)], None)
        }
        NodeSource::Abaqus(path) => {
            let (table, sources) = deck::read(path)?;
            (table, sources.into_iter().map(|source| ("nodes", source)).collect(), None)
        }
        NodeSource::Calculix(path) => {
            let (table, sources) = deck::read(path)?;
            let lookup = NodeLookup::new(&table.nodes.ids);
            let map = path.with_extension("dof");
            let map =
                if stored_path(&map).exists() { Some(calculix::read_row_map(&map, &lookup)?) } else { None };
            (table, sources.into_iter().map(|source| ("nodes", source)).collect(), map)
        }
        NodeSource::Ansys { nodes, mapping } => {
            let source = Source::read(nodes)?;
            let mut table = ansys::read_nodes(&source)?;
            let mut sources = vec![("nodes", source)];
            if let Some(path) = mapping {
                let mapping = Source::read(path)?;
                table = ansys::order_by_mapping(table, &mapping)?;
                sources.push(("node mapping", mapping));
            }
            (table, sources, None)
        }
    };
    Ok(Nodes { table, sources, row_map })
}
