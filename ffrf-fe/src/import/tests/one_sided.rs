//! Files that used to pass for something else: vanished nodes, guessed forms, supports in the mass, bad coordinates.

use super::*;
use crate::import::{Import, ImportOptions, MassForm, Weight, read_model_with};

const SCALAR: &str = "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 2.0\n2 1 1.0\n2 2 2.0\n";

fn text(matrix: &[Vec<f64>]) -> String {
    list(matrix, |_, _| true).join("\n") + "\n"
}

fn lumped() -> Vec<Vec<f64>> {
    (0..6).map(|i| (0..6).map(|j| if i == j { 2.0 } else { 0.0 }).collect()).collect()
}

fn import(mass: &str, stiffness: Option<&str>, options: ImportOptions) -> Result<Import, ImportError> {
    let folder = Folder::new(&[("x.txt", NODES), ("m.mtx", mass)]);
    if let Some(stiffness) = stiffness {
        std::fs::write(folder.path("k.mtx"), stiffness).unwrap();
    }
    let files = ModelFiles {
        nodes: NodeSource::Text(folder.path("x.txt")),
        mass: Some(folder.path("m.mtx")),
        stiffness: stiffness.map(|_| folder.path("k.mtx")),
    };
    read_model_with(&files, &options)
}

fn refusal(mass: &str, stiffness: Option<&str>) -> String {
    import(mass, stiffness, ImportOptions::default())
        .map(|_| "accepted".to_owned())
        .unwrap_or_else(|e| e.to_string())
}

#[test]
fn a_node_that_one_matrix_does_not_know_is_named() {
    let k = text(&stiffness());
    let allow = ImportOptions { allow_massless: true, ..ImportOptions::default() };
    // A node in the middle: the list keeps its extent.
    let mut without_first = lumped();
    (0..3).for_each(|dof| without_first[dof][dof] = 0.0);
    let declared = "%%MatrixMarket matrix coordinate real symmetric\n2 2 1\n2 2 2.0\n".to_owned();
    for mass in [text(&without_first), declared] {
        let message = refusal(&mass, Some(&k));
        assert!(message.contains("m.mtx: 1 node has stiffness and no mass (node 0)"), "{message}");
        let import = import(&mass, Some(&k), allow).unwrap();
        let note = import.notes.iter().find(|note| note.weight == Weight::Warning).unwrap();
        assert!(note.to_string().contains("1 node has stiffness and no mass (node 0), as allowed"), "{note}");
        let message = refusal(&mass, None);
        assert!(message.contains("1 node has a position and no mass (node 0)"), "{message}");
    }
    // The stiffness leaves a node out: no boundary condition says that it is held.
    let mut held = stiffness();
    held.iter_mut().for_each(|row| row[..3].fill(0.0));
    held[..3].iter_mut().for_each(|row| row.fill(0.0));
    for stiffness in
        [text(&held), "%%MatrixMarket matrix coordinate real general\n6 6 1\n6 6 5.0\n".to_owned()]
    {
        let message = refusal(SCALAR, Some(&stiffness));
        assert!(message.contains("k.mtx: 1 node has mass and no stiffness (node 0)"), "{message}");
        assert!(import(SCALAR, Some(&stiffness), allow).is_ok());
    }
}

#[test]
fn a_list_that_was_cut_to_one_direction_is_not_the_scalar_mass() {
    let k = text(&stiffness());
    let cut = "1 1 2.0\n2 2 2.0\n";
    let message = refusal(cut, Some(&k));
    for part in ["m.mtx", "6 rows", "found 2 rows for 2 nodes", "--mass-form scalar"] {
        assert!(message.contains(part), "`{message}` lacks `{part}`");
    }
    let form = |mass_form| ImportOptions { mass_form, ..ImportOptions::default() };
    let model = import(cut, Some(&k), form(MassForm::Scalar)).unwrap().model;
    assert_eq!(dense(&model.mass), [[2.0, 0.0], [0.0, 2.0]]);
    let message = import(SCALAR, Some(&k), form(MassForm::Full)).unwrap_err().to_string();
    assert!(message.contains("6 rows, as --mass-form says"), "{message}");
    let message = import(&text(&lumped()), Some(&k), form(MassForm::Scalar)).unwrap_err().to_string();
    assert!(message.contains("the scalar mass, 2 rows") && message.contains("found 6 rows"), "{message}");
}

#[test]
fn a_size_line_without_its_banner_is_no_entry() {
    let k = text(&stiffness());
    let scalar = ImportOptions { mass_form: MassForm::Scalar, ..ImportOptions::default() };
    for lines in ["2 2 3\n1 1 2.0\n2 1 1.0\n2 2 2.0\n", "% made by x\n2 2 3\n1 1 2\n2 1 1\n2 2 2\n"] {
        let message = import(lines, Some(&k), scalar).unwrap_err().to_string();
        assert!(
            message.contains("size line of a Matrix Market file") && message.contains("`2 2 3`"),
            "{message}"
        );
    }
    // A list whose first entry is the last diagonal one, among others alike, is a list.
    assert!(import("2 2 2\n2 1 1\n1 1 2\n", Some(&k), scalar).is_err(), "two lines follow a 2");
    assert!(import("2 2 2.0\n2 1 1.0\n1 1 2.0\n", Some(&k), scalar).is_ok());
}

#[test]
fn lists_say_how_they_were_read() {
    let import = import(&text(&full_mass()), Some(&text(&stiffness())), ImportOptions::default()).unwrap();
    let readings = import.notes.iter().filter(|note| note.weight == Weight::Reading);
    let notes: Vec<String> = readings.map(ToString::to_string).collect();
    assert_eq!(notes.len(), 2, "{notes:?}");
    assert!(
        notes[0].starts_with("note: ") && notes[0].contains("m.mtx: a list without a header"),
        "{notes:?}"
    );
    assert!(notes[1].contains("`row column value` with 12 entries of 6 rows"), "{notes:?}");
}

#[test]
fn a_support_in_the_mass_is_refused() {
    let k = text(&stiffness());
    let mut marked = full_mass();
    marked[4][4] = 1e36;
    let message = refusal(&text(&marked), Some(&k));
    assert!(message.contains("m.mtx: the diagonal entry of row 5 (node 1) is 1e36 kg"), "{message}");
    let message = refusal(&SCALAR.replace("2 2 2.0", "2 2 1e35"), Some(&k));
    assert!(message.contains("row 2 (node 1) is 1e35 kg"), "{message}");
}

#[test]
fn matrices_in_different_orders_are_noticed() {
    // Three nodes in a row: the mass couples the ends, the stiffness the neighbours.
    let nodes = "0 0 0\n1 0 0\n2 0 0\n";
    let mass = "%%MatrixMarket matrix coordinate real symmetric\n3 3 4\n1 1 2\n2 2 2\n3 3 2\n3 1 1\n";
    let mut k = vec![vec![0.0; 9]; 9];
    for (a, b) in [(0, 1), (1, 2)] {
        for i in 0..3 {
            let (p, q) = (3 * a + i, 3 * b + i);
            k[p][p] += 1.0;
            k[q][q] += 1.0;
            k[p][q] -= 1.0;
            k[q][p] -= 1.0;
        }
    }
    let folder = Folder::new(&[("x.txt", nodes), ("m.mtx", mass), ("k.mtx", &text(&k))]);
    let files = ModelFiles {
        nodes: NodeSource::Text(folder.path("x.txt")),
        mass: Some(folder.path("m.mtx")),
        stiffness: Some(folder.path("k.mtx")),
    };
    let notes = read_model_with(&files, &ImportOptions::default()).unwrap().notes;
    let warning = notes.iter().find(|note| note.text.contains("couples")).unwrap();
    assert!(warning.text.contains("nodes 0 and 2 (1 such pairs)"), "{warning}");
}

/// The project's own part with one coordinate changed by 0.1 %.
#[test]
fn a_coordinate_that_is_off_is_warned_of_at_its_node() {
    let folder = Folder::new(&[]);
    let models = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../models/conrod"));
    for name in ["conrod.dof", "conrod.mas.gz", "conrod.sti.gz"] {
        std::fs::copy(models.join(name), folder.path(name)).unwrap();
    }
    let deck = std::fs::read_to_string(models.join("conrod.inp")).unwrap();
    let warnings = |deck: &str| {
        std::fs::write(folder.path("conrod.inp"), deck).unwrap();
        let nodes = NodeSource::Calculix(folder.path("conrod.inp"));
        let files = ModelFiles { nodes, mass: None, stiffness: None };
        let mut notes = read_model_with(&files, &ImportOptions::default()).unwrap().notes;
        notes.retain(|note| note.weight == Weight::Warning);
        notes
    };
    assert_eq!(warnings(&deck), []);
    for wanted in [17_u64, 400, 1000] {
        let changed: Vec<String> = deck
            .lines()
            .map(|line| {
                let fields: Vec<&str> = line.split(',').map(str::trim).collect();
                match (fields.as_slice(), fields.first().and_then(|id| id.parse::<u64>().ok())) {
                    ([id, x, y, z], Some(found)) if found == wanted => {
                        format!("{id}, {:e}, {y}, {z}", 1.001 * x.parse::<f64>().unwrap())
                    }
                    _ => line.to_owned(),
                }
            })
            .collect();
        let notes = warnings(&changed.join("\n"));
        assert_eq!(notes.len(), 1, "{notes:?}");
        assert!(notes[0].text.contains(&format!("Node {wanted} moves most")), "{}", notes[0]);
    }
}
