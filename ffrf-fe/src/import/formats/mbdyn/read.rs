//! MBDyn: the data file (`.fem`) of the modal joint, to a reduced body.
//!
//! Source: as for [`crate::export::mbdyn`]. Inertia invariants are those of the record groups 14 to 18, or else follow from the
//! lumped masses of group 11.

use std::path::Path;

use ffrf_model::{
    Inertia, Marker, Matrix3, Mode, ModeKind, ReducedBody, Units, Vector3, is_valid_marker_name,
};

use super::records::Records;
use crate::export::mbdyn::uncrossed;
use crate::import::formats::body::{Parts, body};
use crate::import::text::source::Source;
use crate::import::{INFLATED_LIMIT, ImportError};

/// Nodes times modes that a body may hold: every node becomes a marker.
const MOST_MARKER_ROWS: usize = 10_000_000;

/// Reads a body. Its markers are the nodes of the file, its modes those of a user.
///
/// Errors: a file that does not follow the format, lacks what the inertia invariants need, or has lumped masses that differ in x,
/// y and z or rotational inertias, and a body that [`ReducedBody::check`] finds inconsistent.
pub fn read_mbdyn(path: &Path, units: Option<Units>) -> Result<ReducedBody, ImportError> {
    let source = Source::read(path, INFLATED_LIMIT)?;
    let records = Records::read(&source)?;
    let (nodes, modes) = (records.nodes, records.modes);
    if nodes.saturating_mul(modes) > MOST_MARKER_ROWS {
        return Err(ImportError::TooMany {
            path: path.to_path_buf(),
            line: 1,
            what: "nodes times modes",
            limit: MOST_MARKER_ROWS as u64,
            found: nodes.saturating_mul(modes) as u64,
        });
    }
    let coordinates = [records.numbers(5, nodes)?, records.numbers(6, nodes)?, records.numbers(7, nodes)?];
    let positions: Vec<Vector3> = (0..nodes).map(|n| [0, 1, 2].map(|k| coordinates[k][n])).collect();
    let shapes = records.numbers(8, 6 * nodes * modes)?;
    // translation and rotation of a node in a mode
    let shape = |node: usize, mode: usize| {
        let at = 6 * (mode * nodes + node);
        let six = &shapes[at..at + 6];
        ([six[0], six[1], six[2]], [six[3], six[4], six[5]])
    };
    let square = |group: usize| -> Result<Vec<Vec<f64>>, ImportError> {
        let numbers = records.numbers(group, modes * modes)?;
        Ok(numbers.chunks(modes.max(1)).map(<[f64]>::to_vec).collect())
    };
    let (modal_mass, stiffness) = (square(9)?, square(10)?);
    let damping = if records.has(13) { square(13)? } else { vec![vec![0.0; modes]; modes] };
    let mut notes = Vec::new();
    let mut inertia = if records.has(18) {
        of_invariants(&records, modes)?
    } else if records.has(11) {
        notes.push("inertia invariants follow from the lumped masses of record group 11".to_owned());
        of_masses(&records, &positions, modes, |node, mode| shape(node, mode).0)?
    } else {
        return Err(records.missing("11 (lumped masses) or 14 to 18 (invariants)"));
    };
    if records.has(12) {
        rigid(&records, &mut inertia)?;
    } else if records.has(18) {
        return Err(records.missing("12 (global inertia properties)"));
    }
    let largest = modal_mass.iter().flatten().fold(0.0_f64, |most, entry| most.max(entry.abs()));
    let difference =
        (0..modes).flat_map(|i| (0..modes).map(move |j| (i, j))).fold(0.0_f64, |most, (i, j)| {
            let moment = &inertia.mode_mode_moment[i][j];
            most.max((modal_mass[i][j] - moment[0][0] - moment[1][1] - moment[2][2]).abs())
        });
    notes.push(format!(
        "the modal mass of record group 9 differs from that of the invariants by {:.1e} of its largest entry",
        if largest > 0.0 { difference / largest } else { difference }
    ));
    let markers = (0..nodes).map(|node| {
        let (translation, rotation) = (0..modes).map(|mode| shape(node, mode)).unzip();
        let label = records.labels[node];
        let name = if is_valid_marker_name(label) { label.to_owned() } else { format!("N{label}") };
        if !is_valid_marker_name(&name) {
            let expected = "labels of letters, digits and underscores, which become names of markers";
            return Err(source.expected(records.place(2), expected));
        }
        let nodes = vec![label.parse().unwrap_or(node as u64 + 1)];
        Ok(Marker { name, nodes, position: positions[node], translation, rotation, coupling: None })
    });
    let markers = markers.collect::<Result<_, _>>()?;
    let parts = Parts {
        modes: vec![Mode { kind: ModeKind::User, frequency_hz: None }; modes],
        inertia,
        stiffness,
        damping,
        geometric_stiffness: None,
        second_order_terms: Default::default(),
        markers,
        notes,
    };
    body(path, units, source.finish("MBDyn modal data"), parts)
}

/// Mass, first and second moment of record group 12.
fn rigid(records: &Records<'_>, inertia: &mut Inertia) -> Result<(), ImportError> {
    let numbers = records.numbers(12, 13)?;
    let (mass, centre) = (numbers[0], [numbers[1], numbers[2], numbers[3]]);
    let about: Matrix3 = std::array::from_fn(|i| std::array::from_fn(|j| numbers[4 + 3 * i + j]));
    let half = 0.5 * (about[0][0] + about[1][1] + about[2][2]);
    inertia.mass = mass;
    inertia.first_moment = centre.map(|c| mass * c);
    inertia.second_moment = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let diagonal = if i == j { half } else { 0.0 };
            diagonal - 0.5 * (about[i][j] + about[j][i]) + mass * centre[i] * centre[j]
        })
    });
    Ok(())
}

/// The invariants of the modes; those of the rigid body are left at zero.
fn of_invariants(records: &Records<'_>, modes: usize) -> Result<Inertia, ImportError> {
    let columns = |group: usize, count: usize| -> Result<Vec<Vector3>, ImportError> {
        let numbers = records.numbers(group, 3 * count)?;
        Ok((0..count).map(|column| [0, 1, 2].map(|row| numbers[row * count + column])).collect())
    };
    let moments = |columns: &[Vector3], sign: f64| -> Vec<Matrix3> {
        let (threes, _) = columns.as_chunks::<3>();
        threes.iter().map(|three| uncrossed(three, sign)).collect()
    };
    let of_pairs = moments(&columns(18, 3 * modes * modes)?, -1.0);
    Ok(Inertia {
        mass: 0.0,
        first_moment: [0.0; 3],
        modal_first_moment: columns(14, modes)?,
        second_moment: [[0.0; 3]; 3],
        position_mode_moment: moments(&columns(16, 3 * modes)?, 1.0),
        mode_mode_moment: of_pairs.chunks(modes.max(1)).map(<[Matrix3]>::to_vec).collect(),
    })
}

/// Invariants of point masses.
fn of_masses(
    records: &Records<'_>,
    positions: &[Vector3],
    modes: usize,
    shape: impl Fn(usize, usize) -> Vector3,
) -> Result<Inertia, ImportError> {
    let numbers = records.numbers(11, 6 * positions.len())?;
    let (lumped, _) = numbers.as_chunks::<6>();
    let mut inertia = Inertia {
        mass: 0.0,
        first_moment: [0.0; 3],
        modal_first_moment: vec![[0.0; 3]; modes],
        second_moment: [[0.0; 3]; 3],
        position_mode_moment: vec![[[0.0; 3]; 3]; modes],
        mode_mode_moment: vec![vec![[[0.0; 3]; 3]; modes]; modes],
    };
    let add = |moment: &mut Matrix3, mass: f64, a: Vector3, b: Vector3| {
        for (row, a) in moment.iter_mut().zip(a) {
            for (entry, b) in row.iter_mut().zip(b) {
                *entry += mass * a * b;
            }
        }
    };
    for (node, (&x, six)) in positions.iter().zip(lumped).enumerate() {
        let mass = six[0];
        if six[1] != mass || six[2] != mass || six[3..] != [0.0; 3] {
            let label = records.labels[node];
            return Err(records.fault(
                11,
                format!(
                    "the same mass in x, y and z and no rotational inertia at node {label}, found {six:?}"
                ),
            ));
        }
        inertia.mass += mass;
        for k in 0..3 {
            inertia.first_moment[k] += mass * x[k];
        }
        add(&mut inertia.second_moment, mass, x, x);
        for mu in 0..modes {
            let phi = shape(node, mu);
            for k in 0..3 {
                inertia.modal_first_moment[mu][k] += mass * phi[k];
            }
            add(&mut inertia.position_mode_moment[mu], mass, x, phi);
            for nu in 0..modes {
                add(&mut inertia.mode_mode_moment[mu][nu], mass, phi, shape(node, nu));
            }
        }
    }
    Ok(inertia)
}
