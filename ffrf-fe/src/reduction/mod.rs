//! From [`FeModel`](crate::FeModel) and [`ModeBasis`](crate::ModeBasis) to [`ffrf_model::ReducedBody`].

mod damping;
mod invariants;
mod marker;
mod mean_axis;
mod options;
mod reduce;
mod stiffness;

pub use crate::error::ReductionError;
pub use marker::marker_motion;
pub(crate) use marker::unit_loads_at;
pub use options::{Damping, DampingBand, MarkerRequest, ReductionOptions};
pub use reduce::{MODE_SHAPES, reduce};
