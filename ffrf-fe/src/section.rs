//! Section forces: what each mode transmits through a cut.

use ffrf_model::{SectionMarker, Vector3};

pub use crate::error::SectionError;

use crate::compensated::dot;
use crate::modes::{ModeError, entries};
use crate::{FeError, FeModel, ModeBasis};

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
/// between the same nodes give the same force.
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
    let side: Vec<usize> =
        (0..positions.len()).filter(|&row| height(&positions[row]) > ON_PLANE * farthest).collect();
    let behind = positions.len() - side.len();
    if side.is_empty() || behind == 0 {
        return Err(SectionError::OneSide { section: name.clone(), before: side.len(), behind }.into());
    }
    let stiffness = model.stiffness.as_ref().ok_or(ModeError::MissingStiffness)?;
    let shapes = &basis.shapes;
    if shapes.nrows() != 3 * positions.len() {
        let (nodes, found) = (positions.len(), shapes.nrows());
        return Err(ModeError::ModeShapeRows { nodes, expected: 3 * nodes, found }.into());
    }
    let forces = |mode: usize| -> [f64; 6] {
        // Elastic forces of single nodes are far larger than their sum.
        let nodal: Vec<Vector3> = side
            .iter()
            .map(|&row| {
                // K is symmetric: its column is its row.
                [0, 1, 2].map(|k| {
                    dot(entries(stiffness, 3 * row + k).map(|(dof, value)| (value, shapes[(dof, mode)])))
                })
            })
            .collect();
        let arm = |n: usize, k: usize| positions[side[n]][k] - point[k];
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
