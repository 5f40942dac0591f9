//! Element types whose matrices are not what this program needs.

use super::*;
use crate::import::{Import, ImportOptions, Note, Weight, read_model_with};

const DOFS: &str = "1.1\n1.2\n1.3\n2.1\n2.2\n2.3\n";
const QUADRATIC: &str = "1, 1,1,1,1,2,2,2,2,1,1,1,1,2,2,2,2,1,1,1,1";

/// The pair as elements of some type, by the deck of CalculiX or, with the same matrices, of Abaqus.
fn import(
    element: &str,
    nodes: &str,
    dof: &str,
    mass: &[Vec<f64>],
    calculix: bool,
) -> Result<Import, ImportError> {
    let deck = format!("*NODE\n1,0,0,0\n2,1,0,0\n*ELEMENT, TYPE={element}\n{nodes}\n");
    let matrix = list(mass, |i, j| i <= j).join("\n") + "\n";
    let folder = Folder::new(&[("rod.inp", &deck), ("rod.dof", dof), ("rod.mas", &matrix)]);
    let deck = folder.path("rod.inp");
    let files = if calculix {
        ModelFiles { nodes: NodeSource::Calculix(deck), mass: None, stiffness: None }
    } else {
        ModelFiles { nodes: NodeSource::Abaqus(deck), mass: Some(folder.path("rod.mas")), stiffness: None }
    };
    read_model_with(&files, &ImportOptions::default())
}

#[test]
fn internal_nodes_of_incompatible_modes_are_refused_by_the_name_of_the_type() {
    let nodes = "1, 1,1,1,1,2,2,2,2";
    let message =
        import("C3D8I", nodes, &(DOFS.to_owned() + "3.1\n"), &full_mass(), true).unwrap_err().to_string();
    assert_parts(
        &message,
        &["rod.inp:4: element type C3D8I:", "internal nodes", "rod.dof:7:", "found node 3"],
    );
    // The same matrices beside a deck that is read as one of Abaqus: nine rows for two nodes.
    let mass: Vec<Vec<f64>> =
        (0..9).map(|i| (0..9).map(|j| if i == j { 2.0 } else { 0.0 }).collect()).collect();
    let message = import("c3d8i", nodes, DOFS, &mass, false).unwrap_err().to_string();
    assert_parts(&message, &["rod.inp:4: element type C3D8I:", "internal nodes", "found 9 rows"]);
}

#[test]
fn rotations_of_shells_and_beams_are_refused_by_the_name_of_the_type() {
    let mass: Vec<Vec<f64>> =
        (0..12).map(|i| (0..12).map(|j| if i == j { 2.0 } else { 0.0 }).collect()).collect();
    for (element, nodes) in [("S4R", "1, 1,2,2,1"), ("B31", "1, 1,2"), ("stri3", "1, 1,2,2")] {
        let message = import(element, nodes, DOFS, &mass, false).unwrap_err().to_string();
        let name = format!("rod.inp:4: element type {}:", element.to_uppercase());
        assert_parts(&message, &[&name, "rotations", "found 12 rows"]);
        // Where the matrices have rows of displacements alone, nothing is wrong.
        assert!(import(element, nodes, DOFS, &full_mass(), false).is_ok());
    }
    let message = import("SPRINGA", "1, 1,2", DOFS, &mass, false).unwrap_err().to_string();
    assert!(!message.contains("SPRINGA"), "{message}");
}

#[test]
fn a_singular_mass_is_warned_of_with_the_type_that_is_known_for_it() {
    let singular: Vec<Vec<f64>> =
        (0..6).map(|i| (0..6).map(|j| if i % 3 == j % 3 { 1.0 } else { 0.0 }).collect()).collect();
    let warnings = |element: &str, nodes: &str, mass: &[Vec<f64>], calculix| -> Vec<String> {
        let notes = import(element, nodes, DOFS, mass, calculix).unwrap().notes;
        let warning = |note: &&Note| note.weight == Weight::Warning;
        notes.iter().filter(warning).map(ToString::to_string).collect()
    };
    for calculix in [true, false] {
        let found = warnings("C3D20R", QUADRATIC, &singular, calculix);
        assert_eq!(found.len(), 2, "{found:?}");
        assert_parts(&found[0], &["warning: ", "rod.inp: element type C3D20R (line 4)", "singular", "C3D10"]);
        assert_parts(&found[1], &["rod.mas: the mass matrix is singular, 1 pivot vanishes"]);
        let found = warnings("C3D20", QUADRATIC, &singular, calculix);
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(warnings("C3D20", QUADRATIC, &full_mass(), calculix), [""; 0]);
    }
    // CalculiX is known for it, whatever the pivots say; beside a deck of Abaqus they decide.
    assert_eq!(warnings("C3D20R", QUADRATIC, &full_mass(), true).len(), 1);
    assert_eq!(warnings("C3D20R", QUADRATIC, &full_mass(), false), [""; 0]);
    let notes = import("C3D20R", QUADRATIC, DOFS, &full_mass(), false).unwrap().notes;
    assert!(notes.iter().any(|note| note.text.contains("element type C3D20R")), "{notes:?}");
}
