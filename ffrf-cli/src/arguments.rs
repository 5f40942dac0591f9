//! The command line.

mod budget;
mod code;
mod convert;
mod export;
mod interfaces;
mod linearise;
mod material;
mod sections;
mod simulate;
mod stiffening;
mod tradeoff;
mod view;

use std::path::PathBuf;

use clap::{ArgGroup, Args, Parser, Subcommand};
use ffrf_fe::import::{INFLATED_LIMIT, MassForm, SolidsMaterial};
use ffrf_fe::reduction::{Damping, DampingBand};
use ffrf_model::Units;

pub use budget::{Budget, Core, TargetIntegrator, TargetScalar};
pub use code::{Generate, ImplicitStages, Inspect};
pub use convert::Convert;
pub use export::{Export, ExportFmu, ExportFormat, FmiVersion};
pub use interfaces::{CouplingArgument, InterfaceArgument, InterfaceChoice};
pub use linearise::{Campbell, Linearise, StateChoice};
pub use sections::SectionArgument;
pub use simulate::Simulate;
pub use stiffening::StiffeningChoice;
pub use tradeoff::{NamedModel, OnTarget, Plan, Tradeoff, parse_fidelity, parse_integrator, parse_scalar};
pub use view::View;

/// Flexible-body dynamics from finite-element models: reduce, inspect, generate, evaluate, verify, simulate, linearise.
#[derive(Debug, Parser)]
#[command(name = "ffrf", version, max_term_width = 100, arg_required_else_help = true)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The subcommands.
#[derive(Debug, Subcommand)]
#[allow(clippy::large_enum_variant)] // there is one, once
pub enum Command {
    /// Reduce a finite-element model to a flexible body (*.ffrf.json).
    #[command(after_help = REDUCE_EXAMPLE)]
    Reduce(Reduce),
    /// Convert a reduced body to or from the format of another multibody program: MBDyn's modal data (*.fem), standard input data (*.SID_FEM).
    #[command(after_help = CONVERT_EXAMPLE)]
    Convert(Convert),
    /// Show what a reduced body holds: modes, checks, layout, operation counts.
    #[command(after_help = INSPECT_EXAMPLE)]
    Inspect(Inspect),
    /// Print the Rust code that the macro makes of a reduced body.
    #[command(after_help = GENERATE_EXAMPLE)]
    Generate(Generate),
    /// Evaluate the kernels of a reduced body at given states.
    #[command(after_help = EVALUATE_EXAMPLE)]
    Evaluate(Evaluate),
    /// Check the kernels of a reduced body against the finite-element model, node by node.
    #[command(after_help = VERIFY_EXAMPLE)]
    Verify(Verify),
    /// Simulate a mechanism from a scene file, without a compiler.
    #[command(after_help = SIMULATE_EXAMPLE)]
    Simulate(Simulate),
    /// Export a scene for other tools.
    Export(Export),
    /// Linearise a mechanism: state of rest, A, B, C, D, eigenfrequencies and damping, frequency response.
    #[command(visible_alias = "linearize", after_help = LINEARISE_EXAMPLE)]
    Linearise(Linearise),
    /// Eigenfrequencies and whirl of a mechanism against the speed at which it turns.
    #[command(after_help = CAMPBELL_EXAMPLE)]
    Campbell(Campbell),
    /// What a body or a mechanism takes of a microcontroller: flash, RAM, stack, instructions of a step.
    #[command(after_help = BUDGET_EXAMPLE)]
    Budget(Budget),
    /// Run a scene in many configurations (modes, fidelity, scalar, integrator, step): errors against cost.
    #[command(after_help = TRADEOFF_EXAMPLE)]
    Tradeoff(Tradeoff),
    /// Choose modes, terms, scalar, integrator and step of a scene for an error that is allowed, and say why.
    #[command(after_help = PLAN_EXAMPLE)]
    Plan(Plan),
    /// Show a body with its modes and markers, or a motion, in a browser.
    #[command(after_help = VIEW_EXAMPLE)]
    View(View),
}

const VIEW_EXAMPLE: &str = "\
Examples:
  ffrf view rod.ffrf.json --surface rod.npz -o rod.html --sheet rod_modes.svg
  ffrf simulate slider_crank.toml -o run.csv --animation run.glb && ffrf view run.glb -o run.html";

const BUDGET_EXAMPLE: &str = "\
Examples:
  ffrf budget models/conrod.ffrf.json --modes 4 --target cortex-m4f --scalar f32
  ffrf budget models/scenes/slider_crank.toml --integrator linearly_implicit

Builds and runs programs: needs cargo with the target thumbv7em-none-eabihf, and qemu-system-arm.";

const PLAN_EXAMPLE: &str = "\
Examples:
  ffrf plan slider_crank.toml --error 1e-3
  ffrf plan slider_crank.toml --error 1e-2 --quantity reaction --scalar f64 --measure";

const TRADEOFF_EXAMPLE: &str = "\
Examples:
  ffrf tradeoff slider_crank.toml -o sweep
  ffrf tradeoff slider_crank.toml -o sweep --modes 0,2,4 --integrator rk4,dopri5 --step 1e-5,1e-6 --quantity reaction";

const LINEARISE_EXAMPLE: &str = "\
Examples:
  ffrf linearise crane.toml
  ffrf linearise crane.toml -o crane.npz --response crane.csv --frequencies 0.1,100,400
  ffrf linearise crane.toml --at initial -o crane.mat";

const CAMPBELL_EXAMPLE: &str = "\
Example:
  ffrf campbell rotor.toml --spin rotor --speeds 0,2000,41 -o rotor.csv --plot rotor.svg";

const SIMULATE_EXAMPLE: &str = "\
Examples:
  ffrf simulate pendulum.toml -o pendulum.csv
  ffrf simulate pendulum.toml --check
  ffrf simulate pendulum.toml -o first.csv --save-state middle.json";

const REDUCE_EXAMPLE: &str = "\
Examples:
  ffrf reduce --abaqus rod.inp --mass rod_MASS1.mtx --stiffness rod_STIF1.mtx --modes 8 \\
       --marker big_end=17 --damping-ratio 0.01 -o rod.ffrf.json
  ffrf reduce --calculix rod.inp --modes 6 --clamp FIXED -o rod.ffrf.json
  ffrf reduce rod.msh --material 7850,2.1e11,0.3 --modes 6 -o rod.ffrf.json
  ffrf reduce --calculix blade.inp --modes 6 --clamp ROOT --geometric-stiffness --stress notch=NOTCH \\
       --damping-bands 100:0.01,inf:0.1 -o blade.ffrf.json
  ffrf reduce --nodes X.txt --mass M.mtx --stiffness K.mtx --mode-shapes Psi.txt -o body.ffrf.json
  ffrf reduce --calculix rod.inp --interface HUB=set:BORE,rbe2 --interface PIN=set:SMALL,rbe3 \\
       --basis craig-bampton --modes 20 -o rod.ffrf.json";

const CONVERT_EXAMPLE: &str = "\
Examples:
  ffrf convert rod.ffrf.json -o rod.fem
  ffrf convert rod.fem --units SI -o rod.ffrf.json";

const INSPECT_EXAMPLE: &str = "\
Example:
  ffrf inspect rod.ffrf.json
  ffrf inspect rod.ffrf.json --modes 4 --fidelity linear";

const GENERATE_EXAMPLE: &str = "\
Examples:
  ffrf generate rod.ffrf.json --name Rod --modes 4 -o rod.rs
  ffrf generate rod.ffrf.json --scalar f32 --fidelity first_moment,modal_momentum,modal_rotation
  ffrf generate --layout first_moment=zero,modal_mass=identity --modes 3 --name Arm -o arm.rs

The flags are the keys of the macro, and give the same code.";

const EVALUATE_EXAMPLE: &str = "\
Example:
  echo '{\"states\":[{\"q\":[0,0],\"omega\":[0,0,1],\"q_dot\":[0,0],\"force\":[0,0,0,0,0,0,0,0]}]}' > states.json
  ffrf evaluate body.ffrf.json states.json -o out.json

All vectors are resolved in the body frame; force has 6 + M entries (force, moment, modal forces).
\"velocity\" (3 entries, that of the frame origin) is optional and enters the kinetic energy only.";

const VERIFY_EXAMPLE: &str = "\
Example:
  ffrf verify --nodes X.txt --mass M.mtx --stiffness K.mtx --mode-shapes Psi.txt body.ffrf.json

Give the files, units, mode choice and --elastic that `ffrf reduce` was given. With geometric stiffness of a slender part
that is clamped, static solutions keep fewer digits: --tolerance 1e-6.";

/// The files of a finite-element model.
#[derive(Debug, Args)]
#[command(next_help_heading = "Finite-element model")]
#[command(group = ArgGroup::new("node_table").required(true).args(["mesh", "nodes", "abaqus", "calculix", "nastran", "ansys"]))]
pub struct FeFiles {
    /// Mesh of gmsh (.msh) or VTK (.vtu) with solid elements, of which --material makes mass and stiffness; physical groups and
    /// marks of points and cells are node sets.
    #[arg(value_name = "PART.msh")]
    pub mesh: Option<PathBuf>,
    /// Density, Young's modulus and Poisson's ratio of the solids of the mesh, in its units: of all, or of a group of solids.
    /// Repeatable; one without GROUP is for all that no named group holds.
    #[arg(long = "material", value_name = "[GROUP=]RHO,E,NU", value_parser = material::parse, requires = "mesh", allow_hyphen_values = true,
          conflicts_with_all = ["mass", "stiffness", "elastic", "nodes", "abaqus", "calculix", "nastran", "ansys"])]
    pub materials: Vec<SolidsMaterial>,
    /// Node table, one line `x y z` per node (text or NumPy); nodes are numbered from 0.
    #[arg(long, value_name = "X.txt")]
    pub nodes: Option<PathBuf>,
    /// Abaqus input deck with the nodes; matrices from *MATRIX GENERATE.
    #[arg(long, value_name = "PART.inp")]
    pub abaqus: Option<PathBuf>,
    /// CalculiX input deck with the nodes; PART.mas, PART.sti and PART.dof are looked for beside it.
    #[arg(long, value_name = "PART.inp")]
    pub calculix: Option<PathBuf>,
    /// Nastran deck with the grid points; matrices from DMIG entries of a punch file, which may hold both.
    #[arg(long, value_name = "PART.bdf")]
    pub nastran: Option<PathBuf>,
    /// ANSYS node table `id x y z`; matrices from *SMAT or *DMAT in Matrix Market form.
    #[arg(long, value_name = "NODES.txt")]
    pub ansys: Option<PathBuf>,
    /// Mass matrix, 3N x 3N or scalar N x N.
    #[arg(long, value_name = "M.mtx")]
    pub mass: Option<PathBuf>,
    /// Stiffness matrix, 3N x 3N.
    #[arg(long, value_name = "K.mtx")]
    pub stiffness: Option<PathBuf>,
    /// ANSYS node-to-dof mapping vector.
    #[arg(long, value_name = "MAPPING.txt", conflicts_with_all = ["nodes", "abaqus", "calculix", "nastran"])]
    pub mapping: Option<PathBuf>,
    /// What a mass matrix holds whose file does not say it, such as a list without a header: `scalar` (one row a
    /// node) or `full` (three).
    #[arg(long, value_name = "FORM", value_parser = parse_mass_form, default_value = "declared", hide_default_value = true)]
    pub mass_form: MassForm,
    /// Accept nodes that have stiffness and no mass, or mass and no stiffness.
    #[arg(long)]
    pub allow_massless: bool,
    /// Largest size of a compressed file when inflated, in bytes.
    #[arg(long, value_name = "BYTES", default_value_t = INFLATED_LIMIT)]
    pub inflated_limit: u64,
    /// Which units the files are in: `SI`, or length, mass, time such as `mm,t,s` (default: not known).
    #[arg(long, value_name = "UNITS")]
    pub units: Option<Units>,
    /// Convert to these units.
    #[arg(long, value_name = "UNITS", requires = "units")]
    pub convert_to: Option<Units>,
}

/// Which modes.
#[derive(Debug, Args)]
#[command(next_help_heading = "Modes")]
pub struct ModeChoice {
    /// Your own mode shapes, 3N rows and M columns (text, Matrix Market or NumPy).
    #[arg(long, value_name = "Psi.txt", conflicts_with_all = ["modes", "clamp"])]
    pub mode_shapes: Option<PathBuf>,
    /// Number of elastic eigenmodes to compute.
    #[arg(long, value_name = "N")]
    pub modes: Option<usize>,
    /// Hold these nodes while computing the modes: a node set of the deck, or node ids separated by commas.
    #[arg(long, value_name = "SET")]
    pub clamp: Option<String>,
}

/// `ffrf reduce`
#[derive(Debug, Args)]
#[command(group = ArgGroup::new("mode_choice").required(true).args(["mode_shapes", "modes"]))]
pub struct Reduce {
    #[command(flatten)]
    pub files: FeFiles,
    #[command(flatten)]
    pub choice: ModeChoice,
    #[command(flatten)]
    pub interfaces: InterfaceChoice,
    #[command(flatten)]
    pub stiffening: StiffeningChoice,
    /// Modal stiffness matrix K_ff, M x M, in place of the projected stiffness (text, Matrix Market or NumPy).
    #[arg(long, value_name = "K_ff", help_heading = "Modes")]
    pub modal_stiffness: Option<PathBuf>,
    /// Damping ratio of all modes, or one per mode separated by commas.
    #[arg(
        long,
        value_name = "ZETA",
        value_delimiter = ',',
        allow_negative_numbers = true,
        conflicts_with_all = ["rayleigh", "damping_bands"]
    )]
    pub damping_ratio: Option<Vec<f64>>,
    /// Damping ratios by frequency: 1 % below 100 Hz, 10 % below 1 kHz, 100 % above; or your own, up to `inf`.
    #[arg(
        long,
        value_name = "HZ:ZETA,...,inf:ZETA",
        value_parser = parse_bands,
        num_args = 0..=1,
        default_missing_value = "100:0.01,1000:0.1,inf:1",
        conflicts_with = "rayleigh"
    )]
    pub damping_bands: Option<Damping>,
    /// Rayleigh damping D = ALPHA M + BETA K.
    #[arg(long, value_name = "ALPHA,BETA", allow_hyphen_values = true, value_parser = parse_pair)]
    pub rayleigh: Option<(f64, f64)>,
    /// A point to load and to observe: a node id (row number from 0 with --nodes), several separated by
    /// commas, or a node set of the deck. Repeatable.
    #[arg(long = "marker", value_name = "NAME=NODE", value_parser = parse_marker)]
    pub markers: Vec<MarkerArgument>,
    /// Where to observe stress: nodes as for --marker, whose mean is taken. Needs the elements of a deck and its *ELASTIC
    /// material or --elastic. Repeatable.
    #[arg(long = "stress", value_name = "NAME=NODE", value_parser = parse_marker)]
    pub stress: Vec<MarkerArgument>,
    /// Where to cut the part and observe the force and moment that go through: `plane:POINT,NORMAL`, six numbers. They are what the
    /// side of the normal exerts on the rest, about the point. Repeatable.
    #[arg(long = "section", value_name = "NAME=plane:POINT,NORMAL", value_parser = sections::parse_section)]
    pub sections: Vec<SectionArgument>,
    /// Write the surface with the displacements of the modes to this file, for animations (.npz); see `ffrf simulate
    /// --animation`.
    #[arg(long, value_name = "SURFACE.npz")]
    pub surface: Option<PathBuf>,
    /// Show the part with its modes and markers in one page for a browser (.html), or as a model (.glb). Needs elements.
    #[arg(long, value_name = "PART.html")]
    pub view: Option<PathBuf>,
    /// Draw the modes side by side (.svg), for documents. Needs elements.
    #[arg(long, value_name = "MODES.svg")]
    pub sheet: Option<PathBuf>,
    /// A line for people (default: name of the node file).
    #[arg(long)]
    pub title: Option<String>,
    /// Where to write the reduced body.
    #[arg(short, long, value_name = "BODY.ffrf.json")]
    pub output: PathBuf,
}

/// `ffrf evaluate`
#[derive(Debug, Args)]
pub struct Evaluate {
    /// The reduced body.
    #[arg(value_name = "MODEL")]
    pub model: PathBuf,
    /// The states, as JSON.
    #[arg(value_name = "STATES")]
    pub states: PathBuf,
    /// Where to write the results (default: standard output).
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// `ffrf verify`
#[derive(Debug, Args)]
pub struct Verify {
    /// The reduced body to check.
    #[arg(value_name = "MODEL")]
    pub model: PathBuf,
    #[command(flatten)]
    pub files: FeFiles,
    #[command(flatten)]
    pub choice: ModeChoice,
    /// Young's modulus and Poisson's ratio that `ffrf reduce --geometric-stiffness` was given.
    #[arg(long, value_name = "E,NU", value_parser = parse_pair, allow_hyphen_values = true)]
    pub elastic: Option<(f64, f64)>,
    /// Number of random states.
    #[arg(long, value_name = "COUNT", default_value_t = 8)]
    pub states: usize,
    /// Seed of the random states.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Largest deviation that passes, relative to the scale of each quantity.
    #[arg(long, default_value_t = 1e-12)]
    pub tolerance: f64,
}

/// `NAME=NODE`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MarkerArgument {
    /// What stands before `=`.
    pub name: String,
    /// What stands after it.
    pub nodes: String,
}

fn parse_marker(text: &str) -> Result<MarkerArgument, String> {
    let (name, nodes) = text.split_once('=').ok_or("expected NAME=NODE")?;
    if !ffrf_model::is_valid_marker_name(name) {
        return Err(format!("`{name}` is no marker name: letters, digits and underscores, a letter first"));
    }
    if nodes.is_empty() {
        return Err("expected a node after `=`".to_owned());
    }
    Ok(MarkerArgument { name: name.to_owned(), nodes: nodes.to_owned() })
}

fn parse_bands(text: &str) -> Result<Damping, String> {
    let number = |part: &str| part.trim().parse::<f64>().map_err(|error| format!("`{part}`: {error}"));
    let bands = text.split(',').map(|band| {
        let (below, ratio) = band.split_once(':').ok_or(format!("`{band}`: expected HZ:ZETA"))?;
        Ok(DampingBand { below: number(below)?, ratio: number(ratio)? })
    });
    Ok(Damping::Bands(bands.collect::<Result<_, String>>()?))
}

fn parse_mass_form(text: &str) -> Result<MassForm, String> {
    match text {
        "declared" => Ok(MassForm::Declared),
        "scalar" => Ok(MassForm::Scalar),
        "full" => Ok(MassForm::Full),
        _ => Err("expected `scalar` or `full`".to_owned()),
    }
}

fn parse_pair(text: &str) -> Result<(f64, f64), String> {
    let number = |part: &str| part.trim().parse::<f64>().map_err(|error| format!("`{part}`: {error}"));
    let (alpha, beta) = text.split_once(',').ok_or("expected two numbers, ALPHA,BETA")?;
    Ok((number(alpha)?, number(beta)?))
}

#[cfg(test)]
mod tests {
    use clap::{CommandFactory, Parser};

    use ffrf_fe::reduction::{Damping, DampingBand};

    use super::{Arguments, Command};

    #[test]
    fn the_command_line_is_consistent() {
        Arguments::command().debug_assert();
    }

    fn reduce(rest: &str) -> Result<super::Reduce, clap::Error> {
        let words = format!("ffrf reduce {rest}");
        match Arguments::try_parse_from(words.split(' '))?.command {
            Command::Reduce(reduce) => Ok(reduce),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn the_fixed_forms_are_understood() {
        let fixed = [
            "--nodes X.txt --mass M.mtx --stiffness K.mtx --mode-shapes Psi.txt -o body.ffrf.json",
            "--nodes X.txt --mass M.mtx --stiffness K.mtx --modes 8 -o body.ffrf.json",
            "--nodes X.txt --mass M.mtx --stiffness K.mtx --modes 8 --clamp SET -o body.ffrf.json",
            "--abaqus part.inp --mass M.mtx --stiffness K.mtx --modes 8 -o body.ffrf.json",
            "--calculix part.inp --modes 8 -o body.ffrf.json",
            "part.msh --material 7850,2.1e11,0.3 --modes 8 -o body.ffrf.json",
            "part.msh --material HUB=7850,2.1e11,0.3 --material 2700,7e10,0.33 --modes 8 -o body.ffrf.json",
            "part.msh --mass M.mtx --stiffness K.mtx --modes 8 -o body.ffrf.json",
            "--nastran part.bdf --mass part.pch --stiffness part.pch --modes 8 -o body.ffrf.json",
            "--ansys nodes.txt --mapping map.txt --mass M.mtx --stiffness K.mtx --modes 8 -o body.ffrf.json",
            "--nodes X.txt --mass M.mtx --modal-stiffness K_ff --mode-shapes Psi.txt -o body.ffrf.json",
        ];
        for form in fixed {
            reduce(form).unwrap_or_else(|error| panic!("{form}: {error}"));
        }
        let marked =
            reduce("--nodes X --mass M --modes 1 -o b --marker tip=4 --marker root=0 --title T").unwrap();
        assert_eq!(marked.markers.len(), 2);
        assert_eq!((marked.markers[1].name.as_str(), marked.markers[1].nodes.as_str()), ("root", "0"));
        assert_eq!(marked.title.as_deref(), Some("T"));
        let damped = reduce("--nodes X --mass M --modes 1 -o b --rayleigh 0.5,1e-5").unwrap();
        assert_eq!(damped.rayleigh, Some((0.5, 1e-5)));
        let damped = reduce("--nodes X --mass M --modes 1 -o b --damping-ratio 0.01,0.02").unwrap();
        assert_eq!(damped.damping_ratio, Some(vec![0.01, 0.02]));
        let damped = reduce("--nodes X --mass M --modes 1 --damping-bands -o b").unwrap();
        assert_eq!(damped.damping_bands, Some(Damping::common_bands()));
        let damped = reduce("--nodes X --mass M --modes 1 -o b --damping-bands 20:0.02,inf:0.5").unwrap();
        let band = |below, ratio| DampingBand { below, ratio };
        let bands = Damping::Bands(vec![band(20.0, 0.02), band(f64::INFINITY, 0.5)]);
        assert_eq!(damped.damping_bands, Some(bands));
    }

    #[test]
    fn contradictions_are_refused() {
        let refused = [
            "--mass M --modes 1 -o b",
            "--nodes X --abaqus p.inp --mass M --modes 1 -o b",
            "p.msh --abaqus p.inp --mass M --modes 1 -o b",
            "p.msh --material 7850,2.1e11 --modes 1 -o b",
            "p.msh --material =7850,2.1e11,0.3 --modes 1 -o b",
            "p.msh --material 7850,2.1e11,0.3 --mass M --modes 1 -o b",
            "--abaqus p.inp --material 7850,2.1e11,0.3 --modes 1 -o b",
            "--nodes X --mass M -o b",
            "--nodes X --mass M --modes 1",
            "--nodes X --mass M --modes 1 --mode-shapes P -o b",
            "--nodes X --mass M --clamp 1 --mode-shapes P -o b",
            "--nodes X --mass M --modes 1 -o b --rayleigh 1",
            "--nodes X --mass M --modes 1 -o b --rayleigh 1,1 --damping-ratio 0.1",
            "--nodes X --mass M --modes 1 -o b --damping-bands --damping-ratio 0.1",
            "--nodes X --mass M --modes 1 -o b --damping-bands 100,0.1",
            "--nodes X --mass M --modes 1 -o b --marker tip",
            "--nodes X --mass M --modes 1 -o b --marker 1=1",
            "--nodes X --mass M --modes 1 -o b --mapping map.txt",
            "--nodes X --mass M --modes 1 -o b --mass-form half",
            "--nodes X --mass M --modes 1 -o b --units mm",
            "--nodes X --mass M --modes 1 -o b --convert-to SI",
        ];
        for form in refused {
            assert_eq!(reduce(form).unwrap_err().exit_code(), 2, "{form}");
        }
    }
}
