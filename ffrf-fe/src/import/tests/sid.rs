//! Standard input data: the matrices against Newton's law at the nodes, round trips, a file of another program, and defects.

use ffrf_model::{GeometricStiffness, Inertia, ReducedBody, SecondOrderTerms, Vector3};

use super::*;
use crate::export::sid::sid_text;
use crate::import::{read_mbdyn, read_sid};

/// Sums of a few products of order one.
const ROUND_OFF: f64 = 1e-13;

const MASSES: [f64; 4] = [1.0, 2.0, 0.5, 1.5];
const POSITIONS: [Vector3; 4] = [[0.1, 0.2, -0.3], [1.0, 0.0, 0.1], [0.0, 2.0, 0.3], [0.2, 0.1, 1.5]];

fn read(text: &str) -> Result<ReducedBody, ImportError> {
    read_sid(&Folder::new(&[("body.SID_FEM", text)]).path("body.SID_FEM"), None)
}

/// Point masses in two modes, whose invariants come from another reader; a node is named as the file of MBDyn names it.
fn point_masses() -> ReducedBody {
    let folder = Folder::new(&[("body.fem", &mbdyn::lumped())]);
    read_mbdyn(&folder.path("body.fem"), None).unwrap()
}

/// Entries of a matrix in a file, by row and column, or by row, mode and column, from 1.
struct Listed(Vec<(Vec<usize>, f64)>);

impl Listed {
    fn of(text: &str, name: &str) -> Self {
        let start = text.lines().position(|line| line.trim() == name).unwrap();
        let block = text.lines().skip(start + 1).take_while(|line| !line.trim().starts_with("end"));
        let entry = |line: &str| {
            let (key, value) = line.split_once('=')?;
            let indices = key.split_once('(')?.1.split(')').next()?;
            let indices = indices.split(',').map(|index| index.trim().parse().unwrap()).collect();
            Some((indices, value.trim().replace('D', "e").parse().unwrap()))
        };
        Self(block.filter_map(entry).collect())
    }

    fn at(&self, place: &[usize]) -> f64 {
        self.0.iter().find(|(indices, _)| indices == place).map_or(0.0, |(_, value)| *value)
    }

    /// M0 + q_l M1_l.
    fn taylor(&self, row: usize, column: usize, q: [f64; 2]) -> f64 {
        let first: f64 = (0..2).map(|l| q[l] * self.at(&[row, l + 1, column])).sum();
        self.at(&[row, column]) + first
    }
}

fn cross(a: Vector3, b: Vector3) -> Vector3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn plus(a: Vector3, b: Vector3, factor: f64) -> Vector3 {
    std::array::from_fn(|k| a[k] + factor * b[k])
}

fn dot(a: Vector3, b: Vector3) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

const ACCELERATION: Vector3 = [0.3, -0.7, 0.4];
const OMEGA: Vector3 = [0.5, 0.2, -0.9];
const OMEGA_RATE: Vector3 = [-0.1, 0.8, 0.6];
const Q_RATE: [f64; 2] = [0.7, -0.4];
const Q_ACCELERATION: [f64; 2] = [-0.2, 0.9];

/// Force, moment and modal forces that Newton's law asks for, summed over the nodes.
fn newton(q: [f64; 2]) -> [f64; 8] {
    let mut sums = [0.0; 8];
    for node in 0..4 {
        let of =
            |factors: [f64; 2]| (0..2).fold([0.0; 3], |sum, l| plus(sum, mbdyn::SHAPES[l][node], factors[l]));
        let (place, rate, second) = (plus(POSITIONS[node], of(q), 1.0), of(Q_RATE), of(Q_ACCELERATION));
        let mut acceleration = plus(ACCELERATION, cross(OMEGA_RATE, place), 1.0);
        acceleration = plus(acceleration, cross(OMEGA, cross(OMEGA, place)), 1.0);
        acceleration = plus(acceleration, cross(OMEGA, rate), 2.0);
        acceleration = plus(acceleration, second, 1.0);
        let moment = cross(place, acceleration);
        for k in 0..3 {
            sums[k] += MASSES[node] * acceleration[k];
            sums[3 + k] += MASSES[node] * moment[k];
        }
        for mu in 0..2 {
            sums[6 + mu] += MASSES[node] * dot(mbdyn::SHAPES[mu][node], acceleration);
        }
    }
    sums
}

/// The same from the matrices, as the equations of motion of standard input data are written (Wallrapp 1994).
fn equations(text: &str, q: [f64; 2]) -> [f64; 8] {
    let matrix = |name: &str| Listed::of(text, name);
    let (centre, tensor) = (matrix("mdCM"), matrix("J"));
    let (ct, cr, me) = (matrix("Ct"), matrix("Cr"), matrix("Me"));
    let (gr, ge, oe) = (matrix("Gr"), matrix("Ge"), matrix("Oe"));
    let c = [1, 2, 3].map(|k| centre.taylor(k, 1, q));
    let packed = [1, 2, 3, 4, 5, 6].map(|k| tensor.taylor(k, 1, q));
    let [xx, yy, zz, xy, xz, yz] = packed;
    let inertia = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let times = |vector: Vector3| inertia.map(|row| dot(row, vector));
    let mass: f64 = MASSES.iter().sum();
    let mut rows = [0.0; 8];
    let rigid = plus(
        plus(ACCELERATION.map(|a| mass * a), cross(OMEGA_RATE, c), 1.0),
        cross(OMEGA, cross(OMEGA, c)),
        1.0,
    );
    let moment = plus(plus(cross(c, ACCELERATION), times(OMEGA_RATE), 1.0), cross(OMEGA, times(OMEGA)), 1.0);
    for k in 0..3 {
        rows[k] = rigid[k];
        rows[3 + k] = moment[k];
        for mu in 0..2 {
            let momentum = ct.taylor(mu + 1, k + 1, q);
            rows[k] += momentum * Q_ACCELERATION[mu];
            let rate: Vector3 = std::array::from_fn(|j| ct.taylor(mu + 1, j + 1, q) * Q_RATE[mu]);
            rows[k] += 2.0 * cross(OMEGA, rate)[k];
            rows[3 + k] += cr.taylor(mu + 1, k + 1, q) * Q_ACCELERATION[mu];
            let column = |j: usize| 3 * mu + j + 1;
            rows[3 + k] +=
                (0..3).map(|j| gr.taylor(k + 1, column(j), q) * Q_RATE[mu] * OMEGA[j]).sum::<f64>();
        }
    }
    let [x, y, z] = OMEGA;
    let quadratic = [x * x, y * y, z * z, x * y, y * z, x * z];
    for mu in 0..2 {
        let row = mu + 1;
        for k in 0..3 {
            rows[6 + mu] += ct.taylor(row, k + 1, q) * ACCELERATION[k];
            rows[6 + mu] += cr.taylor(row, k + 1, q) * OMEGA_RATE[k];
        }
        for nu in 0..2 {
            rows[6 + mu] += me.taylor(row, nu + 1, q) * Q_ACCELERATION[nu];
            for k in 0..3 {
                rows[6 + mu] += ge.taylor(row, 3 * nu + k + 1, q) * Q_RATE[nu] * OMEGA[k];
            }
        }
        for (k, omega) in quadratic.into_iter().enumerate() {
            rows[6 + mu] += oe.taylor(row, k + 1, q) * omega;
        }
    }
    rows
}

#[test]
fn the_matrices_give_newtons_law_at_the_nodes() {
    let text = sid_text(&point_masses());
    let deviation = |scale: f64| {
        let q = [0.3 * scale, -0.2 * scale];
        let (found, expected) = (equations(&text, q), newton(q));
        let off = |range: std::ops::Range<usize>| {
            range.map(|k| (found[k] - expected[k]).abs()).fold(0.0_f64, f64::max)
        };
        (off(0..3), off(3..6), off(6..8))
    };
    let (force, moment, modal) = deviation(1.0);
    assert!(force < ROUND_OFF && modal < ROUND_OFF, "{force:e}, {modal:e}");
    // J is of first order in the format: the moment lacks what is of second order, and nothing else.
    let (_, halved, _) = deviation(0.5);
    let ratio = moment / halved;
    assert!(moment > 1e-3 && (ratio - 4.0).abs() < 1e-9, "{moment:e}, {ratio}");
    let (_, undeformed, _) = deviation(0.0);
    assert!(undeformed < ROUND_OFF, "{undeformed:e}");
}

/// Stress stiffness that is symmetric in the modes, with every component.
fn stiffened() -> ReducedBody {
    let mut body = point_masses();
    let number =
        |mu: usize, nu: usize, k: usize| ((mu + nu + 1) * (k + 2)) as f64 * 0.07 - 0.2 * (mu * nu) as f64;
    let pairs = |of: &dyn Fn(usize, usize) -> f64| -> Vec<Vec<f64>> {
        (0..2).map(|mu| (0..2).map(|nu| of(mu, nu)).collect()).collect()
    };
    body.geometric_stiffness = Some(GeometricStiffness {
        uniform_load: (0..2)
            .map(|mu| (0..2).map(|nu| [0, 1, 2].map(|k| number(mu, nu, k))).collect())
            .collect(),
        linear_load: (0..2)
            .map(|mu| {
                let matrix = |nu: usize| [0, 1, 2].map(|i| [0, 1, 2].map(|j| number(mu, nu, 4 * i + j)));
                (0..2).map(matrix).collect()
            })
            .collect(),
        marker_loads: Vec::new(),
    });
    body.damping = pairs(&|mu, nu| if mu == nu { 0.4 } else { 0.1 });
    body
}

fn numbers(body: &ReducedBody) -> Vec<f64> {
    let Inertia {
        mass,
        first_moment,
        modal_first_moment,
        second_moment,
        position_mode_moment,
        mode_mode_moment,
    } = &body.inertia;
    let mut all = vec![*mass];
    all.extend(first_moment);
    all.extend(second_moment.as_flattened());
    all.extend(modal_first_moment.as_flattened());
    all.extend(position_mode_moment.as_flattened().as_flattened());
    all.extend(mode_mode_moment.concat().as_flattened().as_flattened());
    if let Some(GeometricStiffness { uniform_load, linear_load, .. }) = &body.geometric_stiffness {
        all.extend(uniform_load.concat().as_flattened());
        all.extend(linear_load.concat().as_flattened().as_flattened());
    }
    all
}

#[track_caller]
fn assert_same(found: &ReducedBody, expected: &ReducedBody) {
    assert_eq!(found.markers, expected.markers);
    assert_eq!((&found.stiffness, &found.damping), (&expected.stiffness, &expected.damping));
    assert_eq!(found.second_order_terms, expected.second_order_terms);
    let (found, expected) = (numbers(found), numbers(expected));
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found - expected).abs() < ROUND_OFF, "{found}, {expected}");
    }
}

#[test]
fn a_body_that_was_written_is_read_again() {
    for mut body in [point_masses(), stiffened()] {
        body.modes[1].frequency_hz = Some(12.5);
        let text = sid_text(&body);
        let again = read(&text).unwrap();
        assert_same(&again, &body);
        assert_eq!(again.modes[1].frequency_hz, Some(12.5));
        assert_eq!(again.second_order_terms, SecondOrderTerms::Known);
        assert_eq!(again.provenance.sources[0].file, "body.SID_FEM");
        assert_same(&read(&sid_text(&again)).unwrap(), &body);
    }
}

/// The file with a matrix as if it were written to order zero.
fn to_order_zero(text: &str, name: &str) -> String {
    let mut inside = false;
    let mut kept = String::new();
    for line in text.lines() {
        let word = line.trim();
        inside = (inside || word == name) && word != format!("end {name}");
        let line = if inside && word.starts_with("order") { "order = 0" } else { line };
        if !(inside && word.starts_with("m1")) {
            kept += line;
            kept.push('\n');
        }
    }
    kept
}

#[test]
fn what_a_file_lacks_of_second_order_is_said() {
    // Without stiffness, Oe alone tells what is inertia, for its trace is the modal mass.
    let plain = to_order_zero(&sid_text(&point_masses()), "Gr");
    assert_same(&read(&plain).unwrap(), &point_masses());

    // With it, Oe holds the sum of both: of the difference T - Γ nothing is lost, and of T the trace.
    let together = read(&to_order_zero(&sid_text(&stiffened()), "Gr")).unwrap();
    assert_eq!(together.second_order_terms, SecondOrderTerms::Together);
    assert_parts(&together.provenance.notes.join("; "), &["a fidelity keeps both or neither"]);
    let (found, expected) = (together.geometric_stiffness.as_ref().unwrap(), stiffened());
    let expected_stiffness = expected.geometric_stiffness.as_ref().unwrap();
    let mut differ = 0;
    for (mu, nu) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let (t, expected_t) =
            (&together.inertia.mode_mode_moment[nu][mu], &expected.inertia.mode_mode_moment[nu][mu]);
        let (gamma, expected_gamma) = (&found.linear_load[mu][nu], &expected_stiffness.linear_load[mu][nu]);
        let trace = |m: &[[f64; 3]; 3]| m[0][0] + m[1][1] + m[2][2];
        assert!((trace(t) - trace(expected_t)).abs() < ROUND_OFF);
        for k in 0..9 {
            let (i, j) = (k / 3, k % 3);
            let off = (t[i][j] - gamma[i][j]) - (expected_t[i][j] - expected_gamma[i][j]);
            assert!(off.abs() < ROUND_OFF, "{off:e}");
            differ += usize::from((t[i][j] - expected_t[i][j]).abs() > 1e-3);
        }
        for k in 0..3 {
            assert!(
                (found.uniform_load[mu][nu][k] - expected_stiffness.uniform_load[mu][nu][k]).abs()
                    < ROUND_OFF
            );
        }
    }
    assert!(differ > 0, "the file does not tell T from Γ");
    // What such a body is written as, is read again as the same.
    assert_same(&read(&sid_text(&together)).unwrap(), &together);

    let without = to_order_zero(&plain, "Oe");
    let unknown = read(&without).unwrap();
    assert_eq!(unknown.second_order_terms, SecondOrderTerms::Unknown);
    assert_parts(&unknown.provenance.notes.join("; "), &["fidelities up to linear"]);
    assert_same(&read(&sid_text(&unknown)).unwrap(), &unknown);
    let (first, all) = (numbers(&unknown), numbers(&point_masses()));
    // Up to T_μ everything is there: 1 + 3 + 9 + 2 * 3 + 2 * 9 numbers.
    assert!(first[..37].iter().zip(&all[..37]).all(|(a, b)| (a - b).abs() < ROUND_OFF));
}

/// A part of which another program made the data, shortened: `tests/data/sid/README.md`.
#[test]
fn a_file_of_another_program_is_read() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/sid/beam.SID_FEM");
    let body = read_sid(&path, None).unwrap();
    assert_eq!((body.mode_count(), body.inertia.mass), (4, 12.5604));
    // Free-free modes of unit mass about the centre: the stiffness is the square of the frequency, given to three decimals.
    for (mu, expected) in [51.626, 55.048, 110.392, 242.901].into_iter().enumerate() {
        assert_eq!(body.modes[mu].frequency_hz, Some(expected));
        let hertz = body.stiffness[mu][mu].sqrt() / std::f64::consts::TAU;
        assert!((hertz - expected).abs() < 1e-3, "mode {mu}: {hertz}");
        let moment = &body.inertia.mode_mode_moment[mu][mu];
        assert!((moment[0][0] + moment[1][1] + moment[2][2] - 1.0).abs() < ROUND_OFF, "{moment:?}");
        assert_eq!(body.inertia.modal_first_moment[mu], [0.0; 3]);
    }
    let notes = body.provenance.notes.join("; ");
    assert_parts(
        &notes,
        &["File created using PY_SID", "Oe and J by 3", "Ge and Cr by 1.0e0", "keeps both or neither"],
    );
    assert_eq!((body.markers.len(), body.markers[1].name.as_str()), (2, "N1861"));
    assert_eq!(body.markers[1].position, [-0.25, 0.0, 0.5200000107]);
    assert_eq!(body.markers[1].translation[3], [-0.0768014760187, -0.00321961514353, 0.62548646451]);
    assert_same(&read(&sid_text(&body)).unwrap(), &body);
}

#[test]
fn other_writings_are_understood() {
    let text = sid_text(&point_masses());
    let body = point_masses();
    // The mode as the last index of m1.
    let swapped: String = text
        .lines()
        .map(|line| {
            let Some((key, value)) = line.split_once('=').filter(|(key, _)| key.trim().starts_with("m1"))
            else {
                return format!("{line}\n");
            };
            let indices: Vec<&str> = key.split(['(', ',', ')']).skip(1).collect();
            format!("m1({}, {}, {}) = {value}\n", indices[0], indices[2], indices[1])
        })
        .collect();
    let read_swapped = read(&swapped).unwrap();
    assert_same(&read_swapped, &body);
    assert_parts(&read_swapped.provenance.notes.join("; "), &["the third index of m1 counts the modes"]);
    // No first line, `new frame`, exponents with e, and a stiffness of initial stresses.
    let (_, rest) = text.split_once('\n').unwrap();
    let bare = rest.trim_start().replace("           frame\n", "new frame\n").replace("D+00", "e0");
    assert_same(&read(&bare).unwrap(), &body);
    let at = text.find("           Ke\n").unwrap();
    let prestressed = "ksigma\norder = 1\nnrow = 2\nncol = 1\nnq = 2\nnqn = 0\nstructure = 3\n\
                       m1(1,1,1) = 5\nm1(2,2,1) = -3\nend ksigma\n";
    let before = text.find("           ksigma\n").unwrap();
    let stiff = read(&format!("{}{prestressed}{}", &text[..before], &text[at..])).unwrap();
    assert_eq!(stiff.stiffness, [[105.0, 0.0], [0.0, 97.0]]);
    // Without Cr of first order, Ge holds the odd parts.
    assert_same(&read(&to_order_zero(&text, "Cr")).unwrap(), &body);
}

#[test]
fn what_cannot_be_read_is_named_with_its_line() {
    let sound = sid_text(&point_masses());
    let change = |from: &str, to: &str| {
        assert!(sound.contains(from), "{from}");
        sound.replacen(from, to, 1)
    };
    let without = |name: &str| {
        let from = sound.find(&format!("           {name}\n")).unwrap();
        let end = format!("end {name}\n");
        let to = sound.find(&end).unwrap() + end.len();
        format!("{}{}", &sound[..from], &sound[to..])
    };
    let nelastq = format!("{:16}{:32}= 2", "", "nelastq");
    let count = |to: &str| change(&nelastq, &nelastq.replace("= 2", to));
    let cases = [
        (
            change("    4    2", "    4    3"),
            "body.SID_FEM:1: expected the numbers of nodes and modes that follow, 4 and 2",
        ),
        (change(" part", " parts"), "body.SID_FEM:2: expected `part`, found `parts`"),
        (count("= 18446744073709551616"), "expected nelastq = a whole number"),
        (count("= 1000000"), "expected nelastq = 1 to 1000"),
        (count("= 3"), "expected nelastq, and as many ielastq numbered from 1"),
        (change("ielastq (   2)", "ielastq (   1)"), "as many ielastq numbered from 1"),
        (change("body ref", "other"), "expected rframe = body ref"),
        (without("Ct"), "expected the matrix `Ct`, found the end of the file"),
        (change("           Ct\n", "           Cs\n"), "expected refmod, frame, mdCM, J"),
        (change("m0( 1, 1)", "m0( 4, 1)"), "expected m0 of `origin` within 3 x 1"),
        (
            change("m1( 1, 1, 1)", "m1( 1, 3, 1)"),
            "expected m1(row, mode, column) of `origin` within 3 rows, 2 modes",
        ),
        (change("m0( 1, 1)", "m0( 1)"), "expected 2 indices from 1 in brackets"),
        (change("D-01", "D-0x"), "expected a number, found"),
        (change("D-01", "D+999"), "expected a finite number, found"),
        (
            change("nrow                  =    3", "nrow                  =    7"),
            "expected `origin` of 3 rows and 1 columns, found 7 and 1",
        ),
        (
            change("order                 =    1", "order                 =    2"),
            "expected `origin` of order 0 or 1",
        ),
        (sound[..sound.len() / 2].to_owned(), "expected"),
    ];
    for (text, part) in cases {
        let message = read(&text).unwrap_err().to_string();
        assert!(message.contains(part), "`{message}` lacks `{part}`");
    }
    // Two modes that are one.
    let me = Listed::of(&sound, "Me");
    assert!(me.at(&[1, 1]) > 0.0);
    let heavy = change(&format!("{:16}{:32}= ", "", "mass"), &format!("{:16}{:32}=-", "", "mass"));
    let message = read(&heavy).unwrap_err().to_string();
    assert!(message.contains("mass"), "{message}");
    let forced = change(
        "           ksigma\n",
        "ksigma\norder = 0\nnrow = 2\nncol = 1\nstructure = 3\nm0(1,1) = 2\nend ksigma\n",
    );
    let at = forced.rfind("           order").map_or(0, |_| forced.find("end ksigma\n").unwrap() + 11);
    let rest = forced[at..].find("end ksigma\n").unwrap() + 11;
    let forced = format!("{}{}", &forced[..at], &forced[at + rest..]);
    assert_parts(&read(&forced).unwrap_err().to_string(), &["ksigma of zero", "initial stresses"]);
}
