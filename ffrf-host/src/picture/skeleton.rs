//! What bodies without a surface look like: bars between what is known of them.

use ffrf_codegen::fidelity::Fidelity;
use ffrf_model::ReducedBody;
use ffrf_runtime::{FlexibleBody as _, Marker, Observables as _};
use nalgebra::{Matrix3, Rotation3, Vector3};

use super::Shape;
use crate::scene::Scene;
use crate::{HostBody, HostModal};

/// Thickness of bars and size of boxes, relative to the size of the scene.
const BAR: f64 = 0.012;
const MARKER: f64 = 0.02;

/// The size of a scene: from the first to the last place of frames and markers.
fn size(scene: &Scene) -> f64 {
    let (mut low, mut high) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
    let bodies = scene.initial.iter().zip(scene.mechanism.markers());
    for (state, markers) in bodies {
        let places = markers.iter().map(|marker| state.position + state.to_inertial(&marker.position));
        for place in places.chain([state.position]) {
            (low, high) = (low.inf(&place), high.sup(&place));
        }
    }
    let size = (high - low).norm();
    if size.is_finite() && size > 0.0 { size } else { 1.0 }
}

/// What every body of a scene looks like without a surface.
pub fn skeletons(scene: &Scene) -> Vec<Shape> {
    let size = size(scene);
    let bodies = scene.mechanism.bodies().iter().zip(scene.mechanism.markers());
    bodies.map(|(body, markers)| skeleton(body, markers, size)).collect()
}

/// What a body looks like without a surface.
pub fn model_skeleton(model: &ReducedBody) -> Shape {
    let (body, markers) = (HostBody::new(model, &Fidelity::Full), HostBody::markers(model));
    let (mut low, mut high) = (Vector3::zeros(), Vector3::zeros());
    for marker in &markers {
        (low, high) = (low.inf(&marker.position), high.sup(&marker.position));
    }
    let size = (high - low).norm();
    skeleton(&body, &markers, if size > 0.0 { size } else { 1.0 })
}

/// A bar from the centre of mass to each marker, a cube at each, and where there are no markers the box of equal inertia.
fn skeleton(body: &HostBody, markers: &[Marker<HostModal, f64>], size: f64) -> Shape {
    let rest = body.undeformed();
    let prepared = body.prepare(&rest, &Vector3::zeros(), &rest);
    let mass = body.mass();
    let center = prepared.first_moment / mass;
    let mut shape = Shape { modes: vec![Vec::new(); body.mode_count()], ..Shape::default() };
    let still = Marker::rigid(center, &rest);
    let far: Vec<&Marker<HostModal, f64>> =
        markers.iter().filter(|marker| (marker.position - center).norm() > 1e-3 * size).collect();
    if far.is_empty() {
        // ½ of the trace less a moment is m times the mean square along that axis, which is a²/12 of a box
        let about = prepared.inertia
            - (Matrix3::from_diagonal_element(center.norm_squared()) - center * center.transpose()) * mass;
        let principal = about.symmetric_eigen();
        let half = principal.eigenvalues.map(|moment| {
            (3.0 * (0.5 * about.trace() - moment).max(0.0) / mass).sqrt().max(0.25 * BAR * size)
        });
        let turn = Rotation3::from_matrix(&principal.eigenvectors);
        shape.hexahedron(&still, &still, &turn, &half);
        return shape;
    }
    for marker in far {
        let along = marker.position - center;
        let turn = Rotation3::rotation_between(&Vector3::x(), &along)
            .unwrap_or_else(|| Rotation3::from_axis_angle(&Vector3::z_axis(), std::f64::consts::PI));
        let across = 0.5 * BAR * size;
        shape.hexahedron(&still, marker, &turn, &Vector3::new(0.0, across, across));
        let cube = Vector3::repeat(0.5 * MARKER * size);
        shape.hexahedron(marker, marker, &Rotation3::identity(), &cube);
    }
    shape
}

impl Shape {
    /// Adds six faces around the line from one marker to another, `half` as far in each direction of `turn`; they move with the
    /// markers and turn with them, to first order.
    fn hexahedron(
        &mut self,
        from: &Marker<HostModal, f64>,
        to: &Marker<HostModal, f64>,
        turn: &Rotation3<f64>,
        half: &Vector3<f64>,
    ) {
        // faces have points of their own: edges stay sharp
        const FACES: [[[f64; 3]; 4]; 6] = [
            [[1., -1., -1.], [1., 1., -1.], [1., 1., 1.], [1., -1., 1.]],
            [[-1., -1., -1.], [-1., -1., 1.], [-1., 1., 1.], [-1., 1., -1.]],
            [[-1., 1., -1.], [-1., 1., 1.], [1., 1., 1.], [1., 1., -1.]],
            [[-1., -1., -1.], [1., -1., -1.], [1., -1., 1.], [-1., -1., 1.]],
            [[-1., -1., 1.], [1., -1., 1.], [1., 1., 1.], [-1., 1., 1.]],
            [[-1., -1., -1.], [-1., 1., -1.], [1., 1., -1.], [1., -1., -1.]],
        ];
        for face in FACES {
            let first = self.points.len() as u32;
            for corner in face {
                let offset = turn * Vector3::from(corner).component_mul(half);
                let marker = if corner[0] > 0.0 { to } else { from };
                self.points.push((marker.position + offset).into());
                for (mode, moved) in self.modes.iter_mut().enumerate() {
                    let part = |rows: &[HostModal; 3]| Vector3::from_fn(|axis, _| rows[axis].0[mode]);
                    let displacement = part(&marker.translation) + part(&marker.rotation).cross(&offset);
                    moved.push(displacement.into());
                }
            }
            self.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        }
    }
}
