//! What can go wrong with a cut through a part.

/// What can go wrong with a cut through a part.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SectionError {
    /// A normal without direction, or numbers that are not finite.
    #[error("section {section}: expected a point and a normal that is not zero, of finite numbers")]
    Plane {
        /// Name of the cut.
        section: String,
    },
    /// All nodes are on one side.
    #[error(
        "section {section}: expected nodes on both sides of the plane, found {before} on the side of the normal and \
         {behind} on the other"
    )]
    OneSide {
        /// Name of the cut.
        section: String,
        /// Nodes on the side of the normal.
        before: usize,
        /// Nodes on the plane and on the other side.
        behind: usize,
    },
}
