//! Fresh against committed, and generated code against the nodes.

use std::error::Error;
use std::path::Path;

use ffrf::nalgebra::{SVector, Vector3};
use ffrf::{DenseForms, Observables};
use ffrf_fe::oracle::{Oracle, OracleState, group_of};
use ffrf_model::ReducedBody;

use crate::part::Part;
use crate::{Conrod, M, N};

/// Modes come from an iteration in floating point, so another machine may find them this much different.
const SAME_MODES: f64 = 1e-9;
/// The generated code and the nodes compute the same polynomial, each in its own order of rounding.
const SAME_KERNELS: f64 = 1e-12;

/// Compares the fresh reduction with the committed file, field by field.
pub fn with_committed(fresh: &ReducedBody, path: &Path) -> Result<(), Box<dyn Error>> {
    let committed = ReducedBody::read(path)?;
    if committed.mode_count() != fresh.mode_count() {
        return Err(format!("expected {} modes, found {}", fresh.mode_count(), committed.mode_count()).into());
    }
    let (new, old) = (&fresh.inertia, &committed.inertia);
    let flat3 = |rows: &[[f64; 3]]| rows.as_flattened().to_vec();
    let pairs = [
        ("mass", vec![new.mass], vec![old.mass]),
        ("second moment", flat3(&new.second_moment), flat3(&old.second_moment)),
        (
            "position-mode moments",
            new.position_mode_moment.as_flattened().as_flattened().to_vec(),
            old.position_mode_moment.as_flattened().as_flattened().to_vec(),
        ),
        (
            "mode-mode moments",
            new.mode_mode_moment.concat().as_flattened().as_flattened().to_vec(),
            old.mode_mode_moment.concat().as_flattened().as_flattened().to_vec(),
        ),
        ("modal stiffness", fresh.stiffness.concat(), committed.stiffness.concat()),
        (
            "mode shapes at the markers",
            fresh.markers.iter().flat_map(|marker| flat3(&marker.translation)).collect(),
            committed.markers.iter().flat_map(|marker| flat3(&marker.translation)).collect(),
        ),
    ];
    for (what, new, old) in pairs {
        check(&format!("{what}, fresh against committed"), deviation(&new, &old)?, SAME_MODES)?;
    }
    Ok(())
}

/// Compares the code that the macro generated with sums over the nodes, in one lively state.
pub fn with_nodes(part: &Part) -> Result<(), Box<dyn Error>> {
    // all modes at about 0.1 mm and 1 m/s, spin about all axes: nothing is zero by accident
    let q = SVector::<f64, M>::from_fn(|mu, _| 5e-5 / (1.0 + mu as f64));
    let q_dot = SVector::<f64, M>::from_fn(|mu, _| 0.5 - 0.1 * mu as f64);
    let (omega, velocity) = (Vector3::new(200.0, 300.0, -100.0), Vector3::new(1.0, -2.0, 3.0));
    let state = OracleState {
        q: q.as_slice().to_vec(),
        velocity: velocity.into(),
        omega: omega.into(),
        q_dot: q_dot.as_slice().to_vec(),
    };
    let nodes = Oracle::new(&part.model, &part.basis)?.evaluate(&state);

    // each entry is measured by the norms whose product bounds it, so that small blocks count as much as large ones
    let column = |i: usize| nodes.scales.column[group_of(i)];
    let mass = Conrod.mass_matrix(&q);
    let entry = |i: usize, j: usize| (mass[(i, j)] - nodes.mass_matrix[i][j]).abs() / (column(i) * column(j));
    let largest =
        (0..N).flat_map(|i| (0..N).map(move |j| (i, j))).map(|(i, j)| entry(i, j)).fold(0.0, f64::max);
    check("mass matrix, generated code against nodes", largest, SAME_KERNELS)?;

    let quadratic = Conrod.quadratic_velocity(&q, &omega, &q_dot);
    let entry =
        |i: usize| (quadratic[i] - nodes.quadratic_velocity[i]).abs() / (column(i) * nodes.scales.convective);
    check(
        "quadratic velocity vector, generated code against nodes",
        (0..N).map(entry).fold(0.0, f64::max),
        SAME_KERNELS,
    )?;

    let energy = Conrod.kinetic_energy(&q, &velocity, &omega, &q_dot);
    check(
        "kinetic energy, generated code against nodes",
        deviation(&[energy], &[nodes.kinetic_energy])?,
        SAME_KERNELS,
    )
}

/// Largest difference relative to the largest entry.
fn deviation(new: &[f64], old: &[f64]) -> Result<f64, Box<dyn Error>> {
    if new.len() != old.len() {
        return Err(format!("expected {} numbers, found {}", new.len(), old.len()).into());
    }
    let largest = old.iter().fold(0.0_f64, |max, x| max.max(x.abs()));
    let difference = new.iter().zip(old).fold(0.0_f64, |max, (a, b)| max.max((a - b).abs()));
    Ok(difference / largest)
}

fn check(what: &str, measured: f64, limit: f64) -> Result<(), Box<dyn Error>> {
    println!("  {what:<58} {measured:.1e}");
    // written so that NaN fails as well
    if measured <= limit {
        Ok(())
    } else {
        Err(format!("{what}: {measured:.1e}, expected at most {limit:.0e}").into())
    }
}
