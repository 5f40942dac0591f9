//! The macro at work: models, fewer modes, single precision, invariants at run time; three doors, one code.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

use std::path::Path;

use ffrf::nalgebra::RealField;
use ffrf::{FamilyMember, FamilyVisitor, FlexibleBody, ModalVector, Observables, flexible_body};
use ffrf_codegen::{GenerateOptions, Kernels, ScalarType, generate};
use ffrf_model::ReducedBody;
use ffrf_test_kit::random_body::{Modes, random_body};
use ffrf_test_kit::{filled, witness};

/// The model that the bodies below are made from.
const MODEL: &str = "tests/models/random_m4.ffrf.json";

flexible_body! {
    /// All four modes.
    pub struct Whole { model: "tests/models/random_m4.ffrf.json" }
}

flexible_body! {
    /// The first two.
    pub struct First { model: "tests/models/random_m4.ffrf.json", modes: ..2 }
}

flexible_body! {
    struct Single { model: "tests/models/random_m4.ffrf.json", modes: ..3, scalar: f32, fma: off }
}

flexible_body! {
    pub struct General { modes: 2, layout: {} }
}

flexible_body! {
    pub struct Special {
        modes: 3,
        layout: {
            mass: dense,
            first_moment: zero,
            modal_first_moment: zero,
            position_mode_moment: symmetric,
            modal_mass: identity,
            damping: diagonal,
        },
    }
}

fn model() -> ReducedBody {
    ReducedBody::read(Path::new(env!("CARGO_MANIFEST_DIR")).join(MODEL)).unwrap()
}

fn options(modes: Option<usize>) -> GenerateOptions {
    GenerateOptions { modes: modes.map(Into::into), ..GenerateOptions::default() }
}

#[test]
fn a_model_with_all_its_modes() {
    let body = model();
    let kernels = Kernels::formulate(&body, &options(None)).unwrap();
    witness::check::<4, 10, _>(&Whole, &body, &kernels, true);
}

#[test]
fn the_first_modes_of_a_model() {
    let body = model();
    let kernels = Kernels::formulate(&body, &options(Some(2))).unwrap();
    witness::check::<2, 8, _>(&First, &body.with_modes(2).unwrap(), &kernels, true);
    assert_eq!(First::MODE_COUNT, 2);
    assert_eq!(First::MODEL_FINGERPRINT, Whole::MODEL_FINGERPRINT);
}

#[test]
fn single_precision() {
    let kernels = Kernels::formulate(&model(), &options(Some(3))).unwrap();
    witness::check_single::<3, 9, _>(&Single, &kernels);
}

#[test]
fn invariants_at_run_time_in_the_general_layout() {
    let body = random_body(12, 2, Modes::Random);
    let general = filled!(General, body, f64);
    let kernels = Kernels::formulate(&body, &options(None)).unwrap();
    witness::check::<2, 8, _>(&general, &body, &kernels, true);
}

#[test]
fn invariants_at_run_time_in_a_special_layout() {
    let body = random_body(13, 3, Modes::FreeFree);
    let given = witness::invariants::<3>(&body);
    let special = Special {
        mass: given.mass,
        second_moment: given.euler_tensor,
        position_mode_moment: given.modal_euler_tensor,
        mode_mode_moment: given.modal_pair_euler_tensor,
        stiffness: given.stiffness,
        damping: std::array::from_fn(|mu| given.damping[mu][mu]),
    };
    let kernels = Kernels::formulate(&body, &options(None)).unwrap();
    witness::check::<3, 9, _>(&special, &body, &kernels, true);
}

#[test]
fn text_and_tokens_are_the_same_code() {
    let mut special = options(Some(3));
    special.scalar = ScalarType::F32;
    for options in [options(None), special] {
        let code = generate(&model(), &options).unwrap();
        let read_back: proc_macro2::TokenStream = code.text.parse().unwrap();
        assert_eq!(read_back.to_string(), code.tokens.to_string());
    }
}

flexible_body! {
    /// Ten bodies from one model.
    pub family parts {
        model: "tests/models/random_m4.ffrf.json",
        modes: [0, 2, 4],
        fidelity: [full, [first_moment, modal_rotation]],
        scalar: [f64, f32],
        fma: off,
    }
}

/// Collects what members are and what they say of themselves.
#[derive(Default)]
struct Roll(Vec<(FamilyMember, usize, usize, f64)>);

impl FamilyVisitor for Roll {
    fn visit<T: RealField + Copy, B: Observables<T> + Copy>(&mut self, member: FamilyMember, body: B) {
        let modes = body.undeformed().as_slice().len();
        let mass = ffrf::nalgebra::try_convert(body.mass()).unwrap();
        self.0.push((member, modes, size_of::<T>(), mass));
    }
}

#[test]
fn a_family_has_a_member_for_each_combination_and_visits_each_once() {
    let mut roll = Roll::default();
    parts::for_each(&mut roll);
    let names: Vec<&str> = roll.0.iter().map(|(member, ..)| member.name).collect();
    let expected = [
        "M0FullF64",
        "M0FullF32",
        "M2FullF64",
        "M2FullF32",
        "M2Terms1F64",
        "M2Terms1F32",
        "M4FullF64",
        "M4FullF32",
        "M4Terms1F64",
        "M4Terms1F32",
    ];
    assert_eq!(names, expected);
    assert_eq!(parts::MEMBERS.map(|member| member.name), expected);
    for (member, modes, size, mass) in &roll.0 {
        assert_eq!(*modes, member.modes, "{member:?}");
        assert_eq!(*size, if member.scalar == "f32" { 4 } else { 8 }, "{member:?}");
        // single precision rounds once
        assert!((mass / model().inertia.mass - 1.0).abs() < 1e-7, "{member:?}");
    }
    assert_eq!(roll.0[4].0.fidelity, "[first_moment, modal_rotation]");
}

/// Types by their names, as `mechanism!` needs them.
macro_rules! count_modes {
    ($name:ident, $modes:literal, $fidelity:literal, $scalar:ident) => {
        assert_eq!(FlexibleBody::<$scalar>::undeformed(&parts::$name).as_slice().len(), $modes, $fidelity);
    };
}

#[test]
fn the_list_of_a_family_names_each_type() {
    parts::members!(count_modes);
}

#[test]
fn a_member_of_a_family_is_the_body_that_stands_alone() {
    let body = model();
    let kernels = Kernels::formulate(&body, &options(None)).unwrap();
    witness::check::<4, 10, _>(&parts::M4FullF64, &body, &kernels, true);
}
