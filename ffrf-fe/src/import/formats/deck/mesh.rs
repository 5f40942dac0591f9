//! The content of one part or instance before the whole model is put together.

use crate::ElementKind;

/// Nodes, elements and sets in the labels of one part or instance.
#[derive(Debug, Clone, Default)]
pub(super) struct Mesh {
    /// Name of the part or instance; empty for the assembly or a flat deck.
    pub(super) name: String,
    /// Labels.
    pub(super) ids: Vec<u64>,
    /// Where each node is defined.
    pub(super) places: Vec<Place>,
    /// Coordinates as in the file.
    pub(super) positions: Vec<[f64; 3]>,
    /// Elements of all kinds.
    pub(super) elements: Vec<RawElement>,
    /// Node sets in file order; a name may come several times.
    pub(super) sets: Vec<RawSet>,
    /// Where an instance stands.
    pub(super) placement: Placement,
}

impl Mesh {
    /// Nodes, elements and set members: what a copy costs.
    pub(super) fn items(&self) -> usize {
        let members: usize = self.sets.iter().map(|set| 1 + set.members.len()).sum();
        1 + self.ids.len() + self.elements.len() + members
    }
}

/// A place in one of the files of the deck.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Place {
    /// Number of the file.
    pub(super) source: usize,
    /// Byte offset.
    pub(super) at: usize,
}

/// An element in labels.
#[derive(Debug, Clone)]
pub(super) struct RawElement {
    /// `None` for kinds that cannot be drawn.
    pub(super) kind: Option<ElementKind>,
    /// Node labels.
    pub(super) nodes: Vec<u64>,
    /// Where it is defined.
    pub(super) place: Place,
}

/// A node set in labels.
#[derive(Debug, Clone)]
pub(super) struct RawSet {
    /// Name as written.
    pub(super) name: String,
    /// Instance whose labels are meant, if one is named.
    pub(super) instance: Option<String>,
    /// Members with their places.
    pub(super) members: Vec<(Member, Place)>,
}

/// A member of a node set.
#[derive(Debug, Clone)]
pub(super) enum Member {
    /// A node.
    Label(u64),
    /// first, last, step.
    Range(u64, u64, u64),
    /// Another set, or `instance.label`.
    Name(String),
}

/// Translation, then rotation about an axis through two points.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Placement {
    /// Units: m.
    pub(super) translation: [f64; 3],
    /// Points a and b of the axis (m) and the angle in degrees.
    pub(super) rotation: Option<([f64; 3], [f64; 3], f64)>,
}

impl Placement {
    /// Position of a node of the instance in the assembly.
    pub(super) fn apply(&self, position: [f64; 3]) -> [f64; 3] {
        let moved: [f64; 3] = std::array::from_fn(|i| position[i] + self.translation[i]);
        let Some((a, b, degrees)) = self.rotation else { return moved };
        let axis: [f64; 3] = std::array::from_fn(|i| b[i] - a[i]);
        let length = axis.iter().map(|component| component * component).sum::<f64>().sqrt();
        if length == 0.0 {
            return moved;
        }
        let n = axis.map(|component| component / length);
        let r: [f64; 3] = std::array::from_fn(|i| moved[i] - a[i]);
        let (sin, cos) = degrees.to_radians().sin_cos();
        let along = n[0] * r[0] + n[1] * r[1] + n[2] * r[2];
        let cross = [n[1] * r[2] - n[2] * r[1], n[2] * r[0] - n[0] * r[2], n[0] * r[1] - n[1] * r[0]];
        // Rodrigues' formula
        std::array::from_fn(|i| a[i] + cos * r[i] + sin * cross[i] + (1.0 - cos) * along * n[i])
    }
}
