//! The places of a mechanism in which bodies keep their modes as unknowns, however many modes they have.
//!
//! When a mechanism is composed, a body's number of modes is not known: a plan has one node for the modes that a body keeps.
//! Here that node becomes as many as are needed, six modes each, one after the other; everything else moves up. All of it
//! can be done while compiling.

use super::{
    Block, BodyPlace, Coupling, EndPlace, JointPlace, ModalEndPlace, ModalPairPlace, ModesPlace, Plan,
    SharedPlace, Step,
};

/// Modes in one node.
const MODES_IN_NODE: usize = 6;

/// Whether bodies with so many constraint rows and modes keep their modes: if that costs less than to eliminate them first.
///
/// Eliminated modes couple all rows on a body, kept ones couple each row with frame and modes. Decided for all bodies with
/// many joints together.
pub const fn keeps_modes(rows: &[usize], modes: &[usize]) -> bool {
    sum(rows) >= sum(modes) + 6 * modes.len()
}

const fn sum(numbers: &[usize]) -> usize {
    let (mut sum, mut rest) = (0, numbers);
    while let [number, others @ ..] = rest {
        sum += *number;
        rest = others;
    }
    sum
}

/// The entry at `index`.
const fn at<T: Copy>(list: &[T], index: usize) -> Option<T> {
    match list.split_at_checked(index) {
        Some((_, [entry, ..])) => Some(*entry),
        _ => None,
    }
}

/// Sets the entry at `index`.
const fn put<T: Copy>(list: &mut [T], index: usize, value: T) {
    if let Some((_, [place, ..])) = list.split_at_mut_checked(index) {
        *place = value;
    }
}

/// How many of everything a plan has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct PlanSizes {
    /// Nodes.
    pub nodes: usize,
    /// Couplings.
    pub couplings: usize,
    /// Targets.
    pub targets: usize,
    /// Blocks.
    pub blocks: usize,
    /// Nodes of modes.
    pub modes: usize,
    /// Nodes of modes at ends of joints.
    pub modal_ends: usize,
    /// Pairs of nodes of modes of one body.
    pub modal_pairs: usize,
}

/// The lists of a plan, to be filled.
#[derive(Debug)]
pub struct PlanLists<'a> {
    /// See [`Elimination`](super::Elimination).
    pub steps: &'a mut [Step],
    /// See [`Elimination`](super::Elimination).
    pub couplings: &'a mut [Coupling],
    /// See [`Elimination`](super::Elimination).
    pub targets: &'a mut [usize],
    /// See [`Plan`].
    pub bodies: &'a mut [BodyPlace],
    /// See [`Plan`].
    pub joints: &'a mut [JointPlace],
    /// See [`Plan`].
    pub shared: &'a mut [SharedPlace],
    /// See [`Plan`].
    pub modes: &'a mut [ModesPlace],
    /// See [`Plan`].
    pub modal_ends: &'a mut [ModalEndPlace],
    /// See [`Plan`].
    pub modal_pairs: &'a mut [ModalPairPlace],
}

/// A plan with one node for the modes of each body that keeps them, and how many modes these bodies have.
#[derive(Debug, Clone, Copy)]
pub struct Unexpanded<'a> {
    /// The plan.
    pub plan: Plan<'a>,
    /// Number of modes of each body that keeps them, in the order of the plan.
    pub modes: &'a [usize],
}

/// One of the nodes that are coupled to a node when its turn comes, or the node itself.
#[derive(Clone, Copy)]
struct Part {
    /// Which coupling of the old step; `None` for the step itself.
    coupling: Option<usize>,
    /// Which of the new nodes.
    chunk: usize,
}

impl Unexpanded<'_> {
    const fn fixed_nodes(&self) -> usize {
        self.plan.bodies.len() + self.plan.joints.len()
    }

    /// Into how many nodes a node becomes.
    const fn chunks(&self, node: usize) -> usize {
        let Some(index) = node.checked_sub(self.fixed_nodes()) else { return 1 };
        match at(self.modes, index) {
            Some(modes) if modes > MODES_IN_NODE => modes.div_ceil(MODES_IN_NODE),
            _ => 1,
        }
    }

    /// The number of a new node.
    const fn node(&self, node: usize, chunk: usize) -> usize {
        let (mut number, mut before) = (node, self.fixed_nodes());
        while before < node {
            number += self.chunks(before) - 1;
            before += 1;
        }
        number + chunk
    }

    /// The number of unknowns of a new node; a node of no modes has one, that moves nothing.
    const fn size(&self, node: usize, size: usize, chunk: usize) -> usize {
        let Some(index) = node.checked_sub(self.fixed_nodes()) else { return size };
        let Some(modes) = at(self.modes, index) else { return size };
        let left = modes.saturating_sub(chunk * MODES_IN_NODE);
        match left {
            0 => 1,
            1..MODES_IN_NODE => left,
            _ => MODES_IN_NODE,
        }
    }

    const fn couplings_end(&self, step: usize) -> usize {
        match at(self.plan.elimination.steps, step + 1) {
            Some(next) => next.couplings,
            None => self.plan.elimination.couplings.len(),
        }
    }

    /// Number of new nodes that the first `count` couplings of a step become.
    const fn width(&self, step: &Step, count: usize) -> usize {
        let (mut width, mut index) = (0, 0);
        while index < count {
            if let Some(coupling) = at(self.plan.elimination.couplings, step.couplings + index) {
                width += self.chunks(coupling.node);
            }
            index += 1;
        }
        width
    }

    /// Where the new blocks of the `chunk`-th node of a step begin, from the first of the step.
    const fn base(chunks: usize, width: usize, chunk: usize) -> usize {
        let (mut base, mut before) = (0, 0);
        while before < chunk {
            base += chunks - before + width;
            before += 1;
        }
        base
    }

    /// Sets where the new blocks of each old step begin; gives how many of everything there are.
    const fn starts(&self, starts: &mut [usize]) -> PlanSizes {
        let mut sizes = PlanSizes {
            nodes: 0,
            couplings: 0,
            targets: 0,
            blocks: 0,
            modes: 0,
            modal_ends: 0,
            modal_pairs: 0,
        };
        let mut index = 0;
        while let Some(step) = at(self.plan.elimination.steps, index) {
            put(starts, index, sizes.blocks);
            let chunks = self.chunks(step.node);
            let width = self.width(&step, self.couplings_end(index) - step.couplings);
            let mut chunk = 0;
            while chunk < chunks {
                let later = chunks - chunk - 1 + width;
                sizes.nodes += 1;
                sizes.couplings += later;
                sizes.targets += later * (later + 1) / 2;
                sizes.blocks += 1 + later;
                chunk += 1;
            }
            index += 1;
        }
        let mut index = 0;
        while let Some(modes) = at(self.plan.modes, index) {
            let chunks = self.chunks(modes.node);
            sizes.modes += chunks;
            sizes.modal_pairs += chunks * (chunks - 1) / 2;
            index += 1;
        }
        let mut index = 0;
        while let Some(end) = at(self.plan.modal_ends, index) {
            sizes.modal_ends += self.chunks_of_body(end.body);
            index += 1;
        }
        sizes
    }

    /// How many of everything the plan has when it is expanded.
    pub const fn sizes(&self) -> PlanSizes {
        self.starts(&mut [])
    }

    /// Number of nodes of the modes of a body.
    const fn chunks_of_body(&self, body: usize) -> usize {
        let mut index = 0;
        while let Some(modes) = at(self.plan.modes, index) {
            if modes.body == body {
                return self.chunks(modes.node);
            }
            index += 1;
        }
        0
    }

    /// Which new block is that of the `row`-th new node of an old block's rows and the `column`-th of its columns.
    const fn block(&self, starts: &[usize], old: usize, row: usize, column: usize) -> usize {
        // the last step that begins at or before the block
        let (mut low, mut high) = (0, self.plan.elimination.steps.len());
        while high - low > 1 {
            let middle = usize::midpoint(low, high);
            match at(self.plan.elimination.steps, middle) {
                Some(step) if step.diagonal <= old => low = middle,
                _ => high = middle,
            }
        }
        let (Some(step), Some(start)) = (at(self.plan.elimination.steps, low), at(starts, low)) else {
            return 0;
        };
        let chunks = self.chunks(step.node);
        let width = self.width(&step, self.couplings_end(low) - step.couplings);
        let diagonal = start + Self::base(chunks, width, row);
        match old - step.diagonal {
            0 => diagonal + column - row,
            later => diagonal + chunks - row + self.width(&step, later - 1) + column,
        }
    }

    const fn moved(&self, starts: &[usize], block: Block, of_modes: usize) -> Block {
        let (row, column) = if block.transposed { (0, of_modes) } else { (of_modes, 0) };
        Block { index: self.block(starts, block.index, row, column), transposed: block.transposed }
    }

    /// The `index`-th of the new nodes that are coupled to the `chunk`-th new node of a step.
    const fn part(&self, step: &Step, chunk: usize, index: usize) -> Part {
        let own = self.chunks(step.node) - chunk - 1;
        if index < own {
            return Part { coupling: None, chunk: chunk + 1 + index };
        }
        let (mut left, mut coupling) = (index - own, 0);
        while let Some(found) = at(self.plan.elimination.couplings, step.couplings + coupling) {
            let chunks = self.chunks(found.node);
            if left < chunks {
                break;
            }
            left -= chunks;
            coupling += 1;
        }
        Part { coupling: Some(coupling), chunk: left }
    }

    /// The new block of an earlier and a later part of a step.
    const fn target(&self, starts: &[usize], step: &Step, earlier: Part, later: Part) -> usize {
        let old = match (earlier.coupling, later.coupling) {
            (None, None) => step.diagonal,
            (None, Some(later)) => step.diagonal + 1 + later,
            (Some(earlier), Some(later)) => {
                match at(self.plan.elimination.targets, step.targets + later * (later + 1) / 2 + earlier) {
                    Some(target) => target,
                    None => 0,
                }
            }
            // own parts come first
            (Some(_), None) => 0,
        };
        self.block(starts, old, earlier.chunk, later.chunk)
    }

    /// Fills the lists; `starts`: room for one number for each step. Gives the number of nodes before any joint.
    pub const fn expand(&self, starts: &mut [usize], to: &mut PlanLists<'_>) -> usize {
        self.starts(starts);
        let starts: &[usize] = starts;
        let leading = self.expand_steps(starts, to);
        let mut index = 0;
        while let Some(body) = at(self.plan.bodies, index) {
            let diagonal = self.block(starts, body.diagonal, 0, 0);
            put(to.bodies, index, BodyPlace { node: body.node, diagonal });
            index += 1;
        }
        let mut index = 0;
        while let Some(joint) = at(self.plan.joints, index) {
            let [first, second] = joint.ends;
            let ends = [self.moved_end(starts, first), self.moved_end(starts, second)];
            let diagonal = self.block(starts, joint.diagonal, 0, 0);
            put(to.joints, index, JointPlace { diagonal, ends, ..joint });
            index += 1;
        }
        let mut index = 0;
        while let Some(shared) = at(self.plan.shared, index) {
            let SharedPlace { body, first, second, block } = shared;
            let block = self.moved(starts, block, 0);
            put(to.shared, index, SharedPlace { body, first, second, block });
            index += 1;
        }
        self.expand_modes(starts, to);
        leading
    }

    const fn moved_end(&self, starts: &[usize], end: Option<EndPlace>) -> Option<EndPlace> {
        match end {
            None => None,
            Some(EndPlace { body, slot, block }) => {
                Some(EndPlace { body, slot, block: self.moved(starts, block, 0) })
            }
        }
    }

    const fn expand_steps(&self, starts: &[usize], to: &mut PlanLists<'_>) -> usize {
        let (mut steps, mut couplings, mut targets, mut leading) = (0, 0, 0, 0);
        let mut index = 0;
        while let Some(step) = at(self.plan.elimination.steps, index) {
            let chunks = self.chunks(step.node);
            let width = self.width(&step, self.couplings_end(index) - step.couplings);
            let mut chunk = 0;
            while chunk < chunks {
                let new = Step {
                    size: self.size(step.node, step.size, chunk),
                    node: self.node(step.node, chunk),
                    diagonal: self.block(starts, step.diagonal, chunk, chunk),
                    is_diagonal: step.is_diagonal,
                    couplings,
                    targets,
                };
                put(to.steps, steps, new);
                steps += 1;
                let count = chunks - chunk - 1 + width;
                let mut later = 0;
                while later < count {
                    let part = self.part(&step, chunk, later);
                    put(to.couplings, couplings, self.coupling(&step, part));
                    couplings += 1;
                    let mut earlier = 0;
                    while earlier <= later {
                        let first = self.part(&step, chunk, earlier);
                        put(to.targets, targets, self.target(starts, &step, first, part));
                        targets += 1;
                        earlier += 1;
                    }
                    later += 1;
                }
                chunk += 1;
            }
            index += 1;
            if index == self.plan.elimination.leading {
                leading = steps;
            }
        }
        leading
    }

    const fn coupling(&self, step: &Step, part: Part) -> Coupling {
        let old = match part.coupling {
            None => Some(Coupling { size: step.size, node: step.node, holds_point: false }),
            Some(coupling) => at(self.plan.elimination.couplings, step.couplings + coupling),
        };
        match old {
            Some(Coupling { size, node, holds_point }) => Coupling {
                size: self.size(node, size, part.chunk),
                node: self.node(node, part.chunk),
                holds_point,
            },
            None => Coupling { size: 1, node: 0, holds_point: false },
        }
    }

    const fn expand_modes(&self, starts: &[usize], to: &mut PlanLists<'_>) {
        let (mut index, mut all, mut pairs) = (0, 0, 0);
        while let Some(modes) = at(self.plan.modes, index) {
            let ModesPlace { body, node, diagonal, frame, .. } = modes;
            let mut chunk = 0;
            while chunk < self.chunks(node) {
                let first = chunk * MODES_IN_NODE;
                let place = ModesPlace {
                    body,
                    first,
                    node: self.node(node, chunk),
                    diagonal: self.block(starts, diagonal, chunk, chunk),
                    frame: self.moved(starts, frame, chunk),
                };
                put(to.modes, all, place);
                all += 1;
                let mut later = chunk + 1;
                while later < self.chunks(node) {
                    let (columns, block) =
                        (later * MODES_IN_NODE, self.block(starts, diagonal, chunk, later));
                    put(to.modal_pairs, pairs, ModalPairPlace { body, rows: first, columns, block });
                    pairs += 1;
                    later += 1;
                }
                chunk += 1;
            }
            index += 1;
        }
        let (mut index, mut all) = (0, 0);
        while let Some(ModalEndPlace { body, slot, block, .. }) = at(self.plan.modal_ends, index) {
            let mut chunk = 0;
            while chunk < self.chunks_of_body(body) {
                let block = self.moved(starts, block, chunk);
                let first = chunk * MODES_IN_NODE;
                put(to.modal_ends, all, ModalEndPlace { body, slot, first, block });
                all += 1;
                chunk += 1;
            }
            index += 1;
        }
    }
}
