//! Markers: position, translation and rotation of a node or node set per unit modal coordinate.

use std::collections::BTreeSet;

use faer::Mat;
use ffrf_model::{Marker, Vector3};

use crate::modes::{entries, symmetric_eigen};
use crate::tolerances::SPREAD;
use crate::{FeModel, ModeBasis};

use super::{MarkerRequest, ReductionError};

/// How many of the nearest nodes give the rotation of a node that is coupled with none.
const NEAREST: usize = 8;

/// One marker.
///
/// A node set moves with the mean of its nodes, and turns with the least-squares small rotation of them.
/// A single node turns with the nodes it is coupled with in K, or in M_s, or, if that tells no rotation,
/// with its eight nearest nodes. A rigid motion of the nodes is reproduced exactly in each case.
/// Errors: no node, a node that does not exist or that no matrix knows, all nodes on one line.
pub(crate) fn make_marker(
    model: &FeModel,
    shapes: &Mat<f64>,
    request: &MarkerRequest,
) -> Result<Marker, ReductionError> {
    let count = model.nodes.len();
    let rows: Vec<usize> = request.nodes.iter().copied().collect::<BTreeSet<_>>().into_iter().collect();
    if rows.is_empty() {
        return Err(ReductionError::EmptyMarker { marker: request.name.clone() });
    }
    if let Some(&row) = rows.iter().find(|&&row| row >= count) {
        return Err(ReductionError::MarkerNode { marker: request.name.clone(), row, nodes: count });
    }
    if let Some(&row) = rows.iter().find(|&&row| is_loose(model, shapes, row)) {
        return Err(ReductionError::MarkerLoose { marker: request.name.clone(), node: model.nodes.ids[row] });
    }
    let fit = fit_of(model, &rows, &request.name)?;
    Ok(Marker {
        name: request.name.clone(),
        nodes: rows.iter().map(|&row| model.nodes.ids[row]).collect(),
        position: mean(&rows, |row| model.nodes.positions[row]),
        translation: (0..shapes.ncols())
            .map(|mode| mean(&rows, |row| displacement(shapes, row, mode)))
            .collect(),
        rotation: (0..shapes.ncols()).map(|mode| fit.rotation(shapes, mode)).collect(),
        coupling: None,
    })
}

/// How a marker moves with the shapes of a basis: [`reduce`](super::reduce) makes its markers so.
///
/// Errors: no node, a node that does not exist or that no matrix knows, all nodes on one line.
pub fn marker_motion(
    model: &FeModel,
    basis: &ModeBasis,
    request: &MarkerRequest,
) -> Result<Marker, ReductionError> {
    make_marker(model, &basis.shapes, request)
}

/// How the nodes of a marker turn; a single one turns with those around it.
fn fit_of(model: &FeModel, rows: &[usize], marker: &str) -> Result<RotationFit, ReductionError> {
    let fit = match rows {
        [row] => fit_around(model, *row),
        _ => RotationFit::new(model, rows),
    };
    fit.map_err(|(nodes, spread)| ReductionError::MarkerRotation { marker: marker.to_owned(), nodes, spread })
}

/// Nodal forces of unit forces along x, y, z at a marker and unit moments about them. Shape: 3N x 6.
///
/// The transpose of the map from displacements to the motion of the marker: a virtual displacement of the nodes does the work that
/// the marker's does. A marker beside the mean of its nodes (an interface) is taken to be rigidly joined to them.
/// Errors: no node, a node that does not exist, all nodes on one line.
pub(crate) fn unit_loads_at(model: &FeModel, marker: &Marker) -> Result<Mat<f64>, ReductionError> {
    let count = model.nodes.len();
    let row_of = |id: &u64| {
        let unknown =
            ReductionError::MarkerNode { marker: marker.name.clone(), row: *id as usize, nodes: count };
        model.nodes.ids.iter().position(|known| known == id).ok_or(unknown)
    };
    let rows: Vec<usize> = marker.nodes.iter().map(row_of).collect::<Result<_, _>>()?;
    if rows.is_empty() {
        return Err(ReductionError::EmptyMarker { marker: marker.name.clone() });
    }
    let fit = fit_of(model, &rows, &marker.name)?;
    let centre = mean(&rows, |row| model.nodes.positions[row]);
    let offset: Vector3 = [0, 1, 2].map(|k| marker.position[k] - centre[k]);
    let mut loads = Mat::zeros(3 * count, 6);
    for k in 0..3 {
        for &row in &rows {
            loads[(3 * row + k, k)] += 1.0 / rows.len() as f64;
        }
        // e_k at the offset turns about the mean; an offset of round-off turns nothing.
        let axis: Vector3 = std::array::from_fn(|i| if i == k { 1.0 } else { 0.0 });
        fit.add_moment(&mut loads, k, cross(offset, axis));
        fit.add_moment(&mut loads, 3 + k, axis);
    }
    Ok(loads)
}

fn cross(a: Vector3, b: Vector3) -> Vector3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The linear map from nodal displacements to the least-squares small rotation ω:
/// Σ (r² I - r rᵀ) ω = Σ r × u, with r from the mean position of the nodes.
struct RotationFit {
    rows: Vec<usize>,
    arms: Vec<Vector3>,
    inverse: [[f64; 3]; 3],
}

impl RotationFit {
    /// Errors: number of nodes and relative spread, if they lie on one line.
    fn new(model: &FeModel, rows: &[usize]) -> Result<Self, (usize, f64)> {
        let centre = mean(rows, |row| model.nodes.positions[row]);
        let arms: Vec<Vector3> =
            rows.iter().map(|&row| [0, 1, 2].map(|i| model.nodes.positions[row][i] - centre[i])).collect();
        let mut moment = Mat::<f64>::zeros(3, 3);
        for r in &arms {
            let square: f64 = r.iter().map(|x| x * x).sum();
            for i in 0..3 {
                moment[(i, i)] += square;
                for j in 0..3 {
                    moment[(i, j)] -= r[i] * r[j];
                }
            }
        }
        let (values, vectors) = symmetric_eigen(moment.as_ref()).map_err(|_| (rows.len(), 0.0))?;
        let spread = if values[2] > 0.0 { (values[0].max(0.0) / values[2]).sqrt() } else { 0.0 };
        if spread < SPREAD {
            return Err((rows.len(), spread));
        }
        let inverse = [0, 1, 2]
            .map(|i| [0, 1, 2].map(|j| (0..3).map(|k| vectors[(i, k)] * vectors[(j, k)] / values[k]).sum()));
        Ok(Self { rows: rows.to_vec(), arms, inverse })
    }

    /// Adds the nodal forces of a moment to a column: those whose work is that of the moment on [`Self::rotation`].
    fn add_moment(&self, loads: &mut Mat<f64>, column: usize, moment: Vector3) {
        let turned: Vector3 = [0, 1, 2].map(|i| (0..3).map(|j| self.inverse[i][j] * moment[j]).sum());
        for (&row, &arm) in self.rows.iter().zip(&self.arms) {
            for (k, force) in cross(turned, arm).into_iter().enumerate() {
                loads[(3 * row + k, column)] += force;
            }
        }
    }

    fn rotation(&self, shapes: &Mat<f64>, mode: usize) -> Vector3 {
        let mut moment = [0.0; 3];
        for (&row, r) in self.rows.iter().zip(&self.arms) {
            let u = displacement(shapes, row, mode);
            for i in 0..3 {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                moment[i] += r[j] * u[k] - r[k] * u[j];
            }
        }
        [0, 1, 2].map(|i| (0..3).map(|j| self.inverse[i][j] * moment[j]).sum())
    }
}

fn fit_around(model: &FeModel, row: usize) -> Result<RotationFit, (usize, f64)> {
    let mut coupled = BTreeSet::from([row]);
    if let Some(stiffness) = &model.stiffness {
        for dof in 3 * row..3 * row + 3 {
            coupled.extend(
                entries(stiffness, dof).filter(|&(_, value)| value != 0.0).map(|(other, _)| other / 3),
            );
        }
    }
    coupled.extend(entries(&model.mass, row).filter(|&(_, value)| value != 0.0).map(|(node, _)| node));
    let coupled: Vec<usize> = coupled.into_iter().collect();
    RotationFit::new(model, &coupled).or_else(|_| RotationFit::new(model, &nearest(model, row)))
}

fn nearest(model: &FeModel, row: usize) -> Vec<usize> {
    let here = model.nodes.positions[row];
    let distance = |node: usize| -> f64 {
        model.nodes.positions[node].iter().zip(here).map(|(x, x0)| (x - x0).powi(2)).sum()
    };
    let mut order: Vec<usize> = (0..model.nodes.len()).collect();
    order.sort_by(|&a, &b| distance(a).total_cmp(&distance(b)).then(a.cmp(&b)));
    order.truncate(NEAREST + 1);
    order
}

/// True for a node that no matrix and no mode shape knows: its displacement would be zero by default.
fn is_loose(model: &FeModel, shapes: &Mat<f64>, row: usize) -> bool {
    let Some(stiffness) = &model.stiffness else { return false };
    let mut values =
        (3 * row..3 * row + 3).flat_map(|dof| entries(stiffness, dof)).chain(entries(&model.mass, row));
    let at_rest = (0..shapes.ncols()).all(|mode| displacement(shapes, row, mode) == [0.0; 3]);
    at_rest && !model.fixed_dofs.contains(&(3 * row)) && values.all(|(_, value)| value == 0.0)
}

fn displacement(shapes: &Mat<f64>, row: usize, mode: usize) -> Vector3 {
    [0, 1, 2].map(|i| shapes[(3 * row + i, mode)])
}

fn mean(rows: &[usize], value: impl Fn(usize) -> Vector3) -> Vector3 {
    let mut sum = [0.0; 3];
    for &row in rows {
        let value = value(row);
        for i in 0..3 {
            sum[i] += value[i];
        }
    }
    sum.map(|total| total / rows.len() as f64)
}
