//! What the elements of a part are made of.

use crate::elements::ElementError;
use crate::error::GeometricStiffnessError;
use crate::{Elasticity, FeModel};

/// Isotropic elasticity of a part, element by element.
#[derive(Debug, Clone, PartialEq)]
pub struct PartElasticity {
    constants: Vec<Elasticity>,
    /// Which constants each element has; empty: all have the first.
    of_element: Vec<usize>,
}

impl From<Elasticity> for PartElasticity {
    fn from(elasticity: Elasticity) -> Self {
        Self { constants: vec![elasticity], of_element: Vec::new() }
    }
}

impl PartElasticity {
    /// The materials of a model: of each element if the file says so, else the one that they all must be.
    ///
    /// Errors: the file defines no material, one that is not isotropic, or several that differ and not which element has which.
    pub fn of_model(model: &FeModel) -> Result<Self, GeometricStiffnessError> {
        let isotropic = model.materials.iter().map(|material| {
            let name = || GeometricStiffnessError::NotIsotropic { material: material.name.clone() };
            material.elasticity.ok_or_else(name)
        });
        let constants = isotropic.collect::<Result<Vec<_>, _>>()?;
        let Some(&first) = constants.first() else { return Err(GeometricStiffnessError::NoMaterial) };
        if model.element_materials.is_empty()
            && let Some(number) = constants.iter().position(|constants| *constants != first)
        {
            return Err(GeometricStiffnessError::SeveralMaterials {
                first: first.youngs_modulus,
                material: model.materials[number].name.clone(),
                second: constants[number].youngs_modulus,
            });
        }
        Ok(Self { constants, of_element: model.element_materials.clone() })
    }

    /// The constants of an element.
    ///
    /// Errors: it has none.
    pub fn of(&self, element: usize) -> Result<&Elasticity, ElementError> {
        let number = if self.of_element.is_empty() { Some(&0) } else { self.of_element.get(element) };
        let materials = self.constants.len();
        number
            .and_then(|&number| self.constants.get(number))
            .ok_or(ElementError::NoMaterial { element, materials })
    }

    /// The constants of all materials, at least one.
    pub fn constants(&self) -> &[Elasticity] {
        &self.constants
    }
}
