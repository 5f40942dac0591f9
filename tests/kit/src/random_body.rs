//! Random unsymmetric bodies made from random nodes: consistent by construction, special in nothing.

use ffrf_model::{
    GeometricStiffness, Inertia, Marker, Matrix3, Mode, ModeKind, Provenance, ReducedBody, SCHEMA_VERSION,
    Vector3,
};

use crate::random::Random;

/// How the modes of a random body are made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Modes {
    /// Random displacements: Θ_ff is dense.
    Random,
    /// Random displacements, orthonormal in the mass: Θ_ff = I.
    Normalised,
    /// Orthonormal, and orthogonal to the six rigid-body modes about the centre of mass: a = 0, B = 0, Ξ = 0.
    FreeFree,
}

/// One displacement field: a vector per node.
type Field = Vec<Vector3>;

/// A body of point masses with `count` modes.
pub fn random_body(seed: u64, count: usize, modes: Modes) -> ReducedBody {
    let mut random = Random::new(seed);
    let nodes = 8 + 2 * count;
    let masses: Vec<f64> = (0..nodes).map(|_| 0.6 + 0.5 * random.number()).collect();
    let mut positions: Field = (0..nodes)
        .map(|_| [0.4 + random.number(), 0.5 * random.number() - 0.2, 0.3 * random.number() + 0.1])
        .collect();
    if modes == Modes::FreeFree {
        let total: f64 = masses.iter().sum();
        let centre = [0, 1, 2].map(|i| -> f64 {
            masses.iter().zip(&positions).map(|(mass, x)| mass * x[i]).sum::<f64>() / total
        });
        for x in &mut positions {
            *x = [0, 1, 2].map(|i| x[i] - centre[i]);
        }
    }
    let mut fields: Vec<Field> =
        (0..count).map(|_| (0..nodes).map(|_| [0, 1, 2].map(|_| 0.5 * random.number())).collect()).collect();
    if modes != Modes::Random {
        let rigid = if modes == Modes::FreeFree { rigid_modes(&positions) } else { Vec::new() };
        orthonormalise(&masses, rigid, &mut fields);
    }
    body(&masses, &positions, &fields, &mut random)
}

/// The body with a geometric stiffness of random numbers, see [`random_geometric_stiffness`].
pub fn stiffened(mut body: ReducedBody, seed: u64, size: f64) -> ReducedBody {
    body.geometric_stiffness = Some(random_geometric_stiffness(seed, body.mode_count(), size));
    body
}

/// Geometric stiffness of random numbers: that of no part, but symmetric in the modes as every one is.
///
/// `size` should be small beside the masses of the modes, for the mass matrix to stay positive definite.
pub fn random_geometric_stiffness(seed: u64, count: usize, size: f64) -> GeometricStiffness {
    let mut random = Random::new(seed);
    let mut geometric = GeometricStiffness {
        uniform_load: vec![vec![[0.0; 3]; count]; count],
        linear_load: vec![vec![[[0.0; 3]; 3]; count]; count],
        marker_loads: Vec::new(),
    };
    for mu in 0..count {
        for nu in mu..count {
            let uniform = [0, 1, 2].map(|_| size * random.number());
            let linear = [0, 1, 2].map(|_| [0, 1, 2].map(|_| size * random.number()));
            for (row, column) in [(mu, nu), (nu, mu)] {
                geometric.uniform_load[row][column] = uniform;
                geometric.linear_load[row][column] = linear;
            }
        }
    }
    geometric
}

fn body(masses: &[f64], positions: &Field, fields: &[Field], random: &mut Random) -> ReducedBody {
    let moment = |a: &Field, b: &Field| -> Matrix3 {
        [0, 1, 2].map(|i| {
            [0, 1, 2].map(|j| masses.iter().zip(a.iter().zip(b)).map(|(m, (a, b))| m * a[i] * b[j]).sum())
        })
    };
    let first =
        |a: &Field| -> Vector3 { [0, 1, 2].map(|i| masses.iter().zip(a).map(|(m, a)| m * a[i]).sum()) };
    let count = fields.len();
    // Stiffness: diagonal plus a random positive semidefinite part.
    let factors: Vec<Vec<f64>> = (0..count).map(|_| random.numbers(count)).collect();
    let stiffness: Vec<Vec<f64>> = (0..count)
        .map(|mu| {
            (0..count)
                .map(|nu| {
                    let product: f64 = (0..count).map(|k| factors[mu][k] * factors[nu][k]).sum();
                    product + if mu == nu { 40.0 + 30.0 * mu as f64 } else { 0.0 }
                })
                .collect()
        })
        .collect();
    let damping: Vec<Vec<f64>> = stiffness
        .iter()
        .enumerate()
        .map(|(mu, row)| {
            row.iter().enumerate().map(|(nu, k)| if mu == nu { 0.01 * k } else { 0.0 }).collect()
        })
        .collect();
    let marker = |name: &str, node: usize| Marker {
        name: name.to_owned(),
        coupling: None,
        nodes: vec![node as u64],
        position: positions[node],
        translation: fields.iter().map(|field| field[node]).collect(),
        rotation: fields.iter().map(|field| field[node].map(|x| 0.25 * x)).collect(),
    };
    ReducedBody {
        schema_version: SCHEMA_VERSION,
        title: format!("random body with {count} modes"),
        units: "m, kg, s, N".to_owned(),
        provenance: Provenance {
            tool: "ffrf".to_owned(),
            tool_version: "0.1.0".to_owned(),
            sources: Vec::new(),
            notes: Vec::new(),
        },
        modes: (0..count)
            .map(|mu| Mode { kind: ModeKind::User, frequency_hz: (mu > 0).then_some(12.5 * mu as f64) })
            .collect(),
        inertia: Inertia {
            mass: masses.iter().sum(),
            first_moment: first(positions),
            modal_first_moment: fields.iter().map(first).collect(),
            second_moment: moment(positions, positions),
            position_mode_moment: fields.iter().map(|field| moment(positions, field)).collect(),
            mode_mode_moment: fields.iter().map(|a| fields.iter().map(|b| moment(a, b)).collect()).collect(),
        },
        stiffness,
        damping,
        geometric_stiffness: None,
        second_order_terms: Default::default(),
        stress_markers: Vec::new(),
        section_markers: Vec::new(),
        markers: vec![marker("tip", 0), marker("root", 1)],
    }
}

fn rigid_modes(positions: &Field) -> Vec<Field> {
    let unit = |i: usize| [0, 1, 2].map(|j| if i == j { 1.0 } else { 0.0 });
    let translations = (0..3).map(|i| positions.iter().map(|_| unit(i)).collect());
    let rotations = (0..3).map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        positions
            .iter()
            .map(|x| {
                let mut u = [0.0; 3];
                u[k] = x[j];
                u[j] = -x[k];
                u
            })
            .collect()
    });
    translations.chain(rotations).collect()
}

/// Gram-Schmidt in the mass inner product, twice, against `others` and each other.
fn orthonormalise(masses: &[f64], others: Vec<Field>, fields: &mut [Field]) {
    let dot = |a: &Field, b: &Field| -> f64 {
        masses
            .iter()
            .zip(a.iter().zip(b))
            .map(|(m, (a, b))| m * (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]))
            .sum()
    };
    let mut basis: Vec<Field> = Vec::new();
    let mut make_orthonormal = |field: &Field| -> Field {
        let mut field = field.clone();
        for _ in 0..3 {
            for known in &basis {
                let factor = dot(known, &field);
                for (x, k) in field.iter_mut().zip(known) {
                    *x = [0, 1, 2].map(|i| x[i] - factor * k[i]);
                }
            }
            let length = dot(&field, &field).sqrt();
            field.iter_mut().for_each(|x| *x = x.map(|x| x / length));
        }
        basis.push(field.clone());
        field
    };
    for other in &others {
        make_orthonormal(other);
    }
    for field in fields {
        *field = make_orthonormal(field);
    }
}
