//! Mass and stiffness of a mesh, assembled of its solids.

use super::coverage::listed;
use crate::FeModel;
use crate::elements::{ElementError, Material, assemble};
use crate::import::nodes::NodeTable;
use crate::import::text::source::Source;
use crate::import::{ImportError, Note};

/// Assembles the solids of a mesh; nodes that belong to none are left out.
pub(crate) fn from_solids(
    mut table: NodeTable,
    source: &Source,
    material: &Material,
    notes: &mut Vec<Note>,
) -> Result<FeModel, ImportError> {
    let &Material { density, youngs_modulus, poisson_ratio } = material;
    if !(density.is_finite() && density > 0.0 && material.elasticity().is_stable()) {
        return Err(ImportError::Material { density, youngs_modulus, poisson_ratio });
    }
    let path = source.path();
    let nodes = table.nodes.len();
    let Some(attached) = table.attached.take().filter(|_| !table.elements.is_empty()) else {
        let advice = "mesh the volume, and put it into a physical group if there are any";
        return Err(ImportError::NoSolids { path: path.to_path_buf(), nodes, advice });
    };
    let lost = (0..nodes).filter(|&row| !attached[row]).count();
    if lost > 0 {
        let ids = (0..nodes).filter(|&row| !attached[row]).map(|row| table.nodes.ids[row]);
        let what = if lost == 1 { "node is" } else { "nodes are" };
        let text = format!("{lost} {what} in no solid and left out ({})", listed(ids));
        notes.push(Note::reading(text).about(path));
        table.retain(&attached);
    }
    let solids = table.elements.len();
    let assembled = assemble(table.nodes, table.elements, material).map_err(|fault| {
        let number = match fault {
            ElementError::Numbered { element, .. } | ElementError::UnknownNode { element, .. } => element,
            _ => 0,
        };
        let line = table.element_places.get(number).map_or(0, |&place| source.line_of(place));
        ImportError::BadElement { path: path.to_path_buf(), line, fault }
    })?;
    let total: f64 = assembled.mass.val().iter().sum();
    if total.is_nan() || total <= 0.0 {
        return Err(ImportError::NoMass { path: path.to_path_buf(), total });
    }
    let text = format!(
        "mass (consistent) and stiffness are assembled of {solids} solids with density {density:?}, Young's modulus \
         {youngs_modulus:e} and Poisson's ratio {poisson_ratio:?}"
    );
    notes.push(Note::reading(text).about(path));
    Ok(FeModel { notes: notes.iter().map(Note::for_provenance).collect(), ..assembled })
}
