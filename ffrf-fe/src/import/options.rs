//! What the user allows an import to take for granted.

/// Largest inflated size of one compressed file unless the user allows more. Units: bytes.
pub const INFLATED_LIMIT: u64 = 8 << 30;

/// Choices of an import; the default takes nothing for granted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ImportOptions {
    /// What the rows of the mass matrix are.
    pub mass_form: MassForm,
    /// Accept nodes that carry stiffness and no mass, or mass and no stiffness.
    pub allow_massless: bool,
    /// Largest inflated size of one compressed file or array. Units: bytes.
    pub inflated_limit: u64,
}

impl Default for ImportOptions {
    fn default() -> Self {
        Self { mass_form: MassForm::Declared, allow_massless: false, inflated_limit: INFLATED_LIMIT }
    }
}

/// What the rows of a mass matrix are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MassForm {
    /// What the file declares: N x N is the scalar mass, 3N x 3N that of all degrees of freedom. A list without a
    /// header declares nothing and is taken for 3N x 3N.
    #[default]
    Declared,
    /// The scalar mass M_s, one row a node, also in a list without a header.
    Scalar,
    /// All degrees of freedom, three rows a node.
    Full,
}
