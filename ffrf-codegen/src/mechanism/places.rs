//! Where every number of a mechanism's equations stands.

use std::collections::BTreeMap;

use super::elimination_order::{Couplings, order};
use super::{Topology, TopologyError};

/// A node in the order of elimination; see the runtime's `mechanism::Step`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StepPlace {
    /// Number of unknowns.
    pub size: usize,
    /// The node.
    pub node: usize,
    /// Diagonal block; the blocks of its couplings follow.
    pub diagonal: usize,
    /// Whether this is a rigid body that nothing has been taken out of.
    pub is_diagonal: bool,
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
    /// The later node.
    pub node: usize,
    /// Whether this is a joint that holds a point, and the earlier node a rigid body that nothing has been taken out of.
    pub holds_point: bool,
}

/// A block off the diagonal, as a joint sees it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BlockPlace {
    /// Which block.
    pub index: usize,
    /// Whether the joint (the first joint, of two) is the node of the rows: the one that is eliminated first.
    pub transposed: bool,
}

/// The frame of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BodyPlace {
    /// The node.
    pub node: usize,
    /// Diagonal block.
    pub diagonal: usize,
}

/// One end of a joint on a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EndPlace {
    /// The body.
    pub body: usize,
    /// Which of the ends of joints on the body this is.
    pub slot: usize,
    /// The block of joint and body.
    pub block: BlockPlace,
}

/// A joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct JointPlace {
    /// Number of rows.
    pub rows: usize,
    /// The node.
    pub node: usize,
    /// Diagonal block.
    pub diagonal: usize,
    /// Whether it is a support, see [`Topology::supports`].
    pub is_support: bool,
    /// First and second end; `None` on the ground.
    pub ends: [Option<EndPlace>; 2],
}

/// Two joints on one flexible body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SharedPlace {
    /// The body.
    pub body: usize,
    /// Slot of the first joint on the body.
    pub first: usize,
    /// Slot of the second joint.
    pub second: usize,
    /// The block of both joints.
    pub block: BlockPlace,
}

/// The modes of a body as a node, where they are kept as unknowns; as many as one block has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModesPlace {
    /// The body.
    pub body: usize,
    /// The node.
    pub node: usize,
    /// Diagonal block.
    pub diagonal: usize,
    /// The block of modes and frame; `transposed` if the frame is eliminated first.
    pub frame: BlockPlace,
}

/// One end of a joint on a body that keeps its modes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModalEndPlace {
    /// The body.
    pub body: usize,
    /// Which of the ends of joints on the body this is.
    pub slot: usize,
    /// The block of modes and joint.
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
    /// The modes of bodies that keep them.
    pub modes: Vec<ModesPlace>,
    /// Ends of joints on these bodies.
    pub modal_ends: Vec<ModalEndPlace>,
    /// Number of nodes that come before any joint.
    pub leading: usize,
    /// Number of blocks.
    pub block_count: usize,
    /// Number of nodes: bodies, then joints, then modes.
    pub node_count: usize,
    /// Number of ends of joints on each body.
    pub attached_ends: Vec<usize>,
}

impl MechanismPlan {
    /// The layout of a mechanism. Errors: see [`TopologyError`].
    pub fn new(topology: &Topology) -> Result<Self, TopologyError> {
        Self::keeping_modes(topology, &[])
    }

    /// The layout where these bodies keep their modes as unknowns: one node each, as if there were not more modes than a
    /// block has. The runtime makes room for more (`mechanism::KeptPlan`). Errors: see [`TopologyError`].
    pub fn keeping_modes(topology: &Topology, keeping: &[usize]) -> Result<Self, TopologyError> {
        topology.check()?;
        let bodies = topology.flexible.len();
        let sizes = Couplings::of(topology, keeping).sizes;
        let order = order(topology, keeping);
        let mut turn = vec![0; sizes.len()];
        for (position, (node, _)) in order.iter().enumerate() {
            turn[*node] = position;
        }
        // blocks by (earlier, later) node; the diagonal by (node, node)
        let mut blocks = BTreeMap::new();
        let mut block_count = 0;
        for (node, neighbours) in &order {
            let mut later = neighbours.clone();
            later.sort_by_key(|other| turn[*other]);
            for other in std::iter::once(node).chain(&later) {
                blocks.insert((*node, *other), block_count);
                block_count += 1;
            }
        }
        let (mut steps, mut couplings, mut targets) = (Vec::new(), Vec::new(), Vec::new());
        let mut changed = vec![false; sizes.len()];
        for (node, neighbours) in &order {
            let mut later = neighbours.clone();
            later.sort_by_key(|other| turn[*other]);
            let is_diagonal = !changed[*node] && topology.flexible.get(*node) == Some(&false);
            steps.push(StepPlace {
                size: sizes[*node],
                node: *node,
                diagonal: blocks[&(*node, *node)],
                is_diagonal,
                couplings: couplings.len(),
                targets: targets.len(),
            });
            for (index, row) in later.iter().enumerate() {
                changed[*row] = true;
                let joint = row.checked_sub(bodies).and_then(|joint| topology.joints.get(joint));
                let holds_point = is_diagonal && joint.is_some_and(|joint| joint.holds_point);
                couplings.push(CouplingPlace { size: sizes[*row], node: *row, holds_point });
                // rows of the earlier of both, columns of the later
                targets.extend(later[..=index].iter().map(|column| blocks[&(*column, *row)]));
            }
        }
        let block = |joint: usize, other: usize| {
            let transposed = turn[joint] < turn[other];
            let (earlier, later) = if transposed { (joint, other) } else { (other, joint) };
            BlockPlace { index: blocks[&(earlier, later)], transposed }
        };
        let supports = topology.supports();
        let mut attached_ends = vec![0; bodies];
        let mut joints = Vec::with_capacity(topology.joints.len());
        for (index, joint) in topology.joints.iter().enumerate() {
            let node = bodies + index;
            let ends = joint.ends.map(|end| {
                end.map(|body| {
                    let slot = attached_ends[body];
                    attached_ends[body] += 1;
                    EndPlace { body, slot, block: block(node, body) }
                })
            });
            joints.push(JointPlace {
                rows: joint.rows,
                node,
                diagonal: blocks[&(node, node)],
                is_support: supports[index],
                ends,
            });
        }
        let mut modes = Vec::with_capacity(keeping.len());
        let mut modal_ends = Vec::new();
        for (index, body) in keeping.iter().enumerate() {
            let node = bodies + topology.joints.len() + index;
            let (diagonal, frame) = (blocks[&(node, node)], block(*body, node));
            modes.push(ModesPlace { body: *body, node, diagonal, frame });
            for joint in &joints {
                let ends = joint.ends.iter().flatten().filter(|end| end.body == *body);
                modal_ends.extend(ends.map(|end| ModalEndPlace {
                    body: *body,
                    slot: end.slot,
                    block: block(joint.node, node),
                }));
            }
        }
        let eliminated = |body: usize| topology.flexible[body] && !keeping.contains(&body);
        let mut shared = Vec::new();
        for (index, joint) in joints.iter().enumerate() {
            for (other, joint_of_other) in joints.iter().enumerate().take(index) {
                for end in joint.ends.iter().flatten().filter(|end| eliminated(end.body)) {
                    for end_of_other in
                        joint_of_other.ends.iter().flatten().filter(|other| other.body == end.body)
                    {
                        shared.push(SharedPlace {
                            body: end.body,
                            first: end.slot,
                            second: end_of_other.slot,
                            block: block(bodies + index, bodies + other),
                        });
                    }
                }
            }
        }
        let is_joint = |node: usize| (bodies..bodies + topology.joints.len()).contains(&node);
        let leading = order.iter().take_while(|(node, _)| !is_joint(*node)).count();
        let bodies =
            (0..bodies).map(|body| BodyPlace { node: body, diagonal: blocks[&(body, body)] }).collect();
        Ok(Self {
            steps,
            couplings,
            targets,
            bodies,
            joints,
            shared,
            modes,
            modal_ends,
            leading,
            block_count,
            node_count: sizes.len(),
            attached_ends,
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
