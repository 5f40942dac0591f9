//! What the generated code depends on: the flags of `ffrf generate` and `ffrf inspect`, named as in the macro.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{ArgAction, Args, ValueEnum};
use ffrf_codegen::layout::Layout;
use ffrf_codegen::{DEFAULT_LAYOUT_TOLERANCE, Fidelity, FusedMultiplyAdd, Language, ScalarType, Strategy};
use ffrf_model::ModeSelection;

/// `ffrf inspect`
#[derive(Debug, Args)]
pub struct Inspect {
    /// The reduced body.
    #[arg(value_name = "MODEL")]
    pub model: PathBuf,
    /// Use these modes only: the first N, a range A..B or a list A,B,C (from 0).
    #[arg(long, value_name = "N|A..B|A,B,C")]
    pub modes: Option<ModeSelection>,
    /// Which terms of the kinetic energy are kept: rigid, constant, linear, unstiffened, full, or a list of terms (default: the level
    /// with most terms that the body has).
    #[arg(long, value_name = "LEVEL|TERM,TERM,...")]
    pub fidelity: Option<Fidelity>,
    /// Below which size, relative to its Gram scale, an entry of an invariant counts as zero.
    #[arg(long, value_name = "X", default_value_t = DEFAULT_LAYOUT_TOLERANCE, value_parser = parse_tolerance)]
    pub layout_tolerance: f64,
}

/// When linearly implicit stages are printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ImplicitStages {
    /// Where the integrator of the scene has them.
    Auto,
    /// Always.
    On,
    /// Never.
    Off,
}

/// `ffrf generate`
#[derive(Debug, Args)]
pub struct Generate {
    /// The reduced body, or a scene SCENE.toml: in Rust its bodies, its mechanism and accelerations in straight-line code, in C
    /// the time step of its mechanism.
    #[arg(value_name = "MODEL", required_unless_present = "layout")]
    pub model: Option<PathBuf>,
    /// Name of the generated type (default: Body, or Mechanism for a scene).
    #[arg(long)]
    pub name: Option<String>,
    /// Use these modes of the model only: the first N, a range A..B or a list A,B,C (from 0); with --layout, the
    /// number of modes.
    #[arg(long, value_name = "N|A..B|A,B,C")]
    pub modes: Option<ModeSelection>,
    /// In place of a model: the invariants come at run time, with these structures. What is not named is as general
    /// as it can be.
    #[arg(
        long,
        value_name = "INVARIANT=STRUCTURE,...",
        requires = "modes",
        conflicts_with_all = ["model", "layout_tolerance"]
    )]
    pub layout: Option<Layout>,
    /// Rust, or portable C99: a source and, beside it, a header called after the name of the type.
    #[arg(long, default_value = "rust", value_parser = named(Language::ALL.map(Language::name), Language::from_name))]
    pub language: Language,
    /// Scalar type of all kernels.
    #[arg(long, default_value = "f64", value_parser = named(ScalarType::ALL.map(ScalarType::name), ScalarType::from_name))]
    pub scalar: ScalarType,
    /// Which terms of the kinetic energy are kept: rigid, constant, linear, unstiffened, full, or a list of terms.
    #[arg(long, value_name = "LEVEL|TERM,TERM,...", default_value = "full")]
    pub fidelity: Fidelity,
    /// Implement FlexibleBodyJacobians as well.
    #[arg(long, action = ArgAction::SetTrue)]
    pub jacobians: bool,
    /// Straight-line code or loops over lanes of modes.
    #[arg(long, default_value = "auto", value_parser = named(Strategy::ALL.map(Strategy::name), Strategy::from_name))]
    pub strategy: Strategy,
    /// Whether products and sums are contracted.
    #[arg(long, default_value = "auto", value_parser = named(FusedMultiplyAdd::ALL.map(FusedMultiplyAdd::name), FusedMultiplyAdd::from_name))]
    pub fma: FusedMultiplyAdd,
    /// Whether a scene in Rust has its linearly implicit stages in straight-line code as well: auto is on where the integrator
    /// of the scene has such stages (linearly_implicit, linearly_implicit_euler, generalized_alpha, radau5, radau7).
    #[arg(long, value_name = "WHEN", default_value = "auto")]
    pub implicit: ImplicitStages,
    /// Straight-line code of a scene for all states, also those that its own motion does not lead to, as out of its plane
    /// (default: what is zero in the scene and stays so is a constant in the code; elsewhere the equations are solved).
    #[arg(long, action = ArgAction::SetTrue)]
    pub all_motions: bool,
    /// Below which size, relative to its Gram scale, an entry of an invariant counts as zero.
    #[arg(long, value_name = "X", default_value_t = DEFAULT_LAYOUT_TOLERANCE, value_parser = parse_tolerance)]
    pub layout_tolerance: f64,
    /// Where to write the code (default: standard output).
    #[arg(short, long, value_name = "OUT.rs|OUT.c")]
    pub output: Option<PathBuf>,
}

/// One of `names`, which are all that `from_name` knows.
fn named<T: Clone + Send + Sync + 'static, const COUNT: usize>(
    names: [&'static str; COUNT],
    from_name: fn(&str) -> Option<T>,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(names)
        .try_map(move |name| from_name(&name).ok_or("not among the possible values"))
}

pub(super) fn parse_tolerance(text: &str) -> Result<f64, String> {
    let tolerance: f64 = text.parse().map_err(|error| format!("{error}"))?;
    if (0.0..1.0).contains(&tolerance) {
        return Ok(tolerance);
    }
    Err("expected a relative tolerance from 0 to below 1, like 1e-13".to_owned())
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;
    use crate::arguments::{Arguments, Command};

    fn generate(rest: &str) -> Result<Generate, String> {
        let words = format!("ffrf generate {rest}");
        match Arguments::try_parse_from(words.split(' ')).map_err(|error| error.to_string())?.command {
            Command::Generate(generate) => Ok(generate),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn the_defaults_are_those_of_the_generator() {
        let default = ffrf_codegen::GenerateOptions::default();
        let found = generate("body.ffrf.json").unwrap();
        assert_eq!((found.name, found.modes, found.scalar), (None, default.modes, default.scalar));
        assert_eq!((found.fidelity, found.jacobians), (default.fidelity, default.jacobians));
        assert_eq!((found.strategy, found.fma), (default.strategy, default.fused_multiply_add));
        assert_eq!(found.layout_tolerance, default.layout_tolerance);
        assert_eq!(found.language, Language::default());
    }

    #[test]
    fn mistakes_are_answered_with_what_is_known() {
        let cases = [
            ("b --scalar f16", "[possible values: f64, f32, generic]"),
            ("b --strategy fast", "[possible values: auto, straight_line, lanes]"),
            ("b --fma maybe", "[possible values: auto, on, off]"),
            ("b --language fortran", "[possible values: rust, c]"),
            (
                "b --fidelity quadratic",
                "rigid, constant, linear, unstiffened, full, or a list of terms (translation, ",
            ),
            ("b --fidelity first_moment,spin", "unknown energy term `spin`: expected translation, "),
            ("b --layout-tolerance 2", "from 0 to below 1"),
            (
                "--layout third=zero --modes 2",
                "unknown invariant `third`, expected one of: mass, first_moment",
            ),
            ("--layout damping=red --modes 2", "expected one of: zero, identity, diagonal"),
            ("--layout damping=zero", "--modes <N|A..B|A,B,C>"),
            ("b --modes 5..2", "`5..2` has no modes"),
            ("b --modes 1,x", "`[0, 2, 5]` for a list"),
            ("b --layout damping=zero --modes 2", "cannot be used with"),
            ("--layout damping=zero --modes 2 --layout-tolerance 0", "cannot be used with"),
            ("--modes 2", "<MODEL>"),
        ];
        for (words, expected) in cases {
            let message = generate(words).unwrap_err();
            assert!(message.contains(expected), "{words}: {message}");
        }
    }
}
