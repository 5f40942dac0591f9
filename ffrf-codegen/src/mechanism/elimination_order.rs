//! The order of elimination of least cost among several that are found greedily.
//!
//! What costs least next is not what costs least in all: a body that goes early is diagonal if it is rigid, and is spared in
//! refinements if it goes before every joint. So bodies are given several advantages over joints, and the order whose
//! factorisation and solutions cost least is taken.
//!
//! Nodes are bodies (six unknowns) and joints (their rows). Eliminating a node couples all its neighbours. For chains, trees
//! and stars the order found costs a number of operations linear in the bodies: leaves go first, a hub last.
//!
//! Without pivoting, a joint may only go where its pivot block is definite. The rows of several joints are independent on
//! the bodies that went before if each has one of these for its own: ten rows of two joints on one rigid body are not. So a
//! joint goes when it finds a body that no earlier joint needs ([`Owners`]), or when every body that it is coupled to has
//! gone: then its block is what it would be at the very end.
//!
//! Modes are eliminated before everything else, inside their body, which couples all joints on it: for a body with many
//! joints that is dense. A body that keeps its modes has a node of its own for them instead, coupled to its frame and its
//! joints, which goes when it is cheapest: after the arms of a hub, whose joints then stay apart.

use std::collections::BTreeSet;

use super::Topology;

/// Unknowns of the modes of one body, where they are kept; how many there are is not known yet.
const ASSUMED_MODES: usize = 6;

/// The nodes of a mechanism with who is coupled to whom: bodies first, then joints, then the modes of those bodies that
/// keep them.
#[derive(Debug, Clone)]
pub(super) struct Couplings {
    /// Unknowns of each node.
    pub(super) sizes: Vec<usize>,
    /// Neighbours of each node.
    pub(super) neighbours: Vec<BTreeSet<usize>>,
}

impl Couplings {
    /// `keeping`: the bodies that keep their modes.
    pub(super) fn of(topology: &Topology, keeping: &[usize]) -> Self {
        let bodies = topology.flexible.len();
        let of_joints = topology.joints.iter().map(|joint| joint.rows);
        let sizes: Vec<usize> = std::iter::repeat_n(6, bodies)
            .chain(of_joints)
            .chain(std::iter::repeat_n(ASSUMED_MODES, keeping.len()))
            .collect();
        let modes_of = |body: usize| {
            keeping
                .iter()
                .position(|keeps| *keeps == body)
                .map(|index| bodies + topology.joints.len() + index)
        };
        let mut couplings = Self { neighbours: vec![BTreeSet::new(); sizes.len()], sizes };
        for body in keeping {
            if let Some(modes) = modes_of(*body) {
                couplings.couple(modes, *body);
            }
        }
        for (joint, shape) in topology.joints.iter().enumerate() {
            for body in shape.ends.iter().flatten() {
                couplings.couple(bodies + joint, *body);
                if let Some(modes) = modes_of(*body) {
                    couplings.couple(bodies + joint, modes);
                }
            }
            for (other, shape_of_other) in topology.joints.iter().enumerate().take(joint) {
                let flexible = |body: &&usize| topology.flexible[**body] && !keeping.contains(body);
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
    /// For each body, the joint that is its support.
    support_of: &'a [Option<usize>],
    /// For each body, whether it has gone.
    gone: Vec<bool>,
    /// For each body, the joint that it belongs to.
    joint_of: Vec<Option<usize>>,
}

impl Owners<'_> {
    /// Gives `joint` a body of its own among those gone, moving earlier joints to their other body where that helps.
    ///
    /// A body on a support may have no more than the motions that this leaves: it is that joint's own, or nobody's.
    fn give(&mut self, joint: usize, tried: &mut BTreeSet<usize>) -> bool {
        let ends = self.topology.joints[joint].ends;
        let may_own =
            |body: &usize| self.gone[*body] && self.support_of[*body].is_none_or(|own| own == joint);
        for body in ends.into_iter().flatten().filter(may_own).collect::<Vec<_>>() {
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
        let mut tried = Self {
            topology: self.topology,
            support_of: self.support_of,
            gone: self.gone.clone(),
            joint_of: self.joint_of.clone(),
        };
        tried.give(joint, &mut BTreeSet::new())
    }
}

/// What bodies cost beside joints in the choice of the next node, in quarters.
const PRICES_OF_BODIES: [usize; 5] = [4, 3, 2, 1, 0];

/// The nodes in their order, each with the nodes that it is coupled to when its turn comes.
pub(super) type Order = Vec<(usize, Vec<usize>)>;

/// The cheapest order. `keeping`: the bodies that keep their modes.
pub(super) fn order(topology: &Topology, keeping: &[usize]) -> Order {
    let orders = PRICES_OF_BODIES.map(|price| greedy(topology, keeping, price));
    let cheapest = orders.into_iter().min_by_key(|order| cost(topology, keeping, order));
    cheapest.unwrap_or_default()
}

/// What a division costs beside a multiply-add where each waits for the last, as the pivots of a node do, and where they
/// are independent.
const DIVISIONS: [usize; 2] = [8, 4];

/// Multiply-adds of a factorisation, a solution, and one refinement where rows may be redundant.
///
/// A rigid body that nothing was taken out of has a diagonal matrix, and meets a joint that holds a point with half of its
/// rows, see the runtime's `Coupling::holds_point`.
fn cost(topology: &Topology, keeping: &[usize], order: &Order) -> usize {
    let sizes = Couplings::of(topology, keeping).sizes;
    let joints = topology.flexible.len()..topology.flexible.len() + topology.joints.len();
    let refined = topology.has_loops();
    let (mut cost, mut joints_began) = (0, false);
    let mut changed = vec![false; sizes.len()];
    for (node, neighbours) in order {
        joints_began |= joints.contains(node);
        let (own, others) = (sizes[*node], neighbours.iter().map(|other| sizes[*other]).sum::<usize>());
        let (factor, halves, held) = if !changed[*node] && topology.flexible.get(*node) == Some(&false) {
            let holds = |node: &&usize| {
                let joint = node.checked_sub(joints.start).and_then(|joint| topology.joints.get(joint));
                joint.is_some_and(|joint| joint.holds_point)
            };
            let held = neighbours.iter().filter(holds).map(|other| sizes[*other]).sum::<usize>();
            (own * others + own * DIVISIONS[1], 0, held)
        } else {
            (own * own * own / 6 + own * own * others / 2 + own * DIVISIONS[0], own * own, 0)
        };
        let solution = halves + 2 * own * others - own * held;
        cost += factor + (own * others * (others + 1) - own / 2 * held * (held + 1)) / 2 + solution;
        if refined && joints_began {
            cost += solution;
        }
        for other in neighbours {
            changed[*other] = true;
        }
    }
    cost
}

/// The order in which the cheapest node goes next; `price`: of bodies.
fn greedy(topology: &Topology, keeping: &[usize], price: usize) -> Order {
    let bodies = topology.flexible.len();
    let joints = bodies..bodies + topology.joints.len();
    let mut couplings = Couplings::of(topology, keeping);
    let mut support_of = vec![None; bodies];
    for (joint, _) in topology.supports().into_iter().enumerate().filter(|(_, is_support)| *is_support) {
        for body in topology.joints[joint].ends.into_iter().flatten() {
            support_of[body] = Some(joint);
        }
    }
    let mut owners =
        Owners { topology, support_of: &support_of, gone: vec![false; bodies], joint_of: vec![None; bodies] };
    let mut left: BTreeSet<usize> = (0..couplings.sizes.len()).collect();
    let mut order = Vec::with_capacity(left.len());
    loop {
        let ready = |node: &usize| {
            !joints.contains(node)
                || couplings.neighbours[*node].iter().all(|other| joints.contains(other))
                || owners.has_one_for(*node - bodies)
        };
        // the cheapest first: whether a joint may go is asked in the order of cost
        let mut by_cost: Vec<usize> = left.iter().copied().collect();
        by_cost.sort_by_key(|node| {
            let share = if *node < bodies { price } else { PRICES_OF_BODIES[0] };
            (share * couplings.cost(*node), *node)
        });
        let Some(next) = by_cost.into_iter().find(ready) else { break };
        left.remove(&next);
        if joints.contains(&next) {
            owners.give(next - bodies, &mut BTreeSet::new());
        } else if let Some(gone) = owners.gone.get_mut(next) {
            *gone = true;
        }
        order.push((next, couplings.eliminate(next)));
    }
    order
}
