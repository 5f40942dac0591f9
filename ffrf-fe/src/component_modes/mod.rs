//! Component modes: bases that are right where joints hold the part.
//!
//! The way through this module: nodes chosen by `selection` become an [`Interface`] (rigid, `coupling_rbe2`, or by
//! mean, `coupling_rbe3`); `coordinates` writes the part with its rigid couplings as u = T y, `interface_motion`
//! reads the interfaces off y; one factor of the supported stiffness gives `flexibility`, and with the interfaces
//! prescribed `constrained`; from these `craig_bampton`, `attachment`, `residual` and `herting` make shapes,
//! `free_free` makes orthonormal modes in mean axes of them (or `raw` keeps them), `mode_selection` chooses by
//! `importance`, `reference_condition` sets the frame; [`reduce_component_modes`] makes the body, with a marker at
//! each reference point. `transfer_function` says how well the result follows the full model, `mac` how alike two
//! bases are.

mod area_weights;
mod attachment;
mod body;
mod compute;
mod condition;
mod constrained;
mod coordinates;
mod coupling_rbe2;
mod coupling_rbe3;
mod craig_bampton;
mod dense_modes;
mod dynamic_stiffness;
mod flexibility;
mod free_free;
mod frequency;
mod herting;
mod importance;
mod interface;
mod interface_motion;
mod jacobi;
mod mac;
mod mode_selection;
mod normal_modes;
mod products;
mod raw;
mod reference_condition;
mod report;
mod request;
mod residual;
mod rigid_motion;
mod selection;
mod shapes;
mod small;
mod static_load;
mod static_shapes;
mod transfer_function;

pub use crate::error::ComponentModeError;
pub use area_weights::area_weights;
pub use body::reduce_component_modes;
pub use compute::{ComponentModes, component_modes};
pub use interface::{Coupling, Interface};
pub use mac::{mac, mass_weighted_mac};
pub use mode_selection::ModeSelection;
pub use reference_condition::ReferenceCondition;
pub use report::{ComponentEntry, ComponentReport, NormalEntry};
pub use request::{BasisForm, ComponentBasis, ComponentRequest};
pub use selection::NodeSelection;
pub use static_load::StaticLoad;
pub(crate) use static_shapes::{static_responses, static_shapes};
pub use transfer_function::{TransferPoint, compare_bases, transfer_functions};
