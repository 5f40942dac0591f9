//! One damaged input per kind of defect: the message must name the file, the line and the numbers.

use super::*;

const M: &str = "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 2.0\n2 1 1.0\n2 2 2.0\n";

/// Imports plain files and returns the message.
fn message(nodes: &str, mass: &str, stiffness: &str) -> String {
    let folder = Folder::new(&[("x.txt", nodes), ("m.mtx", mass), ("k.mtx", stiffness)]);
    folder.plain().map(|_| "accepted".to_owned()).unwrap_or_else(|error| error.to_string())
}

#[track_caller]
fn assert_parts(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "`{message}` lacks `{part}`");
    }
}

fn good_stiffness() -> String {
    list(&stiffness(), |_, _| true).join("\n") + "\n"
}

#[test]
fn the_undamaged_files_pass() {
    assert_eq!(message(NODES, M, &good_stiffness()), "accepted");
}

#[test]
fn node_tables() {
    let k = good_stiffness();
    assert_parts(
        &message("0 0 0\n1 0\n", M, &k),
        &["x.txt:2:", "three coordinates", "the end of the line `1 0`"],
    );
    assert_parts(&message("0 0 0\n1 0 0 7\n", M, &k), &["x.txt:2:", "three coordinates", "`7` in `1 0 0 7`"]);
    assert_parts(&message("0 0 0\n1 0 1.5x\n", M, &k), &["x.txt:2:", "`1.5x`"]);
    assert_parts(&message("0 0 0\n1 inf 0\n", M, &k), &["x.txt:2:", "finite", "`inf`"]);
    assert_parts(&message("# nothing\n", M, &k), &["x.txt", "expected nodes, found none"]);
}

#[test]
fn sizes_that_do_not_fit() {
    let k = good_stiffness();
    let three = "0 0 0\n1 0 0\n2 0 0\n";
    assert_parts(&message(three, M, &k), &["k.mtx", "expected 9 rows (x, y, z of 3 nodes)", "found 6 rows"]);
    let wide = "%%MatrixMarket matrix coordinate real general\n2 3 1\n1 3 1.0\n";
    assert_parts(&message(NODES, wide, &k), &["m.mtx", "square", "2 rows and 3 columns"]);
    let small = "%%MatrixMarket matrix coordinate real general\n3 3 1\n1 1 1.0\n";
    assert_parts(&message(NODES, small, &k), &["m.mtx", "6 rows", "or 2 (one direction)", "found 3 rows"]);
}

#[test]
fn truncated_files() {
    let k = good_stiffness();
    let short = M.strip_suffix("2 2 2.0\n").unwrap();
    assert_parts(&message(NODES, short, &k), &["m.mtx:4:", "cut off", "expected 3 entries, found 2"]);
    let cut_line = M.strip_suffix(" 2.0\n").unwrap();
    assert_parts(&message(NODES, cut_line, &k), &["m.mtx:5:", "cut off", "expected 3 entries, found 2"]);
    let array = "%%MatrixMarket matrix array real general\n2 2\n2\n1\n1\n";
    assert_parts(&message(NODES, array, &k), &["m.mtx:5:", "expected 4 values, found 3"]);
    let long = format!("{M}1 2 0.5\n");
    assert_parts(&message(NODES, &long, &k), &["m.mtx:6:", "after 3 entries", "`1` in `1 2 0.5`"]);
    // lists without a count
    let no_value = k.strip_suffix("  5.000000000000000e0\n").unwrap();
    assert_parts(&message(NODES, M, no_value), &["k.mtx:12:", "`row column value`", "the end of the line"]);
    let in_number = k.strip_suffix("0000e0\n").unwrap();
    assert_parts(&message(NODES, M, in_number), &["k.mtx:12:", "19 characters", "cut file"]);
    let lines: Vec<&str> = k.lines().collect();
    let fewer = lines[..9].join("\n") + "\n";
    assert_parts(&message(NODES, M, &fewer), &["k.mtx", "not symmetric", "(6, 3)", "(3, 6) is -5e0", "0e0"]);
}

#[test]
fn malformed_matrix_lines() {
    let k = good_stiffness();
    let replaced = |from: &str, to: &str| message(NODES, &M.replace(from, to), &k);
    assert_parts(&replaced("2 1 1.0", "2 1 abc"), &["m.mtx:4:", "`row column value`", "`abc` in `2 1 abc`"]);
    assert_parts(&replaced("2 1 1.0", "2 x 1.0"), &["m.mtx:4:", "`x` in"]);
    assert_parts(&replaced("2 1 1.0", "3 1 1.0"), &["m.mtx:4:", "an index from 1 to 2", "`3`"]);
    assert_parts(&replaced("2 1 1.0", "0 1 1.0"), &["m.mtx:4:", "an index from 1 to 2", "`0`"]);
    assert_parts(&replaced("2 1 1.0", "2 1 1.0 5"), &["m.mtx:4:", "`5` in"]);
    assert_parts(&replaced("2 1 1.0", "2 1 nan"), &["m.mtx:4:", "finite", "`nan`"]);
    assert_parts(&replaced("2 1 1.0", "2 1 -1e400"), &["m.mtx:4:", "finite", "`-1e400`"]);
    assert_parts(&replaced("%%MatrixMarket", "%%MatrixMarkt"), &["m.mtx:1:", "`%%MatrixMarket matrix"]);
    assert_parts(&replaced("real", "complex"), &["m.mtx:1:", "real|integer"]);
    assert_parts(&replaced("2 2 3", "2 2"), &["m.mtx:2:", "size line"]);
    let many = "`40000000000` in `2 2 40000000000`";
    assert_parts(&replaced("2 2 3", "2 2 40000000000"), &["m.mtx:2:", "at most 4294967295", many]);
    assert_parts(&replaced("2 2 3\n1 1 2.0", "2 2 4\n1 1 2.0\n1 2 1.0"), &["m.mtx:5:", "same triangle"]);
    assert_parts(&message(NODES, M, "1 1\n"), &["k.mtx:1:", "node dof node dof value"]);
    assert_parts(&message(NODES, M, ""), &["k.mtx:1:", "the end of the file"]);
    assert_parts(&message(NODES, M, "0 1 0 1 3.0\n0 4 0 1 3.0\n"), &["k.mtx:2:", "dof 1 to 3", "`4`"]);
    assert_parts(&message(NODES, M, "0,1, 5,1, 3.0\n"), &["k.mtx:1:", "2 nodes", "found node 5"]);
}

#[test]
fn asymmetric_matrices() {
    let mut k = stiffness();
    k[4][1] = -4.5;
    let text = list(&k, |_, _| true).join("\n") + "\n";
    assert_parts(
        &message(NODES, M, &text),
        &["k.mtx", "(5, 2) is -4.5e0", "(2, 5) is -4e0", "1.000e-1 of the largest"],
    );
    let triangle = "%%MatrixMarket matrix coordinate real general\n2 2 3\n1 1 2.0\n2 1 1.0\n2 2 2.0\n";
    assert_parts(&message(NODES, triangle, &good_stiffness()), &["m.mtx", "(2, 1) is 1e0", "(1, 2) is 0e0"]);
}

#[test]
fn indefinite_matrices() {
    let k = good_stiffness();
    assert_parts(
        &message(NODES, &M.replace("2 1 1.0", "2 1 3.0"), &k),
        &["m.mtx", "mass matrix is indefinite", "1 of 2 pivots", "-1.250e0 times"],
    );
    let mut bad = stiffness();
    bad[4][4] = -4.0;
    let text = list(&bad, |_, _| true).join("\n") + "\n";
    assert_parts(&message(NODES, M, &text), &["k.mtx", "stiffness matrix is indefinite", "1 of 6 pivots"]);
    let negative = M.replace("2.0", "-2.0");
    assert_parts(&message(NODES, &negative, &k), &["m.mtx", "positive total mass", "-2e0 kg"]);
}

#[test]
fn mass_that_differs_between_directions() {
    let mut mass = full_mass();
    mass[4][4] += 1e-3;
    let text = list(&mass, |_, _| true).join("\n") + "\n";
    assert_parts(
        &message(NODES, &text, &good_stiffness()),
        &["m.mtx", "not the same in x, y and z", "(5, 5)", "e-4 of the largest entry", "tolerated 1e-9"],
    );
    let mut coupled = full_mass();
    (coupled[0][1], coupled[1][0]) = (0.5, 0.5);
    let text = list(&coupled, |_, _| true).join("\n") + "\n";
    assert_parts(&message(NODES, &text, &good_stiffness()), &["(2, 1)", "2.500e-1"]);
    // round-off passes and is reported
    let mut noisy = full_mass();
    noisy[4][4] += 1e-14;
    let text = list(&noisy, |_, _| true).join("\n") + "\n";
    let folder = Folder::new(&[("x.txt", NODES), ("m.mtx", &text), ("k.mtx", &good_stiffness())]);
    let anisotropy = folder.plain().unwrap().mass_anisotropy;
    assert!(anisotropy > 1e-15 && anisotropy < 1e-14, "{anisotropy:e}");
}

#[test]
fn ansys_tables_and_mappings() {
    let folder = |table: &str, map: &str| {
        let k = good_stiffness();
        let folder = Folder::new(&[("n.txt", table), ("map.txt", map), ("m.mtx", M), ("k.mtx", &k)]);
        let (nodes, mapping) = (folder.path("n.txt"), Some(folder.path("map.txt")));
        folder.with_nodes(NodeSource::Ansys { nodes, mapping }).map(|_| ()).unwrap_err().to_string()
    };
    let table = "Node\tX\tY\tZ\n1\t0,\t0,\t0,\n2\t1,\t0,\t0,\n";
    assert_parts(&folder(table, "1\n"), &["map.txt", "each of the 2 nodes", "found 1 entries"]);
    assert_parts(&folder(table, "1\n3\n"), &["map.txt:2:", "node 3", "2 nodes"]);
    assert_parts(&folder(table, "1\n1\n"), &["map.txt:2:", "each node once"]);
    let header = "%%MatrixMarket matrix array integer general\n2 1\n1\n";
    assert_parts(&folder(table, header), &["map.txt:3:", "expected 2 nodes, found 1"]);
    assert_parts(&folder("1\t0,\t0,\t0,\n2\t1,\t0,\n", "1\n2\n"), &["n.txt:2:", "`id x y z`"]);
    assert_parts(&folder("1\t0,\t0,\t0,\n2\t1,\t0,\t1,,\n", "1\n2\n"), &["n.txt:2:"]);
    assert_parts(&folder("1\t0,\t0,\t0,\n1\t1,\t0,\t0,\n", "1\n2\n"), &["n.txt:2:", "node 1"]);
}

#[test]
fn a_missing_mass_is_asked_for() {
    let folder = Folder::new(&[("x.txt", NODES)]);
    let nodes = NodeSource::Text(folder.path("x.txt"));
    let error = read_model(&ModelFiles { nodes, mass: None, stiffness: None }).unwrap_err();
    assert_eq!(error.to_string(), "the mass file is missing: name it with --mass");
}

#[test]
fn defects_late_in_a_file_that_is_read_in_pieces() {
    let lines: Vec<String> = (1..=100_000).map(|row| format!("{row} {row} {row}.0")).collect();
    let message = |damaged: &[(usize, &str)], line_end: &str| {
        let mut lines = lines.clone();
        for &(line, text) in damaged {
            lines[line - 1] = text.to_owned();
        }
        let folder = Folder::new(&[("k.mtx", &(lines.join(line_end) + line_end))]);
        let read = super::super::read_matrix(&folder.path("k.mtx"), &crate::Nodes::default());
        read.map(|matrix| format!("{} entries", matrix.compute_nnz()))
            .unwrap_or_else(|error| error.to_string())
    };
    for line_end in ["\n", "\r\n"] {
        assert_eq!(message(&[], line_end), "100000 entries");
        let late = (99_990, "99990 x 1.0");
        assert_parts(&message(&[late], line_end), &["k.mtx:99990:", "`x` in `99990 x 1.0`"]);
        // the first of two, in the same piece and in another
        let earlier = (99_980, "99980 99980 inf");
        assert_parts(&message(&[late, earlier], line_end), &["k.mtx:99980:", "finite", "`inf`"]);
        let early = (7, "7 0 1.0");
        assert_parts(&message(&[late, early], line_end), &["k.mtx:7:", "an index from 1", "`0`"]);
        let alone = (99_999, "99999 99998 5.0");
        assert_parts(&message(&[alone], line_end), &["100001 entries"]);
    }
}
