//! The classical way: inertia shape integrals by quadrature over the elements, and lumped masses.
//!
//! The floating frame of reference is usually built from volume integrals of products of positions and mode shapes,
//! (112), (114), (122), (125), (131). Here they are evaluated element by element, sharing no formula with the
//! invariants that this crate takes from the assembled mass matrix, so that the two can be compared one to one.
//! Commercial codes often replace the consistent mass by a lumped one; [`LumpedMass`] says what that costs.
//!
//! What it costs, measured: `docs/theory/lumped_mass.md` of the repository.

mod integrals;
mod lumping;
mod mapping;
mod rules;

pub use integrals::{ShapeIntegrals, shape_integrals};
pub use lumping::LumpedMass;
pub use mapping::{Point, element_points};
