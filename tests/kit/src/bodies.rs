//! Bodies for tests: clouds of point masses, so that all invariants are physical by construction.

use ffrf_runtime::Marker;
use ffrf_runtime::nalgebra::{SVector, Vector3};

use crate::naive_body::{Invariants, NaiveBody};
use crate::random::Random;

/// A cloud of eight point masses with `M` modes, without any symmetry, from a seeded sequence.
///
/// The modes are not orthogonal and not free of rigid motion; K_ff is diagonal, `stiffness` times 1, 2, ...
/// Masses of about 1 kg within about 1 m, the same for each `M`. The points are also given as markers.
pub fn cloud<const M: usize, const N: usize>(
    seed: u64,
    stiffness: f64,
    damping: f64,
) -> (NaiveBody<M, N>, [Marker<SVector<f64, M>>; 8]) {
    let mut random = Random::new(seed);
    let masses: [f64; 8] = core::array::from_fn(|_| 1.0 + 0.5 * random.number());
    let mut markers = [Marker::rigid(Vector3::zeros(), &SVector::zeros()); 8];
    for marker in &mut markers {
        marker.position = Vector3::from_fn(|_, _| 0.3 + random.number());
    }
    for marker in &mut markers {
        // drawn mode by mode, kept axis by axis
        for rows in [&mut marker.translation, &mut marker.rotation] {
            for mu in 0..M {
                for row in rows.iter_mut() {
                    row[mu] = 0.5 * random.number();
                }
            }
        }
    }
    (NaiveBody::new(&point_mass_invariants(&masses, &markers, stiffness, damping)), markers)
}

/// The masses of the points of [`cloud`].
pub fn cloud_masses(seed: u64) -> [f64; 8] {
    let mut random = Random::new(seed);
    core::array::from_fn(|_| 1.0 + 0.5 * random.number())
}

/// ∫ρ becomes a sum over points with these masses.
fn point_mass_invariants<const M: usize>(
    masses: &[f64; 8],
    points: &[Marker<SVector<f64, M>>; 8],
    stiffness: f64,
    damping: f64,
) -> Invariants<M> {
    let total: f64 = masses.iter().sum();
    let sum = |field: &dyn Fn(&Marker<SVector<f64, M>>) -> f64| -> f64 {
        masses.iter().zip(points).map(|(mass, point)| mass * field(point)).sum()
    };
    let diagonal = |scale: f64| {
        core::array::from_fn(|mu| {
            core::array::from_fn(|nu| if mu == nu { scale * (mu + 1) as f64 } else { 0.0 })
        })
    };
    Invariants {
        mass: total,
        centre_of_mass: core::array::from_fn(|i| sum(&|p| p.position[i]) / total),
        modal_centre_of_mass: core::array::from_fn(|mu| {
            core::array::from_fn(|i| sum(&|p| p.translation[i][mu]) / total)
        }),
        euler_tensor: tensor(|i, j| sum(&|p| p.position[i] * p.position[j])),
        modal_euler_tensor: core::array::from_fn(|mu| {
            tensor(|i, j| sum(&|p| p.position[i] * p.translation[j][mu]))
        }),
        modal_pair_euler_tensor: core::array::from_fn(|mu| {
            core::array::from_fn(|nu| tensor(|i, j| sum(&|p| p.translation[i][mu] * p.translation[j][nu])))
        }),
        stiffness: diagonal(stiffness),
        damping: diagonal(damping),
    }
}

/// A rigid body with its frame in the centre of mass and these principal moments of inertia.
pub fn rigid(mass: f64, principal: Vector3<f64>) -> NaiveBody<0, 6> {
    rigid_about(mass, Vector3::zeros(), principal)
}

/// A rigid body with these principal moments of inertia about its centre of mass, which lies at `centre`.
pub fn rigid_about(mass: f64, centre: Vector3<f64>, principal: Vector3<f64>) -> NaiveBody<0, 6> {
    // Θ = tr(T) I - T, so T = ½ tr(Θ) I - Θ; and Steiner's theorem for T
    let half_trace = 0.5 * principal.sum();
    NaiveBody::new(&Invariants {
        mass,
        centre_of_mass: centre.into(),
        modal_centre_of_mass: [],
        euler_tensor: tensor(|i, j| {
            mass * centre[i] * centre[j] + if i == j { half_trace - principal[i] } else { 0.0 }
        }),
        modal_euler_tensor: [],
        modal_pair_euler_tensor: [],
        stiffness: [],
        damping: [],
    })
}

fn tensor(entry: impl Fn(usize, usize) -> f64) -> [[f64; 3]; 3] {
    core::array::from_fn(|i| core::array::from_fn(|j| entry(i, j)))
}
