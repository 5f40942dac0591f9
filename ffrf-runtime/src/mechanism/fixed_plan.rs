//! A plan of a size that is known when compiling.

use super::{
    Block, BodyPlace, Coupling, Elimination, JointPlace, ModalEndPlace, ModalPairPlace, ModesPlace, Plan,
    PlanLists, SharedPlace, Step, Unexpanded,
};

/// An expanded plan: so many nodes, couplings, targets, bodies, joints, shared places, nodes of modes, ends of joints on
/// these, and pairs of these.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FixedPlan<
    const NODES: usize,
    const COUPLINGS: usize,
    const TARGETS: usize,
    const BODIES: usize,
    const JOINTS: usize,
    const SHARED: usize,
    const MODES: usize,
    const ENDS: usize,
    const PAIRS: usize,
> {
    steps: [Step; NODES],
    leading: usize,
    couplings: [Coupling; COUPLINGS],
    targets: [usize; TARGETS],
    bodies: [BodyPlace; BODIES],
    joints: [JointPlace; JOINTS],
    shared: [SharedPlace; SHARED],
    modes: [ModesPlace; MODES],
    modal_ends: [ModalEndPlace; ENDS],
    modal_pairs: [ModalPairPlace; PAIRS],
}

const BLOCK: Block = Block { index: 0, transposed: false };

impl<
    const NODES: usize,
    const COUPLINGS: usize,
    const TARGETS: usize,
    const BODIES: usize,
    const JOINTS: usize,
    const SHARED: usize,
    const MODES: usize,
    const ENDS: usize,
    const PAIRS: usize,
> FixedPlan<NODES, COUPLINGS, TARGETS, BODIES, JOINTS, SHARED, MODES, ENDS, PAIRS>
{
    /// The plan with a node for every six of the modes that bodies keep; the sizes must be those of
    /// [`Unexpanded::sizes`].
    pub const fn expand(unexpanded: &Unexpanded<'_>) -> Self {
        let step = Step { size: 1, node: 0, diagonal: 0, couplings: 0, is_diagonal: false, targets: 0 };
        let mut plan = Self {
            steps: [step; NODES],
            leading: 0,
            couplings: [Coupling { size: 1, node: 0, holds_point: false }; COUPLINGS],
            targets: [0; TARGETS],
            bodies: [BodyPlace { node: 0, diagonal: 0 }; BODIES],
            joints: [JointPlace { rows: 1, node: 0, diagonal: 0, is_support: false, ends: [None; 2] };
                JOINTS],
            shared: [SharedPlace { body: 0, first: 0, second: 0, block: BLOCK }; SHARED],
            modes: [ModesPlace { body: 0, first: 0, node: 0, diagonal: 0, frame: BLOCK }; MODES],
            modal_ends: [ModalEndPlace { body: 0, slot: 0, first: 0, block: BLOCK }; ENDS],
            modal_pairs: [ModalPairPlace { body: 0, rows: 0, columns: 0, block: 0 }; PAIRS],
        };
        // there are not more old nodes than new ones
        plan.leading = unexpanded.expand(
            &mut [0; NODES],
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
        plan
    }

    /// The plan.
    pub const fn view(&self) -> Plan<'_> {
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
            branches: &[],
        }
    }
}
