//! Meshes: files of gmsh against regular bricks, and defects.

use super::*;
use crate::elements::{ElementError, Material, quadratic_brick};
use crate::import::{ImportOptions, SolidsMaterial, read_model_with};

/// gmsh places nodes along a curve to about this part of its length, and elements are short.
const PLACED: f64 = 1e-9;
/// Positions and sums of a few products.
const ROUND_OFF: f64 = 1e-12;

fn written(file: &str) -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/gmsh")).join(file)
}

fn assembled(path: PathBuf) -> Result<FeModel, ImportError> {
    let nodes = NodeSource::Mesh { path, materials: SolidsMaterial::all(Material::STEEL) };
    read_model(&ModelFiles { nodes, mass: None, stiffness: None })
}

fn text(mesh: &str) -> Result<FeModel, ImportError> {
    assembled(Folder::new(&[("p.msh", mesh)]).path("p.msh"))
}

#[test]
fn physical_groups_are_node_sets() {
    let mut found = Vec::new();
    for file in ["hex20_4.1.msh", "hex20_2.2.msh", "tet10_4.1.msh", "tet10_2.2.msh"] {
        let model = assembled(written(file)).unwrap();
        let nodes = &model.nodes;
        let at = |keep: &dyn Fn([f64; 3]) -> bool| -> Vec<usize> {
            (0..nodes.len()).filter(|&row| keep(nodes.positions[row])).collect()
        };
        assert_eq!(nodes.sets["left end"], at(&|[x, _, _]| x.abs() < ROUND_OFF), "{file}");
        let edge = at(&|[x, y, _]| (x - 1.0).abs() < ROUND_OFF && y.abs() < ROUND_OFF);
        assert_eq!((nodes.sets["edge"].len(), &nodes.sets["edge"]), (3, &edge), "{file}");
        assert_eq!(nodes.sets["point_8"].len(), 1, "{file}");
        assert_eq!(nodes.sets["part"].len(), nodes.len(), "{file}");
        let [note] = model.notes.as_slice() else { panic!("{:?}", model.notes) };
        assert_parts(note, &[file, "assembled of", "density 7850.0", "2.1e11", "0.3"]);
        assert_eq!(model.sources[0].role, "mesh");
        found.push(model);
    }
    for pair in found.chunks(2) {
        assert_eq!(pair[0].nodes.positions, pair[1].nodes.positions);
        assert_eq!(pair[0].elements, pair[1].elements);
    }
}

/// Node by node against a brick whose elements are numbered by the shape functions themselves.
#[test]
fn a_mesh_of_gmsh_is_the_brick_that_is_made_here() {
    let found = assembled(written("hex20_4.1.msh")).unwrap();
    let brick = quadratic_brick([1.0, 0.1, 0.2], [6, 1, 1], &Material::STEEL).unwrap();
    assert_eq!(found.nodes.len(), brick.nodes.len());
    let same = |a: &[f64; 3], b: &[f64; 3]| (0..3).all(|k| (a[k] - b[k]).abs() < ROUND_OFF);
    let row_of = |at: &[f64; 3]| brick.nodes.positions.iter().position(|other| same(at, other)).unwrap();
    let rows: Vec<usize> = found.nodes.positions.iter().map(row_of).collect();
    let (mass, expected) = (found.mass.to_dense(), brick.mass.to_dense());
    let (stiffness, stiff) = (found.stiffness.unwrap().to_dense(), brick.stiffness.unwrap().to_dense());
    let (heaviest, stiffest) = (expected.norm_max(), stiff.norm_max());
    for (a, &i) in rows.iter().enumerate() {
        for (b, &j) in rows.iter().enumerate() {
            assert!((mass[(a, b)] - expected[(i, j)]).abs() < PLACED * heaviest);
            for (k, l) in (0..3).flat_map(|k| (0..3).map(move |l| (k, l))) {
                let error = (stiffness[(3 * a + k, 3 * b + l)] - stiff[(3 * i + k, 3 * j + l)]).abs();
                assert!(error < PLACED * stiffest, "{error:e}");
            }
        }
    }
}

const TETRAHEDRON: &str = "$MeshFormat
4.1 0 8
$EndMeshFormat
$Nodes
1 5 1 5
3 1 0 5
1
2
3
4
5
0 0 0
1 0 0
0 1 0
0 0 1
7 7 7
$EndNodes
$Elements
1 1 1 1
3 1 4 1
1 1 2 3 4
$EndElements
";
const LEGACY: &str = "$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
4
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
$EndNodes
$Elements
2
1 4 2 1 1 1 2 3 4
2 4 2 2 1 1 2 3 4
$EndElements
";

#[test]
fn nodes_without_solids_are_left_out_and_volumes_in_two_groups_come_once() {
    let model = text(TETRAHEDRON).unwrap();
    assert_eq!(model.nodes.len(), 4);
    assert_parts(&model.notes[0], &["p.msh: 1 node is in no solid and left out (node 5)"]);
    let total: f64 = model.mass.val().iter().sum();
    assert!((total / (7850.0 / 6.0) - 1.0).abs() < ROUND_OFF, "{total}");
    let twice = text(LEGACY).unwrap();
    assert_eq!(twice.elements, model.elements);
    assert_eq!(twice.nodes.sets["volume_2"], [0, 1, 2, 3]);
    assert_eq!(dense(&twice.mass), dense(&model.mass));
}

#[test]
fn what_cannot_be_read_is_named_with_its_line() {
    let change = |from: &str, to: &str| TETRAHEDRON.replace(from, to);
    let parametric = LEGACY.replace("Nodes\n", "ParametricNodes\n");
    let cases = [
        (
            parametric,
            "p.msh:4: the section `$ParametricNodes` is not supported here: save the mesh with Mesh.Save",
        ),
        (change("4.1 0 8", "4 0 8"), "p.msh:2: expected version 4.1 or 2.2"),
        (change("4.1 0 8", "4.1 1 8"), "p.msh:2: expected an ASCII file"),
        (
            change("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n", "$Comments\n$EndComments\n"),
            "p.msh:3: expected the section `$MeshFormat` first",
        ),
        (change("1 5 1 5", "1 6 1 5"), "p.msh:17: expected 6 nodes, as announced, found 5"),
        (change("3 1 0 5\n", "3 1 0 6\n"), "p.msh:12: expected one tag of a node a line"),
        (change("7 7 7\n", "7 7\n"), "expected the coordinates x y z of a node"),
        (change("1 0 0\n", "1 x 0\n"), "p.msh:13: expected the coordinates x y z of a node, found `x`"),
        (change("1 0 0\n", "1 nan 0\n"), "p.msh:13: expected a finite number, found `nan`"),
        (change("5\n0 0 0", "1\n0 0 0"), "p.msh:11: node 1 is given a second time"),
        (
            change("1 1 2 3 4", "1 1 2 3 9"),
            "p.msh:21: expected a node of the node table (5 nodes), found node 9",
        ),
        (
            change("1 1 2 3 4", "1 1 2 3"),
            "p.msh:21: expected `tag node node ...` of an element, found the end of the line",
        ),
        (change("1 1 2 3 4", "1 1 2 4 3"), "p.msh:21: element 0 (from 0): the Jacobian determinant is -"),
        (
            change("1 1 2 3 4", "1 1 2 3 4 5"),
            "p.msh:21: expected `tag node node ...` of an element, found `5`",
        ),
        (
            change("3 1 4 1\n", "3 1 12 1\n"),
            "p.msh:20: element type 12, a solid of 27 nodes, is not supported here: mesh with Mesh.SecondOrder",
        ),
        (change("3 1 4 1\n", "3 1 99 1\n"), "p.msh:20: expected the number of an element type"),
        (change("1 1 1 1\n", "1 2 1 1\n"), "expected 2 elements, as announced, found 1"),
        (change("3 1 4 1\n1 1", "3 1 4 2\n1 1 2 3 4\n2 1"), "p.msh:22: expected each solid once"),
        (change("$EndElements\n", ""), "expected `$EndElements`, found the end of the file"),
        (
            change("$EndElements\n", "$EndElements\n$Periodic\n0\n"),
            "p.msh:23: expected a line `$EndPeriodic`",
        ),
        (
            change("$EndNodes\n", "$EndNodes\n$PartitionedEntities\n"),
            "p.msh:18: a partitioned mesh is not supported",
        ),
        (
            change("3 1 4 1\n1 1 2 3 4", "2 1 2 1\n1 1 2 3"),
            "p.msh: expected tetrahedra or hexahedra, found 5 nodes and no solid",
        ),
        (TETRAHEDRON[..TETRAHEDRON.find("$Nodes").unwrap()].to_owned(), "expected nodes, found none"),
        ("solid part\n".to_owned(), "p.msh:1: expected a mesh of gmsh"),
    ];
    for (mesh, message) in cases {
        let found = text(&mesh).unwrap_err().to_string();
        assert!(found.contains(message), "{found}\n{message}\n{mesh}");
    }
}

#[test]
fn a_mesh_needs_a_material_or_matrices() {
    let folder = Folder::new(&[("p.msh", TETRAHEDRON)]);
    let path = folder.path("p.msh");
    let read = |material: Option<Material>| {
        let materials = material.map(SolidsMaterial::all).unwrap_or_default();
        let nodes = NodeSource::Mesh { path: path.clone(), materials };
        read_model_with(&ModelFiles { nodes, mass: None, stiffness: None }, &ImportOptions::default())
    };
    assert_parts(&read(None).unwrap_err().to_string(), &["the mass file is missing", "--material"]);
    for material in [
        Material { density: 0.0, ..Material::STEEL },
        Material { density: f64::NAN, ..Material::STEEL },
        Material { youngs_modulus: -1.0, ..Material::STEEL },
        Material { poisson_ratio: 0.5, ..Material::STEEL },
    ] {
        assert_parts(
            &read(Some(material)).unwrap_err().to_string(),
            &["the material must have a density > 0"],
        );
    }
    let flat = TETRAHEDRON.replace("0 0 1\n", "1 1 0\n");
    let Err(ImportError::BadElement { line, fault, .. }) = text(&flat) else { panic!() };
    assert_eq!(line, 21);
    assert!(matches!(fault, ElementError::Numbered { element: 0, .. }));
}

/// meshio prints positions in text to twelve digits.
const PRINTED: f64 = 1e-11;

/// The files of meshio and of VTK itself: text, base64, deflated, appended, raw, both sizes of lengths.
#[test]
fn grids_of_vtk_are_the_meshes_they_were_made_of() {
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/vtk"));
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if !name.ends_with(".vtu") {
            continue;
        }
        let origin = assembled(written(&format!("{}_4.1.msh", name.split('_').next().unwrap()))).unwrap();
        let found = assembled(path).unwrap();
        let far = |a: &[f64; 3], b: &[f64; 3]| (0..3).fold(0.0_f64, |most, k| most.max((a[k] - b[k]).abs()));
        let pairs = found.nodes.positions.iter().zip(&origin.nodes.positions);
        assert!(pairs.clone().all(|(a, b)| far(a, b) < PRINTED), "{name}");
        assert_eq!(found.elements, origin.elements, "{name}");
        assert_eq!(found.nodes.ids[..3], [0, 1, 2]);
        for (set, group) in
            [("end", "left end"), ("physical_6", "left end"), ("physical_7", "edge"), ("physical_5", "part")]
        {
            assert_eq!(found.nodes.sets[set], origin.nodes.sets[group], "{name}, {set}");
        }
        assert_eq!(found.nodes.sets.len(), 5, "{name}: {:?}", found.nodes.sets.keys());
        let (mass, expected) = (found.mass.to_dense(), origin.mass.to_dense());
        assert!((&mass - &expected).norm_max() < PLACED * expected.norm_max(), "{name}");
        count += 1;
    }
    assert_eq!(count, 6);
}

const GRID: &str = r#"<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">
<UnstructuredGrid>
<Piece NumberOfPoints="5" NumberOfCells="2">
<Points>
<DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 0 1 0 0 0 1 7 7 7
</DataArray>
</Points>
<Cells>
<DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3 4</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">4 5</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10 1</DataArray>
</Cells>
</Piece>
</UnstructuredGrid>
</VTKFile>
"#;

#[test]
fn grids_that_cannot_be_read_are_named_with_their_line() {
    assert_eq!(text(GRID).unwrap().nodes.len(), 4);
    let change = |from: &str, to: &str| {
        assert!(GRID.contains(from), "{from}");
        GRID.replace(from, to)
    };
    let cases = [
        (
            change("UnstructuredGrid\" v", "PolyData\" v"),
            "p.msh:1: expected <VTKFile type=\"UnstructuredGrid\">",
        ),
        (
            change("LittleEndian\"", "LittleEndian\" compressor=\"vtkLZ4DataCompressor\""),
            "p.msh:1: expected no compressor, or vtkZLib",
        ),
        (
            change("NumberOfPoints=\"5\"", "NumberOfPoints=\"6\""),
            "p.msh:5: expected 18 coordinates as the <Piece> announces, found 15",
        ),
        (
            change("NumberOfCells=\"2\"", "NumberOfCells=\"3\""),
            "p.msh:11: expected 3 offsets as the <Piece> announces, found 2",
        ),
        (
            change("NumberOfCells=\"2\"", "NumberOfCells=\"-2\""),
            "p.msh:3: expected a number as attribute NumberOfCells",
        ),
        (
            change("<Points>", "<Dots>").replace("</Points>", "</Dots>"),
            "p.msh:3: expected a DataArray in <Points>",
        ),
        (change("\"offsets\"", "\"offset\""), "p.msh:3: expected a DataArray `offsets` in <Cells>"),
        (change(">4 5<", ">5 4<"), "p.msh:11: expected offsets that ascend to 5, found 4 of cell 1"),
        (change(">4 5<", ">4 6<"), "p.msh:11: expected offsets that ascend to 5, found 6 of cell 1"),
        (change(">4 5<", ">3 5<"), "p.msh:10: expected 4 points of cell 0, found 3"),
        (change(">0 1 2 3 4<", ">0 1 2 9 4<"), "p.msh:10: expected points from 0 to 4, found 9 in cell 0"),
        (change(">0 1 2 3 4<", ">0 1 3 2 4<"), "the Jacobian determinant is -"),
        (change(">0 1 2 3 4<", ">0 1 2 3.5 4<"), "p.msh:10: expected an integer, found `3.5"),
        (change("0 0 0 1 0 0", "0 0 zero 1 0 0"), "p.msh:6: expected a number, found `zero`"),
        (change("0 0 0 1 0 0", "0 0 nan 1 0 0"), "p.msh:6: expected a finite number, found `nan`"),
        (change(">10 1<", ">13 1<"), "p.msh:12: cell type 13 is not supported here: use types 10 and 24"),
        (
            change("\"Int32\" Name=\"conn", "\"Float32\" Name=\"conn"),
            "p.msh:10: expected an array of integers",
        ),
        (change("\"Float64\"", "\"Int64\""), "p.msh:5: expected an array of Float32 or Float64"),
        (change("\"Float64\"", "\"Float16\""), "p.msh:5: expected a DataArray of type Int8 to UInt64"),
        (
            change("\"ascii\">4 5", "\"text\">4 5"),
            "p.msh:11: expected a DataArray of format ascii, binary or appended",
        ),
        (
            change("\"ascii\">4 5", "\"binary\">CAAAAAQA"),
            "p.msh:11: expected all bytes of the array `offsets`",
        ),
        (
            change("\"ascii\">4 5", "\"appended\" offset=\"77\">"),
            "p.msh:11: expected all bytes of the array `offsets`",
        ),
        (
            change("</Piece>", "</Piece><Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"/>"),
            "p.msh:14: expected one <Piece>",
        ),
        (change("</Cells>", "</Zellen>"), "p.msh:13: expected XML of a .vtu file"),
        ("<?xml version=\"1.0\"?>\n".to_owned(), "p.msh:1: expected <VTKFile type=\"UnstructuredGrid\">"),
    ];
    for (mesh, message) in cases {
        let found = text(&mesh).unwrap_err().to_string();
        assert!(found.contains(message), "{found}\n{message}\n{mesh}");
    }
    // four bytes of the length, and the array behind it: 4, 5 in 32 bits
    let binary = change("\"ascii\">4 5", "\"binary\">CAAAAAQAAAAFAAAA");
    assert_eq!(text(&binary).unwrap().elements, text(GRID).unwrap().elements);
}
