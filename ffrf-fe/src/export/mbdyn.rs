//! MBDyn: the data file (`.fem`) of the modal joint.
//!
//! Source: MBDyn input manual, chapter "Modal Element Data"; the record groups 14 to 18 of invariants and their definitions: MBDyn,
//! `mbdyn/struct/modal.cc`. With x the positions and φ the mode shapes, and ũ the matrix of the cross product with u:
//! I3 = ∫ρ φ_μ, I4 = ∫ρ x × φ_μ, I5 = ∫ρ φ_μ × φ_ν, I8 = -∫ρ x̃ φ̃_μ, I9 = ∫ρ φ̃_μ φ̃_ν.

use std::fmt::Write as _;

use ffrf_model::{Inertia, Matrix3, ReducedBody, Vector3};

/// The file of a body: its markers are the nodes, under their names; its invariants are written as they are.
///
/// The damping of the body is record group 13. Geometric stiffness and stress markers have no place in the format.
pub fn mbdyn_text(body: &ReducedBody) -> String {
    let mut text = String::from("** MBDyn MODAL DATA FILE\n");
    let modes = body.mode_count();
    record(&mut text, 1, "HEADER");
    text += "**   REVISION,  NODE,  NORMAL, ATTACHMENT, CONSTRAINT, REJECTED MODES.\n";
    let _ = writeln!(text, "     REV0  {}  {modes}  0  0  0", body.markers.len());
    record(&mut text, 2, "FINITE ELEMENT NODE LIST");
    for marker in &body.markers {
        let _ = writeln!(text, "{}", marker.name);
    }
    for (group, name) in [(3, "INITIAL MODAL DISPLACEMENTS"), (4, "INITIAL MODAL VELOCITIES")] {
        record(&mut text, group, name);
        line(&mut text, &vec![0.0; modes]);
    }
    for (k, group) in (5..8).enumerate() {
        record(&mut text, group, &format!("NODAL {} COORDINATES", ["X", "Y", "Z"][k]));
        for marker in &body.markers {
            line(&mut text, &[marker.position[k]]);
        }
    }
    record(&mut text, 8, "MODE SHAPES");
    for mode in 0..modes {
        let _ = writeln!(text, "**    NORMAL MODE SHAPE #  {}", mode + 1);
        for marker in &body.markers {
            line(&mut text, &[marker.translation[mode], marker.rotation[mode]].concat());
        }
    }
    let inertia = &body.inertia;
    let mass: Vec<Vec<f64>> =
        inertia.mode_mode_moment.iter().map(|row| row.iter().map(trace).collect()).collect();
    for (group, name, matrix) in
        [(9, "MODAL MASS MATRIX", &mass), (10, "MODAL STIFFNESS MATRIX", &body.stiffness)]
    {
        record(&mut text, group, name);
        matrix.iter().for_each(|row| line(&mut text, row));
    }
    record(&mut text, 12, "GLOBAL INERTIA PROPERTIES");
    line(&mut text, &[inertia.mass]);
    let centre = inertia.first_moment.map(|moment| moment / inertia.mass);
    line(&mut text, &centre);
    inertia_about(inertia, centre).iter().for_each(|row| line(&mut text, row));
    record(&mut text, 13, "MODAL DAMPING MATRIX");
    body.damping.iter().for_each(|row| line(&mut text, row));
    invariants(&mut text, inertia);
    text
}

/// Record groups 14 to 18, three rows each.
fn invariants(text: &mut String, inertia: &Inertia) {
    let Inertia { modal_first_moment, position_mode_moment, mode_mode_moment, .. } = inertia;
    let rows = |text: &mut String, columns: &[Vector3]| {
        for i in 0..3 {
            line(text, &columns.iter().map(|column| column[i]).collect::<Vec<_>>());
        }
    };
    record(text, 14, "INVARIANT 3");
    rows(text, modal_first_moment);
    record(text, 15, "INVARIANT 4");
    rows(text, &position_mode_moment.iter().map(axial).collect::<Vec<_>>());
    record(text, 16, "INVARIANT 8");
    let columns = |moments: &[Matrix3], sign: f64| -> Vec<Vector3> {
        moments.iter().flat_map(|moment| crossed(moment, sign)).collect()
    };
    rows(text, &columns(position_mode_moment, 1.0));
    record(text, 17, "INVARIANT 5");
    rows(text, &mode_mode_moment.iter().flatten().map(axial).collect::<Vec<_>>());
    record(text, 18, "INVARIANT 9");
    rows(text, &mode_mode_moment.iter().flat_map(|row| columns(row, -1.0)).collect::<Vec<_>>());
}

fn record(text: &mut String, group: usize, name: &str) {
    let _ = writeln!(text, "**\n** RECORD GROUP {group}, {name}");
}

fn line(text: &mut String, numbers: &[f64]) {
    let numbers: Vec<String> = numbers.iter().map(|number| format!("{number:e}")).collect();
    let _ = writeln!(text, "{}", numbers.join(" "));
}

fn trace(moment: &Matrix3) -> f64 {
    moment[0][0] + moment[1][1] + moment[2][2]
}

/// ∫ρ a × b of T = ∫ρ a bᵀ.
fn axial(moment: &Matrix3) -> Vector3 {
    [moment[1][2] - moment[2][1], moment[2][0] - moment[0][2], moment[0][1] - moment[1][0]]
}

/// Columns of ±(tr T 1 - Tᵀ) of T = ∫ρ a bᵀ: of -∫ρ ã b̃ for 1, of ∫ρ ã b̃ for -1.
fn crossed(moment: &Matrix3, sign: f64) -> [Vector3; 3] {
    let trace = trace(moment);
    std::array::from_fn(|column| {
        std::array::from_fn(|row| {
            let diagonal = if row == column { trace } else { 0.0 };
            sign * (diagonal - moment[column][row])
        })
    })
}

/// T = ∫ρ a bᵀ of ±(tr T 1 - Tᵀ), its columns given.
pub(crate) fn uncrossed(columns: &[Vector3; 3], sign: f64) -> Matrix3 {
    let half: f64 = (0..3).map(|k| columns[k][k]).sum::<f64>() * sign / 2.0;
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            let diagonal = if row == column { half } else { 0.0 };
            diagonal - sign * columns[row][column]
        })
    })
}

/// Inertia tensor about a point, from the second moment about the origin.
fn inertia_about(inertia: &Inertia, centre: Vector3) -> Matrix3 {
    let moment: Matrix3 = std::array::from_fn(|i| {
        std::array::from_fn(|j| inertia.second_moment[i][j] - inertia.mass * centre[i] * centre[j])
    });
    let trace = trace(&moment);
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { trace } else { 0.0 } - moment[i][j]))
}
