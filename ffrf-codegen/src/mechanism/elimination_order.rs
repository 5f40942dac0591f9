//! The order of elimination of least cost, found greedily.
//!
//! Nodes are bodies (six unknowns) and joints (their rows). Eliminating a node couples all its neighbours. For chains, trees
//! and stars the order found costs a number of operations linear in the bodies: leaves go first, a hub last.
//!
//! Without pivoting, a joint may only go where its pivot block is definite. The rows of several joints are independent on
//! the bodies that went before if each has one of these for its own: ten rows of two joints on one rigid body are not. So a
//! joint goes when it finds a body that no earlier joint needs ([`Owners`]), or when every body that it is coupled to has
//! gone: then its block is what it would be at the very end.

use std::collections::BTreeSet;

use super::Topology;

/// The nodes of a mechanism with who is coupled to whom: bodies first, then joints.
#[derive(Debug, Clone)]
pub(super) struct Couplings {
    /// Unknowns of each node.
    pub(super) sizes: Vec<usize>,
    /// Neighbours of each node.
    pub(super) neighbours: Vec<BTreeSet<usize>>,
}

impl Couplings {
    pub(super) fn of(topology: &Topology) -> Self {
        let bodies = topology.flexible.len();
        let sizes: Vec<usize> =
            (0..bodies).map(|_| 6).chain(topology.joints.iter().map(|joint| joint.rows)).collect();
        let mut couplings = Self { neighbours: vec![BTreeSet::new(); sizes.len()], sizes };
        for (joint, shape) in topology.joints.iter().enumerate() {
            for body in shape.ends.iter().flatten() {
                couplings.couple(bodies + joint, *body);
            }
            for (other, shape_of_other) in topology.joints.iter().enumerate().take(joint) {
                let flexible = |body: &&usize| topology.flexible[**body];
                if shape
                    .ends
                    .iter()
                    .flatten()
                    .filter(flexible)
                    .any(|body| shape_of_other.ends.contains(&Some(*body)))
                {
                    couplings.couple(bodies + joint, bodies + other);
                }
            }
        }
        couplings
    }

    fn couple(&mut self, node: usize, other: usize) {
        self.neighbours[node].insert(other);
        self.neighbours[other].insert(node);
    }

    /// Multiply-adds of eliminating `node` now.
    fn cost(&self, node: usize) -> usize {
        let own = self.sizes[node];
        let others: usize = self.neighbours[node].iter().map(|other| self.sizes[*other]).sum();
        own * own * own / 6 + own * own * others / 2 + own * others * (others + 1) / 2
    }

    /// Takes `node` out and couples its neighbours; gives the neighbours.
    fn eliminate(&mut self, node: usize) -> Vec<usize> {
        let neighbours: Vec<usize> = std::mem::take(&mut self.neighbours[node]).into_iter().collect();
        for (index, one) in neighbours.iter().enumerate() {
            self.neighbours[*one].remove(&node);
            for other in &neighbours[..index] {
                self.couple(*one, *other);
            }
        }
        neighbours
    }
}

/// Which eliminated body each eliminated joint has for its own.
struct Owners<'a> {
    topology: &'a Topology,
    /// For each body, whether it has gone.
    gone: Vec<bool>,
    /// For each body, the joint that it belongs to.
    joint_of: Vec<Option<usize>>,
}

impl Owners<'_> {
    /// Gives `joint` a body of its own among those gone, moving earlier joints to their other body where that helps.
    fn give(&mut self, joint: usize, tried: &mut BTreeSet<usize>) -> bool {
        let ends = self.topology.joints[joint].ends;
        for body in ends.into_iter().flatten().filter(|body| self.gone[*body]).collect::<Vec<_>>() {
            if !tried.insert(body) {
                continue;
            }
            if self.joint_of[body].is_none_or(|other| self.give(other, tried)) {
                self.joint_of[body] = Some(joint);
                return true;
            }
        }
        false
    }

    /// Whether [`give`](Self::give) would find one.
    fn has_one_for(&self, joint: usize) -> bool {
        let mut tried =
            Self { topology: self.topology, gone: self.gone.clone(), joint_of: self.joint_of.clone() };
        tried.give(joint, &mut BTreeSet::new())
    }
}

/// The nodes in their order, each with the nodes that it is coupled to when its turn comes.
pub(super) fn order(topology: &Topology) -> Vec<(usize, Vec<usize>)> {
    let bodies = topology.flexible.len();
    let mut couplings = Couplings::of(topology);
    let mut owners = Owners { topology, gone: vec![false; bodies], joint_of: vec![None; bodies] };
    let mut left: BTreeSet<usize> = (0..couplings.sizes.len()).collect();
    let mut order = Vec::with_capacity(left.len());
    loop {
        let ready = |node: &usize| {
            *node < bodies
                || couplings.neighbours[*node].iter().all(|other| *other >= bodies)
                || owners.has_one_for(*node - bodies)
        };
        // the cheapest first: whether a joint may go is asked in the order of cost
        let mut by_cost: Vec<usize> = left.iter().copied().collect();
        by_cost.sort_by_key(|node| (couplings.cost(*node), *node));
        let Some(next) = by_cost.into_iter().find(ready) else { break };
        left.remove(&next);
        match next.checked_sub(bodies) {
            None => owners.gone[next] = true,
            Some(joint) => {
                owners.give(joint, &mut BTreeSet::new());
            }
        }
        order.push((next, couplings.eliminate(next)));
    }
    order
}
