//! The programs that are measured: a package of a library with the bodies and three binaries.

use std::fmt::Write;
use std::path::Path;

use anyhow::{Context, Result, bail};
use ffrf_codegen::{FusedMultiplyAdd, GenerateOptions, ScalarType, generate_array_function};
use ffrf_host::scene::Scene;
use ffrf_host::scene::file::{FidelityValue, SceneFile};
use ffrf_host::straight_line::{Motions, accelerations};
use ffrf_model::{ModeSelection, ReducedBody};

use super::mechanism_code;
use crate::arguments::{Budget, TargetIntegrator};

/// What is measured, as text.
pub struct Subject {
    /// What the report says of it.
    pub title: String,
    /// The library: bodies, and the mechanism if there is one.
    pub library: String,
    /// The binary that takes steps.
    pub step: String,
    /// The binary that calls every kernel; none for a mechanism.
    pub kernels: Option<String>,
}

/// Part of the largest stable step that the explicit method takes when nothing is said.
const PART_OF_STABLE_STEP: f64 = 0.5;
/// A usual tick of a controller. Units: s.
const TICK: f64 = 1e-3;

fn options(name: &str, scalar: ScalarType, layout_tolerance: f64) -> GenerateOptions {
    GenerateOptions {
        name: name.to_owned(),
        scalar,
        layout_tolerance,
        fused_multiply_add: FusedMultiplyAdd::Off,
        ..GenerateOptions::default()
    }
}

/// A single body.
pub fn body(arguments: &Budget, scalar: ScalarType) -> Result<Subject> {
    if arguments.straight_line {
        bail!("--straight-line with a model: expected a scene");
    }
    let Budget { file: path, modes, integrator, step, .. } = arguments;
    let (modes, integrator, step) = (*modes, *integrator, *step);
    let model = ReducedBody::read(path)?;
    let mut options = options("Body", scalar, arguments.layout_tolerance);
    options.modes = modes.map(ModeSelection::First);
    let code = ffrf_codegen::generate(&model, &options).with_context(|| format!("{}", path.display()))?;
    let count = modes.unwrap_or_else(|| model.mode_count());
    let (scalar, method) = (scalar.name(), method(integrator));
    let step_size = step.map_or_else(
        || match integrator {
            TargetIntegrator::RungeKutta => format!(
                "if Body::LARGEST_STABLE_STEP.is_finite() {{ {PART_OF_STABLE_STEP:?} * Body::LARGEST_STABLE_STEP }} else {{ {TICK:?} }}"
            ),
            TargetIntegrator::LinearlyImplicit => format!("{TICK:?}"),
        },
        |step| format!("{step:?}"),
    );
    Ok(Subject {
        title: format!("{}, {count} modes, {method}", path.display()),
        library: format!(
            "#![no_std]\npub type Scalar = {scalar};\npub const MODES: usize = {count};\npub const ALL: usize = 6 + MODES;\n\
             pub const STEP: f64 = {step_size};\n{}",
            code.text
        ),
        step: STEP_OF_BODY.replace("METHOD", method),
        kernels: Some(KERNELS.to_owned()),
    })
}

/// A mechanism, as a scene's file has it.
pub struct MechanismProgram<'a> {
    /// What the report says of it.
    pub title: String,
    /// The scene's file.
    pub file: &'a SceneFile,
    /// Where the files that it names are looked for.
    pub folder: &'a Path,
    /// Number type.
    pub scalar: ScalarType,
    /// Which step is counted.
    pub integrator: TargetIntegrator,
    /// Its size; that of the scene, or a usual tick, if nothing is said. Units: s.
    pub step: Option<f64>,
    /// See [`GenerateOptions`].
    pub layout_tolerance: f64,
    /// Whether its accelerations are straight-line code.
    pub straight_line: bool,
}

/// A mechanism.
pub fn scene(arguments: &Budget, scalar: ScalarType) -> Result<Subject> {
    let Budget { file: path, integrator, step, layout_tolerance, .. } = arguments;
    let file = SceneFile::read(path)?;
    mechanism(&MechanismProgram {
        title: format!(
            "{}, {}{}",
            path.display(),
            method(*integrator),
            if arguments.straight_line { ", accelerations in straight-line code" } else { "" }
        ),
        file: &file,
        folder: path.parent().unwrap_or_else(|| Path::new("")),
        scalar,
        integrator: *integrator,
        step: *step,
        layout_tolerance: *layout_tolerance,
        straight_line: arguments.straight_line,
    })
}

/// A mechanism from its parts. Errors: something in the scene has no counterpart in the macro.
pub fn mechanism(program: &MechanismProgram<'_>) -> Result<Subject> {
    let MechanismProgram { file, folder, scalar, integrator, layout_tolerance, .. } = *program;
    let scene = Scene::compose(file, folder)?;
    let name = scalar.name();
    let mut library = format!("#![no_std]\npub type Scalar = {name};\n");
    let (mut made, mut types): (Vec<(String, String)>, Vec<Option<String>>) = (Vec::new(), Vec::new());
    for (_, table) in &file.bodies {
        let Some(model) = &table.model else {
            types.push(None);
            continue;
        };
        let key = format!("{model} {:?} {:?}", table.modes, table.fidelity);
        if let Some((_, type_name)) = made.iter().find(|(known, _)| *known == key) {
            types.push(Some(type_name.clone()));
            continue;
        }
        let type_name = format!("Body{}", made.len());
        let mut options = options(&type_name, scalar, layout_tolerance);
        options.modes = table.modes.as_ref().map(|modes| modes.0.clone());
        if let Some(fidelity) = &table.fidelity {
            options.fidelity = match fidelity {
                FidelityValue::Level(level) => level.parse()?,
                FidelityValue::Terms(terms) => terms.join(",").parse()?,
            };
        }
        let code = ffrf_codegen::generate(&ReducedBody::read(folder.join(model))?, &options)?;
        let _ = writeln!(library, "{}", code.text);
        made.push((key, type_name.clone()));
        types.push(Some(type_name));
    }
    let function = program.straight_line.then_some("straight_line_accelerations");
    library.push_str(&mechanism_code::invocation(file, &scene, &types, name, function)?);
    if let Some(function) = function {
        if scalar != ScalarType::F64 || integrator != TargetIntegrator::RungeKutta {
            bail!(
                "--straight-line: expected --scalar f64 and --integrator rk4, which asks for accelerations"
            );
        }
        let accelerations = accelerations(&scene, &Motions::of(&scene)?, function)?;
        let code = generate_array_function(&accelerations, &GenerateOptions::default())?;
        library.push_str(&code.text);
    }
    let mut set = String::new();
    for (number, state) in scene.assembled()?.0.iter().enumerate() {
        let body = format!("state.body_{number}");
        let turn = &state.orientation;
        let parameters = [turn.w, turn.i, turn.j, turn.k];
        let _ = writeln!(
            set,
            "    {body}.position = Vector3::from({:?}.map(as_scalar));\n    {body}.velocity = Vector3::from({:?}.map(as_scalar));\n    \
             {body}.angular_velocity = Vector3::from({:?}.map(as_scalar));\n    \
             if let Some(orientation) = ffrf::rotation::from_euler_parameters({parameters:?}.map(as_scalar)) {{ {body}.orientation = orientation; }}",
            <[f64; 3]>::from(state.position),
            <[f64; 3]>::from(state.velocity),
            <[f64; 3]>::from(state.angular_velocity),
        );
        let (q, q_dot) = (state.modal_coordinates.0.as_slice(), state.modal_rates.0.as_slice());
        for (what, numbers) in [("modal_coordinates", q), ("modal_rates", q_dot)] {
            if numbers.iter().any(|number| *number != 0.0) {
                let _ = writeln!(
                    set,
                    "    {body}.{what} = ffrf::nalgebra::SVector::from({numbers:?}.map(as_scalar));"
                );
            }
        }
    }
    let flexible: Vec<&str> = types.iter().flatten().map(String::as_str).collect();
    let step_size = program.step.unwrap_or(match (scene.settings.step, integrator) {
        (ffrf_host::scene::StepChoice::Fixed(step), TargetIntegrator::RungeKutta) => step,
        _ => TICK,
    });
    let _ = writeln!(library, "pub const STEP: f64 = {step_size:?};");
    let step = STEP_OF_MECHANISM
        .replace("METHOD", method(integrator))
        .replace("ARGUMENTS", &flexible.join(", "))
        .replace("SET", &set);
    Ok(Subject { title: program.title.clone(), library, step, kernels: None })
}

fn method(integrator: TargetIntegrator) -> &'static str {
    match integrator {
        TargetIntegrator::RungeKutta => "step_rk4",
        TargetIntegrator::LinearlyImplicit => "step_linearly_implicit",
    }
}

/// Writes the package into `folder`; `sources` is where ffrf is.
pub fn write(subject: &Subject, folder: &Path, sources: &Path, opt_level: &str) -> Result<()> {
    let sources = sources.canonicalize().with_context(|| format!("--sources {}", sources.display()))?;
    let manifest = MANIFEST.replace("SOURCES", &sources.display().to_string()).replace(
        "LEVEL",
        &match opt_level {
            "s" | "z" => format!("\"{opt_level}\""),
            number => number.to_owned(),
        },
    );
    let lock = sources.join("firmware/Cargo.lock");
    let lock = std::fs::read_to_string(&lock).with_context(|| format!("{}", lock.display()))?;
    std::fs::create_dir_all(folder.join("src")).with_context(|| format!("{}", folder.display()))?;
    let binary = |text: &str| format!("{START}{text}");
    let files = [
        ("Cargo.toml", manifest),
        ("Cargo.lock", lock),
        ("build.rs", BUILD.to_owned()),
        ("src/lib.rs", subject.library.clone()),
        ("src/baseline.rs", binary(BASELINE)),
        ("src/step.rs", binary(&subject.step)),
        ("src/kernels.rs", binary(subject.kernels.as_deref().unwrap_or(BASELINE))),
    ];
    for (name, text) in files {
        let path = folder.join(name);
        ffrf_model::write_file(&path, text.as_bytes()).with_context(|| format!("{}", path.display()))?;
    }
    Ok(())
}

const MANIFEST: &str = include_str!("templates/Cargo.toml.txt");
const BUILD: &str = "fn main() {\n    println!(\"cargo:rustc-link-arg-bins=-Tlink.x\");\n}\n";
const START: &str = include_str!("templates/start.rs.txt");
const BASELINE: &str = include_str!("templates/baseline.rs.txt");
const STEP_OF_BODY: &str = include_str!("templates/step_of_body.rs.txt");
const KERNELS: &str = include_str!("templates/kernels.rs.txt");
const STEP_OF_MECHANISM: &str = include_str!("templates/step_of_mechanism.rs.txt");
