//! The generator's plan of a mechanism in the runtime's types.

use ffrf_codegen::mechanism::{BlockPlace, MechanismPlan};
use ffrf_runtime::mechanism::{
    Block, BodyPlace, Coupling, Elimination, EndPlace, JointPlace, Plan, SharedPlace, Step,
};

/// A plan that owns its lists.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct OwnedPlan {
    steps: Vec<Step>,
    leading: usize,
    couplings: Vec<Coupling>,
    targets: Vec<usize>,
    bodies: Vec<BodyPlace>,
    joints: Vec<JointPlace>,
    shared: Vec<SharedPlace>,
    pub(super) block_count: usize,
    pub(super) node_count: usize,
    pub(super) attached_ends: Vec<usize>,
}

impl OwnedPlan {
    pub(super) fn new(plan: &MechanismPlan) -> Self {
        let block = |block: BlockPlace| Block { index: block.index, transposed: block.transposed };
        Self {
            steps: plan
                .steps
                .iter()
                .map(|step| Step {
                    size: step.size,
                    node: step.node,
                    diagonal: step.diagonal,
                    is_diagonal: step.is_diagonal,
                    couplings: step.couplings,
                    targets: step.targets,
                })
                .collect(),
            couplings: plan
                .couplings
                .iter()
                .map(|coupling| Coupling { size: coupling.size, node: coupling.node })
                .collect(),
            targets: plan.targets.clone(),
            bodies: plan
                .bodies
                .iter()
                .map(|body| BodyPlace { node: body.node, diagonal: body.diagonal })
                .collect(),
            joints: plan
                .joints
                .iter()
                .map(|joint| JointPlace {
                    rows: joint.rows,
                    node: joint.node,
                    diagonal: joint.diagonal,
                    ends: joint.ends.map(|end| {
                        end.map(|end| EndPlace { body: end.body, slot: end.slot, block: block(end.block) })
                    }),
                })
                .collect(),
            shared: plan
                .shared
                .iter()
                .map(|shared| SharedPlace {
                    body: shared.body,
                    first: shared.first,
                    second: shared.second,
                    block: block(shared.block),
                })
                .collect(),
            leading: plan.leading,
            block_count: plan.block_count,
            node_count: plan.node_count,
            attached_ends: plan.attached_ends.clone(),
        }
    }

    /// Multiply-adds of one factorisation: of each node its Cholesky factor, its couplings, and what they change.
    pub(super) fn multiply_adds(&self) -> f64 {
        let starts = self.steps.iter().map(|step| step.couplings).skip(1).chain([self.couplings.len()]);
        let nodes = self.steps.iter().zip(starts);
        nodes
            .map(|(step, end)| {
                let couplings = self.couplings.get(step.couplings..end).unwrap_or(&[]);
                let (own, others) =
                    (step.size as f64, couplings.iter().map(|other| other.size).sum::<usize>() as f64);
                own * own * own / 6.0 + own * own * others / 2.0 + own * others * (others + 1.0) / 2.0
            })
            .sum()
    }

    pub(super) fn view(&self) -> Plan<'_> {
        Plan {
            elimination: Elimination {
                steps: &self.steps,
                leading: self.leading,
                couplings: &self.couplings,
                targets: &self.targets,
            },
            bodies: &self.bodies,
            joints: &self.joints,
            shared: &self.shared,
        }
    }
}
