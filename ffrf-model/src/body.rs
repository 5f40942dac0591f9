//! The reduced flexible body: inertia, stiffness, damping, modes, markers, and where they came from.

use serde::{Deserialize, Serialize};

use crate::geometric_stiffness::GeometricStiffness;
use crate::inertia::{Inertia, Vector3};
use crate::second_order_terms::SecondOrderTerms;
use crate::section_marker::SectionMarker;

/// The version of the file format that this library writes, and the only one it reads.
pub const SCHEMA_VERSION: u32 = 1;

/// A flexible body, reduced to `M` modes.
///
/// All quantities are resolved in the body frame, whose origin and axes are those of the node table.
/// Units are the user's, but must be coherent (SI: m, kg, s, N).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ReducedBody {
    /// Version of the file format, see [`SCHEMA_VERSION`].
    pub schema_version: u32,
    /// A line for people.
    pub title: String,
    /// Which units the numbers are in: as [`Units`](crate::Units) prints them, such as `mm, t, s, N`, or
    /// [`UNKNOWN_UNITS`](crate::UNKNOWN_UNITS). Other texts are for people.
    pub units: String,
    /// Which tool made the body, from which files.
    pub provenance: Provenance,
    /// One entry per mode, in the order of the modal coordinates q.
    pub modes: Vec<Mode>,
    /// The inertia invariants (206-208).
    pub inertia: Inertia,
    /// Modal stiffness K_ff. Shape: M x M, symmetric. Units: N/m times (unit of mode shape)^2.
    pub stiffness: Vec<Vec<f64>>,
    /// Modal damping D_ff. Shape: M x M, symmetric.
    pub damping: Vec<Vec<f64>>,
    /// Stress stiffness of unit inertial loads, if it was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub geometric_stiffness: Option<GeometricStiffness>,
    /// Which terms of second order in q the invariants hold: all, unless the body was read from integrals that lack some.
    #[serde(default, skip_serializing_if = "SecondOrderTerms::is_known")]
    pub second_order_terms: SecondOrderTerms,
    /// Points where forces act and where motion is observed.
    pub markers: Vec<Marker>,
    /// Places where stress is observed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub stress_markers: Vec<StressMarker>,
    /// Cuts where the transmitted force is observed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub section_markers: Vec<SectionMarker>,
}

impl ReducedBody {
    /// Number of modes M.
    pub fn mode_count(&self) -> usize {
        self.modes.len()
    }
}

/// Which tool made a body, from which files.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Provenance {
    /// Name of the tool, `ffrf`.
    pub tool: String,
    /// Version of the tool.
    pub tool_version: String,
    /// The files that the body was made from.
    pub sources: Vec<SourceFile>,
    /// What the import took for granted or found odd, such as the form in which a list without a header was read.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// One file that a body was made from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SourceFile {
    /// What the file supplied: `nodes`, `mass`, `stiffness`, `mode shapes`, ...
    pub role: String,
    /// File name without its folder, so that the same data gives the same body everywhere.
    pub file: String,
    /// SHA-256 of the file's bytes, in lower-case hexadecimal.
    pub sha256: String,
}

/// One mode of the basis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mode {
    /// How the mode was made.
    pub kind: ModeKind,
    /// Natural frequency, if the mode is an eigenmode. Units: Hz; cycles per unit of time where the units are not known.
    pub frequency_hz: Option<f64>,
}

/// How a mode was made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum ModeKind {
    /// Eigenmode of the unsupported body.
    FreeFree,
    /// Eigenmode with a node set held fixed.
    Clamped,
    /// Eigenmode of the unsupported body within a basis of component modes (Craig-Bampton, Rubin, ...).
    Component,
    /// Static shape of a unit motion of one interface coordinate, all others at rest.
    Constraint,
    /// Static shape of a load: attachment, inertia relief, static correction.
    Attachment,
    /// Supplied by the user.
    User,
}

/// A point of the body where forces act and where motion is observed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Marker {
    /// Name, unique in the body; letters, digits and underscores.
    pub name: String,
    /// Ids of the nodes whose mean motion the marker follows.
    pub nodes: Vec<u64>,
    /// Reference position in the body frame. Units: m.
    pub position: Vector3,
    /// Displacement per unit modal coordinate, φ_μ at the marker. Shape: M x 3.
    pub translation: Vec<Vector3>,
    /// Small rotation per unit modal coordinate at the marker. Shape: M x 3. Units: rad.
    ///
    /// A least-squares fit over the marker's nodes or, for a single node, over the nodes it is coupled with.
    pub rotation: Vec<Vector3>,
    /// How an interface holds its nodes; none for a marker that only follows them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coupling: Option<InterfaceCoupling>,
}

/// How the nodes of an interface are coupled with its reference point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum InterfaceCoupling {
    /// As one rigid body (RBE2).
    Rigid,
    /// The reference point follows the weighted mean of the nodes (RBE3).
    Average,
}

/// A place of the body where stress is observed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StressMarker {
    /// Name, unique among all markers of the body; letters, digits and underscores.
    pub name: String,
    /// Ids of the nodes over which the stress is averaged.
    pub nodes: Vec<u64>,
    /// Their mean reference position in the body frame. Units: m.
    pub position: Vector3,
    /// Stress per unit modal coordinate: xx, yy, zz, xy, xz, yz. Shape: M x 6. Units: N/m² for unit modes. Frame: body.
    pub stress: Vec<[f64; 6]>,
}
