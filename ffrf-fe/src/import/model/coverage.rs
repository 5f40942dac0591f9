//! Whether mass and stiffness know the same nodes, and couple the same nodes.

use std::path::Path;

use crate::import::nodes::NodeTable;
use crate::import::note::file_name;
use crate::import::{ImportError, Note};
use crate::{Nodes, SparseMatrix};

/// Ids that a message lists.
const LISTED: usize = 8;

/// The first of some ids, in words: `node 7`, or `nodes 1, 2, 3, ...`.
pub(super) fn listed(ids: impl Iterator<Item = u64>) -> String {
    let ids: Vec<String> = ids.take(LISTED + 1).map(|id| id.to_string()).collect();
    match ids.as_slice() {
        [only] => format!("node {only}"),
        some if some.len() <= LISTED => format!("nodes {}", some.join(", ")),
        many => format!("nodes {}, ...", many[..LISTED].join(", ")),
    }
}

/// Which nodes the matrices know.
pub(super) struct Coverage<'a> {
    pub(super) table: &'a NodeTable,
    /// M_s.
    pub(super) mass: &'a SparseMatrix,
    pub(super) mass_path: &'a Path,
    /// K with the rows of held degrees of freedom zero, and its file.
    pub(super) stiffness: Option<(&'a SparseMatrix, &'a Path)>,
    /// Held degrees of freedom.
    pub(super) held: &'a [bool],
    /// Of these, those that a list of the stiffness leaves out without a mark.
    pub(super) left_out: &'a [bool],
}

impl Coverage<'_> {
    /// Refuses nodes that one of the matrices does not know, unless that is meant; a node that none knows is noted.
    pub(super) fn check(&self, allowed: bool, notes: &mut Vec<Note>) -> Result<(), ImportError> {
        let nodes = 0..self.table.nodes.len();
        let massless = |&node: &usize| !self.has_mass(node);
        let Some((_, stiffness_path)) = self.stiffness else {
            let lacking: Vec<usize> = nodes.filter(massless).collect();
            return self.refuse(&lacking, self.mass_path, "a position", "mass", allowed, notes);
        };
        let lacking: Vec<usize> =
            nodes.clone().filter(massless).filter(|&node| self.has_stiffness(node)).collect();
        self.refuse(&lacking, self.mass_path, "stiffness", "mass", allowed, notes)?;
        // A node that is left out whole was held by the export only if the deck has boundary conditions.
        let unknown = |&node: &usize| {
            let dofs = 3 * node..3 * node + 3;
            let absent = self.left_out[dofs.clone()] == [true; 3] && !self.table.has_boundary;
            absent || (!self.held[dofs].contains(&true) && !self.has_stiffness(node))
        };
        let lacking: Vec<usize> = nodes.clone().filter(unknown).filter(|&node| self.has_mass(node)).collect();
        self.refuse(&lacking, stiffness_path, "mass", "stiffness", allowed, notes)?;
        let loose: Vec<usize> = nodes.filter(massless).filter(unknown).collect();
        if !loose.is_empty() {
            notes.push(Note::warning(format!(
                "{} in the node table and in neither matrix: at rest in the body frame ({})",
                if loose.len() == 1 { "1 node is".to_owned() } else { format!("{} nodes are", loose.len()) },
                self.ids(&loose)
            )));
        }
        Ok(())
    }

    fn refuse(
        &self,
        lacking: &[usize],
        path: &Path,
        has: &'static str,
        lacks: &'static str,
        allowed: bool,
        notes: &mut Vec<Note>,
    ) -> Result<(), ImportError> {
        if lacking.is_empty() {
            return Ok(());
        }
        let (count, listed) = (lacking.len(), self.ids(lacking));
        if allowed {
            let verb = if count == 1 { "node has" } else { "nodes have" };
            let text = format!("{count} {verb} {has} and no {lacks} ({listed}), as allowed");
            notes.push(Note::warning(text).about(path));
            return Ok(());
        }
        Err(ImportError::OneSidedNodes { path: path.to_path_buf(), count, listed, has, lacks })
    }

    fn ids(&self, rows: &[usize]) -> String {
        listed(rows.iter().map(|&row| self.table.nodes.ids[row]))
    }

    fn has_mass(&self, node: usize) -> bool {
        self.mass.val_of_col(node).iter().any(|&value| value != 0.0)
    }

    fn has_stiffness(&self, node: usize) -> bool {
        let Some((stiffness, _)) = self.stiffness else { return false };
        (3 * node..3 * node + 3).any(|dof| stiffness.val_of_col(dof).iter().any(|&value| value != 0.0))
    }

    /// Warns of nodes that the mass couples and the stiffness does not: matrices in different orders.
    ///
    /// The nodes of an element are coupled in its stiffness whenever they are in its mass. Held nodes have lost their
    /// rows.
    pub(super) fn compare_patterns(&self, notes: &mut Vec<Note>) {
        let Some((stiffness, stiffness_path)) = self.stiffness else { return };
        let free = |node: usize| !self.held[3 * node..3 * node + 3].contains(&true);
        let mut coupled_with = vec![usize::MAX; self.table.nodes.len()];
        let (mut pairs, mut example) = (0_usize, None);
        for node in (0..self.table.nodes.len()).filter(|&node| free(node)) {
            for dof in 3 * node..3 * node + 3 {
                let entries = stiffness.row_idx_of_col(dof).zip(stiffness.val_of_col(dof));
                for (row, _) in entries.filter(|&(_, &value)| value != 0.0) {
                    coupled_with[row / 3] = node;
                }
            }
            for (other, &value) in self.mass.row_idx_of_col(node).zip(self.mass.val_of_col(node)) {
                if other < node && value != 0.0 && coupled_with[other] != node && free(other) {
                    pairs += 1;
                    example.get_or_insert((other, node));
                }
            }
        }
        if let Some((a, b)) = example {
            let Nodes { ids, .. } = &self.table.nodes;
            let text = format!(
                "the mass couples nodes {} and {} ({pairs} such pairs), which {} does not: are both matrices in the order \
                 of the same nodes?",
                ids[a],
                ids[b],
                file_name(stiffness_path)
            );
            notes.push(Note::warning(text).about(self.mass_path));
        }
    }
}
