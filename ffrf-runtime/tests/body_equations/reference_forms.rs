//! The paper's inertial form and Euler-parameter form, against the reference states
//! (`../shared/reference/FORMAT.md`, cases a to c).

#![allow(clippy::unwrap_used, clippy::panic)] // helpers beside the tests

use ffrf_runtime::forms::{EulerParameterForm, InertialForm, to_body, to_inertial};
use ffrf_runtime::nalgebra::{Quaternion, SMatrix, SVector, UnitQuaternion, Vector3};
use ffrf_runtime::{DenseForms, FlexibleBody, rotation};
use ffrf_test_kit::naive_body::{Invariants, NaiveBody};
use ffrf_test_kit::tolerances::{REFERENCE_ACCELERATION, REFERENCE_MATRICES};
use serde_json::Value;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/reference");

fn list<const R: usize, X>(value: &Value, entry: impl Fn(&Value) -> X) -> [X; R] {
    core::array::from_fn(|i| entry(&value[i]))
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("expected a number, found {value}"))
}

fn numbers<const R: usize>(value: &Value) -> [f64; R] {
    list(value, number)
}

fn rows<const R: usize, const C: usize>(value: &Value) -> [[f64; C]; R] {
    list(value, numbers)
}

fn vector<const R: usize>(value: &Value) -> SVector<f64, R> {
    SVector::from(numbers::<R>(value))
}

fn matrix<const R: usize>(value: &Value) -> SMatrix<f64, R, R> {
    SMatrix::from_fn(|i, j| number(&value[i][j]))
}

fn invariants<const M: usize>(value: &Value) -> Invariants<M> {
    Invariants {
        mass: number(&value["m"]),
        centre_of_mass: numbers(&value["a"]),
        modal_centre_of_mass: rows(&value["b"]),
        euler_tensor: rows(&value["T"]),
        modal_euler_tensor: list(&value["T_mu"], rows),
        modal_pair_euler_tensor: list(&value["T_munu"], |row| list(row, rows)),
        stiffness: rows(&value["K_ff"]),
        damping: [[0.0; M]; M],
    }
}

/// Square roots of the largest diagonal entry of each block: entry (i, j) of a mass matrix is at most `s_i s_j`.
///
/// `starts` are the first rows of the blocks of translation, rotation and modes.
fn scales<const R: usize>(mass: &SMatrix<f64, R, R>, starts: [usize; 3]) -> SVector<f64, R> {
    let block = |row: usize| starts.iter().filter(|start| **start <= row).count();
    SVector::from_fn(|row, _| {
        let same = (0..R).filter(|other| block(*other) == block(row));
        same.map(|other| mass[(other, other)]).fold(0.0, f64::max).sqrt()
    })
}

/// Largest |found - expected| over the natural scale of each entry.
fn mass_error<const R: usize>(
    found: &SMatrix<f64, R, R>,
    expected: &SMatrix<f64, R, R>,
    starts: [usize; 3],
) -> f64 {
    let scales = scales(expected, starts);
    (found - expected).component_div(&(scales * scales.transpose())).amax()
}

struct Case<const M: usize> {
    name: &'static str,
    file: Value,
    worst: [f64; 7],
}

impl<const M: usize> Case<M> {
    fn read(name: &'static str) -> Option<Self> {
        let path = format!("{FOLDER}/{name}.json");
        let Ok(text) = std::fs::read_to_string(&path) else {
            eprintln!("SKIPPED: reference_forms, {path} is missing");
            return None;
        };
        let file: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(file["M"].as_u64(), Some(M as u64));
        Some(Self { name, file, worst: [0.0; 7] })
    }

    fn note(&mut self, what: usize, error: f64) {
        assert!(!error.is_nan());
        self.worst[what] = self.worst[what].max(error);
    }

    fn check<const N: usize, const P: usize>(mut self) {
        let body = NaiveBody::<M, N>::new(&invariants(&self.file["invariants"]));
        let states = self.file["states"].as_array().unwrap().clone();
        assert!(states.len() >= 5, "{}: only {} states", self.name, states.len());
        for state in &states {
            self.check_state::<N, P>(&body, state);
        }
        let names = ["mass_a", "qw_a", "acc_a", "mass_c", "qv_c", "acc_c", "residual_c"];
        eprintln!("{}: {:?}", self.name, names.iter().zip(self.worst).collect::<Vec<_>>());
        for (name, (error, limit)) in names.iter().zip(self.worst.iter().zip([
            REFERENCE_MATRICES,
            REFERENCE_MATRICES,
            REFERENCE_ACCELERATION,
            REFERENCE_MATRICES,
            REFERENCE_MATRICES,
            REFERENCE_ACCELERATION,
            REFERENCE_ACCELERATION,
        ])) {
            assert!(*error < limit, "{}, {name}: error {error:e}, limit {limit:e}", self.name);
        }
    }

    fn check_state<const N: usize, const P: usize>(&mut self, body: &NaiveBody<M, N>, state: &Value) {
        let orientation: UnitQuaternion<f64> =
            rotation::from_euler_parameters(numbers(&state["theta"])).unwrap();
        let [w, i, j, k] = numbers(&state["theta_dot"]);
        let rate = Quaternion::new(w, i, j, k);
        let q = vector::<M>(&state["q"]);
        let q_dot = vector::<M>(&state["q_dot"]);
        let omega: Vector3<f64> = orientation.inverse_transform_vector(&vector::<3>(&state["omega"]));
        let external = vector::<N>(&state["Q_ext"]);
        let force = to_body(&orientation, &external);
        let equations = body.equations_of_motion(&q, &omega, &q_dot, &force);

        // Forces that the motion makes are at most of the order √(M_ii 2 T) |ω|; plus what the file holds.
        let speed = (2.0 * number(&state["kinetic"])).sqrt() * (omega.norm() + 1.0);
        let blocks = [0, 3, 6];
        let form = InertialForm::new(&orientation, &equations.mass_matrix, &equations.quadratic_velocity);
        let expected = matrix::<N>(&state["mass_a"]);
        self.note(0, mass_error(&form.mass_matrix, &expected, blocks));
        let scale = (scales(&expected, blocks) * speed).add_scalar(f64::MIN_POSITIVE);
        let difference = form.quadratic_velocity - vector::<N>(&state["qw_a"]);
        self.note(1, difference.component_div(&scale).amax());
        let found = to_inertial(&orientation, &equations.acceleration);
        let expected = vector::<N>(&state["acc_a"]);
        self.note(2, (found - expected).amax() / expected.amax());

        let blocks = [0, 3, 7];
        let form: EulerParameterForm<P> =
            EulerParameterForm::new(&orientation, &equations.mass_matrix, &equations.quadratic_velocity);
        let expected = matrix::<P>(&state["mass_c"]);
        self.note(3, mass_error(&form.mass_matrix, &expected, blocks));
        let scale = (scales(&expected, blocks) * speed).add_scalar(f64::MIN_POSITIVE);
        let difference = form.quadratic_velocity - vector::<P>(&state["qv_c"]);
        self.note(4, difference.component_div(&scale).amax());
        let found = EulerParameterForm::<P>::acceleration(&orientation, &rate, &equations.acceleration);
        let expected = vector::<4>(&state["theta_ddot"]);
        let error = (found.fixed_rows::<4>(3) - expected).amax() / expected.amax();
        self.note(5, error);
        let (row, right) = EulerParameterForm::<P>::normalisation(&orientation, &rate);
        self.note(5, (row.dot(&expected) - right).abs() / expected.amax());
        // M y + [0; 0; K q] - Q_v - force = 0, with the multiplier of (216) zero
        let mut residual = form.mass_matrix * found
            - form.quadratic_velocity
            - EulerParameterForm::<P>::force(&orientation, &force);
        for (mu, internal) in body.internal_force(&q, &q_dot).iter().enumerate() {
            residual[7 + mu] += internal;
        }
        let size = (form.mass_matrix.abs() * found.abs()).amax();
        self.note(6, residual.amax() / size);
    }
}

#[test]
fn both_forms_agree_with_the_reference() {
    let _ = Case::<1>::read("synth_m1").map(Case::check::<7, 8>);
    let _ = Case::<2>::read("synth_m2").map(Case::check::<8, 9>);
    let _ = Case::<3>::read("synth_m3").map(Case::check::<9, 10>);
    let _ = Case::<5>::read("synth_m5").map(Case::check::<11, 12>);
    let _ = Case::<2>::read("truss3").map(Case::check::<8, 9>);
    let _ = Case::<8>::read("rotorDisc").map(Case::check::<14, 15>);
    let _ = Case::<4>::read("blockC3D8").map(Case::check::<10, 11>);
    let _ = Case::<4>::read("blockC3D10").map(Case::check::<10, 11>);
}
