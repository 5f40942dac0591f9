//! From component modes to a reduced body: interface reference points become markers.

use ffrf_model::{InterfaceCoupling, Marker, ReducedBody};

use crate::reduction::{ReductionOptions, reduce};
use crate::{FeError, FeModel};

use super::{ComponentModes, Coupling};

/// Reduces a model to component modes.
///
/// Every interface becomes a marker of its name at its reference point, in front of the markers of `options`. Its
/// rows are the motion of the coupled reference point, so that a joint or a force there acts on the body exactly as
/// the coupling says. A modal stiffness in `options` is replaced by that of the modes.
/// Errors: those of [`reduce`]; a marker with the name of an interface.
pub fn reduce_component_modes(
    model: &FeModel,
    modes: &ComponentModes,
    options: &ReductionOptions,
) -> Result<ReducedBody, FeError> {
    let options = ReductionOptions { modal_stiffness: Some(modes.stiffness.clone()), ..options.clone() };
    let mut body = reduce(model, &modes.basis, &options)?;
    let count = modes.basis.modes.len();
    let markers = modes.interfaces.iter().enumerate().map(|(number, interface)| {
        let row = |first: usize, mode: usize| {
            [0, 1, 2].map(|i| modes.interface_motion[(6 * number + first + i, mode)])
        };
        Marker {
            name: interface.name.clone(),
            nodes: interface.nodes.iter().map(|&row| model.nodes.ids[row]).collect(),
            position: interface.reference_point,
            translation: (0..count).map(|mode| row(0, mode)).collect(),
            rotation: (0..count).map(|mode| row(3, mode)).collect(),
            coupling: Some(match interface.coupling {
                Coupling::Rigid => InterfaceCoupling::Rigid,
                Coupling::Average { .. } => InterfaceCoupling::Average,
            }),
        }
    });
    body.markers = markers.chain(body.markers).collect();
    body.check()?.verdict()?;
    Ok(body)
}
