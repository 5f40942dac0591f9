//! Mass and stiffness of a mesh, assembled of its solids.

use super::coverage::listed;
use crate::FeModel;
use crate::elements::{ElementError, Material, assemble_materials};
use crate::import::nodes::NodeTable;
use crate::import::solids_material::{SolidsMaterial, assign};
use crate::import::text::source::Source;
use crate::import::{ImportError, Note};

/// Assembles the solids of a mesh; nodes that belong to none are left out.
pub(crate) fn from_solids(
    mut table: NodeTable,
    source: &Source,
    materials: &[SolidsMaterial],
    notes: &mut Vec<Note>,
) -> Result<FeModel, ImportError> {
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
    let line_of = |number: usize| table.element_places.get(number).map_or(0, |&place| source.line_of(place));
    let of_solid = assign(materials, &table.element_sets, solids, path, line_of)?;
    let made_of = describe(materials, &of_solid);
    let named: Vec<(String, Material)> =
        materials.iter().map(|it| (it.group.clone().unwrap_or_default(), it.material)).collect();
    let assembled = assemble_materials(table.nodes, table.elements, &named, of_solid).map_err(|fault| {
        let number = match fault {
            ElementError::Numbered { element, .. }
            | ElementError::UnknownNode { element, .. }
            | ElementError::NoMaterial { element, .. } => element,
            _ => 0,
        };
        ImportError::BadElement { path: path.to_path_buf(), line: line_of(number), fault }
    })?;
    let total: f64 = assembled.mass.val().iter().sum();
    if total.is_nan() || total <= 0.0 {
        return Err(ImportError::NoMass { path: path.to_path_buf(), total });
    }
    let text = format!("mass (consistent) and stiffness are assembled of {solids} solids {made_of}");
    notes.push(Note::reading(text).about(path));
    Ok(FeModel { notes: notes.iter().map(Note::for_provenance).collect(), ..assembled })
}

/// The materials in words, each with how many solids are made of it if there are several.
fn describe(materials: &[SolidsMaterial], of_solid: &[usize]) -> String {
    let one = |number: usize, SolidsMaterial { group, material }: &SolidsMaterial| {
        let Material { density, youngs_modulus, poisson_ratio } = material;
        let constants = format!(
            "with density {density:?}, Young's modulus {youngs_modulus:e} and Poisson's ratio {poisson_ratio:?}"
        );
        let count = of_solid.iter().filter(|&&material| material == number).count();
        match group {
            Some(group) => format!("{count} of group {group} {constants}"),
            None if materials.len() > 1 => format!("{count} others {constants}"),
            None => constants,
        }
    };
    let all: Vec<String> = materials.iter().enumerate().map(|(number, it)| one(number, it)).collect();
    if materials.len() > 1 || materials.iter().any(|it| it.group.is_some()) {
        return format!("of {} materials: {}", materials.len(), all.join("; "));
    }
    all.concat()
}
