//! MBDyn's modal data: lumped masses and invariants of the same points against each other, and defects.

use std::fmt::Write as _;

use ffrf_model::{ReducedBody, Vector3};

use super::*;
use crate::export::mbdyn::mbdyn_text;
use crate::import::read_mbdyn;

/// Sums of a few products of order one.
const ROUND_OFF: f64 = 1e-14;

const MASSES: [f64; 4] = [1.0, 2.0, 0.5, 1.5];
const POSITIONS: [Vector3; 4] = [[0.1, 0.2, -0.3], [1.0, 0.0, 0.1], [0.0, 2.0, 0.3], [0.2, 0.1, 1.5]];
pub(super) const SHAPES: [[Vector3; 4]; 2] = [
    [[0.1, 0.0, 0.2], [-0.3, 0.1, 0.0], [0.0, 0.4, -0.1], [0.2, 0.0, 0.1]],
    [[0.0, -0.2, 0.1], [0.1, 0.0, 0.3], [0.5, 0.1, 0.0], [-0.1, 0.2, 0.0]],
];

/// Point masses as a hand would write them, without invariants.
pub(super) fn lumped() -> String {
    let mut text = "** hand-made\n** RECORD GROUP 1, HEADER\n**\n REV0 4 2 0 0 0\n".to_owned();
    text += "** RECORD GROUP 2, NODES\n1001 TIP\n1003 4\n** RECORD GROUP 3\n0 0\n** RECORD GROUP 4\n0 0\n";
    for k in 0..3 {
        let _ = writeln!(
            text,
            "** RECORD GROUP {}, COORDINATES\n{}",
            k + 5,
            POSITIONS.map(|x| x[k].to_string()).join(" ")
        );
    }
    text += "** RECORD GROUP 8, MODE SHAPES\n";
    for shapes in SHAPES {
        text += "**    NORMAL MODE SHAPE\n";
        for [x, y, z] in shapes {
            let _ = writeln!(text, "{x} {y} {z} 0 0 0.25");
        }
    }
    text += "** RECORD GROUP 9, MASS\n";
    for a in SHAPES {
        let row = SHAPES.map(|b| (0..4).map(|n| MASSES[n] * dot(a[n], b[n])).sum::<f64>().to_string());
        let _ = writeln!(text, "{}", row.join(" "));
    }
    text += "** RECORD GROUP 10, STIFFNESS\n100 0\n0 1.0D+2\n** RECORD GROUP 11, LUMPED MASS\n";
    for mass in MASSES {
        let _ = writeln!(text, "{mass} {mass} {mass} 0 0 0");
    }
    text
}

fn dot(a: Vector3, b: Vector3) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn read(text: &str) -> Result<ReducedBody, ImportError> {
    read_mbdyn(&Folder::new(&[("body.fem", text)]).path("body.fem"), None)
}

/// Numbers of a record group of a file that was written here.
fn numbers(text: &str, group: usize) -> Vec<f64> {
    let (_, rest) = text.split_once(&format!("** RECORD GROUP {group},")).unwrap();
    let lines = rest.lines().skip(1).take_while(|line| !line.starts_with("**"));
    lines.flat_map(str::split_ascii_whitespace).map(|word| word.parse().unwrap()).collect()
}

fn cross(u: Vector3) -> [Vector3; 3] {
    [[0.0, -u[2], u[1]], [u[2], 0.0, -u[0]], [-u[1], u[0], 0.0]]
}

fn times(a: [Vector3; 3], b: [Vector3; 3]) -> [Vector3; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

/// As MBDyn sums them up itself over the nodes of a file with lumped masses (`modal.cc`).
#[test]
fn invariants_are_those_that_mbdyn_computes_of_the_nodes() {
    let body = read(&lumped()).unwrap();
    let text = mbdyn_text(&body);
    let sum = |term: &dyn Fn(usize) -> f64| (0..4).map(|n| MASSES[n] * term(n)).sum::<f64>();
    let mut expected: [Vec<f64>; 5] = Default::default();
    for i in 0..3 {
        for j in 0..2 {
            let phi = SHAPES[j];
            expected[0].push(sum(&|n| phi[n][i]));
            expected[1].push(sum(&|n| dot(cross(POSITIONS[n])[i], phi[n])));
            for column in 0..3 {
                expected[2].push(-sum(&|n| times(cross(POSITIONS[n]), cross(phi[n]))[i][column]));
            }
            for other in SHAPES {
                expected[3].push(sum(&|n| dot(cross(phi[n])[i], other[n])));
                for column in 0..3 {
                    expected[4].push(sum(&|n| times(cross(phi[n]), cross(other[n]))[i][column]));
                }
            }
        }
    }
    for (expected, group) in expected.iter().zip(14..) {
        let found = numbers(&text, group);
        assert_eq!(found.len(), expected.len(), "group {group}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < ROUND_OFF, "group {group}: {found}, {expected}");
        }
    }
    let rigid = numbers(&text, 12);
    assert!((rigid[0] - 5.0).abs() < ROUND_OFF);
    let centre: Vector3 = std::array::from_fn(|k| sum(&|n| POSITIONS[n][k]) / 5.0);
    for i in 0..3 {
        assert!((rigid[1 + i] - centre[i]).abs() < ROUND_OFF);
        for j in 0..3 {
            let from = |n: usize| std::array::from_fn(|k| POSITIONS[n][k] - centre[k]);
            let inertia = -sum(&|n| times(cross(from(n)), cross(from(n)))[i][j]);
            assert!((rigid[4 + 3 * i + j] - inertia).abs() < ROUND_OFF, "{rigid:?}");
        }
    }
}

#[test]
fn a_body_that_was_written_is_read_again() {
    let body = read(&lumped()).unwrap();
    assert_eq!(body.stiffness, [[100.0, 0.0], [0.0, 100.0]]);
    assert_eq!(body.damping, [[0.0; 2]; 2]);
    let names: Vec<&str> = body.markers.iter().map(|marker| marker.name.as_str()).collect();
    assert_eq!(names, ["N1001", "TIP", "N1003", "N4"]);
    assert_eq!(body.markers[1].translation, [SHAPES[0][1], SHAPES[1][1]]);
    assert_eq!(body.markers[1].rotation, [[0.0, 0.0, 0.25]; 2]);
    assert_eq!(body.provenance.sources[0].file, "body.fem");
    assert_parts(
        &body.provenance.notes.join("; "),
        &["lumped masses of record group 11", "record group 9 differs"],
    );

    let mut damped = body.clone();
    damped.damping = vec![vec![0.3, 0.1], vec![0.1, 0.4]];
    let again = read(&mbdyn_text(&damped)).unwrap();
    assert_eq!((&again.stiffness, &again.damping), (&damped.stiffness, &damped.damping));
    for (found, expected) in again.markers.iter().zip(&damped.markers) {
        assert_eq!((&found.name, found.position), (&expected.name, expected.position));
        assert_eq!((&found.translation, &found.rotation), (&expected.translation, &expected.rotation));
    }
    let all = |body: &ReducedBody| -> Vec<f64> {
        let inertia = &body.inertia;
        let mut numbers = vec![inertia.mass];
        numbers.extend(inertia.first_moment);
        numbers.extend(inertia.second_moment.as_flattened());
        numbers.extend(inertia.modal_first_moment.as_flattened());
        numbers.extend(inertia.position_mode_moment.as_flattened().as_flattened());
        numbers.extend(inertia.mode_mode_moment.concat().as_flattened().as_flattened());
        numbers
    };
    for (found, expected) in all(&again).iter().zip(all(&damped)) {
        assert!((found - expected).abs() < 10.0 * ROUND_OFF, "{found}, {expected}");
    }
}

#[test]
fn what_cannot_be_read_is_named_with_its_line() {
    let sound = lumped();
    let change = |from: &str, to: &str| {
        assert!(sound.contains(from), "{from}");
        sound.replacen(from, to, 1)
    };
    let without = |group: usize| {
        let from = sound.find(&format!("** RECORD GROUP {group}")).unwrap();
        let to = sound[from + 2..].find("** RECORD").map_or(sound.len(), |at| from + 2 + at);
        format!("{}{}", &sound[..from], &sound[to..])
    };
    let cases = [
        (
            change("REV0 4 2 0 0 0", "REV0 4 2 0"),
            "body.fem:3: expected in record group 1, a revision and the numbers",
        ),
        (change("REV0 4 2 0 0 0", "REV0 4 2 0 0 2"), "in record group 1, 1 to 10000 modes"),
        (
            change("REV0 4 2 0 0 0", "REV0 4 18446744073709551615 7 0 0"),
            "in record group 1, 1 to 10000 modes",
        ),
        (
            change("REV0 4 2", "REV0 5 2"),
            "body.fem:6: expected in record group 2, 5 labels of nodes, found 4",
        ),
        (change("1001 TIP", "1001 T-P"), "expected labels of letters, digits and underscores"),
        (change("** RECORD GROUP 4", "** RECORD GROUP 3"), "expected each record group once"),
        (change("** RECORD GROUP 4", "** RECORD GROUP four"), "expected `** RECORD GROUP N`"),
        (change("0 0 0.25", "0 0"), "in record group 8, 48 numbers, found 47"),
        (change("0 0 0.25", "0 0 x"), "expected a number, found `x`"),
        (change("0 0 0.25", "0 0 1,2"), "expected a number, found `2`"),
        (change("0 0 0.25", "0 0 nan"), "expected a finite number, found `nan`"),
        (
            change("2 2 2 0 0 0", "2 3 2 0 0 0"),
            "in record group 11, the same mass in x, y and z and no rotational inertia at node TIP",
        ),
        (
            change("2 2 2 0 0 0", "2 2 2 0 1 0"),
            "in record group 11, the same mass in x, y and z and no rotational inertia at node TIP",
        ),
        (without(7), "expected record group 7, found the end of the file"),
        (without(11), "expected record group 11 (lumped masses) or 14 to 18"),
        ("nothing\n".to_owned(), "expected record group 1"),
    ];
    for (text, message) in cases {
        let found = read(&text).unwrap_err().to_string();
        assert!(found.contains(message), "{found}\n{message}");
    }
}
