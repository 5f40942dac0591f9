//! The order of elimination of least cost, found greedily.
//!
//! Nodes are bodies (six unknowns) and joints (their rows). Eliminating a node couples all its neighbours. A joint follows
//! at least one of its bodies: then its pivot block is definite. For chains, trees and stars the order found costs a number
//! of operations linear in the bodies: leaves go first, a hub last.
//!
//! Definite is not regular: what is left of a body that another joint already holds may not be able to move as a joint asks,
//! as where two joints stand at one point. In a tree each joint therefore follows the body that it holds from the side of
//! the ground, and no other joint of that body comes between them: its pivot is then that of a body which can move freely,
//! with what hangs on it. In loops there is no such order; there the rows are shifted and the solution refined.

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
    let held = held_bodies(topology);
    let mut left: BTreeSet<usize> = (0..couplings.sizes.len()).collect();
    let mut order = Vec::with_capacity(left.len());
    loop {
        let gone = |body: &usize| !left.contains(body);
        let ready = |node: &usize| {
            let Some(joint) = node.checked_sub(bodies) else { return true };
            let ends = topology.joints[joint].ends;
            let Some(held) = &held else { return ends.iter().flatten().any(gone) };
            // after the body that it holds, and not between its other body and what holds that one
            let holders_gone =
                |body: &usize| (0..held.len()).all(|other| held[other] != *body || gone(&(bodies + other)));
            let mut others = ends.iter().flatten().filter(|body| **body != held[joint]);
            gone(&held[joint]) && others.all(|body| !gone(body) || holders_gone(body))
        };
        let next = left.iter().copied().filter(ready).min_by_key(|node| (couplings.cost(*node), *node));
        let Some(next) = next else { break };
        left.remove(&next);
        order.push((next, couplings.eliminate(next)));
    }
    order
}

/// For each joint of a tree, the body that it holds from the side of the ground (of the first body, in parts without
/// ground); none if there are loops. Joints between the same two bodies, such as a joint and its drive, are no loop.
fn held_bodies(topology: &Topology) -> Option<Vec<usize>> {
    let (bodies, joints) = (topology.flexible.len(), &topology.joints);
    let mut held: Vec<Option<usize>> = vec![None; joints.len()];
    // what stands on the side of the ground of each body: another body, or itself where a part begins
    let mut before: Vec<Option<Option<usize>>> = vec![None; bodies];
    let mut reached: Vec<Option<usize>> = vec![None];
    for start in 0..=bodies {
        while let Some(from) = reached.pop() {
            for (joint, shape) in joints.iter().enumerate() {
                let to = match shape.ends {
                    [first, Some(second)] if first == from => second,
                    [Some(first), second] if second == from => first,
                    _ => continue,
                };
                if from.is_some_and(|from| before[from] == Some(Some(to))) {
                    continue;
                }
                match before[to] {
                    None => {
                        before[to] = Some(from);
                        reached.push(Some(to));
                    }
                    Some(known) if known == from => {}
                    Some(_) => return None,
                }
                held[joint] = Some(to);
            }
        }
        if start < bodies && before[start].is_none() {
            // a part without ground begins here: nothing stands before it
            before[start] = Some(Some(start));
            reached.push(Some(start));
        }
    }
    held.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::super::JointTopology;
    use super::*;

    fn tree(joints: &[(usize, [Option<usize>; 2])], bodies: usize) -> Topology {
        let joints = joints.iter().map(|(rows, ends)| JointTopology { rows: *rows, ends: *ends }).collect();
        Topology { flexible: vec![false; bodies], joints }
    }

    #[test]
    fn each_joint_of_a_tree_holds_the_body_away_from_the_ground() {
        let grounded =
            [(5, [Some(2), Some(1)]), (3, [None, Some(2)]), (1, [Some(2), None]), (5, [Some(0), Some(1)])];
        assert_eq!(held_bodies(&tree(&grounded, 3)), Some(vec![1, 2, 2, 0]));
        let free = [(5, [Some(0), Some(1)]), (1, [Some(1), Some(0)]), (5, [Some(3), Some(2)])];
        assert_eq!(held_bodies(&tree(&free, 4)), Some(vec![1, 1, 3]));
        let ring = [(5, [Some(0), Some(1)]), (5, [Some(1), Some(2)]), (5, [Some(2), Some(0)])];
        assert_eq!(held_bodies(&tree(&ring, 3)), None);
        let bridge = [(5, [None, Some(0)]), (5, [Some(0), Some(1)]), (5, [None, Some(1)])];
        assert_eq!(held_bodies(&tree(&bridge, 2)), None);
    }

    /// A first body that is cheap to eliminate, since both its joints are small: its joint to the ground goes next, and the
    /// other one waits for the body that it holds.
    #[test]
    fn no_joint_comes_between_a_body_and_what_holds_it() {
        let joints = [(3, [None, Some(0)]), (3, [Some(0), Some(1)]), (6, [Some(1), Some(2)])];
        let order: Vec<usize> = order(&tree(&joints, 3)).into_iter().map(|(node, _)| node).collect();
        let place = |node: usize| order.iter().position(|found| *found == node).unwrap();
        assert_eq!(order.len(), 6);
        for (joint, held) in [0, 1, 2].into_iter().enumerate() {
            assert!(place(held) < place(3 + joint), "{order:?}");
            for other in (0..3).filter(|other| *other != joint && joints[*other].1.contains(&Some(held))) {
                assert!(
                    !(place(held) < place(3 + other) && place(3 + other) < place(3 + joint)),
                    "{order:?}"
                );
            }
        }
    }
}
