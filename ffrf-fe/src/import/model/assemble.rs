//! Puts node table, mass and stiffness together: sizes, boundary conditions, symmetry, isotropy, definiteness.

use std::path::Path;

use super::coverage::Coverage;
use super::rigid_motion;
use crate::SparseMatrix;
use crate::import::matrix::definiteness::refuse_indefinite;
use crate::import::matrix::raw_matrix::{Numbering, RawMatrix};
use crate::import::matrix::scalar_mass::{ScalarMass, scalar_mass};
use crate::import::matrix::sparse_lines::SparseLines;
use crate::import::nodes::NodeTable;
use crate::import::{ImportError, ImportOptions, MassForm, Note};
use crate::tolerances::HELD_DIAGONAL;

/// The checked parts of a model.
pub(crate) struct Assembled {
    /// Vanishing pivots of M_s, of which a sound mass has none; `None` if they were not computed.
    pub(crate) vanishing_mass: Option<usize>,
    pub(crate) mass: ScalarMass,
    pub(crate) stiffness: Option<SparseMatrix>,
    pub(crate) fixed_dofs: Vec<usize>,
}

/// A matrix over all degrees of freedom, and which of them were held.
struct Settled {
    lines: SparseLines,
    /// Held by a huge diagonal entry, or left out of a list.
    held: Vec<bool>,
    /// Held by a huge diagonal entry.
    huge: Vec<bool>,
}

impl Settled {
    /// Degrees of freedom that a list leaves out without marking them as held.
    fn left_out(&self) -> Vec<bool> {
        self.held.iter().zip(&self.huge).map(|(&held, &huge)| held && !huge).collect()
    }
}

/// Puts the parts together and checks them; `notes` gets what was taken for granted or is odd.
pub(crate) fn assemble(
    table: &NodeTable,
    mass: &mut RawMatrix,
    stiffness: Option<&mut RawMatrix>,
    options: &ImportOptions,
    notes: &mut Vec<Note>,
) -> Result<Assembled, ImportError> {
    let nodes = table.nodes.len();
    let dofs = 3 * nodes;
    let mut held = vec![false; dofs];
    let mut left_out = vec![false; dofs];
    let stiffness_path = stiffness.as_ref().map(|raw| raw.source.path().to_path_buf());
    let stiffness = match stiffness {
        None => None,
        Some(raw) => {
            refuse_size(raw, nodes, false)?;
            let settled = settle(raw, false);
            held.copy_from_slice(&settled.held);
            left_out = settled.left_out();
            let matrix = settled.lines.symmetric(raw.storage, raw.source.path())?;
            refuse_indefinite(&matrix, "stiffness", raw.source.path())?;
            Some(matrix)
        }
    };
    refuse_size(mass, nodes, true)?;
    refuse_form(mass, nodes, options.mass_form)?;
    let path = &mass.source.path().to_path_buf();
    let scalar = if mass.size == nodes {
        let lines = SparseLines::from_entries(std::mem::take(&mut mass.entries), nodes);
        refuse_huge(&lines, table, path)?;
        ScalarMass { matrix: lines.symmetric(mass.storage, path)?, anisotropy: 0.0 }
    } else {
        let settled = settle(mass, true);
        refuse_huge(&settled.lines, table, path)?;
        if stiffness.is_none() {
            // Without stiffness a node that the list leaves out whole has no mass; one left out in part is held.
            for (flags, missing) in held.chunks_exact_mut(3).zip(settled.held.chunks_exact(3)) {
                if missing != [true; 3] {
                    flags.copy_from_slice(missing);
                }
            }
        }
        let known: Vec<bool> = (0..dofs)
            .map(|dof| !held[dof] || settled.lines.diagonal(dof).is_some_and(|value| value != 0.0))
            .collect();
        let full = settled.lines.symmetric(mass.storage, path)?;
        scalar_mass(&full, &known, table, path)?
    };
    refuse_massless(&scalar.matrix, path)?;
    let vanishing_mass = refuse_indefinite(&scalar.matrix, "mass", path)?;
    let coverage = Coverage {
        table,
        mass: &scalar.matrix,
        mass_path: path,
        stiffness: stiffness.as_ref().zip(stiffness_path.as_deref()),
        held: &held,
        left_out: &left_out,
    };
    coverage.check(options.allow_massless, notes)?;
    coverage.compare_patterns(notes);
    if let (Some(stiffness), Some(path)) = (&stiffness, &stiffness_path) {
        rigid_motion::compare(&table.nodes, stiffness, path, notes);
    }
    let fixed_dofs = (0..dofs).filter(|&dof| held[dof]).collect();
    Ok(Assembled { vanishing_mass, mass: scalar, stiffness, fixed_dofs })
}

/// Takes the entries, sorts them and finds the held degrees of freedom; in a stiffness their rows become zero.
fn settle(raw: &mut RawMatrix, is_mass: bool) -> Settled {
    let present = match raw.numbering {
        Numbering::Declared => vec![true; raw.size],
        Numbering::Listed | Numbering::Labelled | Numbering::Named => raw.entries.present(raw.size),
    };
    let mut lines = SparseLines::from_entries(std::mem::take(&mut raw.entries), raw.size);
    let huge: Vec<bool> =
        (0..raw.size).map(|dof| lines.diagonal(dof).is_some_and(|value| value >= HELD_DIAGONAL)).collect();
    if !is_mass {
        lines.clear(&huge);
    }
    let held = present.iter().zip(&huge).map(|(&present, &huge)| huge || !present).collect();
    Settled { lines, held, huge }
}

fn refuse_size(raw: &RawMatrix, nodes: usize, scalar_allowed: bool) -> Result<(), ImportError> {
    if raw.size == 3 * nodes || (scalar_allowed && raw.size == nodes) {
        return Ok(());
    }
    let scalar = if scalar_allowed { format!(" or {nodes} (one direction)") } else { String::new() };
    Err(ImportError::SizeMismatch {
        path: raw.source.path().to_path_buf(),
        expected: format!("{} rows (x, y, z of {nodes} nodes){scalar}", 3 * nodes),
        found: raw.size,
        what: "rows",
    })
}

/// Refuses a mass whose form is not the one that was named, and a list that could be of either form.
fn refuse_form(mass: &RawMatrix, nodes: usize, form: MassForm) -> Result<(), ImportError> {
    let scalar = mass.size == nodes;
    let (expected, advice) = match form {
        MassForm::Declared if scalar && mass.numbering == Numbering::Listed => (
            format!("{} rows (x, y, z of each node) in a list without a header", 3 * nodes),
            "is the list cut off? If it is the scalar mass, say --mass-form scalar",
        ),
        MassForm::Scalar if !scalar => (
            format!("the scalar mass, {nodes} rows, as --mass-form says"),
            "this is a matrix of all directions",
        ),
        MassForm::Full if scalar => (
            format!("a mass of all directions, {} rows, as --mass-form says", 3 * nodes),
            "this is a matrix of one direction",
        ),
        _ => return Ok(()),
    };
    let path = mass.source.path().to_path_buf();
    Err(ImportError::MassForm { path, expected, found: mass.size, nodes, advice })
}

/// Refuses a mass that stands for a support.
fn refuse_huge(lines: &SparseLines, table: &NodeTable, path: &Path) -> Result<(), ImportError> {
    let per_node = lines.size() / table.nodes.len().max(1);
    for row in 0..lines.size() {
        if let Some(value) = lines.diagonal(row).filter(|&value| value >= HELD_DIAGONAL) {
            let node = table.nodes.ids[row / per_node];
            let path = path.to_path_buf();
            return Err(ImportError::HugeMass { path, row: row + 1, node, value, limit: HELD_DIAGONAL });
        }
    }
    Ok(())
}

fn refuse_massless(mass: &SparseMatrix, path: &Path) -> Result<(), ImportError> {
    let total: f64 = mass.val().iter().sum();
    if total > 0.0 {
        return Ok(());
    }
    Err(ImportError::NoMass { path: path.to_path_buf(), total })
}
