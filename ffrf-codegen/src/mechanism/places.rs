//! Where every number of a mechanism's equations stands.

use std::collections::BTreeMap;

use super::elimination_order::{Couplings, order};
use super::{Topology, TopologyError};

/// A node in the order of elimination; see the runtime's `mechanism::Step`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StepPlace {
    /// Number of unknowns.
    pub size: usize,
    /// First unknown.
    pub unknowns: usize,
    /// Diagonal block among the values; the blocks of its couplings follow.
    pub diagonal: usize,
    /// First coupling.
    pub couplings: usize,
    /// First target.
    pub targets: usize,
}

/// A later node coupled to one that is eliminated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CouplingPlace {
    /// Number of unknowns of the later node.
    pub size: usize,
    /// First unknown of the later node.
    pub unknowns: usize,
}

/// A block off the diagonal, as a joint sees it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BlockPlace {
    /// Start among the values.
    pub start: usize,
    /// Number of columns.
    pub columns: usize,
    /// Whether the joint (the first joint, of two) is the node of the columns.
    pub transposed: bool,
}

/// The frame of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BodyPlace {
    /// First unknown.
    pub unknowns: usize,
    /// Diagonal block among the values.
    pub diagonal: usize,
}

/// One end of a joint on a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EndPlace {
    /// The body.
    pub body: usize,
    /// First attached row on the body.
    pub slot: usize,
    /// The block of joint and body.
    pub block: BlockPlace,
}

/// A joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct JointPlace {
    /// Number of rows.
    pub rows: usize,
    /// First multiplier among the unknowns.
    pub unknowns: usize,
    /// Diagonal block among the values.
    pub diagonal: usize,
    /// First and second end; `None` on the ground.
    pub ends: [Option<EndPlace>; 2],
}

/// Two joints on one flexible body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SharedPlace {
    /// The body.
    pub body: usize,
    /// First attached row and number of rows of the first joint.
    pub first: (usize, usize),
    /// The same of the second joint.
    pub second: (usize, usize),
    /// The block of both joints.
    pub block: BlockPlace,
}

/// The whole layout of a mechanism's equations.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MechanismPlan {
    /// Order of elimination.
    pub steps: Vec<StepPlace>,
    /// Couplings of all steps.
    pub couplings: Vec<CouplingPlace>,
    /// Targets of all steps.
    pub targets: Vec<usize>,
    /// Bodies.
    pub bodies: Vec<BodyPlace>,
    /// Joints.
    pub joints: Vec<JointPlace>,
    /// Pairs of joints on one flexible body.
    pub shared: Vec<SharedPlace>,
    /// Number of values: the entries of the factors, and as many of the matrix.
    pub value_count: usize,
    /// Number of unknowns.
    pub unknown_count: usize,
    /// Number of attached rows of each body.
    pub attached_rows: Vec<usize>,
}

impl MechanismPlan {
    /// The layout of a mechanism. Errors: see [`TopologyError`].
    pub fn new(topology: &Topology) -> Result<Self, TopologyError> {
        topology.check()?;
        let bodies = topology.flexible.len();
        let sizes = Couplings::of(topology).sizes;
        let order = order(topology);
        let mut first_unknown = Vec::with_capacity(sizes.len());
        let mut unknown_count = 0;
        for size in &sizes {
            first_unknown.push(unknown_count);
            unknown_count += size;
        }
        let mut turn = vec![0; sizes.len()];
        for (position, (node, _)) in order.iter().enumerate() {
            turn[*node] = position;
        }
        // blocks by (earlier, later) node; the diagonal by (node, node)
        let mut blocks = BTreeMap::new();
        let mut value_count = 0;
        for (node, neighbours) in &order {
            let mut later = neighbours.clone();
            later.sort_by_key(|other| turn[*other]);
            for other in std::iter::once(node).chain(&later) {
                blocks.insert((*node, *other), value_count);
                value_count += sizes[*node] * sizes[*other];
            }
        }
        let (mut steps, mut couplings, mut targets) = (Vec::new(), Vec::new(), Vec::new());
        for (node, neighbours) in &order {
            let mut later = neighbours.clone();
            later.sort_by_key(|other| turn[*other]);
            steps.push(StepPlace {
                size: sizes[*node],
                unknowns: first_unknown[*node],
                diagonal: blocks[&(*node, *node)],
                couplings: couplings.len(),
                targets: targets.len(),
            });
            for (index, row) in later.iter().enumerate() {
                couplings.push(CouplingPlace { size: sizes[*row], unknowns: first_unknown[*row] });
                // rows of the later of both, columns of the earlier
                targets.extend(later[..=index].iter().map(|column| blocks[&(*column, *row)]));
            }
        }
        let block = |joint: usize, other: usize| {
            let transposed = turn[joint] < turn[other];
            let (earlier, later) = if transposed { (joint, other) } else { (other, joint) };
            BlockPlace { start: blocks[&(earlier, later)], columns: sizes[earlier], transposed }
        };
        let mut attached_rows = vec![0; bodies];
        let mut joints = Vec::with_capacity(topology.joints.len());
        for (index, joint) in topology.joints.iter().enumerate() {
            let node = bodies + index;
            let ends = joint.ends.map(|end| {
                end.map(|body| {
                    let slot = attached_rows[body];
                    attached_rows[body] += joint.rows;
                    EndPlace { body, slot, block: block(node, body) }
                })
            });
            joints.push(JointPlace {
                rows: joint.rows,
                unknowns: first_unknown[node],
                diagonal: blocks[&(node, node)],
                ends,
            });
        }
        let mut shared = Vec::new();
        for (index, joint) in joints.iter().enumerate() {
            for (other, joint_of_other) in joints.iter().enumerate().take(index) {
                for end in joint.ends.iter().flatten().filter(|end| topology.flexible[end.body]) {
                    for end_of_other in
                        joint_of_other.ends.iter().flatten().filter(|other| other.body == end.body)
                    {
                        shared.push(SharedPlace {
                            body: end.body,
                            first: (end.slot, joint.rows),
                            second: (end_of_other.slot, joint_of_other.rows),
                            block: block(bodies + index, bodies + other),
                        });
                    }
                }
            }
        }
        let bodies = (0..bodies)
            .map(|body| BodyPlace { unknowns: first_unknown[body], diagonal: blocks[&(body, body)] })
            .collect();
        Ok(Self {
            steps,
            couplings,
            targets,
            bodies,
            joints,
            shared,
            value_count: 2 * value_count,
            unknown_count,
            attached_rows,
        })
    }

    /// Multiply-adds of one factorisation.
    pub fn factor_cost(&self) -> usize {
        let ends = self.steps.iter().skip(1).map(|step| step.couplings).chain([self.couplings.len()]);
        self.steps
            .iter()
            .zip(ends)
            .map(|(step, end)| {
                let others: usize = self.couplings[step.couplings..end].iter().map(|other| other.size).sum();
                let own = step.size;
                own * own * own / 6 + own * own * others / 2 + own * others * (others + 1) / 2
            })
            .sum()
    }
}
