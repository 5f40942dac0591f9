//! `check` of bodies whose invariants come at run time: sound bodies pass, each defect is named.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

use std::array::from_fn;

use ffrf::{InvariantError, InvariantExpectation, flexible_body};
use ffrf_model::ReducedBody;
use ffrf_test_kit::random_body::{Modes, random_body};
use ffrf_test_kit::{filled, witness};

flexible_body! {
    struct General { modes: 3, layout: {} }
}

flexible_body! {
    struct Single { modes: 3, layout: {}, scalar: f32 }
}

flexible_body! {
    struct Generic { modes: 3, layout: {}, scalar: generic }
}

flexible_body! {
    struct FreeFree {
        modes: 3,
        layout: {
            first_moment: zero,
            modal_first_moment: zero,
            position_mode_moment: symmetric,
            modal_mass: identity,
            stiffness: diagonal,
            damping: diagonal,
        },
    }
}

flexible_body! {
    /// Θ_ff is data of its own.
    struct OwnMass {
        modes: 2,
        layout: { second_moment: diagonal, position_mode_moment: zero, mode_mode_moment: antisymmetric, damping: zero },
        fidelity: linear,
    }
}

flexible_body! {
    /// Two modes along different axes.
    struct Axes {
        modes: 2,
        layout: { position_mode_moment: diagonal, mode_mode_moment: diagonal, modal_mass: diagonal, stiffness: identity },
    }
}

flexible_body! {
    struct Rigid { modes: 0, layout: {} }
}

fn dense(seed: u64) -> ReducedBody {
    random_body(seed, 3, Modes::Random)
}

fn general(seed: u64) -> General {
    let body = dense(seed);
    filled!(General, body, f64)
}

fn single(seed: u64) -> Single {
    let body = dense(seed);
    filled!(Single, body, f32)
}

fn generic(seed: u64) -> Generic {
    let body = dense(seed);
    filled!(Generic, body, f64)
}

fn free_free(seed: u64) -> FreeFree {
    let body = random_body(seed, 3, Modes::FreeFree);
    let given = witness::invariants::<3>(&body);
    FreeFree {
        mass: given.mass,
        second_moment: given.euler_tensor,
        position_mode_moment: given.modal_euler_tensor,
        mode_mode_moment: given.modal_pair_euler_tensor,
        stiffness: from_fn(|mu| given.stiffness[mu][mu]),
        damping: from_fn(|mu| given.damping[mu][mu]),
    }
}

fn own_mass() -> OwnMass {
    let odd = [[0.0, 0.1, -0.2], [-0.1, 0.0, 0.3], [0.2, -0.3, 0.0]];
    OwnMass {
        mass: 3.0,
        first_moment: [0.1, 0.2, -0.3],
        modal_first_moment: [[0.1, 0.0, 0.2], [0.0, -0.3, 0.1]],
        second_moment: [2.0, 1.0, 0.0],
        mode_mode_moment: [[[[0.0; 3]; 3], odd], [odd.map(|row| row.map(|x| -x)), [[0.0; 3]; 3]]],
        modal_mass: [[1.0, 0.2], [0.2, 0.8]],
        stiffness: [[90.0, -4.0], [-4.0, 0.0]],
    }
}

fn axes() -> Axes {
    Axes {
        mass: 3.0,
        first_moment: [0.0; 3],
        modal_first_moment: [[0.1, 0.0, 0.2], [0.0, -0.3, 0.1]],
        second_moment: [[2.0, 0.1, 0.0], [0.1, 1.0, 0.0], [0.0, 0.0, 0.5]],
        position_mode_moment: [[0.1, 0.2, 0.3], [0.3, -0.1, 0.2]],
        mode_mode_moment: [[[0.5, 0.2, 0.1], [0.1, 0.1, -0.2]], [[0.1, 0.1, -0.2], [0.2, 0.9, 0.1]]],
        damping: [[0.1, 0.0], [0.0, 0.2]],
    }
}

/// The error of a body that was sound before `spoil`.
#[track_caller]
fn spoilt<B>(
    mut body: B,
    check: impl Fn(&B) -> Result<(), InvariantError>,
    spoil: impl Fn(&mut B),
) -> InvariantError {
    assert_eq!(check(&body), Ok(()));
    spoil(&mut body);
    check(&body).unwrap_err()
}

#[track_caller]
fn is_at(error: InvariantError, field: &str, index: &[usize], found: f64) {
    assert_eq!((error.field, error.index.as_slice()), (field, index), "{error}");
    assert!(error.found == found || (error.found.is_nan() && found.is_nan()), "{error}, not {found}");
}

#[test]
fn sound_bodies_pass_in_every_layout_and_number_type() {
    for seed in 1..30 {
        assert_eq!(general(seed).check(), Ok(()), "seed {seed}");
        assert_eq!(single(seed).check(), Ok(()), "seed {seed}");
        assert_eq!(generic(seed).check(), Ok(()), "seed {seed}");
        assert_eq!(free_free(seed).check(), Ok(()), "seed {seed}");
    }
    assert_eq!(own_mass().check(), Ok(()));
    assert_eq!(axes().check(), Ok(()));
    // A flat plate and a thin rod beside the origin.
    let plate = [[0.3, 0.1, 0.0], [0.1, 0.2, 0.0], [0.0; 3]];
    let mut rigid = Rigid {
        mass: 2.0,
        first_moment: [0.1, 0.2, 0.0],
        modal_first_moment: [],
        second_moment: plate,
        position_mode_moment: [],
        mode_mode_moment: [],
        stiffness: [],
        damping: [],
    };
    assert_eq!(rigid.check(), Ok(()));
    rigid.second_moment = [[1.0, 0.0, 0.0], [0.0, 2e-12, 0.0], [0.0, 0.0, 2e-12]];
    rigid.first_moment = [0.0; 3];
    assert_eq!(rigid.check(), Ok(()));
}

#[test]
fn numbers_that_are_not_finite_are_named_before_anything_else() {
    type Spoil = fn(&mut General);
    let cases: [(&str, &[usize], Spoil); 8] = [
        ("mass", &[], |body| body.mass = f64::NAN),
        ("first_moment", &[1], |body| body.first_moment[1] = f64::NAN),
        ("modal_first_moment", &[2, 0], |body| body.modal_first_moment[2][0] = f64::NAN),
        ("second_moment", &[2, 1], |body| body.second_moment[2][1] = f64::NAN),
        ("position_mode_moment", &[1, 2, 0], |body| body.position_mode_moment[1][2][0] = f64::NAN),
        ("mode_mode_moment", &[2, 1, 0, 2], |body| body.mode_mode_moment[2][1][0][2] = f64::NAN),
        ("stiffness", &[0, 2], |body| body.stiffness[0][2] = f64::NAN),
        ("damping", &[1, 1], |body| body.damping[1][1] = f64::NAN),
    ];
    for (field, index, spoil) in cases {
        let error = spoilt(general(3), General::check, spoil);
        is_at(error, field, index, f64::NAN);
        assert_eq!(error.expected, InvariantExpectation::Finite);
    }
    let error = spoilt(single(3), Single::check, |body| body.mass = f32::INFINITY);
    is_at(error, "mass", &[], f64::INFINITY);
    assert_eq!(error.to_string(), "mass: found inf, expected a finite number");
}

#[test]
fn mass_and_second_moment() {
    let error = spoilt(general(3), General::check, |body| body.mass = 0.0);
    is_at(error, "mass", &[], 0.0);
    assert_eq!(error.expected, InvariantExpectation::Positive);

    let error = spoilt(general(3), General::check, |body| body.second_moment[1][1] = -0.5);
    is_at(error, "second_moment", &[1, 1], -0.5);
    assert_eq!(error.expected, InvariantExpectation::NotNegative);

    let error = spoilt(general(3), General::check, |body| body.second_moment[2][0] += 0.5);
    is_at(error, "second_moment", &[2, 0], general(3).second_moment[2][0] + 0.5);
    let InvariantExpectation::Value { value, reason, .. } = error.expected else { panic!("{error}") };
    assert_eq!((value, reason), (general(3).second_moment[0][2], "symmetric"));

    // Not negative on the diagonal, but along (1, -1, 0): 1 - 2² / 1 = -3.
    let error = spoilt(general(3), General::check, |body| {
        body.second_moment = [[1.0, 2.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    });
    assert_eq!((error.field, error.index.as_slice()), ("second_moment", &[1, 1][..]));
    assert!((error.found + 3.0).abs() < 1e-7, "{error}");

    // All mass on the line (1, 1, 0): the inertia tensor is [[1, -1, 0], [-1, 1, 0], [0, 0, 2]].
    let error = spoilt(general(3), General::check, |body| {
        body.second_moment = [[1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0; 3]];
    });
    is_at(error, "second_moment", &[1, 1], 0.0);
    assert!(error.to_string().contains("all mass is on one line"), "{error}");
    let error = spoilt(own_mass(), OwnMass::check, |body| body.second_moment = [2.0, 0.0, 0.0]);
    is_at(error, "second_moment", &[0], 0.0);
}

#[test]
fn moments_of_modes_mirror_each_other() {
    let error = spoilt(general(3), General::check, |body| body.mode_mode_moment[2][1][0][2] += 0.25);
    is_at(error, "mode_mode_moment", &[2, 1, 0, 2], general(3).mode_mode_moment[2][1][0][2] + 0.25);
    let InvariantExpectation::Value { value, reason, .. } = error.expected else { panic!("{error}") };
    assert_eq!((value, reason), (general(3).mode_mode_moment[1][2][2][0], "T_νμ = T_μνᵀ"));
    // One tensor transposed as a whole: the usual mistake of index order.
    let error = spoilt(general(3), General::check, |body| {
        body.mode_mode_moment[0][1] = body.mode_mode_moment[1][0];
    });
    assert_eq!((error.field, &error.index.as_slice()[..2]), ("mode_mode_moment", &[1, 0][..]));

    let error = spoilt(free_free(3), FreeFree::check, |body| body.position_mode_moment[1][2][0] += 0.25);
    assert_eq!((error.field, error.index.as_slice()), ("position_mode_moment", &[1, 2, 0][..]));
    assert!(error.to_string().ends_with("(symmetric)"), "{error}");

    let error = spoilt(own_mass(), OwnMass::check, |body| body.mode_mode_moment[0][1][1][0] = 0.1);
    is_at(error, "mode_mode_moment", &[0, 1, 1, 0], 0.1);
    assert!(error.to_string().contains("expected -0.1 within"), "{error}");
    let error = spoilt(own_mass(), OwnMass::check, |body| body.mode_mode_moment[1][1][2][2] = 0.5);
    is_at(error, "mode_mode_moment", &[1, 1, 2, 2], 0.5);

    let error = spoilt(single(3), Single::check, |body| body.mode_mode_moment[2][1][0][2] += 1e-3);
    assert_eq!((error.field, error.index.as_slice()), ("mode_mode_moment", &[2, 1, 0, 2][..]));
}

#[test]
fn modal_mass_is_positive_and_what_the_layout_says() {
    let error = spoilt(free_free(3), FreeFree::check, |body| body.mode_mode_moment[2][2][1][1] += 1.0);
    assert_eq!((error.field, error.index.as_slice()), ("mode_mode_moment", &[2, 2][..]));
    assert!((error.found - 2.0).abs() < 1e-12, "{error}");
    let error = spoilt(free_free(3), FreeFree::check, |body| body.mode_mode_moment[0][1][1][1] += 0.5);
    assert_eq!((error.field, error.index.as_slice()), ("mode_mode_moment", &[0, 1][..]));
    assert!((error.found - 0.5).abs() < 1e-12, "{error}");

    let error = spoilt(axes(), Axes::check, |body| {
        body.mode_mode_moment[0][1][2] = 0.0;
        body.mode_mode_moment[1][0][2] = 0.0;
    });
    is_at(error, "mode_mode_moment", &[0, 1], 0.2);
    assert!(error.to_string().contains("declares Θ_ff diagonal"), "{error}");
    let error = spoilt(axes(), Axes::check, |body| body.mode_mode_moment[1][0][2] = 0.2);
    is_at(error, "mode_mode_moment", &[1, 0, 2], 0.2);

    let error = spoilt(general(3), General::check, |body| body.mode_mode_moment[1][1] = [[0.0; 3]; 3]);
    is_at(error, "mode_mode_moment", &[1, 1], 0.0);
    // The third mode is the first once more.
    let error = spoilt(general(3), General::check, |body| {
        body.mode_mode_moment[2] = body.mode_mode_moment[0];
        for row in &mut body.mode_mode_moment {
            row[2] = row[0];
        }
    });
    assert_eq!((error.field, error.index.as_slice()), ("mode_mode_moment", &[2, 2][..]));
    assert!(error.found.abs() < 1e-14, "{error}");

    let error = spoilt(own_mass(), OwnMass::check, |body| body.modal_mass[1][0] = -0.2);
    is_at(error, "modal_mass", &[1, 0], -0.2);
    let error = spoilt(own_mass(), OwnMass::check, |body| body.modal_mass[0][0] = -1.0);
    is_at(error, "modal_mass", &[0, 0], -1.0);
}

#[test]
fn stiffness_and_damping() {
    let error = spoilt(general(3), General::check, |body| body.stiffness[2][2] = -1.0);
    is_at(error, "stiffness", &[2, 2], -1.0);
    let error = spoilt(general(3), General::check, |body| body.stiffness[1][0] += 1.0);
    is_at(error, "stiffness", &[1, 0], general(3).stiffness[1][0] + 1.0);
    let error = spoilt(general(3), General::check, |body| body.damping[2][0] = 1.0);
    is_at(error, "damping", &[2, 0], 1.0);
    let error = spoilt(free_free(3), FreeFree::check, |body| body.damping[1] = -1e-3);
    is_at(error, "damping", &[1], -1e-3);
    assert_eq!(error.to_string(), "damping[1]: found -0.001, expected a number that is not negative");
    let error = spoilt(generic(3), Generic::check, |body| body.stiffness[0][0] = -3.0);
    is_at(error, "stiffness", &[0, 0], -3.0);
}

#[test]
fn fields_that_contradict_each_other_show_in_the_mass_matrix() {
    // The second mode is the translation along x of a body of mass m.
    let error = spoilt(general(3), General::check, |body| {
        let (mass, first) = (body.mass, body.first_moment);
        body.modal_first_moment[1] = [mass, 0.0, 0.0];
        body.position_mode_moment[1] = first.map(|x| [x, 0.0, 0.0]);
        for mu in [0, 2] {
            let moment = body.modal_first_moment[mu];
            body.mode_mode_moment[mu][1] = moment.map(|x| [x, 0.0, 0.0]);
            body.mode_mode_moment[1][mu] = [moment, [0.0; 3], [0.0; 3]];
        }
        body.mode_mode_moment[1][1] = [[mass, 0.0, 0.0], [0.0; 3], [0.0; 3]];
    });
    assert_eq!((error.field, error.index.as_slice()), ("mass_matrix", &[7, 7][..]));
    assert!(error.found.abs() < 1e-14, "{error}");
    // A centre of mass farther out than the second moment allows.
    let error = spoilt(general(3), General::check, |body| body.first_moment[0] *= 100.0);
    assert_eq!(error.field, "mass_matrix");
    assert!((3..6).contains(&error.index.as_slice()[0]) && error.found < 0.0, "{error}");
    let error = spoilt(single(3), Single::check, |body| body.modal_first_moment[2] = [50.0, 0.0, 0.0]);
    assert_eq!((error.field, error.index.as_slice()), ("mass_matrix", &[8, 8][..]));
    assert!(error.found < -1.0, "{error}");
}
