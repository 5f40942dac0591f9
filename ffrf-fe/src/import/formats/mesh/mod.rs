//! Mesh files: nodes, solid elements and named sets, of which mass and stiffness can be assembled.

mod element_types;
mod entities;
mod gmsh;
mod solids;
mod vtu;
mod vtu_array;

use crate::import::ImportError;
use crate::import::nodes::NodeTable;
use crate::import::text::source::Source;

/// Reads a mesh; its first bytes tell the format.
pub(crate) fn read(source: &Source) -> Result<NodeTable, ImportError> {
    if gmsh::is_gmsh(source.bytes()) {
        return gmsh::read(source);
    }
    if vtu::is_xml(source.bytes()) {
        return vtu::read(source);
    }
    Err(source.expected(0, "a mesh of gmsh (`$MeshFormat`) or VTK (`<VTKFile>`)"))
}
