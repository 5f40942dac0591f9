//! Transfer functions of the interfaces: the reduced against the full model over frequency.

use faer::Mat;

use crate::{FeError, FeModel};

use super::ComponentModeError;
use super::compute::ComponentModes;
use super::coordinates::Coordinates;
use super::dynamic_stiffness::DynamicStiffness;
use super::frequency::eigenvalue;
use super::interface_motion::InterfaceMotion;
use super::rigid_motion::RigidMotion;

/// The elastic receptance of the interfaces at one frequency.
///
/// H(ω) = B (K - ω²M)⁻¹ Bᵀ less the rigid part, which every basis holds exactly. Rows and columns are the interface
/// motions, each scaled by the square root of its static elastic compliance in the full model: dimensionless.
#[derive(Debug, Clone, PartialEq)]
pub struct TransferPoint {
    /// Units: Hz.
    pub frequency_hz: f64,
    /// Frobenius norm of the scaled receptance of the full model.
    pub full: f64,
    /// The same of the reduced model.
    pub reduced: f64,
    /// Norm of the difference over that of the full model.
    pub error: f64,
}

/// Compares full and reduced model at frequencies.
///
/// Undamped: near a resonance a small shift of frequency shows as a large error, as it should.
/// Errors: those of [`component_modes`](super::component_modes); a frequency on a resonance.
pub fn transfer_functions(
    model: &FeModel,
    modes: &ComponentModes,
    frequencies_hz: &[f64],
) -> Result<Vec<TransferPoint>, FeError> {
    let compared = compare_bases(model, &[modes], frequencies_hz)?;
    Ok(compared.into_iter().flatten().collect())
}

/// Compares several bases of the same interfaces with the full model, which is solved once at each frequency.
///
/// One list for each basis, with one point for each frequency. Interfaces are those of the first.
/// Errors: as [`transfer_functions`]; bases with other interfaces.
pub fn compare_bases(
    model: &FeModel,
    bases: &[&ComponentModes],
    frequencies_hz: &[f64],
) -> Result<Vec<Vec<TransferPoint>>, FeError> {
    let Some(first) = bases.first() else { return Ok(Vec::new()) };
    if let Some(other) = bases.iter().find(|basis| basis.interfaces != first.interfaces) {
        let names = |basis: &ComponentModes| -> Vec<String> {
            basis.interfaces.iter().map(|interface| interface.name.clone()).collect()
        };
        return Err(ComponentModeError::OtherInterfaces { first: names(first), other: names(other) }.into());
    }
    let coordinates = Coordinates::new(model, &first.interfaces)?;
    let motion = InterfaceMotion::new(&coordinates, &first.interfaces)?;
    let rigid = RigidMotion::new(&coordinates)?;
    let mut forces = motion.forces(&coordinates);
    rigid.balance(&mut forces);
    let stiffness = DynamicStiffness::new(&coordinates)?;
    let scale = first.report.compliance.iter().map(|x| x.sqrt().recip()).collect::<Vec<_>>();
    let scaled = |matrix: &Mat<f64>| {
        Mat::from_fn(scale.len(), scale.len(), |i, j| matrix[(i, j)] * scale[i] * scale[j])
    };
    let mut compared = vec![Vec::with_capacity(frequencies_hz.len()); bases.len()];
    for &frequency_hz in frequencies_hz {
        let mut shapes = stiffness.solve(frequency_hz, forces.as_ref())?;
        rigid.remove_from(&mut shapes);
        let full = scaled(&motion.of(&coordinates, shapes.as_ref()));
        for (points, modes) in compared.iter_mut().zip(bases) {
            let reduced = scaled(&modes.elastic_receptance(frequency_hz));
            let error = (&full - &reduced).norm_l2() / full.norm_l2();
            let (full, reduced) = (full.norm_l2(), reduced.norm_l2());
            points.push(TransferPoint { frequency_hz, full, reduced, error });
        }
    }
    Ok(compared)
}

impl ComponentModes {
    /// Elastic receptance of the interfaces in the reduced model: Σ b_k b_kᵀ / (ω_k² - ω²), undamped.
    ///
    /// Shape: 6 I x 6 I. Units: m/N, rad/N, m/(N m), rad/(N m). Frame: body.
    pub fn elastic_receptance(&self, frequency_hz: f64) -> Mat<f64> {
        let value = eigenvalue(frequency_hz);
        let rows = self.modal_motion.nrows();
        let scaled = Mat::from_fn(rows, self.modal_values.len(), |i, k| {
            self.modal_motion[(i, k)] / (self.modal_values[k] - value)
        });
        &scaled * self.modal_motion.transpose()
    }
}
