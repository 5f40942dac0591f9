//! `ffrf generate`: the code that the macro makes, as text.

use std::fmt::Write;
use std::path::Path;

use anyhow::{Context, Result, bail};
use ffrf_codegen::{Fidelity, FusedMultiplyAdd, GenerateOptions, Language, Strategy};
use ffrf_host::scene::Scene;
use ffrf_model::{ModeSelection, ReducedBody};

use crate::arguments::{Generate, ImplicitStages};
use crate::output;

mod straight_line;

/// Runs the command.
pub fn run(arguments: &Generate) -> Result<()> {
    let default = GenerateOptions::default();
    let mut options = GenerateOptions {
        name: arguments.name.clone().unwrap_or(default.name),
        scalar: arguments.scalar,
        fidelity: arguments.fidelity.clone(),
        jacobians: arguments.jacobians,
        fused_multiply_add: arguments.fma,
        strategy: arguments.strategy,
        layout_tolerance: arguments.layout_tolerance,
        ..GenerateOptions::default()
    };
    let scene =
        arguments.model.as_deref().filter(|model| model.extension().is_some_and(|name| name == "toml"));
    let is_straight = scene.is_some() && arguments.language == Language::Rust;
    for (is_given, what) in [
        (arguments.implicit == ImplicitStages::On, "--implicit on"),
        (arguments.all_motions, "--all-motions"),
    ] {
        if is_given && !is_straight {
            bail!("{what}: expected a scene and --language rust");
        }
    }
    if let Some(scene) = scene {
        return mechanism(arguments, scene, options);
    }
    let code = match (&arguments.model, &arguments.layout, &arguments.modes) {
        (Some(model), _, modes) => {
            let body = ReducedBody::read(model)?;
            let source_name = model.file_name().map(|name| name.to_string_lossy().into_owned());
            options.source_name = source_name.unwrap_or_default();
            options.modes = modes.clone();
            if arguments.language == Language::C {
                return write_c(arguments, &body, &options).with_context(|| format!("{}", model.display()));
            }
            ffrf_codegen::generate(&body, &options).with_context(|| format!("{}", model.display()))?
        }
        (None, ..) if arguments.language == Language::C => {
            bail!("--language c: a model is expected, invariants at run time are for Rust")
        }
        (None, Some(layout), Some(ModeSelection::First(modes))) => {
            ffrf_codegen::generate_with_layout(*modes, layout, &options).context("--layout")?
        }
        (None, Some(_), Some(modes)) => {
            bail!("--modes {modes}: with --layout, the number of modes is expected")
        }
        (None, ..) => bail!("no invariants: give a model, or --layout and --modes"),
    };
    output::write(arguments.output.as_deref(), &code.text)
}

/// Writes source and header, or both as one text to standard output.
fn write_c(arguments: &Generate, body: &ReducedBody, options: &GenerateOptions) -> Result<()> {
    let code = ffrf_codegen::generate_c(body, options)?;
    write_both(arguments, [&code.header, &code.source, &code.single], &code.prefix)
}

/// The time step of a scene's mechanism in C.
fn mechanism(arguments: &Generate, path: &Path, options: GenerateOptions) -> Result<()> {
    if arguments.language != Language::C {
        return straight_line::run(arguments, path, options);
    }
    refuse_of_scenes(arguments)?;
    if arguments.fma == FusedMultiplyAdd::On {
        bail!("--fma on with a scene: expected auto or off");
    }
    let name = arguments.name.clone().unwrap_or_else(|| "Mechanism".to_owned());
    let options = GenerateOptions { name, ..options };
    let source_name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let scene = Scene::read(path).with_context(|| format!("{}", path.display()))?;
    let model = scene.mechanism_model(&source_name).with_context(|| format!("{}", path.display()))?;
    let code = ffrf_codegen::generate_mechanism_c(&model, &options)
        .with_context(|| format!("{}", path.display()))?;
    write_both(arguments, [&code.header, &code.source, &code.single], &code.prefix)
}

/// Refuses what a scene says itself.
fn refuse_of_scenes(arguments: &Generate) -> Result<()> {
    for (is_given, what, where_) in [
        (arguments.modes.is_some(), "--modes", "`modes` of the bodies in the scene"),
        (arguments.fidelity != Fidelity::default(), "--fidelity", "`fidelity` of the bodies in the scene"),
        (arguments.jacobians, "--jacobians", "none: a step needs no Jacobians"),
        (arguments.strategy == Strategy::Lanes, "--strategy lanes", "auto or straight_line"),
    ] {
        if is_given {
            bail!("{what} with a scene: expected {where_}");
        }
    }
    Ok(())
}

fn write_both(arguments: &Generate, [header, text, single]: [&str; 3], prefix: &str) -> Result<()> {
    let Some(source) = arguments.output.as_deref() else { return output::write(None, single) };
    if source.extension().is_none_or(|extension| extension != "c") {
        bail!(
            "-o {}: expected the name of a source, NAME.c; {}.h is written beside it",
            source.display(),
            prefix
        );
    }
    output::write(Some(&source.with_file_name(format!("{prefix}.h"))), header)?;
    output::write(Some(source), text)
}

/// The layout found in a body and the operations of each kernel.
pub fn account(body: &ReducedBody, options: &GenerateOptions) -> Result<String> {
    let report = ffrf_codegen::generate(body, options)?.report;
    let mut text = String::from("layout found\n");
    for (invariant, structure) in report.layout.entries() {
        let _ = writeln!(text, "  {:<28}{structure}", invariant.name());
    }
    text.push_str("\noperations per call\n");
    for kernel in &report.kernels {
        let _ = writeln!(text, "  {:<28}{}", kernel.name, kernel.counts);
    }
    if let Some(lanes) = &report.lanes {
        let _ =
            writeln!(text, "\noperations per call of the kernels in loops ({lanes}), counted as statements");
        let statements = GenerateOptions { strategy: Strategy::StraightLine, ..options.clone() };
        let all = ffrf_codegen::generate(body, &statements)?.report.kernels;
        let printed = |name: &str| report.kernels.iter().any(|kernel| kernel.name == name);
        for kernel in all.iter().filter(|kernel| !printed(kernel.name)) {
            let _ = writeln!(text, "  {:<28}{}", kernel.name, kernel.counts);
        }
    }
    Ok(text)
}
