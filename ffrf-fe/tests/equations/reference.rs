//! The public reference bodies, read through the import: random unsymmetric bodies, bars, Abaqus blocks, rotor.

use std::path::Path;

use ffrf_fe::SparseMatrix;
use ffrf_fe::import::{ModelFiles, NodeSource, read_mode_shapes, read_model};

use crate::bodies::{Body, Kind};

const NAMES: [&str; 8] =
    ["synth_m1", "synth_m2", "synth_m3", "synth_m5", "truss3", "blockC3D8", "blockC3D10", "rotorDisc"];

/// Bodies of `../shared/reference/fe`; none, with a note, where the folder is missing.
pub fn bodies() -> Vec<Body> {
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/reference/fe"));
    if !folder.is_dir() {
        eprintln!("SKIPPED: the reference bodies are not at {}", folder.display());
        return Vec::new();
    }
    NAMES.iter().map(|name| read(folder, name)).collect()
}

fn read(folder: &Path, name: &str) -> Body {
    let folder = folder.join(name);
    let files = ModelFiles {
        nodes: NodeSource::Text(folder.join("X.txt")),
        mass: Some(folder.join("Ms.mtx")),
        stiffness: Some(folder.join("K.mtx")),
    };
    let model = read_model(&files).expect("the reference model can be read");
    let mut positions = model.nodes.positions;
    let mut shapes = read_mode_shapes(&folder.join("Psi.txt"), positions.len()).expect("modes can be read");
    let (mut mass, mut stiffness) = (model.mass, model.stiffness.expect("the reference has a stiffness"));
    let kind = if name.starts_with("synth") { Kind::Unsymmetric } else { Kind::Symmetric };
    if kind == Kind::Symmetric {
        let extent = positions.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
        for x in positions.iter_mut().flatten() {
            *x /= extent;
        }
        let total: f64 = mass.val().iter().sum();
        scale(&mut mass, 1.0 / total);
        let stiffest = stiffness.val().iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        scale(&mut stiffness, 1.0 / stiffest);
        for mu in 0..shapes.ncols() {
            let largest = shapes.as_ref().col(mu).norm_max();
            shapes.as_mut().col_mut(mu).iter_mut().for_each(|x| *x /= largest);
        }
    }
    Body { kind, ..Body::new(name, positions, shapes, mass, stiffness) }
}

fn scale(matrix: &mut SparseMatrix, factor: f64) {
    matrix.val_mut().iter_mut().for_each(|x| *x *= factor);
}
