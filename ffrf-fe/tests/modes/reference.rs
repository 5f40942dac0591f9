//! Reading `../shared/reference` without the import that is tested elsewhere.

use std::fs;
use std::path::PathBuf;

use faer::Mat;
use faer::sparse::Triplet;
use ffrf_fe::{FeModel, Nodes, SparseMatrix};
use serde::Deserialize;

/// One reference case, as far as modes and reduction need it.
#[derive(Deserialize)]
pub struct Case {
    pub size: f64,
    pub frequencies_hz: Option<Vec<f64>>,
    pub invariants: Invariants,
}

#[derive(Deserialize)]
#[allow(non_snake_case, reason = "the names in the file")]
pub struct Invariants {
    pub m: f64,
    pub a: [f64; 3],
    pub b: Vec<[f64; 3]>,
    pub T: [[f64; 3]; 3],
    pub T_mu: Vec<[[f64; 3]; 3]>,
    pub T_munu: Vec<Vec<[[f64; 3]; 3]>>,
    pub K_ff: Vec<Vec<f64>>,
}

/// The folder, or `None` with a loud note if it is not there.
fn folder() -> Option<PathBuf> {
    let path = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/reference"));
    if path.is_dir() {
        return Some(path);
    }
    eprintln!("SKIPPED: reference data are not at {}", path.display());
    None
}

/// Case, model and mode shapes of a body.
pub fn load(name: &str) -> Option<(Case, FeModel, Mat<f64>)> {
    let folder = folder()?;
    let case =
        serde_json::from_str(&fs::read_to_string(folder.join(format!("{name}.json"))).unwrap()).unwrap();
    let fe = folder.join("fe").join(name);
    let positions: Vec<[f64; 3]> =
        table(&fe.join("X.txt")).iter().map(|row| [row[0], row[1], row[2]]).collect();
    let shapes = table(&fe.join("Psi.txt"));
    let model = FeModel {
        nodes: Nodes { ids: (0..positions.len() as u64).collect(), positions, ..Nodes::default() },
        mass: matrix_market(&fe.join("Ms.mtx")),
        mass_anisotropy: 0.0,
        stiffness: Some(matrix_market(&fe.join("K.mtx"))),
        fixed_dofs: Vec::new(),
        elements: Vec::new(),
        materials: Vec::new(),
        element_materials: Vec::new(),
        sources: Vec::new(),
        notes: Vec::new(),
    };
    Some((case, model, Mat::from_fn(shapes.len(), shapes[0].len(), |i, j| shapes[i][j])))
}

fn table(path: &PathBuf) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(path).unwrap();
    text.lines().map(|line| line.split_whitespace().map(|word| word.parse().unwrap()).collect()).collect()
}

fn matrix_market(path: &PathBuf) -> SparseMatrix {
    let text = fs::read_to_string(path).unwrap();
    let mut lines = text.lines().filter(|line| !line.starts_with('%'));
    let size: usize = lines.next().unwrap().split_whitespace().next().unwrap().parse().unwrap();
    let mut triplets = Vec::new();
    for line in lines {
        let mut words = line.split_whitespace();
        let row = words.next().unwrap().parse::<usize>().unwrap() - 1;
        let col = words.next().unwrap().parse::<usize>().unwrap() - 1;
        let val = words.next().unwrap().parse().unwrap();
        triplets.push(Triplet { row, col, val });
        if row != col {
            triplets.push(Triplet { row: col, col: row, val });
        }
    }
    SparseMatrix::try_new_from_triplets(size, size, &triplets).unwrap()
}
