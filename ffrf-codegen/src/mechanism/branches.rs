//! The bodies of a tree in the order of a sweep.

use super::Topology;

/// A body of a tree with the joint that holds it; see the runtime's `mechanism::Branch`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BranchPlace {
    /// The body.
    pub body: usize,
    /// The joint that holds it; `None` if it is free.
    pub joint: Option<usize>,
    /// Whether it is the second end of that joint.
    pub is_second: bool,
    /// Where the body at the other end stands among the branches; `None` on the ground.
    pub parent: Option<usize>,
    /// Number of the first of its motions among those of all bodies.
    pub freedom: usize,
    /// Number of its motions.
    pub freedoms: usize,
}

/// Motions of a free body.
const FREE: usize = 6;

impl Topology {
    /// The bodies from the roots to the leaves, if there are joints and they close no loop; else none.
    pub fn branches(&self) -> Vec<BranchPlace> {
        if self.joints.is_empty() || self.has_loops() {
            return Vec::new();
        }
        let mut branches: Vec<BranchPlace> = Vec::with_capacity(self.flexible.len());
        let mut place = vec![None; self.flexible.len()];
        let mut freedom = 0;
        let mut add = |branch: BranchPlace, place: &mut [Option<usize>], branches: &mut Vec<BranchPlace>| {
            place[branch.body] = Some(branches.len());
            branches.push(BranchPlace { freedom, ..branch });
            freedom += branch.freedoms;
        };
        // those on the ground, then what hangs on them; then the same from each body that is not reached
        let mut next = 0;
        let mut roots = 0..self.flexible.len();
        let mut from: Option<Option<usize>> = Some(None);
        while let Some(here) = from {
            let parent = here.map(|place: usize| branches[place].body);
            for (joint, shape) in self.joints.iter().enumerate() {
                let [first, second] = shape.ends;
                for (body, other, is_second) in [(second, first, true), (first, second, false)] {
                    let Some(body) = body.filter(|body| other == parent && place[*body].is_none()) else {
                        continue;
                    };
                    let freedoms = FREE.saturating_sub(shape.rows);
                    let branch = BranchPlace {
                        body,
                        joint: Some(joint),
                        is_second,
                        parent: here,
                        freedom: 0,
                        freedoms,
                    };
                    add(branch, &mut place, &mut branches);
                }
            }
            if next == branches.len()
                && let Some(body) = roots.find(|body| place[*body].is_none())
            {
                let root = BranchPlace {
                    body,
                    joint: None,
                    is_second: false,
                    parent: None,
                    freedom: 0,
                    freedoms: FREE,
                };
                add(root, &mut place, &mut branches);
            }
            from = (next < branches.len()).then_some(Some(next));
            next += 1;
        }
        branches
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanism::JointTopology;

    fn joint(rows: usize, ends: [Option<usize>; 2]) -> JointTopology {
        JointTopology { rows, holds_point: false, ends }
    }

    #[test]
    fn bodies_come_after_their_parents_whichever_end_they_are() {
        let joints =
            vec![joint(5, [Some(2), Some(0)]), joint(3, [Some(2), None]), joint(6, [Some(1), Some(0)])];
        let tree = Topology { flexible: vec![false; 4], joints };
        let branches = tree.branches();
        let orders: Vec<_> =
            branches.iter().map(|branch| (branch.body, branch.joint, branch.parent)).collect();
        let expected = [(2, Some(1), None), (0, Some(0), Some(0)), (1, Some(2), Some(1)), (3, None, None)];
        assert_eq!(orders, expected);
        let freedoms: Vec<_> = branches.iter().map(|branch| (branch.freedom, branch.freedoms)).collect();
        assert_eq!(freedoms, [(0, 3), (3, 1), (4, 0), (4, 6)]);
        assert_eq!(
            branches.iter().map(|branch| branch.is_second).collect::<Vec<_>>(),
            [false, true, false, false]
        );
    }

    #[test]
    fn loops_are_no_trees() {
        let joints = vec![joint(5, [None, Some(0)]), joint(3, [Some(0), Some(1)]), joint(1, [None, Some(1)])];
        assert!(Topology { flexible: vec![false; 2], joints }.branches().is_empty());
    }
}
