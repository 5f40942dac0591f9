//! Geometric stiffness of unit forces and moments at markers.

use faer::Mat;
use ffrf_model::{Marker, MarkerLoadStiffness};

use crate::reduction::unit_loads_at;
use crate::{Elasticity, FeError, FeModel, ModeBasis};

use super::compute::stress_stiffness;
use super::loads::COUNT;
use super::support::PrestressSupport;

/// Loads of a marker: three forces, three moments.
const OF_MARKER: usize = 6;

/// What the stresses of unit forces and moments at markers add to the stiffness of the modes.
///
/// The load acts on the nodes of the marker as the marker follows them: the transpose of the map from nodal displacements to its
/// translation and rotation, a mean and a least-squares fit. It is balanced by what holds the frame: a clamp, interfaces, or in mean
/// axes the inertia of the part. A load on nodes that are held has no stiffness.
/// Errors: as those of [`geometric_stiffness`](super::geometric_stiffness); nodes of a marker that do not exist or whose
/// rotation cannot be told.
pub fn marker_load_stiffness(
    model: &FeModel,
    basis: &ModeBasis,
    support: &PrestressSupport,
    elasticity: Option<Elasticity>,
    markers: &[&Marker],
) -> Result<Vec<MarkerLoadStiffness>, FeError> {
    let modes = basis.modes.len();
    let mut found = Vec::with_capacity(markers.len());
    // As many markers at a time as inertial loads are.
    for group in markers.chunks(COUNT / OF_MARKER) {
        let mut loads = Mat::zeros(3 * model.nodes.len(), COUNT);
        for (place, marker) in group.iter().enumerate() {
            let forces = unit_loads_at(model, marker)?;
            for k in 0..OF_MARKER {
                loads.col_as_slice_mut(OF_MARKER * place + k).copy_from_slice(forces.col_as_slice(k));
            }
        }
        let stiffness = stress_stiffness(model, basis, support, elasticity, loads.as_ref())?;
        for (place, marker) in group.iter().enumerate() {
            let pair = |mu: usize, nu: usize| {
                let all = &stiffness[mu.min(nu)][mu.max(nu)];
                std::array::from_fn(|k| all[OF_MARKER * place + k])
            };
            found.push(MarkerLoadStiffness {
                marker: marker.name.clone(),
                stiffness: (0..modes).map(|mu| (0..modes).map(|nu| pair(mu, nu)).collect()).collect(),
            });
        }
    }
    Ok(found)
}
