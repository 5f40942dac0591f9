//! Random bodies made slender and turned, as Gram matrices: T = ∫ρ x xᵀ becomes A T Aᵀ when x becomes A x.

use ffrf::nalgebra::{Matrix3, Rotation3, Vector3};
use ffrf_model::ReducedBody;

use ffrf_test_kit::random_body::{Modes, random_body};

/// A body with its long axis along x, thinner by the factor `thickness` in y and z, then turned with its modes.
pub fn slender_body(seed: u64, modes: usize, thickness: f64, turn: &Rotation3<f64>) -> ReducedBody {
    let mut body = random_body(seed, modes, Modes::Normalised);
    let positions = turn * Matrix3::from_diagonal(&Vector3::new(1.0, thickness, thickness));
    let fields = *turn.matrix();
    let inertia = &mut body.inertia;
    inertia.first_moment = (positions * Vector3::from(inertia.first_moment)).into();
    inertia.second_moment = symmetric(changed(&inertia.second_moment, &positions, &positions));
    for mu in 0..modes {
        inertia.modal_first_moment[mu] = (fields * Vector3::from(inertia.modal_first_moment[mu])).into();
        inertia.position_mode_moment[mu] = changed(&inertia.position_mode_moment[mu], &positions, &fields);
        for nu in 0..mu {
            let moment = changed(&inertia.mode_mode_moment[mu][nu], &fields, &fields);
            inertia.mode_mode_moment[mu][nu] = moment;
            inertia.mode_mode_moment[nu][mu] = [0, 1, 2].map(|i| [0, 1, 2].map(|j| moment[j][i]));
        }
        let own = &mut inertia.mode_mode_moment[mu][mu];
        *own = symmetric(changed(own, &fields, &fields));
    }
    body
}

/// A moment Bᵀ
fn changed(moment: &[[f64; 3]; 3], left: &Matrix3<f64>, right: &Matrix3<f64>) -> [[f64; 3]; 3] {
    let product = left * Matrix3::from_fn(|i, j| moment[i][j]) * right.transpose();
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| product[(i, j)]))
}

/// Without the rounding that tells the triangles apart.
fn symmetric(moment: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    [0, 1, 2].map(|i: usize| [0, 1, 2].map(|j: usize| moment[i.min(j)][i.max(j)]))
}
