//! The order of elimination of least cost, found greedily.
//!
//! Nodes are bodies (six unknowns) and joints (their rows). Eliminating a node couples all its neighbours. A joint follows
//! at least one of its bodies: then its pivot block is definite. For chains, trees and stars the order found costs a number
//! of operations linear in the bodies: leaves go first, a hub last.

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

/// The nodes in their order, each with the nodes that it is coupled to when its turn comes.
pub(super) fn order(topology: &Topology) -> Vec<(usize, Vec<usize>)> {
    let bodies = topology.flexible.len();
    let mut couplings = Couplings::of(topology);
    let mut left: BTreeSet<usize> = (0..couplings.sizes.len()).collect();
    let mut order = Vec::with_capacity(left.len());
    loop {
        let ready = |node: &usize| {
            *node < bodies
                || topology.joints[*node - bodies].ends.iter().flatten().any(|body| !left.contains(body))
        };
        let next = left.iter().copied().filter(ready).min_by_key(|node| (couplings.cost(*node), *node));
        let Some(next) = next else { break };
        left.remove(&next);
        order.push((next, couplings.eliminate(next)));
    }
    order
}
