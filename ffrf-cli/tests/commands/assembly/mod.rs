//! Natural frequencies of mechanisms of reduced bodies against the whole finite-element assembly: by our own sparse matrices,
//! and by CalculiX where it is installed.
//!
//! `cargo test --workspace --test commands assembly -- --nocapture` prints the tables of `docs/assemblies.md`.

#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

mod calculix;
mod full;
mod structure;

use std::path::{Path, PathBuf};

use ffrf_fe::component_modes::{
    ComponentBasis, ComponentRequest, Interface, NodeSelection, component_modes, reduce_component_modes,
};
use ffrf_fe::elements::{Material, assemble, quadratic_brick};
use ffrf_fe::import::{ModelFiles, NodeSource, SolidsMaterial, read_model};
use ffrf_fe::reduction::ReductionOptions;
use ffrf_fe::{FeModel, Nodes};
use ffrf_host::analysis::{Drives, eigenmodes, linearise};
use ffrf_host::scene::Scene;
use ffrf_host::scene::file::SceneFile;

use structure::{Part, Structure};

/// Share of a frequency, for all up to half of the highest that the bases retain.
const WITHIN: f64 = 0.005;
/// Our sparse assembly against CalculiX, which prints seven digits and condenses rigid bodies as equations.
const SAME_MODEL: f64 = 2e-5;

fn models() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../models")
}

/// The model of other node positions; elements, sets and material stay.
fn moved(model: FeModel, material: &Material, to: impl Fn([f64; 3]) -> [f64; 3]) -> FeModel {
    let positions = model.nodes.positions.iter().map(|&at| to(at)).collect();
    assemble(Nodes { positions, ..model.nodes }, model.elements, material).unwrap()
}

fn read(nodes: NodeSource) -> FeModel {
    read_model(&ModelFiles { nodes, mass: None, stiffness: None }).unwrap()
}

/// Turned about z by `angle`, then shifted.
fn placed(angle: f64, shift: [f64; 3]) -> impl Fn([f64; 3]) -> [f64; 3] {
    let (sin, cos) = angle.sin_cos();
    move |[x, y, z]| [cos * x - sin * y + shift[0], sin * x + cos * y + shift[1], z + shift[2]]
}

/// The structure's parts with modes of a basis, `normal` of them normal ones, as models in a folder; the highest frequency that all
/// of them retain.
fn reduce(structure: &Structure, basis: ComponentBasis, normal: usize, folder: &Path) -> f64 {
    let mut highest = f64::INFINITY;
    for part in &structure.parts {
        let request =
            ComponentRequest { basis, ..ComponentRequest::craig_bampton(part.interfaces.clone(), normal) };
        let modes = component_modes(&part.model, &request, &mut |_| {}).unwrap();
        let retained = modes.report.normal.last().unwrap().frequency_hz;
        println!(
            "{}: {} nodes, {} modes, of them {normal} normal ones up to {retained:.0} Hz",
            part.name,
            part.model.nodes.len(),
            modes.basis.modes.len()
        );
        highest = highest.min(retained);
        let body = reduce_component_modes(&part.model, &modes, &ReductionOptions::default()).unwrap();
        std::fs::write(folder.join(format!("{}.ffrf.json", part.name)), body.to_json().unwrap()).unwrap();
    }
    highest
}

/// Compares the frequencies of a scene of reduced bodies with those of the assembly, up to half of the highest retained one.
fn compare(structure: &Structure, basis: ComponentBasis, normal: usize, scene: &str) {
    let folder = tempfile::tempdir().unwrap();
    let limit = 0.5 * reduce(structure, basis, normal, folder.path());
    let scene = Scene::compose(&SceneFile::parse(scene).unwrap(), folder.path()).unwrap();
    let (state, _) = scene.assembled().unwrap();
    let system = linearise(&scene, 0.0, &state, Drives::Held).unwrap();
    let reduced: Vec<f64> = eigenmodes(&system.a).unwrap().iter().map(|mode| mode.frequency_hz()).collect();
    let count = reduced.iter().take_while(|&&frequency| frequency < limit).count();
    assert!(count >= 5, "only {count} frequencies below {limit} Hz: {reduced:?}");
    let full = full::frequencies(structure, count + 1);
    // None is missing below the limit: the reduced model is never softer than the full one.
    assert!(full[count] > limit * (1.0 - WITHIN), "{} Hz is not among {reduced:?}", full[count]);
    let calculix = calculix::frequencies(structure, count);
    println!(
        "compared up to {limit:.0} Hz\n\n| mode | reduced/Hz | assembly/Hz | off by | CalculiX/Hz | off by |"
    );
    println!("| ---: | ---: | ---: | ---: | ---: | ---: |");
    for k in 0..count {
        // Not a number where CalculiX did not run.
        let other = calculix.as_ref().map_or(f64::NAN, |all| all[k]);
        println!(
            "| {} | {:.3} | {:.3} | {:+.4} % | {other:.3} | {:+.4} % |",
            k + 1,
            reduced[k],
            full[k],
            100.0 * (reduced[k] / full[k] - 1.0),
            100.0 * (reduced[k] / other - 1.0)
        );
    }
    for k in 0..count {
        let off = reduced[k] / full[k] - 1.0;
        assert!(off.abs() < WITHIN, "mode {}: {off}", k + 1);
        if let Some(calculix) = &calculix {
            let off = full[k] / calculix[k] - 1.0;
            assert!(off.abs() < SAME_MODEL, "mode {}: CalculiX is off by {off}", k + 1);
            assert!((reduced[k] / calculix[k] - 1.0).abs() < WITHIN, "mode {}", k + 1);
        }
    }
}

/// A shaft with two discs on two springy bearings; about its axis it is held by a spring at one end.
#[test]
fn the_rotor_on_bearings_vibrates_as_its_assembly_does() {
    let path = models().join("rotor/rotor.msh.gz");
    let model = read(NodeSource::Mesh { path, materials: SolidsMaterial::all(Material::STEEL) });
    let section = |name, x| {
        let plane = NodeSelection::Plane { point: [x, 0.0, 0.0], normal: [1.0, 0.0, 0.0], tolerance: 0.0 };
        Interface::rigid(&model, name, &plane.rows(&model.nodes).unwrap()).unwrap()
    };
    let interfaces = vec![section("LEFT", 0.04), section("RIGHT", 0.56)];
    let bearing = [1e8, 2e7, 3e7, 2e3];
    let springs = (0..2).flat_map(|end| {
        let motions = Structure::motions(0, end, &[0, 1, 2, 3]);
        motions.into_iter().zip(bearing).take(if end == 0 { 4 } else { 3 })
    });
    let springs: Vec<_> = springs.collect();
    let part = Part { name: "rotor", model, material: Material::STEEL, interfaces };
    let structure = Structure { parts: vec![part], springs, ..Structure::default() };
    let [kx, ky, kz, about] = bearing;
    let scene = format!(
        "[simulation]\nduration = 1.0\nstep = 1e-5\n[bodies.rotor]\nmodel = \"rotor.ffrf.json\"\n\
         [forces.left]\nkind = \"bushing\"\nfirst = \"ground\"\nfirst_position = [0.04, 0.0, 0.0]\nsecond = \"rotor.LEFT\"\n\
         stiffness_matrix = [{kx}, {ky}, {kz}, {about}, 0.0, 0.0]\n\
         [forces.right]\nkind = \"bushing\"\nfirst = \"ground\"\nfirst_position = [0.56, 0.0, 0.0]\nsecond = \"rotor.RIGHT\"\n\
         stiffness_matrix = [{kx}, {ky}, {kz}, 0.0, 0.0, 0.0]\n"
    );
    // Bearings are soft against the shaft: its interfaces are nearly free, and so are the modes that fit.
    compare(&structure, ComponentBasis::Rubin, 20, &scene);
}

/// A flexible crank whose shaft is held, the connecting rod of `models/conrod`, and a piston in its guide.
#[test]
fn the_slider_crank_vibrates_as_its_assembly_does() {
    const CRANK: f64 = 0.06;
    const PISTON: f64 = 0.3;
    let turn = std::f64::consts::FRAC_PI_3;
    let pin = [CRANK * turn.cos(), CRANK * turn.sin(), 0.0];
    let (width, thickness) = (0.03, 0.02);
    let crank = quadratic_brick([CRANK, width, thickness], [6, 3, 2], &Material::STEEL).unwrap();
    let flat = |[x, y, z]: [f64; 3]| [x, y - 0.5 * width, z - 0.5 * thickness];
    let ends = [0.0, CRANK].map(|end| {
        (0..crank.nodes.len()).filter(|&row| crank.nodes.positions[row][0] == end).collect::<Vec<_>>()
    });
    let turned = placed(turn, [0.0; 3]);
    let crank = moved(crank, &Material::STEEL, |at| turned(flat(at)));
    let rod = read(NodeSource::Calculix(models().join("conrod/conrod.inp")));
    let bores = ["BIG_END", "SMALL_END"].map(|name| (name, rod.nodes.sets[name].clone()));
    let material = Material { youngs_modulus: 210e9, poisson_ratio: 0.3, density: 7850.0 };
    // From the pin down to the x axis, on which the piston runs.
    let big_end = Interface::rigid(&rod, "BIG_END", &bores[0].1).unwrap().reference_point();
    let small_end = Interface::rigid(&rod, "SMALL_END", &bores[1].1).unwrap().reference_point();
    let angle = -(pin[1] / (small_end[0] - big_end[0])).asin();
    let shift = placed(angle, [0.0; 3])(big_end);
    let rod = moved(rod, &material, placed(angle, [0, 1, 2].map(|i| pin[i] - shift[i])));
    let interfaces = |model: &FeModel, names: [&str; 2], rows: [&Vec<usize>; 2]| -> Vec<Interface> {
        (0..2).map(|k| Interface::rigid(model, names[k], rows[k]).unwrap()).collect()
    };
    let on_crank = interfaces(&crank, ["MAIN", "PIN"], [&ends[0], &ends[1]]);
    let on_rod = interfaces(&rod, ["BIG_END", "SMALL_END"], [&bores[0].1, &bores[1].1]);
    let [px, py, pz] = on_rod[1].reference_point();
    let held =
        [Structure::motions(0, 0, &[0, 1, 2, 3, 4, 5]), Structure::motions(1, 1, &[1, 2, 3, 4])].concat();
    let hinge = [0, 1, 2, 3, 4];
    let shared = Structure::motions(0, 1, &hinge).into_iter().zip(Structure::motions(1, 0, &hinge)).collect();
    let structure = Structure {
        parts: vec![
            Part { name: "crank", model: crank, material: Material::STEEL, interfaces: on_crank },
            Part { name: "rod", model: rod, material, interfaces: on_rod },
        ],
        held,
        shared,
        masses: vec![(Structure::motions(1, 1, &[0])[0], PISTON)],
        ..Structure::default()
    };
    let scene = format!(
        "[simulation]\nduration = 1.0\nstep = 1e-6\n[bodies.crank]\nmodel = \"crank.ffrf.json\"\n\
         [bodies.rod]\nmodel = \"rod.ffrf.json\"\n\
         [bodies.piston]\nmass = {PISTON}\ninertia = [[1e-4,0.0,0.0],[0.0,1e-4,0.0],[0.0,0.0,1e-4]]\nposition = [{px}, {py}, {pz}]\n\
         [joints.shaft]\nkind = \"fixed\"\nfirst = \"ground\"\nsecond = \"crank.MAIN\"\n\
         [joints.pin]\nkind = \"revolute\"\nfirst = \"crank.PIN\"\nsecond = \"rod.BIG_END\"\naxis = [0.0, 0.0, 1.0]\n\
         [joints.gudgeon]\nkind = \"revolute\"\nfirst = \"rod.SMALL_END\"\nsecond = \"piston\"\naxis = [0.0, 0.0, 1.0]\n\
         [joints.guide]\nkind = \"prismatic\"\nfirst = \"ground\"\nfirst_position = [{px}, {py}, {pz}]\nsecond = \"piston\"\naxis = [1.0, 0.0, 0.0]\n"
    );
    compare(&structure, ComponentBasis::Rubin, 20, &scene);
}
