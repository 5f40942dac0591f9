//! The files of a model as the user names them, and the way from them to a model.

use std::path::{Path, PathBuf};

use super::error::shown;
use super::formats::{ansys, calculix, deck, matrix_file, mesh, nastran, numpy, text_table};
use super::matrix::raw_matrix::{MatrixRole, RawMatrix};
use super::model;
use super::nodes::{ElementTrouble, NodeLookup, NodeTable, TroubleKind};
use super::solids_material::SolidsMaterial;
use super::text::compressed::stored_path;
use super::text::source::Source;
use super::{ImportError, ImportOptions, Note};
use crate::FeModel;

/// What the user named on the command line.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelFiles {
    /// Where the nodes come from.
    pub nodes: NodeSource,
    /// Mass matrix, 3N x 3N or N x N. `None`: the `.mas` file beside a CalculiX deck; an error otherwise.
    pub mass: Option<PathBuf>,
    /// Stiffness matrix, 3N x 3N. `None`: the `.sti` file beside a CalculiX deck, if there is one.
    pub stiffness: Option<PathBuf>,
}

/// Node sources.
#[derive(Debug, Clone, PartialEq)]
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
    /// Nastran deck: grid points, solid elements, materials, sets.
    Nastran(PathBuf),
    /// Mesh of gmsh (`.msh`) or VTK (`.vtu`).
    Mesh {
        /// The mesh.
        path: PathBuf,
        /// What its solids are made of: mass and stiffness are assembled here if their files are not named. May be empty.
        materials: Vec<SolidsMaterial>,
    },
    /// ANSYS node table `id x y z`.
    Ansys {
        /// The table.
        nodes: PathBuf,
        /// Node of each block of three matrix rows. `None`: the order of the table.
        mapping: Option<PathBuf>,
    },
}

/// A model as its files give it, and what the import took for granted or found odd.
#[derive(Debug, Clone)]
pub struct Import {
    /// The checked model.
    pub model: FeModel,
    /// Remarks for the user, in the order of the files.
    pub notes: Vec<Note>,
}

/// Reads and checks a model, taking nothing for granted that the files do not say: [`read_model_with`] and the default
/// options, without the notes.
///
/// # Errors
/// Whatever makes the files unusable, with file, line and numbers: see [`ImportError`].
pub fn read_model(files: &ModelFiles) -> Result<FeModel, ImportError> {
    read_model_with(files, &ImportOptions::default()).map(|import| import.model)
}

/// Reads and checks a model.
///
/// Node rows follow the node file, except with an ANSYS mapping, where they follow the matrices. Nodes that no
/// element and no matrix uses are left out.
///
/// # Errors
/// Whatever makes the files unusable, with file, line and numbers: see [`ImportError`].
pub fn read_model_with(files: &ModelFiles, options: &ImportOptions) -> Result<Import, ImportError> {
    let mut notes = Vec::new();
    let (mut table, sources) = read_nodes(&files.nodes, options, &mut notes)?;
    if let (NodeSource::Mesh { materials, .. }, None, None, [(_, source)]) =
        (&files.nodes, &files.mass, &files.stiffness, sources.as_slice())
        && !materials.is_empty()
    {
        let mut model = model::from_solids(table, source, materials, &mut notes)?;
        model.sources = sources.into_iter().map(|(_, source)| source.finish("mesh")).collect();
        return Ok(Import { model, notes });
    }
    let troubles = std::mem::take(&mut table.troubles);
    let of_kind = |kind| troubles.iter().find(|trouble| trouble.kind == kind).cloned();
    let singular = of_kind(TroubleKind::SingularMass);
    let rows = of_kind(TroubleKind::InternalNodes).or(of_kind(TroubleKind::Rotations));
    read_matrices(files, table, sources, singular, options, notes).map_err(|fault| match rows {
        Some(ElementTrouble { element, path, line, kind }) if is_about_rows(&fault) => {
            let reason = if kind == TroubleKind::Rotations {
                "its nodes have rotations or are expanded, and only rows of displacements are read; use solid elements"
            } else {
                "CalculiX writes rows for internal nodes that the deck does not know; use C3D8 or C3D20"
            };
            ImportError::ElementType { path, line, element, reason, fault: Box::new(fault) }
        }
        _ => fault,
    })
}

/// Whether rows that an element type adds to the matrices can be the cause of an error.
fn is_about_rows(fault: &ImportError) -> bool {
    matches!(
        fault,
        ImportError::UnknownNode { .. } | ImportError::SizeMismatch { .. } | ImportError::Anisotropic { .. }
    )
}

/// Warns of a mass matrix that gives some motions no mass, and names the element type that is known for it.
///
/// `vanishing` pivots were found, if they were computed. CalculiX integrates the mass of the type with too few points,
/// Abaqus does not: beside a deck of Abaqus the pivots decide.
fn warn_of_singular_mass(
    element: Option<&ElementTrouble>,
    vanishing: Option<usize>,
    calculix: bool,
    mass: &Path,
    notes: &mut Vec<Note>,
) {
    let found = vanishing.filter(|&count| count > 0);
    if let Some(ElementTrouble { element, path, line, .. }) = element
        && (calculix || found.is_some() || vanishing.is_none())
    {
        let text = format!(
            "element type {element} (line {line}): CalculiX integrates its mass with too few points, so that the mass \
             matrix is singular and some of its modes have no mass; use C3D20 or C3D10"
        );
        notes.push(Note::warning(text).about(path));
    } else if let Some(ElementTrouble { element, path, line, .. }) = element {
        let text = format!(
            "element type {element} (line {line}): its mass would be singular if CalculiX had made it; the one read here \
             is not"
        );
        notes.push(Note::reading(text).about(path));
    }
    if let Some(count) = found {
        let pivots = if count == 1 { "pivot vanishes" } else { "pivots vanish" };
        let text = format!("the mass matrix is singular, {count} {pivots}: some motions have no mass");
        notes.push(Note::warning(text).about(mass));
    }
}

fn read_matrices(
    files: &ModelFiles,
    mut table: NodeTable,
    sources: Vec<(&'static str, Source)>,
    singular: Option<ElementTrouble>,
    options: &ImportOptions,
    mut notes: Vec<Note>,
) -> Result<Import, ImportError> {
    let limit = options.inflated_limit;
    let lookup = NodeLookup::new(&table.nodes.ids);
    let beside = |extension: &str| match &files.nodes {
        NodeSource::Calculix(deck) => {
            Some(deck.with_extension(extension)).filter(|path| stored_path(path).exists())
        }
        _ => None,
    };
    let row_map = beside("dof").map(|path| calculix::read_row_map(&path, &lookup, limit)).transpose()?;
    let Some(mass_path) = files.mass.clone().or_else(|| beside("mas")) else {
        let advice = match &files.nodes {
            NodeSource::Calculix(deck) => format!("expected {}", shown(&deck.with_extension("mas"))),
            NodeSource::Mesh { .. } => {
                "name it with --mass, or assemble the solids of the mesh with --material DENSITY,E,NU"
                    .to_owned()
            }
            _ => "name it with --mass".to_owned(),
        };
        return Err(ImportError::MissingFile { role: "mass", advice });
    };
    let read = |path: &Path, role: MatrixRole| -> Result<RawMatrix, ImportError> {
        let source = Source::read_unhashed(path, limit)?;
        let mut raw = match &row_map {
            Some(map) => calculix::read_matrix(source, &lookup, map, role)?,
            None => matrix_file::read_square(source, &lookup, role)?,
        };
        raw.source.start_hash();
        Ok(raw)
    };
    let mut mass = read(&mass_path, MatrixRole::Mass)?;
    let stiffness = files.stiffness.clone().or_else(|| beside("sti"));
    let mut stiffness = stiffness.map(|path| read(&path, MatrixRole::Stiffness)).transpose()?;
    for raw in std::iter::once(&mass).chain(&stiffness) {
        notes.extend(raw.reading());
    }
    model::drop_unused_nodes(&mut table, &mut mass, stiffness.as_mut(), row_map.is_some(), &mut notes);
    let parts = model::assemble(&table, &mut mass, stiffness.as_mut(), options, &mut notes)?;
    let calculix = matches!(files.nodes, NodeSource::Calculix(_));
    warn_of_singular_mass(singular.as_ref(), parts.vanishing_mass, calculix, &mass_path, &mut notes);

    let mut hashed: Vec<_> = sources.into_iter().map(|(role, source)| source.finish(role)).collect();
    hashed.extend(row_map.map(|map| map.source.finish("degrees of freedom")));
    hashed.push(mass.source.finish("mass"));
    hashed.extend(stiffness.map(|raw| raw.source.finish("stiffness")));
    let model = FeModel {
        nodes: table.nodes,
        mass: parts.mass.matrix,
        mass_anisotropy: parts.mass.anisotropy,
        stiffness: parts.stiffness,
        fixed_dofs: parts.fixed_dofs,
        elements: table.elements,
        materials: table.materials,
        element_materials: Vec::new(),
        sources: hashed,
        notes: notes.iter().map(Note::for_provenance).collect(),
    };
    Ok(Import { model, notes })
}

/// Sources with what each supplied.
type Sources = Vec<(&'static str, Source)>;

/// The node table and the files it came from.
fn read_nodes(
    nodes: &NodeSource,
    options: &ImportOptions,
    notes: &mut Vec<Note>,
) -> Result<(NodeTable, Sources), ImportError> {
    let limit = options.inflated_limit;
    Ok(match nodes {
        NodeSource::Text(path) => {
            let source = Source::read(path, limit)?;
            (text_table::read_nodes(&source)?, vec![("nodes", source)])
        }
        NodeSource::Numpy(path) => {
            let source = Source::read(path, limit)?;
            (numpy::read_nodes(&source)?, vec![("nodes", source)])
        }
        NodeSource::Abaqus(path) | NodeSource::Calculix(path) => {
            let (table, sources) = deck::read(path, limit)?;
            (table, sources.into_iter().map(|source| ("nodes", source)).collect())
        }
        NodeSource::Mesh { path, .. } => {
            let source = Source::read(path, limit)?;
            (mesh::read(&source)?, vec![("nodes", source)])
        }
        NodeSource::Nastran(path) => {
            let source = Source::read(path, limit)?;
            (nastran::deck::read(&source)?, vec![("nodes", source)])
        }
        NodeSource::Ansys { nodes, mapping } => {
            let source = Source::read(nodes, limit)?;
            let mut table = ansys::read_nodes(&source)?;
            let mut sources = vec![("nodes", source)];
            match mapping {
                Some(path) => {
                    let mapping = Source::read(path, limit)?;
                    table = ansys::order_by_mapping(table, &mapping)?;
                    sources.push(("node mapping", mapping));
                }
                None => {
                    let text =
                        "no --mapping is given, so the matrices are taken to be in the order of this table";
                    notes.push(Note::reading(text).about(nodes));
                }
            }
            (table, sources)
        }
    })
}
