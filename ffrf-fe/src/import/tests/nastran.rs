//! Nastran: decks and `DMIG` entries, in each kind of field, and files that pyNastran wrote.

use super::*;
use crate::elements::{Material, element_matrices};
use crate::import::{ImportOptions, read_model_with};
use crate::{ElementKind, Nodes};

/// A matrix of two grid points in large fields: one triangle, column by column.
fn punch(name: &str, matrix: &[Vec<f64>]) -> String {
    let mut text =
        format!("$TITLE   = A PUNCH FILE\nDMIG    {name:<8}{:>8}{:>8}{:>8}{:>8}{:>24}\n", 0, 6, 2, 0, 6);
    for (j, _) in matrix.iter().enumerate() {
        text += &format!("DMIG*   {name:<16}{:>16}{:>16}\n", 7 - 4 * (j / 3), j % 3 + 1);
        for (i, row) in matrix.iter().enumerate().take(j + 1) {
            if row[j] != 0.0 {
                let value = format!("{:.9E}", row[j]).replace('E', "D");
                text += &format!("*       {:>16}{:>16}{value:>16}\n", 7 - 4 * (i / 3), i % 3 + 1);
            }
        }
    }
    text
}

fn folder(mass: &str, stiffness: &str) -> Folder {
    Folder::new(&[
        ("n.txt", "Node\tX\tY\tZ\n7\t0.0\t0.0\t0.0\n3\t1.0\t0.0\t0.0\n"),
        ("m.mtx", mass),
        ("k.mtx", stiffness),
    ])
}

fn model(mass: &str, stiffness: &str) -> Result<FeModel, ImportError> {
    let folder = folder(mass, stiffness);
    folder.with_nodes(NodeSource::Ansys { nodes: folder.path("n.txt"), mapping: None })
}

/// The mass in small fields, several rows of a column in one entry, and in free fields.
const SMALL: &str = "DMIG    MAAX           0       6       1       0                       6
DMIG    MAAX           7       1               7       1      2.
DMIG    MAAX           7       2               7       2   2.0+0
DMIG    MAAX           7       3               7       3     2.0
DMIG    MAAX           3       1               7       1     1.0
+              3       1  2.0E+0
DMIG    MAAX           3       2               7       2     1.0
+              3       2     2.0
DMIG    MAAX           3       3               7       3     1.0
+              3       3     2.0
";
const FREE: &str = "DMIG,MAAX,0,1,2,0,,,6
DMIG,MAAX,7,1,,7,1,2.0,
,3,1,1.0
DMIG,MAAX,7,2,,7,2,20.-1,
,3,2,1.0
DMIG,MAAX,7,3,,7,3,2.0,
,3,3,1.0
DMIG,MAAX,3,1,,7,1,1.0,
,3,1,2.0
DMIG,MAAX,3,2,,7,2,1.0,
,3,2,2.0
DMIG,MAAX,3,3,,7,3,1.0,
,3,3,2.0
";

#[test]
fn the_same_pair_in_large_small_and_free_fields() {
    let stiffness = punch("KAAX", &stiffness());
    for mass in [punch("MAAX", &full_mass()).as_str(), SMALL, FREE] {
        let model = model(mass, &stiffness).unwrap();
        assert_eq!(dense(&model.mass), MASS);
        assert_eq!(dense(model.stiffness.as_ref().unwrap()), super::stiffness());
    }
}

#[test]
fn what_cannot_be_read_is_named_with_its_line() {
    let sound = punch("KAAX", &stiffness());
    let cases = [
        (
            FREE.replace("MAAX,0,1,2", "MAAX,0,9,2"),
            "k.mtx:1: expected a form IFO of 1 (square) or 6 (symmetric)",
        ),
        (FREE.replace("MAAX,0,1,2", "MAAX,0,1,3"), "k.mtx:1: expected real numbers"),
        (FREE.replace("7,1,,7,1", "7,1,,7,4"), "k.mtx:2: expected a component from 1 to 3"),
        (FREE.replace("7,1,,7,1", "7,1,,8,1"), "node 8"),
        (FREE.replace("20.-1", "twenty"), "k.mtx:4: expected a finite real number, found `twenty`"),
        (FREE.replace("20.-1", "nan"), "k.mtx:4: expected a finite real number, found `nan`"),
        (FREE.replace("DMIG,MAAX,7,3", "DMIG,XAAX,7,3"), "whose name starts with `K` among `MAAX`, `XAAX`"),
        (
            FREE.replace("DMIG,MAAX,7,3,,7", "DMIG,MAAX,0,3,,7"),
            "k.mtx:6: expected one header of the matrix `MAAX`",
        ),
        (FREE.replace("2.0,\n,3,1", "2.0,\n\u{b5},3,1"), "k.mtx:3: expected a line of ASCII text"),
        (FREE.lines().skip(1).collect::<Vec<_>>().join("\n"), "the header of a matrix"),
        ("DMIG,MAAX,0,1,2,0,,,6\n".to_owned(), "columns of the matrix `MAAX`"),
    ];
    for (text, message) in cases {
        let found = model(&sound, &text).unwrap_err().to_string();
        assert!(found.contains(message), "{found}\n{message}");
    }
}

/// Entries of several matrices, and entries of other kinds between them: the name tells which is meant.
#[test]
fn one_punch_file_holds_both_matrices() {
    let both = format!(
        "GRID,9,,0.,0.,0.\n{SMALL}$ a remark\nASET1,123,3,7\n{}ENDDATA\n1 2 3\n",
        punch("KAAX", &stiffness())
    );
    let found = model(&both, &both).unwrap();
    assert_eq!(dense(&found.mass), MASS);
    assert_eq!(dense(found.stiffness.as_ref().unwrap()), stiffness());

    let nodes = Nodes { ids: vec![7, 3], positions: vec![[0.0; 3], [1.0, 0.0, 0.0]], ..Nodes::default() };
    let message =
        crate::import::read_matrix(&folder(&both, "").path("m.mtx"), &nodes).unwrap_err().to_string();
    assert_parts(&message, &["m.mtx:", "expected one matrix", "`MAAX`, `KAAX`"]);
    let message = model(&both, &both.replace("MAAX", "KBBX")).unwrap_err().to_string();
    assert_parts(&message, &["k.mtx:", "`K` among `KBBX`, `KAAX`"]);
}

/// The folder with the files of pyNastran, and the script that made them.
fn written() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/nastran"))
}

/// Twelve digits of each entry are in the file.
const PRINTED: f64 = 1e-10;

#[test]
fn deck_and_punch_file_of_another_tool_give_the_matrices_of_the_element() {
    let punch = written().join("part.pch");
    let files = ModelFiles {
        nodes: NodeSource::Nastran(written().join("part.bdf")),
        mass: Some(punch.clone()),
        stiffness: Some(punch),
    };
    let import = read_model_with(&files, &ImportOptions::default()).unwrap();
    let [note] = import.notes.as_slice() else { panic!("{:?}", import.notes) };
    assert_parts(&note.text, &["1 node is in no matrix and left out (node 99)"]);
    let model = import.model;
    assert_eq!(model.nodes.ids, [10, 20, 30, 40, 50, 60, 70, 80]);
    assert_eq!(model.nodes.sets["SET4"], [0, 2, 4, 6]);
    assert_eq!(model.materials[0].elasticity, Some(Material::STEEL.elasticity()));
    let [element] = model.elements.as_slice() else { panic!("{:?}", model.elements) };
    assert_eq!(
        (element.kind, element.nodes.as_slice()),
        (ElementKind::Hexahedron8, &[0, 1, 3, 2, 4, 5, 7, 6][..])
    );

    let corners: Vec<[f64; 3]> = element.nodes.iter().map(|&row| model.nodes.positions[row]).collect();
    let expected = element_matrices(element.kind, &corners, &Material::STEEL).unwrap();
    let (stiffness, mass) = (model.stiffness.unwrap().to_dense(), model.mass.to_dense());
    let (heaviest, stiffest) = (mass.norm_max(), stiffness.norm_max());
    let place = |row: usize| 3 * element.nodes[row / 3] + row % 3;
    for (i, j) in (0..24).flat_map(|i| (0..24).map(move |j| (i, j))) {
        let error = (stiffness[(place(i), place(j))] - expected.stiffness[(i, j)]).abs();
        assert!(error < PRINTED * stiffest, "({i}, {j}): {error:e}");
    }
    for (i, j) in (0..8).flat_map(|i| (0..8).map(move |j| (i, j))) {
        let error = (mass[(element.nodes[i], element.nodes[j])] - expected.mass[(i, j)]).abs();
        assert!(error < PRINTED * heaviest, "({i}, {j}): {error:e}");
    }
}

const DECK: &str = "GRID,7,,0.,0.,0.
GRID           3              1.
";

#[test]
fn decks_that_cannot_be_read_are_named_with_their_line() {
    let quadratic = "CTETRA         1       1       1       2       3       4       5       6
               7       8       9
";
    let cases = [
        ("GRID,1,5,0.,0.,0.\n".to_owned(), "p.bdf:1: expected a position in basic coordinates"),
        (format!("{DECK}GRID,8,,1.,0.,0.,2\n"), "p.bdf:3: expected displacements in basic coordinates"),
        (format!("{DECK}GRID,8,,1.,zero,0.\n"), "p.bdf:3: expected a finite real number, found `zero`"),
        (format!("{DECK}GRID,7,,1.,0.,0.\n"), "p.bdf:3: node 7 is given a second time"),
        (format!("{DECK}GRDSET,,2\n"), "p.bdf:3: GRDSET is not supported here: write"),
        (format!("{DECK}INCLUDE 'other.bdf'\n"), "p.bdf:3: INCLUDE is not supported here: join the files"),
        (
            format!("{DECK}CTETRA,1,1,7,3,8,9\n"),
            "p.bdf:3: expected a node of the node table (2 nodes), found node 8",
        ),
        (format!("{DECK}{quadratic}"), "p.bdf:3: expected 4 or 10 grid points of CTETRA, found 9"),
        (
            format!("{DECK}SET1,1,THRU,3\n"),
            "p.bdf:3: expected the number of a grid point, or THRU between two",
        ),
        (format!("{DECK}SET1,1,7,THRU,3\n"), "p.bdf:3: expected a larger number behind THRU"),
        ("$ nothing\n".to_owned(), "expected nodes, found none"),
        (",1,2\n".to_owned(), "p.bdf:1: expected an entry of the bulk data before its continuation"),
    ];
    for (text, message) in cases {
        let folder = Folder::new(&[("p.bdf", text.as_str()), ("m.mtx", FREE), ("k.mtx", FREE)]);
        let found = folder.with_nodes(NodeSource::Nastran(folder.path("p.bdf"))).unwrap_err().to_string();
        assert!(found.contains(message), "{found}\n{message}");
    }
}

/// Middles of edges of `CHEXA`: those of the lower face, the upright edges, those of the upper face.
#[test]
fn quadratic_hexahedra_come_in_the_order_of_the_shape_functions() {
    let model = crate::elements::quadratic_brick([2.0, 3.0, 5.0], [1, 1, 1], &Material::STEEL).unwrap();
    let nodes = &model.elements[0].nodes;
    let mut text = String::new();
    for (row, [x, y, z]) in model.nodes.positions.iter().enumerate() {
        text += &format!("GRID,{},,{x:?},{y:?},{z:?}\n", row + 1);
    }
    let order: Vec<usize> = (0..12).chain(16..20).chain(12..16).map(|place| nodes[place] + 1).collect();
    text += &format!("CHEXA,1,1,{}\n", order[..6].iter().map(|id| format!("{id},")).collect::<String>());
    text += &order[6..]
        .chunks(8)
        .map(|ids| ids.iter().map(|id| format!(",{id}")).collect::<String>() + "\n")
        .collect::<String>();
    let folder = Folder::new(&[("p.bdf", text.as_str())]);
    let source = crate::import::text::source::Source::read(&folder.path("p.bdf"), 0).unwrap();
    let table = crate::import::formats::nastran::deck::read(&source).unwrap();
    assert_eq!(table.elements, model.elements);
}

#[test]
fn grid_points_come_in_ascending_order() {
    let folder = Folder::new(&[("p.bdf", "GRID,7,,7.,0.,0.\nGRID,3,,3.,0.,0.\nSET1,1,3,THRU,6\nSET1,2,7\n")]);
    let source = crate::import::text::source::Source::read(&folder.path("p.bdf"), 0).unwrap();
    let nodes = crate::import::formats::nastran::deck::read(&source).unwrap().nodes;
    assert_eq!((nodes.ids, nodes.positions), (vec![3, 7], vec![[3.0, 0.0, 0.0], [7.0, 0.0, 0.0]]));
    assert_eq!((&nodes.sets["SET1"][..], &nodes.sets["SET2"][..]), (&[0][..], &[1][..]));
}

/// By columns or strings, as text or binary, of either byte order; with and without rows of rotations.
#[test]
fn matrices_by_columns_are_those_of_the_punch_file() {
    let read = |file: &str| {
        let matrices = Some(written().join(file));
        let nodes = NodeSource::Nastran(written().join("part.bdf"));
        read_model(&ModelFiles { nodes, mass: matrices.clone(), stiffness: matrices }).unwrap()
    };
    let expected = read("part.pch");
    let (mass, stiffness) = (expected.mass.to_dense(), expected.stiffness.unwrap().to_dense());
    let (heaviest, stiffest) = (mass.norm_max(), stiffness.norm_max());
    let files =
        ["text", "binary", "text_strings", "binary_big_strings", "text_big_strings", "binary_strings"];
    for file in files {
        let model = read(&format!("{file}.op4"));
        // files with six rows a grid point know the point without elements, too
        assert_eq!(model.nodes.ids[..8], expected.nodes.ids, "{file}");
        let found = (model.mass.to_dense(), model.stiffness.unwrap().to_dense());
        let error = (found.0.submatrix(0, 0, 8, 8) - &mass).norm_max();
        assert!(error < PRINTED * heaviest, "{file}: {error:e}");
        let error = (found.1.submatrix(0, 0, 24, 24) - &stiffness).norm_max();
        assert!(error < PRINTED * stiffest, "{file}: {error:e}");
    }
}

const COLUMNS: &str = "       2       2       6       2KAA     1P,3E23.16
       1       1       2
 2.0000000000000000E+00 1.0000000000000000E+00
       2       1       2
 1.0000000000000000E+00 2.0000000000000000E+00
       3       1       1
 1.4142135623730951E+00
";
const STRINGS: &str = "       2      -2       6       2KAA     1P,3E23.16
       1       0       6
       5       1
 2.0000000000000000E+00 1.0000000000000000E+00
       2       0       6
       5       1
 1.0000000000000000E+00 2.0000000000000000E+00
       3       1       1
 1.4142135623730951E+00
";

#[test]
fn columns_that_cannot_be_read_are_named_with_their_line() {
    let nodes = Nodes { ids: vec![1, 2], positions: vec![[0.0; 3], [1.0, 0.0, 0.0]], ..Nodes::default() };
    let read = |text: &[u8]| {
        let folder = Folder::new(&[]);
        std::fs::write(folder.path("k.op4"), text).unwrap();
        crate::import::read_matrix(&folder.path("k.op4"), &nodes)
    };
    for text in [COLUMNS, STRINGS] {
        assert_eq!(dense(&read(text.as_bytes()).unwrap()), MASS);
    }
    let columns = |from: &str, to: &str| COLUMNS.replacen(from, to, 1);
    let strings = |from: &str, to: &str| STRINGS.replacen(from, to, 1);
    let cases = [
        (columns("6       2KAA", "6       4KAA"), "k.op4:1: expected a real matrix"),
        (
            columns("2       2       6", "2       3       6"),
            "expected a square matrix, found 3 rows and 2 columns",
        ),
        (
            columns("       3       1       1", "       4       1       1"),
            "k.op4:6: expected a column from 1 to 3",
        ),
        (columns("1       1       2", "1       2       2"), "k.op4:2: expected rows from 1 to 2 in column 1"),
        (
            columns("1       1       2", "1       1       3"),
            "k.op4:2: expected 3 numbers or words of column 1, found 2 numbers",
        ),
        (columns("2.0000", "2x0000"), "k.op4:3: expected a number in 23 characters"),
        (
            columns(" 2.0000000000000000E+00", "                    nan"),
            "expected a finite number in row 1 of column 1, found NaN",
        ),
        (
            columns("       3       1       1\n 1.4142135623730951E+00\n", ""),
            "expected column 3 that ends the matrix `KAA`, found the end",
        ),
        (format!("{COLUMNS}{COLUMNS}"), "k.op4:8: expected one matrix, found `KAA`, `KAA`"),
        (format!("{COLUMNS}one more line\n"), "k.op4:8: expected `columns rows form type name format`"),
        (strings("       5       1", "       5       2"), "k.op4:3: expected rows from 1 to 2 in column 1"),
        (strings("       5       1", "       1       1"), "k.op4:3: expected length and row of a string"),
        (
            strings("       5       1", "       9       1"),
            "k.op4:3: expected 4 numbers of a string of entries, found 2",
        ),
    ];
    for (text, message) in cases {
        let found = read(text.as_bytes()).unwrap_err().to_string();
        assert!(found.contains(message), "{found}\n{message}\n{text}");
    }
    let sound = std::fs::read(written().join("binary.op4")).unwrap();
    for length in [33, 60, sound.len() - 1, sound.len() - 20] {
        let found = read(&sound[..length]).unwrap_err().to_string();
        assert!(found.contains("k.op4: expected ") && found.contains("at byte"), "{found}");
    }
    let mut rotation = COLUMNS.replace("       2       2       6", "      12      12       6");
    rotation = rotation
        .replace("       3       1       1", "      13       1       1")
        .replace("2       1       2", "5       1       2");
    let found = read(rotation.as_bytes()).unwrap_err().to_string();
    assert_parts(
        &found,
        &[
            "k.op4:4: expected six rows a grid point of which those of rotations are empty",
            "in row 1 of column 5",
        ],
    );
}
