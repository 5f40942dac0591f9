//! A scene as a functional mock-up unit (FMU): what it shows to other tools, and the C functions that they call.
//!
//! ```text
//! scene.toml + models ──model──▶ variables ──description──▶ modelDescription.xml
//!                          ├─────instance──▶ CoSimulation of ffrf-host ◀──ffi── fmi2*, fmi3*
//!                          └─────c_sources─▶ the step of ffrf-codegen in C, and fmi2*, fmi3* about it
//! ```
//!
//! Source: Functional Mock-up Interface Specification, versions 3.0.2 and 2.0.5 (Modelica Association), co-simulation.
//! No panic and no Rust type crosses the border to C; `unsafe` stands in [`ffi`] alone.

mod c_sources;
pub mod description;
#[allow(unsafe_code)] // the border to C
pub mod ffi;
mod instance;
mod model;
mod packed;
mod parameter;
mod saved;
mod sources;
mod variables;

pub use c_sources::SourcesError;
pub use instance::{Arrival, Instance, InstanceError};
pub use model::{Model, ModelError, SCENE};
pub use packed::{packed_path, sources};
pub use parameter::Parameter;
pub use saved::Saved;
pub use sources::Sources;
pub use variables::{Role, Variable};

/// What a library of this crate carries in its bytes, so that the command knows one of its own version.
pub const MARK: &str = concat!("ffrf-fmu library of version ", env!("CARGO_PKG_VERSION"), ";");
