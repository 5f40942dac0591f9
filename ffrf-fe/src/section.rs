//! Section forces: what each mode transmits through a cut.

use ffrf_model::{SectionMarker, Vector3};

pub use crate::error::SectionError;

use crate::compensated::dot;
use crate::modes::{ModeError, entries};
use crate::{FeError, FeModel, ModeBasis, SparseMatrix};

/// A plane that cuts a part in two.
#[derive(Debug, Clone, PartialEq)]
pub struct SectionRequest {
    /// Name of the marker.
    pub name: String,
    /// A point of the plane, which moments are about. Units: m. Frame: body.
    pub point: Vector3,
    /// Normal of the plane, of any length. Frame: body.
    pub normal: Vector3,
}

/// Nodes nearer to the plane than this share of the size of the part lie on it, and with it on the side behind the normal.
const ON_PLANE: f64 = 1e-6;

/// Force and moment through a plane per unit modal coordinate.
///
/// The elastic forces K φ of the nodes on the side of the normal, summed: inside of that side they cancel, and what the elements in
/// between exert is left. At rest that is the load on that side, whatever the elements are. The plane cuts between nodes: planes
/// between the same nodes give the same force. A node on the plane with neighbours on both sides counts by the share of them that is
/// before the plane, one half in even meshes, as the inertia force of the material around it does; one at the end of the part is behind.
/// Errors: a normal of zero, numbers that are not finite, all nodes on one side, no stiffness.
pub fn section_marker(
    model: &FeModel,
    basis: &ModeBasis,
    request: &SectionRequest,
) -> Result<SectionMarker, FeError> {
    let SectionRequest { name, point, normal } = request;
    let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    if !(length > 0.0 && length.is_finite()) || point.iter().any(|x| !x.is_finite()) {
        return Err(SectionError::Plane { section: name.clone() }.into());
    }
    let normal = normal.map(|x| x / length);
    let height = |x: &Vector3| (0..3).map(|k| (x[k] - point[k]) * normal[k]).sum::<f64>();
    let positions = &model.nodes.positions;
    let farthest = positions.iter().map(|x| height(x).abs()).fold(0.0, f64::max);
    let heights: Vec<f64> = positions.iter().map(height).collect();
    let on_plane = ON_PLANE * farthest;
    let before = heights.iter().filter(|&&height| height > on_plane).count();
    let behind = positions.len() - before;
    if before == 0 || behind == 0 {
        return Err(SectionError::OneSide { section: name.clone(), before, behind }.into());
    }
    let stiffness = model.stiffness.as_ref().ok_or(ModeError::MissingStiffness)?;
    let side: Vec<(usize, f64)> = (0..positions.len())
        .map(|row| (row, share_before(stiffness, &heights, on_plane, row)))
        .filter(|&(_, share)| share > 0.0)
        .collect();
    let shapes = &basis.shapes;
    if shapes.nrows() != 3 * positions.len() {
        let (nodes, found) = (positions.len(), shapes.nrows());
        return Err(ModeError::ModeShapeRows { nodes, expected: 3 * nodes, found }.into());
    }
    let forces = |mode: usize| -> [f64; 6] {
        // Elastic forces of single nodes are far larger than their sum.
        let nodal: Vec<Vector3> = side
            .iter()
            .map(|&(row, share)| {
                // K is symmetric: its column is its row.
                [0, 1, 2].map(|k| {
                    let terms =
                        entries(stiffness, 3 * row + k).map(|(dof, value)| (value, shapes[(dof, mode)]));
                    share * dot(terms)
                })
            })
            .collect();
        let arm = |n: usize, k: usize| positions[side[n].0][k] - point[k];
        std::array::from_fn(|component| {
            let k = component % 3;
            if component < 3 {
                return dot(nodal.iter().map(|force| (force[k], 1.0)));
            }
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let turning = nodal.iter().enumerate();
            dot(turning.flat_map(|(n, force)| [(arm(n, i), force[j]), (-arm(n, j), force[i])]))
        })
    };
    Ok(SectionMarker {
        name: name.clone(),
        position: *point,
        normal,
        force: (0..shapes.ncols()).map(forces).collect(),
    })
}

/// What of the material around a node is before the plane: 1 or 0 off the plane; on it the reach of its neighbours before the plane
/// beside that of all, and 0 at the end of the part.
fn share_before(stiffness: &SparseMatrix, heights: &[f64], on_plane: f64, row: usize) -> f64 {
    if heights[row].abs() > on_plane {
        return if heights[row] > 0.0 { 1.0 } else { 0.0 };
    }
    let reach = |side: f64| {
        let neighbours = (3 * row..3 * row + 3).flat_map(|dof| entries(stiffness, dof));
        let far = neighbours.map(|(dof, _)| side * heights[dof / 3]).fold(0.0, f64::max);
        if far > on_plane { far } else { 0.0 }
    };
    let (before, behind) = (reach(1.0), reach(-1.0));
    if before > 0.0 && behind > 0.0 { before / (before + behind) } else { 0.0 }
}
