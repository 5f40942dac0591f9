//! The same choices in the words of each door: the macro's fields, the command line's flags, the generator's options.
//!
//! `ffrf-macros` tests that the macro expands to what the generator makes of the options, `ffrf-cli/tests/commands/doors.rs` that
//! the command prints the same text.

use ffrf_codegen::invariants::{Invariant, Structure};
use ffrf_codegen::layout::Layout;
use ffrf_codegen::{Fidelity, FusedMultiplyAdd, GenerateOptions, ScalarType, Strategy};
use ffrf_model::ModeSelection;

/// The model that the doors open, in the folder `models`.
pub const MODEL: &str = "conrod.ffrf.json";

/// One choice.
pub struct Door {
    /// Fields of the macro behind `model` or `layout`.
    pub fields: &'static str,
    /// Flags of `ffrf generate` behind the model.
    pub flags: &'static str,
    /// The options that both mean.
    pub options: GenerateOptions,
}

fn named() -> GenerateOptions {
    GenerateOptions { name: "Part".to_owned(), ..GenerateOptions::default() }
}

fn terms(names: &[&str]) -> Fidelity {
    Fidelity::Terms(
        ffrf_codegen::fidelity::EnergyTerm::ALL
            .into_iter()
            .filter(|term| names.contains(&term.name()))
            .collect(),
    )
}

/// Every option alone, and several at once; the model of [`MODEL`].
pub fn with_model() -> Vec<Door> {
    let model = || GenerateOptions { source_name: MODEL.to_owned(), ..named() };
    let door = |fields, flags, options| Door { fields, flags, options };
    vec![
        door("", "", model()),
        door("modes: ..2", "--modes 2", GenerateOptions { modes: Some(2.into()), ..model() }),
        door(
            "modes: 1..3",
            "--modes 1..3",
            GenerateOptions { modes: Some(ModeSelection::Range(1, 3)), ..model() },
        ),
        door(
            "modes: [3, 0]",
            "--modes 3,0",
            GenerateOptions { modes: Some(ModeSelection::Listed(vec![3, 0])), ..model() },
        ),
        door("scalar: f32", "--scalar f32", GenerateOptions { scalar: ScalarType::F32, ..model() }),
        door("scalar: f64", "--scalar f64", model()),
        door(
            "scalar: generic, modes: ..2",
            "--scalar generic --modes 2",
            GenerateOptions { scalar: ScalarType::Generic, modes: Some(2.into()), ..model() },
        ),
        door("fidelity: rigid", "--fidelity rigid", GenerateOptions { fidelity: Fidelity::Rigid, ..model() }),
        door(
            "fidelity: constant",
            "--fidelity constant",
            GenerateOptions { fidelity: Fidelity::Constant, ..model() },
        ),
        door(
            "fidelity: linear",
            "--fidelity linear",
            GenerateOptions { fidelity: Fidelity::Linear, ..model() },
        ),
        door("fidelity: full", "--fidelity full", model()),
        door(
            "fidelity: [modal_rotation, first_moment]",
            "--fidelity modal_rotation,first_moment",
            GenerateOptions { fidelity: terms(&["first_moment", "modal_rotation"]), ..model() },
        ),
        door("fidelity: []", "--fidelity []", GenerateOptions { fidelity: terms(&[]), ..model() }),
        door(
            "modes: ..2, jacobians: true",
            "--modes 2 --jacobians",
            GenerateOptions { modes: Some(2.into()), jacobians: true, ..model() },
        ),
        door(
            "strategy: straight_line",
            "--strategy straight_line",
            GenerateOptions { strategy: Strategy::StraightLine, ..model() },
        ),
        door(
            "modes: ..2, strategy: lanes",
            "--modes 2 --strategy lanes",
            GenerateOptions { modes: Some(2.into()), strategy: Strategy::Lanes, ..model() },
        ),
        door("fma: on", "--fma on", GenerateOptions { fused_multiply_add: FusedMultiplyAdd::On, ..model() }),
        door(
            "fma: off",
            "--fma off",
            GenerateOptions { fused_multiply_add: FusedMultiplyAdd::Off, ..model() },
        ),
        door(
            "layout_tolerance: 1e-3",
            "--layout-tolerance 1e-3",
            GenerateOptions { layout_tolerance: 1e-3, ..model() },
        ),
        door(
            "modes: ..3, scalar: f32, fidelity: linear, jacobians: true, fma: off, layout_tolerance: 1e-9",
            "--modes 3 --scalar f32 --fidelity linear --jacobians --fma off --layout-tolerance 1e-9",
            GenerateOptions {
                modes: Some(3.into()),
                scalar: ScalarType::F32,
                fidelity: Fidelity::Linear,
                jacobians: true,
                fused_multiply_add: FusedMultiplyAdd::Off,
                layout_tolerance: 1e-9,
                ..model()
            },
        ),
    ]
}

/// Invariants at run time: number of modes and layout come with the options.
pub fn with_layout() -> Vec<(usize, Layout, Door)> {
    let general = Layout::GENERAL;
    let special = general
        .with(Invariant::FirstMoment, Structure::Zero)
        .with(Invariant::PositionModeMoment, Structure::Symmetric)
        .with(Invariant::ModalMass, Structure::Identity);
    let own_mass = general.with(Invariant::ModeModeMoment, Structure::Zero);
    vec![
        (2, general, Door { fields: "modes: 2, layout: {}", flags: "--modes 2 --layout=", options: named() }),
        (
            3,
            special,
            Door {
                fields: "modes: 3, fma: off, layout: { first_moment: zero, position_mode_moment: symmetric, modal_mass: identity }",
                flags: "--modes 3 --fma off --layout first_moment=zero,position_mode_moment=symmetric,modal_mass=identity",
                options: GenerateOptions { fused_multiply_add: FusedMultiplyAdd::Off, ..named() },
            },
        ),
        (
            1,
            own_mass,
            Door {
                fields: "modes: 1, layout: { mode_mode_moment: zero }, fidelity: constant, scalar: f32",
                flags: "--modes 1 --layout mode_mode_moment=zero --fidelity constant --scalar f32",
                options: GenerateOptions { fidelity: Fidelity::Constant, scalar: ScalarType::F32, ..named() },
            },
        ),
    ]
}
