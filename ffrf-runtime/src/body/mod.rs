//! What a body is (model), what depends on its state (data), and what can be seen of it.

mod dense_forms;
mod flexible_body;
mod free_body;
mod free_system;
mod implicit;
mod increment;
mod load;
mod marker;
mod marker_motion;
mod marker_rows;
mod marker_step;
mod modal_matrix;
mod modal_vector;
mod motion;
mod named_markers;
mod observables;
mod oscillator;
mod pair;
mod prepared;
mod rigid_body;
mod span;
mod span_marker;
mod state;

pub use dense_forms::{DenseForms, EquationsOfMotion};
pub use flexible_body::FlexibleBody;
pub use free_body::FreeBody;
pub use free_system::FreeSystem;
pub use increment::Increment;
pub use load::Load;
pub use marker::Marker;
pub use marker_motion::{MarkerMotion, PlacedMarker, Wrench};
pub use marker_step::MarkerStep;
pub use modal_matrix::{ModalFactors, ModalMatrix};
pub use modal_vector::ModalVector;
pub use motion::{GeneralisedForce, Motion};
pub use named_markers::NamedMarkers;
pub use observables::Observables;
pub use pair::{Pair, PairSystem};
pub use prepared::{Eliminated, Factored, Prepared};

pub(crate) use implicit::ImplicitBody;
pub use oscillator::Oscillators;
pub use rigid_body::RigidBody;
pub(crate) use span::Span;
pub(crate) use span_marker::SpanMarker;
pub use state::State;
