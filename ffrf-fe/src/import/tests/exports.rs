//! Real exports against the reference matrices made from them.

use std::path::Path;

use super::*;
use crate::import::{ImportOptions, read_mode_shapes, read_model_with};

/// Both sides come from the same printed numbers; summing and averaging costs a few units in the last place.
const AGREEMENT: f64 = 1e-14;

fn shared(folder: &str) -> Option<PathBuf> {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared")).join(folder);
    if !path.exists() {
        eprintln!("SKIPPED: {} is missing", path.display());
        return None;
    }
    Some(path)
}

fn reference(name: &str) -> Option<FeModel> {
    let folder = shared("reference/fe")?.join(name);
    let nodes = NodeSource::Text(folder.join("X.txt"));
    let stiffness = Some(folder.join("K.mtx")).filter(|path| path.exists());
    let files = ModelFiles { nodes, mass: Some(folder.join("Ms.mtx")), stiffness };
    let import = read_model_with(&files, &ImportOptions::default()).unwrap();
    assert_eq!(import.notes, [], "{name}: nothing is odd about a sound export, and no form is guessed");
    Some(import.model)
}

fn deviation(found: &SparseMatrix, wanted: &SparseMatrix) -> f64 {
    assert_eq!(found.nrows(), wanted.nrows());
    (found.to_dense() - wanted.to_dense()).norm_max() / wanted.to_dense().norm_max()
}

#[test]
fn abaqus_exports_agree_with_the_reference() {
    let Some(folder) = shared("fe-exports") else { return };
    for (name, deck, mass, stiffness, elements) in [
        ("blockC3D8", "blockC3D8.inp", "blockC3D8_MASS1.mtx", "blockC3D8_STIF1.mtx", 90),
        ("blockC3D10", "blockC3D10.inp", "blockC3D10_MASS1.mtx", "blockC3D10_STIF1.mtx", 122),
        ("rotorDisc", "rotorDiscTest.inp", "rotorDiscTestMASS1.mtx", "rotorDiscTestSTIF1.mtx", 48),
    ] {
        let files = ModelFiles {
            nodes: NodeSource::Abaqus(folder.join(deck)),
            mass: Some(folder.join(mass)),
            stiffness: Some(folder.join(stiffness)),
        };
        let model = read_model(&files).unwrap();
        let Some(wanted) = reference(name) else { return };
        assert_eq!(model.nodes.positions, wanted.nodes.positions, "{name}");
        assert!(model.fixed_dofs.is_empty());
        assert_eq!(model.elements.len(), elements);
        assert!(model.mass_anisotropy < AGREEMENT, "{name}: {:e}", model.mass_anisotropy);
        assert!(deviation(&model.mass, &wanted.mass) < AGREEMENT, "{name}");
        let found = model.stiffness.unwrap();
        assert!(deviation(&found, wanted.stiffness.as_ref().unwrap()) < AGREEMENT, "{name}");
    }
}

#[test]
fn every_reference_body_is_accepted() {
    let Some(folder) = shared("reference/fe") else { return };
    let mut read = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let Some(model) = reference(&name) else { return };
        let psi = shared("reference/fe").unwrap().join(&name).join("Psi.txt");
        let shapes = read_mode_shapes(&psi, model.nodes.len()).unwrap();
        assert!(shapes.ncols() > 0 && shapes.norm_max() > 0.0, "{name}");
        read += 1;
    }
    assert!(read >= 10, "{read}");
}

/// The mapping vector is right if the stiffness knows a rigid rotation about each axis as free of force.
#[test]
fn ansys_export_is_in_the_order_of_its_matrices() {
    let Some(folder) = shared("fe-exports") else { return };
    let files = ModelFiles {
        nodes: NodeSource::Ansys {
            nodes: folder.join("rotorAnsysNodalCoordinates.txt"),
            mapping: Some(folder.join("rotorAnsysMatrixDofMappingVector.txt")),
        },
        mass: Some(folder.join("rotorAnsysMassMatrixSparse.txt")),
        stiffness: Some(folder.join("rotorAnsysStiffnessMatrixSparse.txt")),
    };
    let model = read_model(&files).unwrap();
    assert_eq!(model.nodes.len(), 115);
    assert_eq!(model.nodes.ids[..4], [3, 31, 17, 10]);
    assert!(model.mass_anisotropy < AGREEMENT);
    let stiffness = model.stiffness.unwrap();
    let largest = stiffness.val().iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    for axis in 0..3 {
        let rotation = faer::Mat::from_fn(345, 1, |dof, _| {
            let x = model.nodes.positions[dof / 3];
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            if dof % 3 == u {
                -x[v]
            } else if dof % 3 == v {
                x[u]
            } else {
                0.0
            }
        });
        let force = (&stiffness * &rotation).norm_max() / largest;
        // The node table is printed to ten digits.
        assert!(force < 1e-9, "axis {axis}: {force:e}");
    }
}

/// The project's own part: figures as its README gives them.
#[test]
fn the_connecting_rod_is_read_compressed() {
    let deck = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../models/conrod/conrod.inp"));
    if !deck.exists() {
        eprintln!("SKIPPED: {} is missing", deck.display());
        return;
    }
    let files = ModelFiles { nodes: NodeSource::Calculix(deck.to_path_buf()), mass: None, stiffness: None };
    let model = read_model(&files).unwrap();
    assert_eq!((model.nodes.len(), model.elements.len()), (1232, 157));
    assert!(model.fixed_dofs.is_empty());
    let total: f64 = model.mass.val().iter().sum();
    assert!((total - 0.604996).abs() < 1e-6, "{total}");
    // CalculiX prints 14 digits.
    assert!(model.mass_anisotropy < 1e-13, "{:e}", model.mass_anisotropy);
    let files: Vec<_> = model.sources.iter().map(|source| source.file.as_str()).collect();
    assert_eq!(files, ["conrod.inp", "conrod.dof", "conrod.mas.gz", "conrod.sti.gz"]);
    for set in ["BIG_END", "SMALL_END"] {
        assert!(!model.nodes.sets[set].is_empty());
    }
}
