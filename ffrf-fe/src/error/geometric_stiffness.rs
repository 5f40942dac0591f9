//! What can go wrong with geometric stiffness.

use ffrf_model::printable;

/// What can go wrong with geometric stiffness.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GeometricStiffnessError {
    /// There is nothing that stresses could be computed in.
    #[error(
        "geometric stiffness needs the elements of the part: give a mesh, or the deck with --abaqus, --calculix or --nastran"
    )]
    NoElements,
    /// Nothing says what the elements are made of.
    #[error("the files define no *ELASTIC material: give its constants with --elastic E,NU")]
    NoMaterial,
    /// A material that is not isotropic, or that changes with temperature.
    #[error(
        "material {}: expected one *ELASTIC line of an isotropic material; give its constants with --elastic E,NU",
        printable(material)
    )]
    NotIsotropic {
        /// Name of the material.
        material: String,
    },
    /// Materials that differ.
    #[error(
        "material {} has E = {second:e}, one before it {first:e}: expected a part of one material; if they are the same \
         for this purpose, give the constants with --elastic E,NU",
        printable(material)
    )]
    SeveralMaterials {
        /// Young's modulus of the first material. Units: N/m².
        first: f64,
        /// Name of the other.
        material: String,
        /// Young's modulus of the other. Units: N/m².
        second: f64,
    },
    /// Constants of no stable material.
    #[error("E = {youngs_modulus:e}, nu = {poisson_ratio}: expected E > 0 and -1 < nu < 0.5")]
    Unstable {
        /// Young's modulus. Units: N/m².
        youngs_modulus: f64,
        /// Poisson's ratio.
        poisson_ratio: f64,
    },
    /// The material is not the one that the stiffness matrix was made with.
    #[error(
        "the elements store {ratio:.3} times the strain energy that the stiffness matrix says, with E = {youngs_modulus:e}: \
         expected about 1; the material or its units are not those of the matrix, or elements are missing"
    )]
    Energy {
        /// Strain energy of the elements over that of the matrix.
        ratio: f64,
        /// Young's modulus. Units: N/m².
        youngs_modulus: f64,
    },
}
