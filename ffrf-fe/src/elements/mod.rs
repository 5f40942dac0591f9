//! Solid elements: matrices of models made here or read as a mesh (other imports bring their own), and displacement gradients and stresses inside the elements of any model.

mod assemble;
mod error;
mod isoparametric;
mod material;
mod recovery;
mod rules;
pub(crate) mod shapes;

pub use assemble::{assemble, assemble_materials, brick, quadratic_brick};
pub use error::ElementError;
pub use isoparametric::{ElementMatrices, QuadraturePoint, element_matrices, quadrature};
pub use material::Material;
pub use recovery::nodal_gradients;
