//! Component modes of a solid block of any size: seconds and memory of each phase (`benches/large_fe.sh`).
//!
//! `cargo run --release -p ffrf-fe --example large_part -- [--dofs 100000] [--proportions 4x2x1] [--element hex8|tet10]
//! [--interfaces 3] [--modes 20] [--basis craig-bampton|attachment|rubin|herting] [--coupling rbe2|rbe3] [--threads 2]
//! [--write FOLDER] [--no-solve]`. With `--write`, K, M_s, the positions and the rows of the interfaces are written as plain
//! arrays for other programs.

#[path = "../measured/mod.rs"]
mod measured;
mod mesh;

use std::error::Error;
use std::fs;
use std::path::PathBuf;
use std::time::Instant;

use ffrf_fe::component_modes::{ComponentBasis, ComponentRequest, Interface, component_modes};

use measured::{Phases, peak_megabytes, write_indices, write_matrix, write_numbers};

struct Options {
    dofs: usize,
    proportions: [usize; 3],
    is_tetrahedral: bool,
    interfaces: usize,
    modes: usize,
    basis: ComponentBasis,
    is_rigid: bool,
    threads: usize,
    write: Option<PathBuf>,
    solve: bool,
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = parse()?;
    let start = Instant::now();
    let model = if options.is_tetrahedral {
        mesh::tetrahedra(mesh::divisions(options.dofs, options.proportions, 2))?
    } else {
        mesh::hexahedra(mesh::divisions(options.dofs, options.proportions, 1))?
    };
    let entries = model.stiffness.as_ref().map_or(0, |stiffness| stiffness.compute_nnz());
    println!("dofs {}", 3 * model.nodes.len());
    println!("{} elements, {entries} entries of K", model.elements.len());
    println!("assembly {:.2} s, peak memory {:.0} MB", start.elapsed().as_secs_f64(), peak_megabytes());
    let patches = mesh::patches(&model, options.interfaces);
    if let (Some(folder), Some(stiffness)) = (&options.write, &model.stiffness) {
        fs::create_dir_all(folder)?;
        write_matrix(folder, "K", stiffness)?;
        write_matrix(folder, "M", &model.mass)?;
        write_numbers(&folder.join("positions"), model.nodes.positions.as_flattened())?;
        for (number, (_, rows)) in patches.iter().enumerate() {
            write_indices(&folder.join(format!("interface{number}")), rows)?;
        }
    }
    if !options.solve {
        return Ok(());
    }
    let mut interfaces = Vec::new();
    for (name, rows) in &patches {
        let interface = Interface::rigid(&model, name, rows)?;
        println!("interface {name}: {} nodes", rows.len());
        interfaces.push(if options.is_rigid { interface } else { interface.averaged() });
    }
    let request = ComponentRequest {
        basis: options.basis,
        threads: options.threads,
        ..ComponentRequest::craig_bampton(interfaces, options.modes)
    };
    let mut phases = Phases::begin();
    let (start, start_of_work) = (Instant::now(), processor_seconds());
    let modes = component_modes(&model, &request, &mut |progress| phases.enter(progress))?;
    let seconds = start.elapsed().as_secs_f64();
    phases.close();
    println!("{}", modes.report.method);
    println!("modes {}", modes.basis.modes.len());
    println!("orthogonality_error {:.1e}", modes.report.orthogonality_error);
    println!("compliance_kept {}", modes.report.compliance_kept);
    println!("solve_seconds {seconds:.3}");
    println!("processor_seconds {:.2}", processor_seconds() - start_of_work);
    println!("peak_megabytes {:.1}", peak_megabytes());
    for normal in &modes.report.normal {
        println!("normal_hz {:?}", normal.frequency_hz);
    }
    for mode in &modes.basis.modes {
        println!("frequency_hz {:?}", mode.frequency_hz.unwrap_or(f64::NAN));
    }
    Ok(())
}

fn parse() -> Result<Options, Box<dyn Error>> {
    let mut options = Options {
        dofs: 100_000,
        proportions: [4, 2, 1],
        is_tetrahedral: false,
        interfaces: 3,
        modes: 20,
        basis: ComponentBasis::CraigBampton,
        is_rigid: true,
        threads: 2,
        write: None,
        solve: true,
    };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or(format!("{word} needs a value"));
        match word.as_str() {
            "--dofs" => options.dofs = value()?.parse()?,
            "--proportions" => {
                let parts: Vec<usize> = value()?.split('x').map(str::parse).collect::<Result<_, _>>()?;
                options.proportions =
                    parts.try_into().map_err(|_| "--proportions needs three numbers, as 4x2x1")?;
            }
            "--element" => options.is_tetrahedral = one_of(&value()?, [("hex8", false), ("tet10", true)])?,
            "--interfaces" => options.interfaces = value()?.parse()?,
            "--modes" => options.modes = value()?.parse()?,
            "--basis" => {
                options.basis = one_of(
                    &value()?,
                    [
                        ("craig-bampton", ComponentBasis::CraigBampton),
                        ("attachment", ComponentBasis::Attachment),
                        ("rubin", ComponentBasis::Rubin),
                        ("herting", ComponentBasis::Herting),
                    ],
                )?;
            }
            "--coupling" => options.is_rigid = one_of(&value()?, [("rbe2", true), ("rbe3", false)])?,
            "--threads" => options.threads = value()?.parse()?,
            "--write" => options.write = Some(value()?.into()),
            "--no-solve" => options.solve = false,
            _ => return Err(format!("unknown option {word}").into()),
        }
    }
    Ok(options)
}

fn one_of<T: Copy, const N: usize>(word: &str, choices: [(&str, T); N]) -> Result<T, String> {
    let found = choices.iter().find(|(name, _)| *name == word);
    found
        .map(|(_, value)| *value)
        .ok_or_else(|| format!("{word}: expected {:?}", choices.map(|(name, _)| name)))
}

/// Processor time of all threads so far, in Linux's ticks of 10 ms; 0 elsewhere.
fn processor_seconds() -> f64 {
    let status = fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // Behind the name, which may hold blanks, in brackets: user and system time are fields 14 and 15 of the line.
    let fields = status.rsplit(')').next().unwrap_or_default().split_whitespace().skip(11).take(2);
    fields.filter_map(|ticks| ticks.parse::<f64>().ok()).sum::<f64>() / 100.0
}
