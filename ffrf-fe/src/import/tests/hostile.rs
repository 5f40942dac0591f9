//! Files that announce more than they hold, grow without limit, or carry control characters.

use super::*;
use crate::import::{ImportOptions, read_mode_shapes, read_model_with, read_square_matrix};

fn deck(text: &str) -> Result<FeModel, ImportError> {
    let mass = "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 2\n2 2 2\n";
    let folder = Folder::new(&[("part.inp", text), ("m.mtx", mass)]);
    folder.with_nodes(NodeSource::Abaqus(folder.path("part.inp")))
}

#[test]
fn sizes_that_a_header_announces_are_not_allocated() {
    let header =
        |kind: &str, size: &str| format!("%%MatrixMarket matrix {kind} real general\n{size}\n1 1 1.0\n");
    let folder = Folder::new(&[
        ("coordinate.mtx", &header("coordinate", "33 4000000000 1")),
        ("array.mtx", &header("array", "33 4000000000")),
        ("many.mtx", &header("coordinate", "33 34 1")),
        ("square.mtx", &header("coordinate", "4000000000 4000000000 1")),
        ("list.mtx", "1 1 1.0\n4000000000 1 1.0\n"),
    ]);
    for name in ["coordinate.mtx", "array.mtx"] {
        let message = read_mode_shapes(&folder.path(name), 11).unwrap_err().to_string();
        assert_parts(&message, &[name, "at most 33 modes", "found 4000000000 columns"]);
    }
    let message = read_mode_shapes(&folder.path("many.mtx"), 11).unwrap_err().to_string();
    assert_parts(&message, &["at most 33 modes, as many as degrees of freedom", "found 34 columns"]);
    for name in ["square.mtx", "list.mtx"] {
        let message =
            crate::import::read_matrix(&folder.path(name), &crate::Nodes::default()).unwrap_err().to_string();
        assert_parts(&message, &[name, "at most 16777216 rows", "found 4000000000 rows"]);
    }
    let message = read_square_matrix(&folder.path("square.mtx"), 3).unwrap_err().to_string();
    assert_parts(&message, &["expected 3 rows and columns", "found 4000000000 rows"]);
}

#[test]
fn numpy_headers_are_looked_over_first() {
    let shape = |shape: &str| {
        let text = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}\n");
        [b"\x93NUMPY\x01\x00", (text.len() as u16).to_le_bytes().as_slice(), text.as_bytes()].concat()
    };
    for (bytes, found) in [
        (b"\x93NUMPY\x02\x00\xff\xff\xff\xff".to_vec(), "4294967295 bytes announced"),
        (shape("(33, 4000000000)"), "132000000000 announced"),
        (shape("(4294967295, 4294967295, 4294967295)"), "announced"),
        (shape("(33, 6)"), "a complete NumPy array"),
    ] {
        let folder = Folder::new(&[]);
        std::fs::write(folder.path("psi.npy"), bytes).unwrap();
        let message = read_mode_shapes(&folder.path("psi.npy"), 11).unwrap_err().to_string();
        assert_parts(&message, &["psi.npy", found]);
    }
}

#[test]
fn node_ids_of_an_array_are_different() {
    let ids = |second: f64| {
        let folder = Folder::new(&[]);
        let nodes = [7.0, 0.0, 0.0, 0.0, second, 1.0, 0.0, 0.0];
        std::fs::write(folder.path("x.npy"), formats::npy(&nodes, &[2, 4])).unwrap();
        std::fs::write(folder.path("m.mtx"), list(&full_mass(), |_, _| true).join("\n") + "\n").unwrap();
        folder.with_nodes(NodeSource::Numpy(folder.path("x.npy"))).map(|model| model.nodes.ids)
    };
    assert_eq!(ids(9.0).unwrap(), [7, 9]);
    assert_parts(
        &ids(7.0).unwrap_err().to_string(),
        &["x.npy", "each node id once", "found 7 again in row 2"],
    );
}

#[test]
fn compressed_files_have_a_limit() {
    use std::io::Write;
    let folder = Folder::new(&[("m.mtx", "1 1 1.0\n")]);
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::best());
    encoder.write_all(&vec![b' '; 100_000]).unwrap();
    std::fs::write(folder.path("x.txt.gz"), encoder.finish().unwrap()).unwrap();
    let nodes = NodeSource::Text(folder.path("x.txt"));
    let files = ModelFiles { nodes, mass: Some(folder.path("m.mtx")), stiffness: None };
    let options = ImportOptions { inflated_limit: 99_999, ..ImportOptions::default() };
    let message = read_model_with(&files, &options).unwrap_err().to_string();
    assert_parts(&message, &["x.txt.gz", "more than 99999 bytes, the limit"]);
    assert_parts(&read_model(&files).unwrap_err().to_string(), &["x.txt.gz: expected nodes, found none"]);
}

#[test]
fn sets_that_name_each_other_do_not_multiply() {
    let mut text = "*NODE\n1,0,0,0\n2,1,0,0\n*NSET, NSET=s0\n1, 2\n".to_owned();
    for level in 1..60 {
        text += &format!("*NSET, NSET=s{level}\ns{0}, s{0}, s{0}, s{0}\n", level - 1);
    }
    assert_eq!(deck(&text).unwrap().nodes.sets["s59"], [0, 1]);
}

#[test]
fn included_files_do_not_multiply() {
    let line = "*INCLUDE, INPUT=part.inp\n";
    assert_parts(
        &deck(line).unwrap_err().to_string(),
        &["part.inp:1:", "a file that does not include itself"],
    );
    let many = "*INCLUDE, INPUT=other.inp\n".repeat(1001);
    let folder = Folder::new(&[("part.inp", &many), ("other.inp", "*NODE\n1,0,0,0\n"), ("m.mtx", "")]);
    let message = folder.with_nodes(NodeSource::Abaqus(folder.path("part.inp"))).unwrap_err().to_string();
    assert_parts(&message, &["part.inp:1001:", "at most 1000 included files", "found 1001"]);
    for level in 0..9 {
        let text = format!("*INCLUDE, INPUT=f{}.inp\n", level + 1);
        std::fs::write(folder.path(&format!("f{level}.inp")), text).unwrap();
    }
    let message = folder.with_nodes(NodeSource::Abaqus(folder.path("f0.inp"))).unwrap_err().to_string();
    assert_parts(&message, &["f8.inp:1:", "at most 8 files included in each other", "found 9"]);
}

#[test]
fn labels_of_instances_do_not_overflow() {
    let text = format!(
        "*PART, NAME=p\n*NODE\n{}, 0, 0, 0\n*END PART\n*INSTANCE, NAME=a, PART=p\n*END INSTANCE\n\
         *INSTANCE, NAME=b, PART=p\n*END INSTANCE\n",
        u64::MAX / 2 + 1
    );
    let message = deck(&text).unwrap_err().to_string();
    assert_parts(&message, &["part.inp:3:", "9223372036854775808", "cannot be raised", "below 2^64"]);
}

#[test]
fn labels_that_were_raised_do_not_clash_with_a_third_instance() {
    let text = "*PART, NAME=p\n*NODE\n1, 0, 0, 0\n*END PART\n*PART, NAME=q\n*NODE\n2, 1, 0, 0\n*END PART\n\
                *INSTANCE, NAME=a, PART=p\n*END INSTANCE\n*INSTANCE, NAME=b, PART=p\n*END INSTANCE\n\
                *INSTANCE, NAME=c, PART=q\n*END INSTANCE\n";
    let folder = Folder::new(&[
        ("part.inp", text),
        ("m.mtx", "1 1 1\n2 2 1\n3 3 1\n4 4 1\n5 5 1\n6 6 1\n7 7 1\n8 8 1\n9 9 1\n"),
    ]);
    let model = folder.with_nodes(NodeSource::Abaqus(folder.path("part.inp"))).unwrap();
    assert_eq!(model.nodes.ids, [1, 2, 4]);
    std::fs::write(folder.path("part.inp"), text.replace("\n1, 0, 0, 0", "\n0, 0, 0, 0")).unwrap();
    let model = folder.with_nodes(NodeSource::Abaqus(folder.path("part.inp"))).unwrap();
    assert_eq!(model.nodes.ids, [0, 1, 2]);
}

#[test]
fn control_characters_of_a_file_are_escaped() {
    for text in [
        "*Node\n1, \u{1b}]0;x\u{7}, 0, 0\n",
        "*Instance, part=\u{1b}[2J, name=i\n",
        "*INCLUDE, INPUT=\u{1b}c\n",
    ] {
        let message = deck(text).unwrap_err().to_string();
        assert!(message.contains("\\u{1b}"), "{message:?}");
        assert!(!message.contains(char::is_control), "{message:?}");
    }
}
