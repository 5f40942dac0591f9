//! The table of targets: which file of which model an input stands for.

use std::path::Path;

use ffrf_fe::elements::Material;
use ffrf_fe::import::{
    ImportOptions, ModelFiles, NodeSource, SolidsMaterial, read_mbdyn, read_mode_shapes, read_model_with,
    read_sid,
};
use ffrf_model::ReducedBody;

use crate::Outcome;

/// One reader with sound files around the one that is fuzzed.
pub struct Target {
    /// Name of the fuzz target and of its folder of samples.
    pub name: &'static str,
    /// Name of the file that the input becomes.
    file: &'static str,
    read: fn(&Path) -> Outcome,
}

/// Every target.
pub const TARGETS: [Target; 21] = [
    Target {
        name: "deck",
        file: "part.inp",
        read: |folder| model(folder, NodeSource::Abaqus(folder.join("part.inp"))),
    },
    Target { name: "calculix_dof", file: "rod.dof", read: calculix },
    Target { name: "calculix_list", file: "rod.sti", read: calculix },
    Target { name: "ansys_nodes", file: "n.txt", read: ansys },
    Target { name: "ansys_mapping", file: "map.txt", read: ansys },
    Target { name: "matrix_market", file: "k.mtx", read: plain },
    Target { name: "dmig", file: "k.mtx", read: dmig },
    Target { name: "op4", file: "k.mtx", read: dmig },
    Target { name: "vtu", file: "part.msh", read: mesh },
    Target { name: "mesh", file: "part.msh", read: mesh },
    Target { name: "nastran_deck", file: "part.bdf", read: nastran },
    Target { name: "list", file: "k.mtx", read: plain },
    Target { name: "numpy", file: "k.mtx", read: plain },
    Target { name: "npz", file: "k.mtx", read: plain },
    Target { name: "text_nodes", file: "x.txt", read: plain },
    Target {
        name: "numpy_nodes",
        file: "x.npy",
        read: |folder| model(folder, NodeSource::Numpy(folder.join("x.npy"))),
    },
    Target {
        name: "gzip",
        file: "x.gz",
        read: |folder| model(folder, NodeSource::Text(folder.join("x.gz"))),
    },
    Target { name: "mode_shapes", file: "psi.txt", read: mode_shapes },
    Target { name: "mbdyn", file: "body.fem", read: mbdyn },
    Target { name: "sid", file: "body.SID_FEM", read: sid },
    Target { name: "model_file", file: "body.ffrf.json", read: body },
];

/// Two nodes joined by springs, in every form that some target needs.
const SOUND: [(&str, &str); 9] = [
    ("x.txt", "0 0 0\n1 0 0\n"),
    ("m.mtx", "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 2\n2 1 1\n2 2 2\n"),
    ("k.mtx", K),
    ("rod.inp", "*NODE\n1,0,0,0\n2,1,0,0\n*ELEMENT, TYPE=T3D2\n1,1,2\n"),
    ("rod.dof", "1.1\n1.2\n1.3\n2.1\n2.2\n2.3\n"),
    ("rod.sti", K),
    ("rod.mas", "1 1 2.0\n2 2 2.0\n3 3 2.0\n4 4 2.0\n5 5 2.0\n6 6 2.0\n"),
    ("n.txt", "Node\tX\tY\tZ\n12\t1,0\t0,0\t0,0\n5\t0,0\t0,0\t0,0\n"),
    ("map.txt", "%%MatrixMarket matrix array integer general\n2 1\n5\n12\n"),
];
const K: &str = "1 1 3.0\n4 1 -3.0\n2 2 4.0\n5 2 -4.0\n3 3 5.0\n6 3 -5.0\n4 4 3.0\n5 5 4.0\n6 6 5.0\n";

/// Runs the target of this name on an input; panics if there is none, or no folder can be written.
pub fn run(name: &str, input: &[u8]) -> Outcome {
    let Some(target) = TARGETS.iter().find(|target| target.name == name) else {
        panic!("there is no target `{name}`");
    };
    let folder = tempfile::tempdir().unwrap_or_else(|error| panic!("no temporary folder: {error}"));
    for (file, text) in SOUND.iter().filter(|(file, _)| *file != target.file) {
        write(&folder.path().join(file), text.as_bytes());
    }
    write(&folder.path().join(target.file), input);
    (target.read)(folder.path())
}

fn write(path: &Path, bytes: &[u8]) {
    if let Err(error) = std::fs::write(path, bytes) {
        panic!("{}: {error}", path.display());
    }
}

fn model(folder: &Path, nodes: NodeSource) -> Outcome {
    let beside = matches!(nodes, NodeSource::Calculix(_));
    let named = |file: &str| (!beside).then(|| folder.join(file));
    read(ModelFiles { nodes, mass: named("m.mtx"), stiffness: named("k.mtx") })
}

fn read(files: ModelFiles) -> Outcome {
    let options = ImportOptions { inflated_limit: 1 << 20, ..ImportOptions::default() };
    match read_model_with(&files, &options) {
        Ok(import) => {
            Outcome::Model(Box::new(import.model), import.notes.iter().map(ToString::to_string).collect())
        }
        Err(error) => Outcome::Refused(error.to_string()),
    }
}

fn plain(folder: &Path) -> Outcome {
    model(folder, NodeSource::Text(folder.join("x.txt")))
}

fn calculix(folder: &Path) -> Outcome {
    model(folder, NodeSource::Calculix(folder.join("rod.inp")))
}

fn ansys(folder: &Path) -> Outcome {
    model(folder, NodeSource::Ansys { nodes: folder.join("n.txt"), mapping: Some(folder.join("map.txt")) })
}

fn mesh(folder: &Path) -> Outcome {
    let nodes =
        NodeSource::Mesh { path: folder.join("part.msh"), materials: SolidsMaterial::all(Material::STEEL) };
    read(ModelFiles { nodes, mass: None, stiffness: None })
}

fn nastran(folder: &Path) -> Outcome {
    model(folder, NodeSource::Nastran(folder.join("part.bdf")))
}

fn dmig(folder: &Path) -> Outcome {
    model(folder, NodeSource::Ansys { nodes: folder.join("n.txt"), mapping: None })
}

fn mode_shapes(folder: &Path) -> Outcome {
    match read_mode_shapes(&folder.join("psi.txt"), 2) {
        Ok(shapes) => {
            let finite =
                (0..shapes.ncols()).all(|column| shapes.col_as_slice(column).iter().all(|x| x.is_finite()));
            Outcome::Dense(shapes.nrows(), shapes.ncols(), finite)
        }
        Err(error) => Outcome::Refused(error.to_string()),
    }
}

fn mbdyn(folder: &Path) -> Outcome {
    match read_mbdyn(&folder.join("body.fem"), None) {
        Ok(body) => Outcome::Body(Box::new(body)),
        Err(error) => Outcome::Refused(error.to_string()),
    }
}

fn sid(folder: &Path) -> Outcome {
    match read_sid(&folder.join("body.SID_FEM"), None) {
        Ok(body) => Outcome::Body(Box::new(body)),
        Err(error) => Outcome::Refused(error.to_string()),
    }
}

fn body(folder: &Path) -> Outcome {
    match ReducedBody::read(folder.join("body.ffrf.json")) {
        Ok(body) => Outcome::Body(Box::new(body)),
        Err(error) => Outcome::Refused(error.to_string()),
    }
}
