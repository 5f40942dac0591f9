//! What the elements of a part are made of.

use crate::{Elasticity, FeModel};

use super::GeometricStiffnessError;

/// The elastic constants of a part of one isotropic material.
///
/// Errors: the file defines no material, one that is not isotropic, or several that differ.
pub fn uniform_elasticity(model: &FeModel) -> Result<Elasticity, GeometricStiffnessError> {
    let mut found: Option<Elasticity> = None;
    for material in &model.materials {
        let Some(elasticity) = material.elasticity else {
            return Err(GeometricStiffnessError::NotIsotropic { material: material.name.clone() });
        };
        match found {
            Some(first) if first != elasticity => {
                return Err(GeometricStiffnessError::SeveralMaterials {
                    first: first.youngs_modulus,
                    material: material.name.clone(),
                    second: elasticity.youngs_modulus,
                });
            }
            _ => found = Some(elasticity),
        }
    }
    found.ok_or(GeometricStiffnessError::NoMaterial)
}
