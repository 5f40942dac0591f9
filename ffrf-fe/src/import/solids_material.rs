//! What the solids of a mesh are made of.

use std::collections::BTreeMap;
use std::path::Path;

use super::ImportError;
use crate::elements::Material;

/// Groups that a message names.
const NAMED: usize = 20;

/// A material, and which solids of a mesh are made of it.
#[derive(Debug, Clone, PartialEq)]
pub struct SolidsMaterial {
    /// Name of the group of solids; `None`: all that no named group holds.
    pub group: Option<String>,
    /// What they are made of.
    pub material: Material,
}

impl SolidsMaterial {
    /// One material for all solids.
    pub fn all(material: Material) -> Vec<Self> {
        vec![Self { group: None, material }]
    }
}

/// Which of `materials` each of `count` solids is made of. `line_of`: the line of a solid in the file.
///
/// Errors: constants of no material, a group without solids, one that is named twice, a solid in two groups or in none.
pub(super) fn assign(
    materials: &[SolidsMaterial],
    groups: &BTreeMap<String, Vec<usize>>,
    count: usize,
    path: &Path,
    line_of: impl Fn(usize) -> usize,
) -> Result<Vec<usize>, ImportError> {
    let known = || {
        let solid = |count: usize| if count == 1 { "solid" } else { "solids" };
        let holding = groups.iter().filter(|(_, solids)| !solids.is_empty());
        let mut list: Vec<String> = holding
            .map(|(name, solids)| format!("{name} ({} {})", solids.len(), solid(solids.len())))
            .collect();
        if list.is_empty() {
            return "none".to_owned();
        }
        if list.len() > NAMED {
            let rest = list.len() - NAMED;
            list.truncate(NAMED);
            list.push(format!("and {rest} more"));
        }
        list.join(", ")
    };
    let mut of_solid: Vec<Option<usize>> = vec![None; count];
    for (number, SolidsMaterial { group, material }) in materials.iter().enumerate() {
        let &Material { density, youngs_modulus, poisson_ratio } = material;
        if !(density.is_finite() && density > 0.0 && material.elasticity().is_stable()) {
            return Err(ImportError::Material {
                group: group.clone(),
                density,
                youngs_modulus,
                poisson_ratio,
            });
        }
        if materials[..number].iter().any(|before| before.group == *group) {
            return Err(ImportError::MaterialTwice { group: group.clone() });
        }
        let Some(group) = group else { continue };
        let Some(solids) = groups.get(group).filter(|solids| !solids.is_empty()) else {
            let (path, group) = (path.to_path_buf(), group.clone());
            return Err(ImportError::UnknownSolids { path, group, known: known() });
        };
        for &solid in solids {
            if let Some(before) = of_solid[solid] {
                return Err(ImportError::TwoMaterials {
                    path: path.to_path_buf(),
                    line: line_of(solid),
                    first: materials[before].group.clone().unwrap_or_default(),
                    second: group.clone(),
                });
            }
            of_solid[solid] = Some(number);
        }
    }
    let rest = materials.iter().position(|material| material.group.is_none());
    let missing = || of_solid.iter().enumerate().filter(|(_, material)| material.is_none());
    if let (None, Some((first, _))) = (rest, missing().next()) {
        return Err(ImportError::NoMaterial {
            path: path.to_path_buf(),
            line: line_of(first),
            count: missing().count(),
            known: known(),
        });
    }
    Ok(of_solid.into_iter().map(|material| material.or(rest).unwrap_or_default()).collect())
}
