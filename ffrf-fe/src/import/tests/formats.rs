//! The same small model in every format gives the same matrices.

use proptest::prelude::*;

use super::*;

fn header(size: usize, lines: &[String], symmetry: &str) -> String {
    let banner = format!("%%MatrixMarket matrix coordinate real {symmetry}\n% comment\n");
    format!("{banner}{size} {size} {}\n{}\n", lines.len(), lines.join("\n"))
}

#[test]
fn matrix_market_in_all_its_forms() {
    let lower = header(6, &list(&stiffness(), |i, j| i >= j), "symmetric");
    let upper = header(6, &list(&stiffness(), |i, j| i <= j), "symmetric");
    let general = header(6, &list(&stiffness(), |_, _| true), "general");
    let numbers: Vec<String> = stiffness().concat().iter().map(f64::to_string).collect();
    let array = format!("%%MatrixMarket matrix array real general\n6 6\n{}\n", numbers.join("\n"));
    let full_mass = header(6, &list(&full_mass(), |i, j| i >= j), "symmetric");
    let masses = [
        "%%MatrixMarket matrix coordinate integer symmetric\r\n2 2 3\r\n1 1 2\r\n2 1 1\r\n2 2 2\r\n",
        "%%MatrixMarket matrix array real symmetric\n2 2\n2.0\n1.0\n2.0\n",
        // duplicates are summed
        "%%matrixmarket MATRIX Coordinate Real General\n2 2 5\n1 1 1.5\n1 1 0.5\n1 2 1\n2 1 1\n2 2 2\n",
        &full_mass,
    ];
    for stiffness in [&lower, &upper, &general, &array] {
        for mass in masses {
            let folder = Folder::new(&[("x.txt", NODES), ("m.mtx", mass), ("k.mtx", stiffness)]);
            assert_is_the_pair(&folder.plain().unwrap());
        }
    }
}

#[test]
fn abaqus_lists_with_one_or_both_triangles() {
    let deck = "*Part, name=p\n*End Part\n*Assembly, name=A\n*Instance, name=p-1, part=p\n*Node\n\
                7, 0., 0., 0.\n3, 1., 0., 0.\n9, 5., 5., 5.\n*Element, type=T3D2\n1, 7, 3\n*Nset, nset=end\n 3,\n\
                *End Instance\n*End Assembly\n";
    let labels = |line: &String| {
        let fields: Vec<&str> = line.split_whitespace().collect();
        let dof = |field: &str| {
            let dof = field.parse::<usize>().unwrap() - 1;
            format!("{},{}", [7, 3][dof / 3], dof % 3 + 1)
        };
        format!("{}, {}, {}", dof(fields[0]), dof(fields[1]), fields[2])
    };
    let keeps: [fn(usize, usize) -> bool; 3] = [|_, _| true, |i, j| i >= j, |i, j| i <= j];
    for keep in keeps {
        let (k, m) = (list(&stiffness(), keep), list(&full_mass(), keep));
        let numbered = [("m.mtx", m.join("\n") + "\n"), ("k.mtx", k.join("\n") + "\n")];
        let by_label = |lines: &[String]| {
            format!("** comment\n{}\n", lines.iter().map(labels).collect::<Vec<_>>().join("\n"))
        };
        let labelled = [("m.mtx", by_label(&m)), ("k.mtx", by_label(&k))];
        for files in [numbered, labelled] {
            let folder =
                Folder::new(&[("p.inp", deck), (files[0].0, &files[0].1), (files[1].0, &files[1].1)]);
            let model = folder.with_nodes(NodeSource::Abaqus(folder.path("p.inp"))).unwrap();
            assert_is_the_pair(&model);
            assert_eq!(model.nodes.ids, [7, 3], "node 9 belongs to no element and no matrix");
            assert_eq!(model.nodes.sets["end"], [1]);
            let sources: Vec<_> = model.sources.iter().map(|s| (s.role.as_str(), s.file.as_str())).collect();
            assert_eq!(sources, [("nodes", "p.inp"), ("mass", "m.mtx"), ("stiffness", "k.mtx")]);
        }
    }
}

#[test]
fn calculix_rows_are_found_by_the_dof_file() {
    let deck = "*NODE\n4,1,0,0\n2,0,0,0\n8,9,9,9\n*ELEMENT,TYPE=T3D2\n1,2,4\n";
    let upper = |matrix: &[Vec<f64>]| list(matrix, |i, j| i <= j).join("\n") + "\n";
    let folder = Folder::new(&[
        ("rod.inp", deck),
        ("rod.dof", "2.1\n2.2\n2.3\n4.1\n4.2\n4.3\n"),
        ("rod.sti", &upper(&stiffness())),
        ("rod.mas", &upper(&full_mass())),
    ]);
    let nodes = NodeSource::Calculix(folder.path("rod.inp"));
    let model = read_model(&ModelFiles { nodes, mass: None, stiffness: None }).unwrap();
    // node 4 stands first in the deck
    assert_eq!(model.nodes.ids, [4, 2]);
    assert_eq!(model.nodes.positions, [[1.0, 0.0, 0.0], [0.0; 3]]);
    assert_eq!(dense(&model.mass), MASS);
    assert_eq!(dense(model.stiffness.as_ref().unwrap()), stiffness());
    let roles: Vec<_> = model.sources.iter().map(|source| source.role.as_str()).collect();
    assert_eq!(roles, ["nodes", "degrees of freedom", "mass", "stiffness"]);
}

#[test]
fn ansys_nodes_with_decimal_commas_in_matrix_order() {
    let lower = header(6, &list(&stiffness(), |i, j| i >= j), "symmetric");
    let mass = header(6, &list(&full_mass(), |i, j| i >= j), "symmetric");
    for table in [
        "Knotennummer\tX-Position (m)\tY (m)\tZ (m)\t\r\n12\t1,\t0,\t0,e+000\t\r\n5\t0,\t0,\t0,\t\r\n",
        "Node Number;X;Y;Z\n12;1.0;0.0;0.0\n5;0.0;0.0;0.0\n",
        "12, 1.0, 0, 0\n5, 0, 0, 0\n",
        "12 1. 0 0\n5 0 0 0\n",
    ] {
        let folder = Folder::new(&[
            ("nodes.txt", table),
            ("map.txt", "%%MatrixMarket matrix array integer general\n2 1\n5\n12\n"),
            ("m.mtx", &mass),
            ("k.mtx", &lower),
        ]);
        let (nodes, mapping) = (folder.path("nodes.txt"), Some(folder.path("map.txt")));
        let model = folder.with_nodes(NodeSource::Ansys { nodes: nodes.clone(), mapping }).unwrap();
        assert_is_the_pair(&model);
        assert_eq!(model.nodes.ids, [5, 12]);
        let table_order = folder.with_nodes(NodeSource::Ansys { nodes, mapping: None }).unwrap();
        assert_eq!(table_order.nodes.ids, [12, 5]);
    }
}

pub(super) fn npy<T: npyz::AutoSerialize + Copy>(values: &[T], shape: &[u64]) -> Vec<u8> {
    use npyz::WriterBuilder;
    let mut bytes = Vec::new();
    let mut writer =
        npyz::WriteOptions::new().default_dtype().shape(shape).writer(&mut bytes).begin_nd().unwrap();
    writer.extend(values.iter().copied()).unwrap();
    writer.finish().unwrap();
    bytes
}

fn write_npz<'a>(path: &std::path::Path, arrays: impl Iterator<Item = &'a (&'a str, Vec<u8>)>) {
    let mut archive = zip::ZipWriter::new(std::fs::File::create(path).unwrap());
    for (name, bytes) in arrays {
        archive.start_file(format!("{name}.npy"), zip::write::SimpleFileOptions::default()).unwrap();
        std::io::Write::write_all(&mut archive, bytes).unwrap();
    }
    archive.finish().unwrap();
}

#[test]
fn numpy_arrays_and_scipy_archives() {
    let folder = Folder::new(&[]);
    std::fs::write(folder.path("x.npy"), npy(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0], &[2, 3])).unwrap();
    std::fs::write(folder.path("m.npy"), npy(&MASS.concat(), &[2, 2])).unwrap();
    let flat = stiffness().concat();
    std::fs::write(folder.path("k.npy"), npy(&flat, &[6, 6])).unwrap();
    let places: Vec<usize> = (0..36).filter(|&place| flat[place] != 0.0).collect();
    let data: Vec<f64> = places.iter().map(|&place| flat[place]).collect();
    let counted = |numbers: Vec<usize>| {
        let numbers: Vec<i64> = numbers.into_iter().map(|number| number as i64).collect();
        npy(&numbers, &[numbers.len() as u64])
    };
    let indices = counted(places.iter().map(|&place| place % 6).collect());
    let rows = counted(places.iter().map(|&place| place / 6).collect());
    let starts =
        counted((0..=6).map(|row| places.iter().filter(|&&place| place < 6 * row).count()).collect());
    let data = npy(&data, &[places.len() as u64]);
    // What scipy.sparse.save_npz writes, but for `format`, which is a text and only tells that the matrix is sparse.
    let common = [("format", counted(vec![0])), ("shape", counted(vec![6, 6])), ("data", data)];
    let compressed = [("indices", indices.clone()), ("indptr", starts)];
    // Of a symmetric matrix, csr and csc are the same arrays.
    write_npz(&folder.path("csr.npz"), common.iter().chain(&compressed));
    write_npz(&folder.path("coo.npz"), common.iter().chain(&[("row", rows), ("col", indices)]));
    for stiffness in ["k.npy", "csr.npz", "coo.npz"] {
        let files = ModelFiles {
            nodes: NodeSource::Numpy(folder.path("x.npy")),
            mass: Some(folder.path("m.npy")),
            stiffness: Some(folder.path(stiffness)),
        };
        assert_is_the_pair(&read_model(&files).unwrap());
    }
    // cut in the middle of the data
    let whole = std::fs::read(folder.path("k.npy")).unwrap();
    std::fs::write(folder.path("k.mtx"), &whole[..whole.len() - 20]).unwrap();
    std::fs::copy(folder.path("m.npy"), folder.path("m.mtx")).unwrap();
    std::fs::write(folder.path("x.txt"), NODES).unwrap();
    let message = folder.plain().unwrap_err().to_string();
    assert!(message.contains("k.mtx") && message.contains("complete NumPy array"), "{message}");
}

#[test]
fn mode_shapes_in_text_matrix_market_and_numpy() {
    let columns = [1.0, 0.5, -2.0, 0.0, 1e-3, 4.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0];
    let row = |i: usize| format!("{} {}", columns[i], columns[6 + i]);
    let text = (0..6).map(row).collect::<Vec<_>>().join("\n");
    let numbers: Vec<String> = columns.iter().map(f64::to_string).collect();
    let array = format!("%%MatrixMarket matrix array real general\n6 2\n{}\n", numbers.join("\n"));
    let entry = |k: usize| format!("{} {} {}\n", k % 6 + 1, k / 6 + 1, columns[k]);
    let listed: String = (0..12).map(entry).collect();
    let coordinate = format!("%%MatrixMarket matrix coordinate real general\n6 2 12\n{listed}");
    let folder = Folder::new(&[("a.txt", &text), ("b.mtx", &array), ("c.mtx", &coordinate)]);
    let by_rows: Vec<f64> = (0..12).map(|k| columns[k % 2 * 6 + k / 2]).collect();
    std::fs::write(folder.path("d.npy"), npy(&by_rows, &[6, 2])).unwrap();
    for name in ["a.txt", "b.mtx", "c.mtx", "d.npy"] {
        let shapes = crate::import::read_mode_shapes(&folder.path(name), 2).unwrap();
        assert_eq!((shapes.nrows(), shapes.ncols()), (6, 2));
        for k in 0..12 {
            assert_eq!(shapes[(k % 6, k / 6)], columns[k], "{name}");
        }
        let message = crate::import::read_mode_shapes(&folder.path(name), 3).unwrap_err().to_string();
        assert!(message.contains("expected 9 rows (x, y, z of 3 nodes), found 6 rows"), "{message}");
    }
}

#[test]
fn modal_stiffness_must_be_square_and_symmetric() {
    let folder = Folder::new(&[
        ("k.txt", "1.0 2.0\n2.0 5.0\n"),
        ("bad.txt", "1 2\n3 4\n"),
        ("wide.txt", "1 2 3\n4 5 6\n"),
    ]);
    let matrix = crate::import::read_square_matrix(&folder.path("k.txt"), 2).unwrap();
    assert_eq!((matrix[(0, 1)], matrix[(1, 1)]), (2.0, 5.0));
    let message =
        |name: &str| crate::import::read_square_matrix(&folder.path(name), 2).unwrap_err().to_string();
    assert!(message("bad.txt").contains("entry (2, 1) is 3e0, entry (1, 2) is 2e0; deviation 2.500e-1"));
    assert!(message("wide.txt").contains("found 2 rows and 3 columns"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// Any diagonally dominant matrix survives a trip through each triangle and the full form, to the bit.
    #[test]
    fn written_matrices_come_back(values in proptest::collection::vec(-1.0_f64..1.0, 21), exponent in -12_i32..13) {
        let mut matrix = vec![vec![0.0; 6]; 6];
        let mut values = values.into_iter();
        for i in 0..6 {
            for j in 0..=i {
                let value = values.next().unwrap() * 10_f64.powi(exponent);
                matrix[i][j] = value;
                matrix[j][i] = value;
            }
            matrix[i][i] = 20.0 * 10_f64.powi(exponent);
        }
        let mass = "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 2\n2 1 1\n2 2 2\n";
        let keeps: [fn(usize, usize) -> bool; 3] = [|_, _| true, |i, j| i >= j, |i, j| i <= j];
        for keep in keeps {
            let lines = list_exactly(&matrix, keep);
            let folder = Folder::new(&[("x.txt", NODES), ("m.mtx", mass), ("k.mtx", &lines)]);
            let model = folder.plain().unwrap();
            prop_assert_eq!(dense(model.stiffness.as_ref().unwrap()), matrix.clone());
        }
    }
}

fn list_exactly(matrix: &[Vec<f64>], keep: fn(usize, usize) -> bool) -> String {
    let mut text = String::new();
    for i in 0..6 {
        for j in (0..6).filter(|&j| keep(i, j)) {
            text += &format!("{}\t{}\t{:e}\n", i + 1, j + 1, matrix[i][j]);
        }
    }
    text
}
