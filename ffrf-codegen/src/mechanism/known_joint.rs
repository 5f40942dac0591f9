//! The kinds of joints by their names in scenes and macros: how many rows each has and what may be said of it.

/// A kind of joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct KnownJoint {
    /// Its name where users write it.
    pub name: &'static str,
    /// Its type in the runtime, and the variant of that name.
    pub type_name: &'static str,
    /// Number of rows; `None` for the kind whose user chooses them.
    pub rows: Option<usize>,
    /// Whether its first three rows keep two points together, in inertial components.
    pub holds_point: bool,
    /// Whether it has an axis or axes to choose.
    pub has_axis: bool,
    /// Whether its angle can be driven.
    pub has_angle: bool,
    /// Whether its travel can be driven.
    pub has_travel: bool,
}

impl KnownJoint {
    /// The kind of this name.
    pub fn find(name: &str) -> Option<&'static Self> {
        KNOWN_JOINTS.iter().find(|joint| joint.name == name)
    }
}

const fn joint(name: &'static str, type_name: &'static str, rows: usize, has_axis: bool) -> KnownJoint {
    KnownJoint {
        name,
        type_name,
        rows: Some(rows),
        holds_point: false,
        has_axis,
        has_angle: false,
        has_travel: false,
    }
}

const fn holding_point(joint: KnownJoint) -> KnownJoint {
    KnownJoint { holds_point: true, ..joint }
}

/// Every kind of joint.
pub const KNOWN_JOINTS: [KnownJoint; 12] = [
    holding_point(joint("fixed", "Fixed", 6, false)),
    holding_point(KnownJoint { has_angle: true, ..joint("revolute", "Revolute", 5, true) }),
    holding_point(joint("spherical", "Spherical", 3, false)),
    holding_point(joint("universal", "Universal", 4, true)),
    KnownJoint { has_angle: true, has_travel: true, ..joint("cylindrical", "Cylindrical", 4, true) },
    KnownJoint { has_travel: true, ..joint("prismatic", "Prismatic", 5, true) },
    joint("planar", "Planar", 3, true),
    joint("distance", "Distance", 1, false),
    KnownJoint { has_travel: true, ..joint("in_line", "InLine", 2, true) },
    joint("in_plane", "InPlane", 1, true),
    joint("constant_orientation", "ConstantOrientation", 3, false),
    KnownJoint { rows: None, ..joint("generic", "Generic", 0, true) },
];
