//! Small vibrations of a reduced body that nothing holds, from its file alone.

use faer::Mat;
use faer::linalg::solvers::Solve;
use ffrf_model::{Inertia, ReducedBody};

/// Mass matrix at rest of frame velocity, angular velocity and modal rates. Shape: 6 + M square.
pub fn mass_matrix(inertia: &Inertia) -> Mat<f64> {
    let count = inertia.mode_count();
    let (tensor, modal) = (inertia.inertia_tensor(), inertia.modal_mass());
    let first = inertia.first_moment;
    let mut matrix = Mat::zeros(6 + count, 6 + count);
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        matrix[(i, i)] = inertia.mass;
        matrix[(i, 3 + j)] = first[k];
        matrix[(i, 3 + k)] = -first[j];
        for l in 0..3 {
            matrix[(3 + i, 3 + l)] = tensor[i][l];
        }
        for mu in 0..count {
            matrix[(i, 6 + mu)] = inertia.modal_first_moment[mu][i];
            matrix[(3 + i, 6 + mu)] = inertia.rotation_coupling(mu)[i];
        }
    }
    for mu in 0..count {
        for nu in 0..count {
            matrix[(6 + mu, 6 + nu)] = modal[mu][nu];
        }
    }
    Mat::from_fn(6 + count, 6 + count, |i, j| if i <= j { matrix[(i, j)] } else { matrix[(j, i)] })
}

/// Modal stiffness with six empty rows and columns in front.
pub fn stiffness_matrix(body: &ReducedBody) -> Mat<f64> {
    let size = 6 + body.mode_count();
    Mat::from_fn(size, size, |i, j| if i < 6 || j < 6 { 0.0 } else { body.stiffness[i - 6][j - 6] })
}

/// Motion of the first `count` markers: translations, then rotations of each.
pub fn marker_rows(body: &ReducedBody, count: usize) -> Mat<f64> {
    let mut rows = Mat::zeros(6 * count, 6 + body.mode_count());
    for (number, marker) in body.markers.iter().take(count).enumerate() {
        let p = marker.position;
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            rows[(6 * number + i, i)] = 1.0;
            rows[(6 * number + 3 + i, 3 + i)] = 1.0;
            // ω × p
            rows[(6 * number + i, 3 + j)] = p[k];
            rows[(6 * number + i, 3 + k)] = -p[j];
            for mu in 0..body.mode_count() {
                rows[(6 * number + i, 6 + mu)] = marker.translation[mu][i];
                rows[(6 * number + 3 + i, 6 + mu)] = marker.rotation[mu][i];
            }
        }
    }
    rows
}

/// Receptance of the first `count` markers, rigid motion included.
pub fn receptance(body: &ReducedBody, count: usize, hertz: f64) -> Mat<f64> {
    let value = (std::f64::consts::TAU * hertz).powi(2);
    let (mass, stiffness) = (mass_matrix(&body.inertia), stiffness_matrix(body));
    let dynamic = Mat::from_fn(mass.nrows(), mass.ncols(), |i, j| stiffness[(i, j)] - value * mass[(i, j)]);
    let rows = marker_rows(body, count);
    &rows * dynamic.full_piv_lu().solve(rows.transpose())
}
