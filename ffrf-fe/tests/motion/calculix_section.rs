//! Section forces against those that CalculiX integrates from its own stresses (`*SECTION PRINT`, SOF and SOM): a bar at rest under the
//! load at its tip, and its vibrations, in which inertia adds to the force from section to section.
//!
//! CalculiX solves with elements of reduced integration (C3D20R), whose stresses hold at the faces; ours integrate fully.

use std::fmt::Write as _;

use ffrf_fe::elements::quadratic_brick;
use ffrf_fe::modes::{ModeRequest, compute_modes};
use ffrf_fe::section::{SectionRequest, section_marker};
use ffrf_fe::{FeModel, ModeBasis};
use ffrf_model::Vector3;
use ffrf_test_kit::calculix;

use crate::section::{STEEL, at_rest};

const EDGES: [f64; 3] = [0.5, 0.05, 0.03];
const DIVISIONS: [usize; 3] = [40, 2, 2];
/// A section between elements.
const CUT: Vector3 = [0.25, 0.025, 0.015];
const LOAD: Vector3 = [3000.0, -200.0, 500.0];
const MODES: usize = 4;

/// At rest CalculiX's stresses are off by 4e-5 of the force: extrapolated beside a clamp that holds the bar from thinning.
const AT_REST: f64 = 1e-4;
/// Forces of the modes, of the largest of the mode: two kinds of elements, of which a half wave of the highest mode has six, differ by
/// 0.1 to 0.8 % in eigenvalues, and forces go with them.
const VIBRATING: f64 = 1e-2;

/// Force and moment about the middle of the section: at rest, and of each mode.
fn of_calculix(model: &FeModel) -> Option<Vec<[f64; 6]>> {
    let folder = tempfile::tempdir().expect("a folder");
    let text = calculix::results(folder.path(), &deck(model))?;
    let after = |head: &str| -> Vec<Vec<f64>> {
        let lines: Vec<&str> = text.lines().collect();
        let heads = (0..lines.len()).filter(|&line| lines[line].contains(head));
        let numbers =
            |line: &str| line.split_whitespace().map(|field| field.parse().expect("a number")).collect();
        heads.map(|line| numbers(lines[line + 2])).collect()
    };
    let (forces, moments) = (after("total surface force"), after("moment about the center of gravity"));
    assert_eq!((forces.len(), moments.len()), (1 + MODES, 1 + MODES), "{text}");
    let pairs = forces.iter().zip(&moments);
    Some(pairs.map(|(f, m)| [f[0], f[1], f[2], m[0], m[1], m[2]]).collect())
}

fn deck(model: &FeModel) -> String {
    let mut text = String::from("*NODE\n");
    for (row, [x, y, z]) in model.nodes.positions.iter().enumerate() {
        writeln!(text, "{}, {x:.12e}, {y:.12e}, {z:.12e}", row + 1).expect("text");
    }
    text.push_str("*ELEMENT, TYPE=C3D20R, ELSET=BAR\n");
    let mut faces = String::new();
    for (number, element) in model.elements.iter().enumerate() {
        let mut fields = vec![(number + 1).to_string()];
        fields.extend(element.nodes.iter().map(|node| (node + 1).to_string()));
        writeln!(text, "{},\n{}", fields[..11].join(", "), fields[11..].join(", ")).expect("text");
        // The elements before the cut, with their face of nodes 4, 1, 5, 8.
        if [3, 0, 4, 7].iter().all(|&k| model.nodes.positions[element.nodes[k]][0] == CUT[0]) {
            writeln!(faces, "{}, S6", number + 1).expect("text");
        }
    }
    for (name, x) in [("ROOT", 0.0), ("TIP", EDGES[0])] {
        writeln!(text, "*NSET, NSET={name}").expect("text");
        for row in rows_at(model, x) {
            writeln!(text, "{},", row + 1).expect("text");
        }
    }
    let share = LOAD.map(|force| force / rows_at(model, EDGES[0]).len() as f64);
    let print = "*SECTION PRINT, SURFACE=CUT, NAME=CUT\nSOF, SOM\n*END STEP\n";
    write!(
        text,
        "*SURFACE, NAME=CUT\n{faces}*MATERIAL, NAME=STEEL\n*ELASTIC\n{:e}, {}\n*DENSITY\n{:e}\n\
         *SOLID SECTION, ELSET=BAR, MATERIAL=STEEL\n*BOUNDARY\nROOT, 1, 3\n\
         *STEP\n*STATIC\n*CLOAD\nTIP, 1, {:e}\nTIP, 2, {:e}\nTIP, 3, {:e}\n{print}\
         *STEP\n*FREQUENCY\n{MODES}\n{print}",
        STEEL.youngs_modulus, STEEL.poisson_ratio, STEEL.density, share[0], share[1], share[2]
    )
    .expect("text");
    text
}

fn rows_at(model: &FeModel, x: f64) -> Vec<usize> {
    (0..model.nodes.len()).filter(|&row| model.nodes.positions[row][0] == x).collect()
}

fn of_ours(model: &FeModel, basis: &ModeBasis) -> Vec<[f64; 6]> {
    let request = SectionRequest { name: "cut".to_owned(), point: CUT, normal: [1.0, 0.0, 0.0] };
    section_marker(model, basis, &request).expect("a cut").force
}

#[test]
fn section_forces_are_those_of_calculix_at_rest_and_in_vibration() {
    let model = quadratic_brick(EDGES, DIVISIONS, &STEEL).expect("a sound mesh");
    let Some(expected) = of_calculix(&model) else { return };
    let tip = rows_at(&model, EDGES[0]);
    let mut force = vec![0.0; 3 * model.nodes.len()];
    for &row in &tip {
        for k in 0..3 {
            force[3 * row + k] = LOAD[k] / tip.len() as f64;
        }
    }
    let at_rest = of_ours(&model, &at_rest(&model, &force));
    let request = ModeRequest::clamped(MODES, rows_at(&model, 0.0));
    let modes = compute_modes(&model, &request, &mut |_| {}).expect("modes");
    let vibrating = of_ours(&model, &modes.basis);
    for (case, found) in at_rest.iter().chain(&vibrating).enumerate() {
        // The surface is that of the elements before the cut, whose normal points to the rest; modes have any sign.
        let expected = expected[case].map(|value| -value);
        let products = found.iter().zip(&expected).map(|(a, b)| a * b);
        let sign = if case > 0 && products.sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
        let largest =
            |of: std::ops::Range<usize>| expected[of].iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let (force, moment) = (largest(0..3), largest(3..6));
        assert!(force > 0.0 && moment > 0.0);
        let off = (0..6).map(|k| (sign * found[k] - expected[k]).abs() / if k < 3 { force } else { moment });
        let off: Vec<f64> = off.collect();
        let worst = off.iter().fold(0.0_f64, |most, off| most.max(*off));
        println!("case {case}: CalculiX has {expected:?} N and N m, off by {worst:.1e} of the largest");
        let within = if case == 0 { AT_REST } else { VIBRATING };
        assert!(off.iter().all(|&off| off < within), "case {case}: {found:?}, CalculiX {expected:?}");
    }
}
