//! The element types of gmsh by number.
//!
//! Source: gmsh 4.15 reference manual, sections "MSH file format" and "Node ordering".

use crate::ElementKind;

/// Points, lines and surfaces name nodes of groups; solids are what the part is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    /// A point, line or surface.
    Lower,
    /// A solid, with the place of each of its nodes in the order of Abaqus and CalculiX.
    Solid(ElementKind, &'static [usize]),
    /// A solid whose matrices are not known here, with what to do.
    Unknown(&'static str),
}

/// One element type.
#[derive(Debug, Clone, Copy)]
pub(super) struct ElementType {
    /// Dimension, 0 to 3.
    pub(super) dimension: u8,
    /// Number of nodes.
    pub(super) nodes: usize,
    /// What it is.
    pub(super) shape: Shape,
}

const IN_ORDER: &[usize] = &[0, 1, 2, 3, 4, 5, 6, 7];
/// The last two middles of edges change places.
const TETRAHEDRON_10: &[usize] = &[0, 1, 2, 3, 4, 5, 6, 7, 9, 8];
/// Middles of edges: lower face, upper face, upright.
const HEXAHEDRON_20: &[usize] = &[0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15];

const INCOMPLETE: &str = "mesh with Mesh.SecondOrderIncomplete = 1, which makes hexahedra of 20 nodes";
const SIMPLER: &str = "mesh the volume with tetrahedra or hexahedra of first or second order";

/// The type with a number; `None` for numbers beyond the manual's table of orders up to five.
pub(super) fn element_type(number: u64) -> Option<ElementType> {
    let solid = |kind, nodes, order| (3, nodes, Shape::Solid(kind, order));
    let unknown = |nodes, advice| (3, nodes, Shape::Unknown(advice));
    let (dimension, nodes, shape) = match number {
        15 => (0, 1, Shape::Lower),
        1 => (1, 2, Shape::Lower),
        8 => (1, 3, Shape::Lower),
        26 => (1, 4, Shape::Lower),
        27 => (1, 5, Shape::Lower),
        28 => (1, 6, Shape::Lower),
        2 => (2, 3, Shape::Lower),
        3 => (2, 4, Shape::Lower),
        9 => (2, 6, Shape::Lower),
        10 | 20 => (2, 9, Shape::Lower),
        16 => (2, 8, Shape::Lower),
        21 => (2, 10, Shape::Lower),
        22 => (2, 12, Shape::Lower),
        23 | 24 => (2, 15, Shape::Lower),
        25 => (2, 21, Shape::Lower),
        4 => solid(ElementKind::Tetrahedron4, 4, &IN_ORDER[..4]),
        5 => solid(ElementKind::Hexahedron8, 8, IN_ORDER),
        6 => solid(ElementKind::Wedge6, 6, &IN_ORDER[..6]),
        11 => solid(ElementKind::Tetrahedron10, 10, TETRAHEDRON_10),
        17 => solid(ElementKind::Hexahedron20, 20, HEXAHEDRON_20),
        12 => unknown(27, INCOMPLETE),
        13 => unknown(18, SIMPLER),
        18 => unknown(15, SIMPLER),
        7 => unknown(5, SIMPLER),
        14 => unknown(14, SIMPLER),
        19 => unknown(13, SIMPLER),
        29 => unknown(20, SIMPLER),
        30 => unknown(35, SIMPLER),
        31 => unknown(56, SIMPLER),
        _ => return None,
    };
    Some(ElementType { dimension, nodes, shape })
}
