//! Bodies of run-time size.

mod host_body;
mod modal_vector;

pub use host_body::HostBody;
pub use modal_vector::HostModal;
