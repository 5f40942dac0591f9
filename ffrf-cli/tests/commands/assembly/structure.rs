//! A structure of solid parts with rigid interfaces, of which joints share motions: one description, read by the reduced scene,
//! the assembled matrices and the deck.

use ffrf_fe::FeModel;
use ffrf_fe::component_modes::Interface;
use ffrf_fe::elements::Material;

/// One part, where it stands in the structure.
pub struct Part {
    pub name: &'static str,
    pub model: FeModel,
    pub material: Material,
    pub interfaces: Vec<Interface>,
}

/// Motion `axis` (translations along x, y, z, then rotations about them) of an interface of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Motion {
    pub part: usize,
    pub interface: usize,
    pub axis: usize,
}

/// Parts and what ties their interfaces to each other and to the ground.
#[derive(Default)]
pub struct Structure {
    pub parts: Vec<Part>,
    /// Motions at rest.
    pub held: Vec<Motion>,
    /// Motions that are one: the second follows the first.
    pub shared: Vec<(Motion, Motion)>,
    /// Springs to the ground: N/m or N m/rad.
    pub springs: Vec<(Motion, f64)>,
    /// Masses that move along with a translation: kg.
    pub masses: Vec<(Motion, f64)>,
}

impl Structure {
    /// Motions of one interface.
    pub fn motions(part: usize, interface: usize, axes: &[usize]) -> Vec<Motion> {
        axes.iter().map(|&axis| Motion { part, interface, axis }).collect()
    }
}
