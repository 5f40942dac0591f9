//! Coordinates of the part with its rigid couplings: u = T y.
//!
//! y holds the free degrees of freedom of all nodes that no rigid interface claims, then the six motions of each
//! rigid interface. T is sparse and never stored: a claimed node follows its reference point.

use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use faer::{Mat, MatRef};
use ffrf_model::Vector3;

use crate::modes::{ModeError, entries};
use crate::{FeError, FeModel, SparseMatrix};

use super::coupling_rbe2::rigid_rows;
use super::small::subtract;
use super::{ComponentModeError, Interface};

const NOT_FREE: usize = usize::MAX;

/// A node that follows a rigid interface.
#[derive(Clone, Copy)]
struct Follower {
    node: usize,
    arm: Vector3,
}

/// A rigid interface as six coordinates.
struct Group {
    /// Place of its first motion in y.
    first: usize,
    reference_point: Vector3,
    followers: Vec<Follower>,
}

/// The coordinates y of a model with interfaces.
pub(crate) struct Coordinates<'a> {
    pub model: &'a FeModel,
    pub stiffness: &'a SparseMatrix,
    /// Full number of each coordinate that is a degree of freedom of a node, ascending.
    free: Vec<usize>,
    /// Place in y of each full degree of freedom, or `NOT_FREE`.
    compact: Vec<usize>,
    groups: Vec<Group>,
    /// For each node the group it follows and its arm.
    follows: Vec<Option<(u32, Vector3)>>,
    /// Full degrees of freedom that the export's boundary conditions or this program hold.
    pub held: Vec<usize>,
}

impl<'a> Coordinates<'a> {
    /// Sorts the degrees of freedom; interfaces by mean take no coordinates.
    ///
    /// Errors: no stiffness, sizes that do not fit, nodes that are held or that two rigid interfaces claim.
    pub fn new(model: &'a FeModel, interfaces: &[Interface]) -> Result<Self, FeError> {
        Self::held(model, interfaces, &[])
    }

    /// The same with the nodes of some rows at rest.
    ///
    /// Errors: as those of [`Self::new`]; a row that does not exist.
    pub fn held(model: &'a FeModel, interfaces: &[Interface], rows: &[usize]) -> Result<Self, FeError> {
        let stiffness = model.stiffness.as_ref().ok_or(ModeError::MissingStiffness)?;
        let nodes = model.nodes.len();
        check_size("stiffness", stiffness, 3 * nodes)?;
        check_size("mass", &model.mass, nodes)?;
        let mut is_held = vec![false; 3 * nodes];
        for &dof in &model.fixed_dofs {
            *is_held.get_mut(dof).ok_or(ModeError::UnknownNodeRow { row: dof / 3, nodes })? = true;
        }
        for &row in rows {
            is_held.get_mut(3 * row..3 * row + 3).ok_or(ModeError::UnknownNodeRow { row, nodes })?.fill(true);
        }
        let follows = followers(model, interfaces, &is_held)?;
        let mut compact = vec![NOT_FREE; 3 * nodes];
        let mut free = Vec::new();
        for dof in 0..3 * nodes {
            let known = has_entries(&model.mass, dof / 3) || has_entries(stiffness, dof);
            if !is_held[dof] && known && follows[dof / 3].is_none() {
                compact[dof] = free.len();
                free.push(dof);
            }
        }
        let groups = interfaces
            .iter()
            .filter(|interface| interface.is_rigid())
            .enumerate()
            .map(|(number, interface)| Group {
                first: free.len() + 6 * number,
                reference_point: interface.reference_point,
                followers: interface
                    .nodes
                    .iter()
                    .filter_map(|&node| follows[node].map(|(_, arm)| Follower { node, arm }))
                    .collect(),
            })
            .collect();
        let held = (0..3 * nodes).filter(|&dof| is_held[dof]).collect();
        Ok(Self { model, stiffness, free, compact, groups, follows, held })
    }

    /// Number of coordinates.
    pub fn dimension(&self) -> usize {
        self.free.len() + 6 * self.groups.len()
    }

    /// Places of the six motions of each rigid interface, in the order of the interfaces.
    pub fn rigid_places(&self) -> impl Iterator<Item = usize> + '_ {
        self.groups.iter().map(|group| group.first)
    }

    /// The coordinate that is this degree of freedom of a node.
    pub fn place_of(&self, dof: usize) -> Option<usize> {
        self.compact.get(dof).copied().filter(|&place| place != NOT_FREE)
    }

    /// u = T y on all 3N degrees of freedom; zero where they are held or loose.
    pub fn expand(&self, shapes: MatRef<'_, f64>) -> Mat<f64> {
        let mut full = Mat::zeros(self.compact.len(), shapes.ncols());
        for j in 0..shapes.ncols() {
            let column = full.col_as_slice_mut(j);
            for (i, &dof) in self.free.iter().enumerate() {
                column[dof] = shapes[(i, j)];
            }
            for group in &self.groups {
                for follower in &group.followers {
                    for (axis, row) in rigid_rows(follower.arm).iter().enumerate() {
                        column[3 * follower.node + axis] =
                            (0..6).map(|k| row[k] * shapes[(group.first + k, j)]).sum();
                    }
                }
            }
        }
        full
    }

    /// Tᵀ f: forces on y of forces on all 3N degrees of freedom.
    pub fn contract(&self, full: MatRef<'_, f64>) -> Mat<f64> {
        let mut forces = Mat::zeros(self.dimension(), full.ncols());
        for j in 0..full.ncols() {
            let column = forces.col_as_slice_mut(j);
            for (i, &dof) in self.free.iter().enumerate() {
                column[i] = full[(dof, j)];
            }
            for group in &self.groups {
                for follower in &group.followers {
                    for (axis, row) in rigid_rows(follower.arm).iter().enumerate() {
                        for k in 0..6 {
                            column[group.first + k] += row[k] * full[(3 * follower.node + axis, j)];
                        }
                    }
                }
            }
        }
        forces
    }

    /// y of six columns of rigid motion: values at nodes, and velocity and rotation of the reference points.
    ///
    /// `field(position)` is the 3 x 6 displacement of a point, `rotation` the rotation of each column.
    pub fn sample(&self, field: impl Fn(Vector3) -> [[f64; 6]; 3], rotation: [[f64; 6]; 3]) -> Mat<f64> {
        let mut shapes = Mat::zeros(self.dimension(), 6);
        for (i, &dof) in self.free.iter().enumerate() {
            let row = field(self.model.nodes.positions[dof / 3])[dof % 3];
            for k in 0..6 {
                shapes[(i, k)] = row[k];
            }
        }
        for group in &self.groups {
            let rows = field(group.reference_point);
            for axis in 0..3 {
                for k in 0..6 {
                    shapes[(group.first + axis, k)] = rows[axis][k];
                    shapes[(group.first + 3 + axis, k)] = rotation[axis][k];
                }
            }
        }
        shapes
    }

    /// Lower triangle of Tᵀ(K - σM)T on the coordinates that `number` counts (`None`: left out), and the node of
    /// each, nodes of reference points behind all others.
    pub fn shifted_lower(&self, shift: f64, number: &[Option<u32>]) -> (SparseColMat<u32, f64>, Vec<usize>) {
        let size = number.iter().flatten().count();
        let mut starts = Vec::with_capacity(size + 1);
        starts.push(0_u32);
        let (mut rows, mut values) = (Vec::<u32>::new(), Vec::<f64>::new());
        let mut node_of = Vec::with_capacity(size);
        let mut column = Accumulator::new(self.dimension());
        for place in 0..self.dimension() {
            let Some(own) = number[place] else { continue };
            node_of.push(self.node_of(place));
            // A coordinate always has its diagonal entry, even a zero one.
            column.add(place, 0.0);
            self.sources(place, &mut |dof, factor| {
                for (row, value) in entries(self.stiffness, dof) {
                    self.scatter(row, factor * value, &mut column);
                }
                if shift != 0.0 {
                    for (node, value) in entries(&self.model.mass, dof / 3) {
                        self.scatter(3 * node + dof % 3, -shift * factor * value, &mut column);
                    }
                }
            });
            column.drain(|row, value| {
                if let Some(row) = number[row].filter(|&row| row >= own) {
                    rows.push(row);
                    values.push(value);
                }
            });
            starts.push(rows.len() as u32);
        }
        let pattern = SymbolicSparseColMat::new_checked(size, size, starts, None, rows);
        (SparseColMat::new(pattern, values), node_of)
    }

    /// Positions of all nodes, then of the reference points of the rigid interfaces.
    pub fn node_positions(&self) -> Vec<Vector3> {
        let points = self.groups.iter().map(|group| group.reference_point);
        self.model.nodes.positions.iter().copied().chain(points).collect()
    }

    fn node_of(&self, place: usize) -> usize {
        match self.free.get(place) {
            Some(dof) => dof / 3,
            None => self.model.nodes.len() + (place - self.free.len()) / 6,
        }
    }

    /// The full degrees of freedom that a coordinate moves, with factors.
    fn sources(&self, place: usize, visit: &mut dyn FnMut(usize, f64)) {
        if let Some(&dof) = self.free.get(place) {
            return visit(dof, 1.0);
        }
        let motion = (place - self.free.len()) % 6;
        let group = &self.groups[(place - self.free.len()) / 6];
        for follower in &group.followers {
            for (axis, row) in rigid_rows(follower.arm).iter().enumerate() {
                if row[motion] != 0.0 {
                    visit(3 * follower.node + axis, row[motion]);
                }
            }
        }
    }

    /// Adds `value` in row `dof` of the full matrix to the coordinates that move it.
    fn scatter(&self, dof: usize, value: f64, column: &mut Accumulator) {
        if let Some((group, arm)) = self.follows[dof / 3] {
            let row = rigid_rows(arm)[dof % 3];
            for (k, factor) in row.into_iter().enumerate().filter(|(_, factor)| *factor != 0.0) {
                column.add(self.groups[group as usize].first + k, factor * value);
            }
        } else if self.compact[dof] != NOT_FREE {
            column.add(self.compact[dof], value);
        }
    }
}

/// One column of a sparse matrix while it is summed.
struct Accumulator {
    values: Vec<f64>,
    is_touched: Vec<bool>,
    touched: Vec<u32>,
}

impl Accumulator {
    fn new(size: usize) -> Self {
        Self { values: vec![0.0; size], is_touched: vec![false; size], touched: Vec::new() }
    }

    fn add(&mut self, row: usize, value: f64) {
        if !self.is_touched[row] {
            self.is_touched[row] = true;
            self.touched.push(row as u32);
        }
        self.values[row] += value;
    }

    /// Hands out the entries in ascending order and forgets them.
    fn drain(&mut self, mut visit: impl FnMut(usize, f64)) {
        self.touched.sort_unstable();
        for row in self.touched.drain(..) {
            let row = row as usize;
            visit(row, self.values[row]);
            self.values[row] = 0.0;
            self.is_touched[row] = false;
        }
    }
}

type Followed = Vec<Option<(u32, Vector3)>>;

fn followers(
    model: &FeModel,
    interfaces: &[Interface],
    is_held: &[bool],
) -> Result<Followed, ComponentModeError> {
    let mut follows: Followed = vec![None; model.nodes.len()];
    let mut names: Vec<&str> = Vec::new();
    for interface in interfaces {
        let held = |&&row: &&usize| (3 * row..3 * row + 3).any(|dof| is_held[dof]);
        if let Some(&row) = interface.nodes.iter().find(held) {
            let node = model.nodes.ids[row];
            return Err(ComponentModeError::Held { interface: interface.name.clone(), node });
        }
        if !interface.is_rigid() {
            continue;
        }
        for &row in &interface.nodes {
            if let Some((first, _)) = follows[row] {
                return Err(ComponentModeError::Shared {
                    node: model.nodes.ids[row],
                    first: names[first as usize].to_owned(),
                    second: interface.name.clone(),
                });
            }
            let arm = subtract(model.nodes.positions[row], interface.reference_point);
            follows[row] = Some((names.len() as u32, arm));
        }
        names.push(&interface.name);
    }
    Ok(follows)
}

fn has_entries(matrix: &SparseMatrix, column: usize) -> bool {
    matrix.val_of_col(column).iter().any(|&value| value != 0.0)
}

fn check_size(what: &str, matrix: &SparseMatrix, expected: usize) -> Result<(), ModeError> {
    if matrix.nrows() == expected && matrix.ncols() == expected {
        return Ok(());
    }
    Err(ModeError::MatrixSize {
        what: what.to_owned(),
        expected,
        rows: matrix.nrows(),
        columns: matrix.ncols(),
    })
}
