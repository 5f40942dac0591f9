//! The force elements that implicit steps take into their matrix, by the names of their types in the runtime.

use super::{JointTopology, Topology};

/// How many soft rows each kind has; its `soften` pushes as many.
const SOFT_ROWS: [(&str, usize); 4] = [("Spring", 3), ("TorsionSpring", 1), ("Bushing", 6), ("Friction", 1)];

/// The number of soft rows of an element of this type; `None` for those that implicit steps too take as forces.
pub fn soft_row_count(type_name: &str) -> Option<usize> {
    SOFT_ROWS.iter().find(|(name, _)| *name == type_name).map(|(_, rows)| *rows)
}

impl Topology {
    /// The same mechanism with soft links behind its joints.
    #[must_use]
    pub fn with_soft_links(&self, links: impl IntoIterator<Item = JointTopology>) -> Self {
        let mut whole = self.clone();
        whole.joints.extend(links);
        whole
    }
}
