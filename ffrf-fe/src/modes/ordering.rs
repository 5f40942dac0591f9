//! Fill-reducing elimination order: geometric nested dissection against minimum degree, on the graph of nodes.
//!
//! The degrees of freedom of a node have the same neighbours, so that ordering nodes is nine times cheaper than
//! ordering degrees of freedom and keeps dense 3 x 3 blocks together.

use faer::perm::Perm;
use faer::sparse::SymbolicSparseColMat;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::{Side, sparse::SparseColMat};

use super::ModeError;

/// Subsets of at most this many nodes are not cut further.
const LEAF: usize = 6;
/// Where cuts are tried, as parts of a subset ordered along an axis.
const CUTS: [f64; 3] = [0.5, 0.45, 0.55];

/// An elimination order of the degrees of freedom, and how it was found.
pub(crate) struct Ordering {
    /// Degrees of freedom in the order of elimination.
    pub order: Vec<u32>,
    /// Name of the method that predicted the smaller factor.
    pub method: &'static str,
}

/// Orders the degrees of freedom of a lower triangle; `node_of` gives the node of each, ascending.
///
/// Errors: [`ModeError::FactorTooLarge`].
pub(crate) fn order(
    lower: &SparseColMat<u32, f64>,
    node_of: &[usize],
    positions: &[[f64; 3]],
) -> Result<Ordering, ModeError> {
    let size = lower.nrows();
    let graph = NodeGraph::new(lower, node_of, positions);
    let pattern = graph.lower_pattern();
    let too_large = |_| ModeError::FactorTooLarge { size };
    let degree = analyse(&pattern, SymmetricOrdering::Amd).map_err(too_large)?;
    let dissected = graph.dissect();
    let permutation = permutation(&dissected);
    let nested = analyse(&pattern, SymmetricOrdering::Custom(permutation.as_ref())).map_err(too_large)?;
    let (nodes, method) = match degree.perm() {
        Some(by_degree) if degree.len_val() < nested.len_val() => {
            (by_degree.arrays().0.to_vec(), "minimum degree")
        }
        _ => (dissected, "nested dissection"),
    };
    let order = nodes.iter().flat_map(|&node| graph.members(node)).collect();
    Ok(Ordering { order, method })
}

/// The permutation that puts `order[i]` at place i.
pub(crate) fn permutation(order: &[u32]) -> Perm<u32> {
    let mut inverse = vec![0_u32; order.len()];
    for (place, &item) in order.iter().enumerate() {
        inverse[item as usize] = place as u32;
    }
    Perm::new_checked(order.into(), inverse.into(), order.len())
}

/// Symbolic analysis with supernodes.
pub(crate) fn analyse(
    lower: &SymbolicSparseColMat<u32>,
    ordering: SymmetricOrdering<'_, u32>,
) -> Result<SymbolicCholesky<u32>, faer::sparse::FaerError> {
    let params = CholeskySymbolicParams {
        supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
        ..Default::default()
    };
    factorize_symbolic_cholesky(lower.as_ref(), Side::Lower, ordering, params)
}

/// Adjacency of the nodes that have free degrees of freedom.
struct NodeGraph {
    /// Start of each node's neighbours, one more entry than nodes.
    starts: Vec<usize>,
    neighbours: Vec<u32>,
    positions: Vec<[f64; 3]>,
    /// First degree of freedom of each node, one more entry than nodes.
    first_dof: Vec<u32>,
}

impl NodeGraph {
    fn new(lower: &SparseColMat<u32, f64>, node_of: &[usize], positions: &[[f64; 3]]) -> Self {
        let mut first_dof = Vec::new();
        let mut compact = vec![0_u32; node_of.len()];
        let mut node_positions = Vec::new();
        for (dof, &node) in node_of.iter().enumerate() {
            if dof == 0 || node_of[dof - 1] != node {
                first_dof.push(dof as u32);
                node_positions.push(positions[node]);
            }
            compact[dof] = first_dof.len() as u32 - 1;
        }
        let count = first_dof.len();
        first_dof.push(node_of.len() as u32);
        let mut lists: Vec<Vec<u32>> = vec![Vec::new(); count];
        for column in 0..lower.ncols() {
            let node = compact[column];
            for &row in lower.symbolic().row_idx_of_col_raw(column) {
                let other = compact[row as usize];
                if other != node {
                    lists[node as usize].push(other);
                    lists[other as usize].push(node);
                }
            }
            // Entries repeat for each pair of directions: thin out before the list grows.
            if column + 1 == lower.ncols() || compact[column + 1] != node {
                lists[node as usize].sort_unstable();
                lists[node as usize].dedup();
            }
        }
        let mut starts = vec![0];
        let mut neighbours = Vec::new();
        for list in &mut lists {
            list.sort_unstable();
            list.dedup();
            neighbours.append(list);
            starts.push(neighbours.len());
        }
        Self { starts, neighbours, positions: node_positions, first_dof }
    }

    fn len(&self) -> usize {
        self.positions.len()
    }

    fn neighbours(&self, node: u32) -> &[u32] {
        &self.neighbours[self.starts[node as usize]..self.starts[node as usize + 1]]
    }

    fn members(&self, node: u32) -> std::ops::Range<u32> {
        self.first_dof[node as usize]..self.first_dof[node as usize + 1]
    }

    fn lower_pattern(&self) -> SymbolicSparseColMat<u32> {
        let mut starts = vec![0_u32];
        let mut rows = Vec::new();
        for node in 0..self.len() as u32 {
            rows.push(node);
            rows.extend(self.neighbours(node).iter().filter(|&&other| other > node));
            starts.push(rows.len() as u32);
        }
        SymbolicSparseColMat::new_checked(self.len(), self.len(), starts, None, rows)
    }

    /// Nodes in the order of nested dissection by planes across the coordinate axes.
    fn dissect(&self) -> Vec<u32> {
        let mut order = Vec::with_capacity(self.len());
        let mut side = vec![Side3::Outside; self.len()];
        // Subsets still to be ordered; a separator is written after both of its sides.
        let mut stack = vec![Work::Cut((0..self.len() as u32).collect())];
        while let Some(work) = stack.pop() {
            let nodes = match work {
                Work::Write(nodes) => {
                    order.extend(nodes);
                    continue;
                }
                Work::Cut(nodes) if nodes.len() <= LEAF => {
                    order.extend(nodes);
                    continue;
                }
                Work::Cut(nodes) => nodes,
            };
            match self.best_cut(&nodes, &mut side) {
                Some(cut) => {
                    stack.push(Work::Write(cut.separator));
                    stack.push(Work::Cut(cut.upper));
                    stack.push(Work::Cut(cut.lower));
                }
                None => order.extend(nodes),
            }
        }
        order
    }

    fn best_cut(&self, nodes: &[u32], side: &mut [Side3]) -> Option<Cut> {
        let mut best: Option<(f64, Cut)> = None;
        for axis in 0..3 {
            let coordinate = |node: u32| self.positions[node as usize][axis];
            let mut sorted = nodes.to_vec();
            sorted.sort_by(|&a, &b| coordinate(a).total_cmp(&coordinate(b)).then(a.cmp(&b)));
            let extent = coordinate(sorted[sorted.len() - 1]) - coordinate(sorted[0]);
            let mut tried = 0;
            for part in CUTS {
                let middle = (part * sorted.len() as f64) as usize;
                let Some(place) = plane_near(&sorted, middle, 1e-6 * extent, coordinate) else { continue };
                if place == tried {
                    continue;
                }
                tried = place;
                let cut = self.cut(&sorted, place, side);
                let smaller = cut.lower.len().min(cut.upper.len());
                if smaller == 0 {
                    continue;
                }
                let balance = nodes.len() as f64 / (2 * smaller) as f64;
                let cost = cut.separator.len() as f64 * balance.sqrt();
                if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                    best = Some((cost, cut));
                }
            }
        }
        best.map(|(_, cut)| cut)
    }

    /// Cuts before `place`; the separator is the thinner of the two layers along the cut.
    fn cut(&self, sorted: &[u32], place: usize, side: &mut [Side3]) -> Cut {
        let (lower, upper) = sorted.split_at(place);
        lower.iter().for_each(|&node| side[node as usize] = Side3::Lower);
        upper.iter().for_each(|&node| side[node as usize] = Side3::Upper);
        let touches =
            |node: u32, other: Side3| self.neighbours(node).iter().any(|&next| side[next as usize] == other);
        let (lower_layer, lower_rest): (Vec<u32>, Vec<u32>) =
            lower.iter().partition(|&&node| touches(node, Side3::Upper));
        let (upper_layer, upper_rest): (Vec<u32>, Vec<u32>) =
            upper.iter().partition(|&&node| touches(node, Side3::Lower));
        sorted.iter().for_each(|&node| side[node as usize] = Side3::Outside);
        let mut cut = if lower_layer.len() <= upper_layer.len() {
            Cut { lower: lower_rest, upper: upper.to_vec(), separator: lower_layer }
        } else {
            Cut { lower: lower.to_vec(), upper: upper_rest, separator: upper_layer }
        };
        cut.separator.sort_unstable();
        cut
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Side3 {
    Outside,
    Lower,
    Upper,
}

enum Work {
    Cut(Vec<u32>),
    Write(Vec<u32>),
}

struct Cut {
    lower: Vec<u32>,
    upper: Vec<u32>,
    separator: Vec<u32>,
}

/// The place nearest to `middle` where the coordinate steps, so that layers of a regular mesh stay whole.
fn plane_near(sorted: &[u32], middle: usize, step: f64, coordinate: impl Fn(u32) -> f64) -> Option<usize> {
    let steps = |place: usize| {
        place > 0 && place < sorted.len() && coordinate(sorted[place]) - coordinate(sorted[place - 1]) > step
    };
    (0..sorted.len()).find_map(|distance| {
        if steps(middle + distance) {
            Some(middle + distance)
        } else if middle >= distance && steps(middle - distance) {
            Some(middle - distance)
        } else {
            None
        }
    })
}
