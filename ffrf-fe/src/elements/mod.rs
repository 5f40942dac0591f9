//! Solid elements: matrices of models made here (examples, benchmarks, tests; imported models bring their own), and
//! displacement gradients and stresses inside the elements of any model.

mod assemble;
mod isoparametric;
mod material;
mod recovery;
mod rules;
pub(crate) mod shapes;

pub use crate::error::ElementError;
pub use assemble::{assemble, brick, quadratic_brick};
pub use isoparametric::{ElementMatrices, QuadraturePoint, element_matrices, quadrature};
pub use material::Material;
pub use recovery::nodal_gradients;
