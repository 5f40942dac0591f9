//! The generator's plan of a mechanism in the runtime's types.

use ffrf_codegen::mechanism::{BlockPlace, BranchPlace, MechanismPlan, Topology, TopologyError};
use ffrf_runtime::mechanism::{
    Block, BodyPlace, Branch, Coupling, Elimination, EndPlace, JointPlace, ModalEndPlace, ModalPairPlace,
    ModesPlace, Plan, PlanLists, SharedPlace, Step, Unexpanded, keeps_modes, sweeps,
};

/// The bodies that keep their modes as unknowns, and how many modes these have. `modes`: of each body.
pub(super) fn keeping(topology: &Topology, modes: &[usize]) -> (Vec<usize>, Vec<usize>) {
    let hubs = topology.hubs();
    let rows: Vec<usize> = hubs.iter().map(|hub| hub.rows).collect();
    let (bodies, counts): (Vec<usize>, Vec<usize>) =
        hubs.iter().map(|hub| (hub.body, modes[hub.body])).unzip();
    if keeps_modes(&rows, &counts) { (bodies, counts) } else { (Vec::new(), Vec::new()) }
}

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
    modes: Vec<ModesPlace>,
    modal_ends: Vec<ModalEndPlace>,
    modal_pairs: Vec<ModalPairPlace>,
    pub(super) block_count: usize,
    pub(super) node_count: usize,
    pub(super) attached_ends: Vec<usize>,
    branches: Vec<Branch>,
}

impl OwnedPlan {
    /// The plan in which the bodies `keeping` keep their modes, so many.
    pub(super) fn of(topology: &Topology, keeping: &[usize], modes: &[usize]) -> Result<Self, TopologyError> {
        let mut plan = Self::new(&MechanismPlan::keeping_modes(topology, keeping)?);
        if modes.is_empty() {
            return Ok(plan);
        }
        let old = plan.clone();
        let unexpanded = Unexpanded { plan: old.view(), modes };
        let sizes = unexpanded.sizes();
        let block = Block { index: 0, transposed: false };
        plan.steps = vec![
            Step { size: 1, node: 0, diagonal: 0, is_diagonal: false, couplings: 0, targets: 0 };
            sizes.nodes
        ];
        plan.couplings = vec![Coupling { size: 1, node: 0, holds_point: false }; sizes.couplings];
        plan.targets = vec![0; sizes.targets];
        plan.modes = vec![ModesPlace { body: 0, first: 0, node: 0, diagonal: 0, frame: block }; sizes.modes];
        plan.modal_ends = vec![ModalEndPlace { body: 0, slot: 0, first: 0, block }; sizes.modal_ends];
        plan.modal_pairs = vec![ModalPairPlace { body: 0, rows: 0, columns: 0, block: 0 }; sizes.modal_pairs];
        (plan.block_count, plan.node_count) = (sizes.blocks, sizes.nodes);
        plan.leading = unexpanded.expand(
            &mut vec![0; old.steps.len()],
            &mut PlanLists {
                steps: &mut plan.steps,
                couplings: &mut plan.couplings,
                targets: &mut plan.targets,
                bodies: &mut plan.bodies,
                joints: &mut plan.joints,
                shared: &mut plan.shared,
                modes: &mut plan.modes,
                modal_ends: &mut plan.modal_ends,
                modal_pairs: &mut plan.modal_pairs,
            },
        );
        Ok(plan)
    }

    fn new(plan: &MechanismPlan) -> Self {
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
                .map(|coupling| Coupling {
                    size: coupling.size,
                    node: coupling.node,
                    holds_point: coupling.holds_point,
                })
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
                    is_support: joint.is_support,
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
            modes: plan
                .modes
                .iter()
                .map(|modes| ModesPlace {
                    body: modes.body,
                    first: 0,
                    node: modes.node,
                    diagonal: modes.diagonal,
                    frame: block(modes.frame),
                })
                .collect(),
            modal_ends: plan
                .modal_ends
                .iter()
                .map(|end| ModalEndPlace {
                    body: end.body,
                    slot: end.slot,
                    first: 0,
                    block: block(end.block),
                })
                .collect(),
            modal_pairs: Vec::new(),
            leading: plan.leading,
            block_count: plan.block_count,
            node_count: plan.node_count,
            attached_ends: plan.attached_ends.clone(),
            branches: Vec::new(),
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
                of_instant: true,
            },
            bodies: &self.bodies,
            joints: &self.joints,
            shared: &self.shared,
            modes: &self.modes,
            modal_ends: &self.modal_ends,
            modal_pairs: &self.modal_pairs,
            branches: &self.branches,
        }
    }

    /// The plan with a sweep over the bodies where they are a tree. `modes`: of each body.
    #[must_use]
    pub(super) fn swept(mut self, topology: &Topology, modes: &[usize]) -> Self {
        if sweeps(modes) {
            self.branches = topology.branches().iter().map(branch).collect();
        }
        self
    }

    /// Number of blocks, branches and motions where a tree is swept over.
    pub(super) fn tree_counts(&self) -> [usize; 3] {
        [0, self.branches.len(), self.branches.iter().map(|branch| branch.freedoms).sum()]
    }
}

fn branch(place: &BranchPlace) -> Branch {
    Branch {
        body: place.body,
        joint: place.joint,
        is_second: place.is_second,
        parent: place.parent,
        freedom: place.freedom,
        freedoms: place.freedoms,
    }
}
