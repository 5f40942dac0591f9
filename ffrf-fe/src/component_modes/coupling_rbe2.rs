//! Rigid coupling (RBE2): every node of the interface follows the reference point as one rigid body.

use ffrf_model::Vector3;

/// Displacement of a node per unit motion of the reference point: u = v + ω × r.
///
/// `arm` is r, from the reference point to the node. Shape: 3 x 6; columns are the translations v and the
/// small rotations ω of the reference point, along and about x, y, z of the body frame.
pub(crate) fn rigid_rows(arm: Vector3) -> [[f64; 6]; 3] {
    let [x, y, z] = arm;
    [[1.0, 0.0, 0.0, 0.0, z, -y], [0.0, 1.0, 0.0, -z, 0.0, x], [0.0, 0.0, 1.0, y, -x, 0.0]]
}
