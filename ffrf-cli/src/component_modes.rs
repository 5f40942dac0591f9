//! `ffrf reduce --interface ...`: a body with component modes.

use anyhow::{Context, Result, bail};
use ffrf_fe::component_modes::{
    BasisForm, ComponentRequest, Interface, ModeSelection, StaticLoad, area_weights, component_modes,
    reduce_component_modes,
};
use ffrf_fe::geometric_stiffness::PrestressSupport;
use ffrf_fe::modes::Progress;
use ffrf_fe::reduction::ReductionOptions;
use ffrf_fe::{FeModel, ModeBasis};
use ffrf_model::ReducedBody;

use crate::arguments::{CouplingArgument, InterfaceArgument, InterfaceChoice, Reduce};
use crate::{section, stiffening, stress, transfer};

/// The body, its basis, and what there is to say about its modes.
pub fn reduce(
    model: &FeModel,
    arguments: &Reduce,
    options: &ReductionOptions,
    progress: &mut dyn FnMut(Progress),
) -> Result<(ReducedBody, ModeBasis, String)> {
    let choice = &arguments.interfaces;
    let Some(normal_modes) = arguments.choice.modes else {
        bail!("--interface needs --modes, the number of normal modes of its basis (0 for none)");
    };
    if arguments.choice.clamp.is_some() {
        bail!(
            "--clamp and --interface exclude each other: a Craig-Bampton basis holds the interfaces itself"
        );
    }
    if arguments.modal_stiffness.is_some() {
        bail!("--modal-stiffness goes with --mode-shapes, not with --interface");
    }
    let request = request(model, choice, normal_modes)?;
    let modes =
        component_modes(model, &request, progress).context("the component modes could not be computed")?;
    let mut text = format!("{}\n", modes.report);
    if let Some(limit) = choice.transfer_up_to {
        text.push_str(&transfer::compare(model, &modes, &request, choice, limit)?);
    }
    let mut body = reduce_component_modes(model, &modes, options)?;
    let support =
        PrestressSupport::Interfaces { interfaces: request.interfaces, reference: request.reference };
    let conversion = arguments.files.conversion();
    stiffening::add(&mut body, model, &modes.basis, &support, &arguments.stiffening, conversion)?;
    stress::add(&mut body, model, &modes.basis, arguments)?;
    section::add(&mut body, model, &modes.basis, arguments)?;
    Ok((body, modes.basis, text))
}

fn request(model: &FeModel, choice: &InterfaceChoice, normal_modes: usize) -> Result<ComponentRequest> {
    let interfaces = choice
        .interfaces
        .iter()
        .map(|argument| interface(model, argument).with_context(|| format!("--interface {}", argument.name)));
    let loads = choice.static_loads.iter().map(|load| {
        let rows = load.nodes.rows(&model.nodes).context("--static-load")?;
        Ok(StaticLoad::uniform(&rows, load.force))
    });
    Ok(ComponentRequest {
        basis: choice.basis.into(),
        static_loads: loads.collect::<Result<_>>()?,
        form: if choice.raw { BasisForm::Raw } else { BasisForm::FreeFree },
        selection: ModeSelection {
            above_hz: choice.keep_above,
            below_hz: choice.keep_below,
            importance: choice.keep_importance,
            count: choice.keep_count,
        },
        reference: choice.reference.clone(),
        ..ComponentRequest::craig_bampton(interfaces.collect::<Result<_>>()?, normal_modes)
    })
}

fn interface(model: &FeModel, argument: &InterfaceArgument) -> Result<Interface> {
    let rows = argument.nodes.rows(&model.nodes)?;
    let interface = Interface::rigid(model, &argument.name, &rows)?;
    let interface = match argument.coupling {
        CouplingArgument::Rigid => interface,
        CouplingArgument::Mean => interface.averaged(),
        CouplingArgument::MeanByArea => {
            let weights = area_weights(model, interface.nodes())?;
            interface.weighted(model, weights)?
        }
    };
    Ok(match argument.reference_point {
        Some(point) => interface.at(point)?,
        None => interface,
    })
}
