//! Which bodies a mechanism has and which joints connect them: all that the order of elimination depends on.

use thiserror::Error;

/// The most rows of one joint.
pub const MOST_ROWS: usize = 6;

/// Bodies and joints of a mechanism.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Topology {
    /// For each body, whether it has modes: joints on a flexible body are coupled through them.
    pub flexible: Vec<bool>,
    /// The joints.
    pub joints: Vec<JointTopology>,
}

/// The fewest ends of joints on a body that may keep its modes as unknowns.
const ENDS_OF_HUB: usize = 4;
/// A body with more ends of joints keeps its modes in a compiled mechanism, however many there are: it would have constants
/// for the couplings of all pairs of joints, n³/6 of them, for a body with some five times as many modes as ends.
const MOST_ENDS_ELIMINATED: usize = 32;

/// A support leaves as many motions as half of a block has rows, or fewer.
const LEAST_ROWS_OF_SUPPORT: usize = 3;

/// A flexible body with so many joints that its modes may be kept as unknowns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Hub {
    /// The body.
    pub body: usize,
    /// Ends of joints on it.
    pub ends: usize,
    /// Rows of these.
    pub rows: usize,
}

impl Hub {
    /// Whether its modes are kept however many there are, where that number is not known when the layout is written.
    pub fn always_keeps(&self) -> bool {
        self.ends > MOST_ENDS_ELIMINATED
    }
}

/// A joint between two bodies, or a body and the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct JointTopology {
    /// Number of rows, 1 to 6.
    pub rows: usize,
    /// Whether its first three rows keep two points together, in inertial components.
    pub holds_point: bool,
    /// The bodies at its first and second end; `None` for the ground.
    pub ends: [Option<usize>; 2],
}

/// Why a mechanism cannot be composed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum TopologyError {
    /// A joint without rows, or with too many.
    #[error("joint {joint}: expected 1 to {MOST_ROWS} rows, found {found}")]
    Rows {
        /// The joint.
        joint: usize,
        /// The number of rows found.
        found: usize,
    },
    /// A joint that connects nothing to anything.
    #[error("joint {joint}: both ends are the ground")]
    Ground {
        /// The joint.
        joint: usize,
    },
    /// A joint of a body with itself.
    #[error("joint {joint}: both ends are body {body}")]
    SameBody {
        /// The joint.
        joint: usize,
        /// The body.
        body: usize,
    },
    /// A body that does not exist.
    #[error("joint {joint}: body {found} does not exist, there are {count}")]
    NoSuchBody {
        /// The joint.
        joint: usize,
        /// The body found.
        found: usize,
        /// The number of bodies.
        count: usize,
    },
}

impl Topology {
    /// Whether every joint connects two different things that exist.
    pub fn check(&self) -> Result<(), TopologyError> {
        let count = self.flexible.len();
        for (joint, JointTopology { rows, ends, .. }) in self.joints.iter().enumerate() {
            if !(1..=MOST_ROWS).contains(rows) {
                return Err(TopologyError::Rows { joint, found: *rows });
            }
            if let Some(found) = ends.iter().flatten().copied().find(|body| *body >= count) {
                return Err(TopologyError::NoSuchBody { joint, found, count });
            }
            match ends {
                [None, None] => return Err(TopologyError::Ground { joint }),
                [Some(body), Some(other)] if body == other => {
                    return Err(TopologyError::SameBody { joint, body: *body });
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// The flexible bodies with many joints. Those of a mechanism with soft links are those of the whole.
    pub fn hubs(&self) -> Vec<Hub> {
        let flexible = self.flexible.iter().enumerate().filter(|(_, flexible)| **flexible);
        let counted = flexible.map(|(body, _)| {
            let here = |joint: &&JointTopology| joint.ends.contains(&Some(body));
            let (ends, rows) = self
                .joints
                .iter()
                .filter(here)
                .fold((0, 0), |(ends, rows), joint| (ends + 1, rows + joint.rows));
            Hub { body, ends, rows }
        });
        counted.filter(|hub| hub.ends >= ENDS_OF_HUB).collect()
    }

    /// For each joint, whether it is a support: the first joint of a rigid body with the ground that leaves it at most three
    /// motions, in a mechanism with loops. The body's unknowns can then be these motions; trees are swept over.
    pub fn supports(&self) -> Vec<bool> {
        let mut supported = self.flexible.clone();
        let loops = self.has_loops();
        let is_support = |joint: &JointTopology| match joint.ends {
            [Some(body), None] | [None, Some(body)] if loops && joint.rows >= LEAST_ROWS_OF_SUPPORT => {
                !std::mem::replace(&mut supported[body], true)
            }
            _ => false,
        };
        self.joints.iter().map(is_support).collect()
    }

    /// Whether bodies and joints form loops, through the ground or without it: then constraint rows may be redundant.
    pub fn has_loops(&self) -> bool {
        // joining sets of connected bodies; the ground is one more
        let ground = self.flexible.len();
        let mut leader: Vec<usize> = (0..=ground).collect();
        let find = |leader: &[usize], mut body: usize| {
            while leader[body] != body {
                body = leader[body];
            }
            body
        };
        for joint in &self.joints {
            let [first, second] = joint.ends.map(|end| find(&leader, end.unwrap_or(ground)));
            if first == second {
                return true;
            }
            leader[first] = second;
        }
        false
    }
}
