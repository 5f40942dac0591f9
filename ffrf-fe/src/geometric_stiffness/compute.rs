//! Geometric stiffness of a mode basis.

use faer::MatRef;
use ffrf_model::GeometricStiffness;

use crate::modes::ModeError;
use crate::{Elasticity, FeError, FeModel, ModeBasis, PartElasticity};

use super::GeometricStiffnessError;
use super::integrate::{self, Integrals, integrate};
use super::loads::{COUNT, by_load, unit_loads};
use super::support::{PrestressSupport, displacements};

/// Factor by which the strain energy of the elements may differ from that of the stiffness matrix.
///
/// Reduced integration and incompatible modes soften an element by some per cent, a coarse bent mesh by up to a half; a material in
/// other units differs by a factor of a thousand and more.
const ENERGY_FACTOR: f64 = 3.0;

/// Geometric stiffness of the modes under unit inertial loads.
///
/// The loads are those of the mass matrix, the displacements those of the stiffness matrix; the stresses follow inside the
/// elements, by `elasticity` or else by the material of each element.
/// Source: Zienkiewicz, Taylor, The Finite Element Method (initial stress matrix); loads as in Wallrapp, Mechanics of Structures and
/// Machines 22 (1994), standard input data K0.
/// Errors: no elements, no material or several that are not told apart, a material whose strain energy is not that of the stiffness matrix, elements
/// that are not usable, a support on which the stiffness is not positive definite.
pub fn geometric_stiffness(
    model: &FeModel,
    basis: &ModeBasis,
    support: &PrestressSupport,
    elasticity: Option<Elasticity>,
) -> Result<GeometricStiffness, FeError> {
    let loads = unit_loads(model);
    let stiffness = stress_stiffness(model, basis, support, elasticity, loads.as_ref())?;
    let modes = basis.modes.len();
    let pair = |mu: usize, nu: usize| by_load(&stiffness[mu.min(nu)][mu.max(nu)]);
    let list = || 0..modes;
    Ok(GeometricStiffness {
        uniform_load: list().map(|mu| list().map(|nu| pair(mu, nu).0).collect()).collect(),
        linear_load: list().map(|mu| list().map(|nu| pair(mu, nu).1).collect()).collect(),
        marker_loads: Vec::new(),
    })
}

/// Γ_μν of the stresses of each load, at [mu][nu] with mu <= nu. `loads`: nodal forces. Shape: 3N x [`COUNT`].
///
/// Errors: those of [`geometric_stiffness`].
pub(super) fn stress_stiffness(
    model: &FeModel,
    basis: &ModeBasis,
    support: &PrestressSupport,
    elasticity: Option<Elasticity>,
    loads: MatRef<'_, f64>,
) -> Result<Vec<Vec<[f64; COUNT]>>, FeError> {
    if model.elements.is_empty() {
        return Err(GeometricStiffnessError::NoElements.into());
    }
    let elasticity = match elasticity {
        Some(given) => given.into(),
        None => PartElasticity::of_model(model)?,
    };
    let constants = elasticity.constants();
    if let Some(&Elasticity { youngs_modulus, poisson_ratio }) = constants.iter().find(|it| !it.is_stable()) {
        return Err(GeometricStiffnessError::Unstable { youngs_modulus, poisson_ratio }.into());
    }
    let loaded = displacements(model, support, loads)?;
    let Integrals { stiffness, strain_energy } =
        integrate(model, &elasticity, loaded.as_ref(), basis.shapes.as_ref())?;
    let matrix = model.stiffness.as_ref().ok_or(ModeError::MissingStiffness)?;
    let (matrix_energy, factor) = (integrate::strain_energy(matrix, &loaded), ENERGY_FACTOR);
    let agree = strain_energy <= factor * matrix_energy && matrix_energy <= factor * strain_energy;
    if !agree {
        let ratio = strain_energy / matrix_energy;
        let youngs_modulus = constants.iter().fold(0.0_f64, |most, it| most.max(it.youngs_modulus));
        return Err(GeometricStiffnessError::Energy { ratio, youngs_modulus }.into());
    }
    Ok(stiffness)
}
