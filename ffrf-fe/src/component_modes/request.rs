//! What the user asks of a component basis.

use std::fmt;

use super::{Interface, ModeSelection, ReferenceCondition, StaticLoad};

/// Which component modes to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct ComponentRequest {
    /// The interfaces, at least one.
    pub interfaces: Vec<Interface>,
    /// Which shapes span the basis.
    pub basis: ComponentBasis,
    /// Number of normal modes, rigid motion not counted.
    pub normal_modes: usize,
    /// Loads whose static deformation the basis shall hold exactly.
    pub static_loads: Vec<StaticLoad>,
    /// Orthonormal modes or the shapes themselves.
    pub form: BasisForm,
    /// Which of the transformed modes to keep.
    pub selection: ModeSelection,
    /// The frame that deformation is measured in.
    pub reference: ReferenceCondition,
    /// 1 to use one thread only. The result is the same to the bit.
    pub threads: usize,
}

impl ComponentRequest {
    /// A Craig-Bampton basis with `normal_modes` clamped modes, transformed to free-free modes in mean axes.
    pub fn craig_bampton(interfaces: Vec<Interface>, normal_modes: usize) -> Self {
        Self {
            interfaces,
            basis: ComponentBasis::CraigBampton,
            normal_modes,
            static_loads: Vec::new(),
            form: BasisForm::FreeFree,
            selection: ModeSelection::default(),
            reference: ReferenceCondition::MeanAxes,
            threads: 0,
        }
    }
}

/// Which shapes span the basis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ComponentBasis {
    /// Constraint modes and normal modes with the interfaces at rest.
    #[default]
    CraigBampton,
    /// Attachment modes (inertia relief) and free normal modes.
    Attachment,
    /// Free normal modes and their residual attachment modes.
    Rubin,
    /// Constraint modes, inertia-relief modes, and free normal modes relative to the interfaces.
    Herting,
    /// Free normal modes alone: what interfaces need static shapes for is seen against it.
    FreeFree,
    /// Normal modes with the first interface at rest, alone.
    Clamped,
}

impl ComponentBasis {
    /// Every basis.
    pub const ALL: [Self; 6] =
        [Self::FreeFree, Self::Clamped, Self::CraigBampton, Self::Attachment, Self::Rubin, Self::Herting];

    /// True if its shapes are constraint modes and normal modes with all interfaces at rest.
    pub fn is_clamped(self) -> bool {
        self == Self::CraigBampton
    }

    /// How many modes the basis has beside its normal modes, rigid motion removed, if no shape depends on others.
    ///
    /// `interfaces` is their number, `rigid` that of rigid motions.
    pub fn static_shapes(self, interfaces: usize, rigid: usize) -> usize {
        match self {
            Self::FreeFree | Self::Clamped => 0,
            Self::CraigBampton => (6 * interfaces).saturating_sub(rigid),
            Self::Attachment | Self::Rubin | Self::Herting => 6 * interfaces,
        }
    }
}

impl fmt::Display for ComponentBasis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::CraigBampton => "Craig-Bampton",
            Self::Attachment => "attachment",
            Self::Rubin => "Rubin (residual flexibility)",
            Self::Herting => "Herting",
            Self::FreeFree => "free-free",
            Self::Clamped => "clamped",
        })
    }
}

/// Orthonormal modes or the shapes themselves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BasisForm {
    /// Rotated to the eigenmodes of the unsupported part within the span: Θ_ff = I and K_ff diagonal.
    #[default]
    FreeFree,
    /// The shapes as they are, less what rigid motion and other shapes already hold: Θ_ff and K_ff are full.
    Raw,
}
