//! Solid elements for models made here: examples, benchmarks and tests. Imported models bring their own matrices.

mod assemble;
mod isoparametric;
mod material;
mod rules;
pub(crate) mod shapes;

pub use crate::error::ElementError;
pub use assemble::{assemble, brick};
pub use isoparametric::{ElementMatrices, QuadraturePoint, element_matrices, quadrature};
pub use material::Material;
