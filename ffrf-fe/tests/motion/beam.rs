//! The beam under test: a soft solid brick, large enough in deformation to see nonlinear terms.

use faer::Mat;
use ffrf_fe::FeModel;
use ffrf_fe::elements::{Material, brick};
use ffrf_fe::formulations::corotated::CorotatedModel;
use ffrf_fe::formulations::rotation::rotation_matrix;

pub const SOFT: Material = Material { youngs_modulus: 1e6, poisson_ratio: 0.3, density: 1000.0 };

/// 1 m long, 0.1 m by 0.12 m, without symmetry about a node.
pub fn beam(divisions: [usize; 3]) -> FeModel {
    brick([1.0, 0.1, 0.12], divisions, &SOFT).expect("a sound mesh")
}

/// A reproducible smooth displacement: bending, torsion and stretch of the given size.
pub fn deformation(model: &FeModel, size: f64) -> Mat<f64> {
    let positions = &model.nodes.positions;
    Mat::from_fn(3 * positions.len(), 1, |row, _| {
        let [x, y, z] = positions[row / 3];
        let bent = [-2.0 * x * y + 0.3 * x, x * x - 0.5 * x * z, 0.4 * x * x + 0.5 * x * y];
        size * bent[row % 3]
    })
}

/// The deformed beam, turned and moved.
pub fn placed(body: &CorotatedModel, deformation: &Mat<f64>) -> Mat<f64> {
    // A unit quaternion: 0.25 + 0.01 + 0.49 + 0.25 = 1.
    let rotation = rotation_matrix([0.5, 0.1, -0.7, 0.5]);
    body.from_body_frame((&body.reference + deformation).as_ref(), rotation.as_ref())
        + body.translations() * Mat::from_fn(3, 1, |i, _| 0.3 - 0.2 * i as f64)
}
