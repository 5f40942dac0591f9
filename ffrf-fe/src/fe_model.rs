//! A finite-element model as this crate sees it: nodes, mass and stiffness, nothing of element technology.

use std::collections::BTreeMap;

use ffrf_model::SourceFile;

use crate::elasticity::Elasticity;
use crate::sparse::SparseMatrix;

/// Nodes, mass and stiffness of one elastic part.
///
/// Degrees of freedom are x, y, z of node 0, then of node 1, ...: dof `3 n + i`.
#[derive(Debug, Clone)]
pub struct FeModel {
    /// Node table and named sets.
    pub nodes: Nodes,
    /// Scalar mass matrix M_s with M_FE = M_s ⊗ I3. Shape: N x N, symmetric, both triangles stored. Units: kg.
    pub mass: SparseMatrix,
    /// Largest deviation of M_FE from M_s ⊗ I3, relative to its largest entry; 0 for a scalar import.
    pub mass_anisotropy: f64,
    /// Stiffness K_FE. Shape: 3N x 3N, symmetric, both triangles stored. Units: N/m. `None` if not supplied.
    pub stiffness: Option<SparseMatrix>,
    /// Degrees of freedom that the export's boundary conditions held fixed, sorted. Their rows of K are zero.
    pub fixed_dofs: Vec<usize>,
    /// Elements, if the file had any: for pictures, surfaces and stresses; mass and stiffness do not depend on them.
    pub elements: Vec<Element>,
    /// Materials, if the file had any: for stresses.
    pub materials: Vec<SolidMaterial>,
    /// Which of `materials` each element is made of; empty if that is not known, and all must be alike.
    pub element_materials: Vec<usize>,
    /// The files read, with hashes.
    pub sources: Vec<SourceFile>,
    /// What the import took for granted or found odd, for the provenance of bodies: files without their folders.
    pub notes: Vec<String>,
}

/// A material that a file defines.
#[derive(Debug, Clone, PartialEq)]
pub struct SolidMaterial {
    /// Its name; may be empty.
    pub name: String,
    /// Its constants; `None` if it is not isotropic, or not the same at all temperatures.
    pub elasticity: Option<Elasticity>,
}

/// Node table: row `n` of every field is node `n`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Nodes {
    /// Ids as in the file; row numbers from 0 for plain text tables.
    pub ids: Vec<u64>,
    /// Reference positions x_n in the body frame. Units: m.
    pub positions: Vec<[f64; 3]>,
    /// Named node sets, as row numbers, sorted.
    pub sets: BTreeMap<String, Vec<usize>>,
}

impl Nodes {
    /// Number of nodes N.
    pub fn len(&self) -> usize {
        self.ids.len()
    }

    /// True if there is no node.
    pub fn is_empty(&self) -> bool {
        self.ids.is_empty()
    }

    /// Row of the node with this id.
    pub fn row_of(&self, id: u64) -> Option<usize> {
        self.ids.iter().position(|&known| known == id)
    }
}

/// One element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Element {
    /// Shape and order.
    pub kind: ElementKind,
    /// Node rows in the order of Abaqus and CalculiX.
    pub nodes: Vec<usize>,
}

/// Element shapes that can be drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ElementKind {
    /// 4-node tetrahedron (C3D4).
    Tetrahedron4,
    /// 10-node tetrahedron (C3D10).
    Tetrahedron10,
    /// 8-node hexahedron (C3D8, C3D8R).
    Hexahedron8,
    /// 20-node hexahedron (C3D20, C3D20R).
    Hexahedron20,
    /// 6-node wedge (C3D6).
    Wedge6,
}
