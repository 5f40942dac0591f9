//! Materials of groups of solids: each element with its own, and what is refused.

use super::*;
use crate::elements::Material;
use crate::import::SolidsMaterial;

const RUBBER: Material = Material { youngs_modulus: 1e7, poisson_ratio: 0.45, density: 1100.0 };
/// Sums of a few masses.
const ROUND_OFF: f64 = 1e-14;

/// Two tetrahedra that share a face: entity 1 in the group `HUB`, entity 2 in the unnamed group 8 and, so that there is one, in `ALL`.
const TWO: &str = "$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
3 7 \"HUB\"
3 9 \"ALL\"
$EndPhysicalNames
$Entities
0 0 0 2
1 0 0 0 1 1 1 2 7 9 0
2 0 0 0 1 1 1 2 8 9 0
$EndEntities
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
1 1 1
$EndNodes
$Elements
2 2 1 2
3 1 4 1
1 1 2 3 4
3 2 4 1
2 2 3 4 5
$EndElements
";
const LEGACY: &str = "$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
3 7 \"HUB\"
3 9 \"ALL\"
$EndPhysicalNames
$Nodes
5
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
5 1 1 1
$EndNodes
$Elements
4
1 4 2 7 1 1 2 3 4
2 4 2 9 1 1 2 3 4
3 4 2 9 2 2 3 4 5
4 4 2 8 2 2 3 4 5
$EndElements
";
const VTK: &str = r#"<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"><UnstructuredGrid>
<Piece NumberOfPoints="5" NumberOfCells="3">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1 1 1 1</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 0 1 2 3 1 2 3 4</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">3 7 11</DataArray>
<DataArray type="Int64" Name="types" format="ascii">5 10 10</DataArray></Cells>
<CellData><DataArray type="Int64" Name="part" format="ascii">0 7 8</DataArray></CellData>
</Piece></UnstructuredGrid></VTKFile>
"#;

fn group(name: &str, material: Material) -> SolidsMaterial {
    SolidsMaterial { group: Some(name.to_owned()), material }
}

fn assembled(file: &str, text: &str, materials: Vec<SolidsMaterial>) -> Result<FeModel, ImportError> {
    let folder = Folder::new(&[(file, text)]);
    let nodes = NodeSource::Mesh { path: folder.path(file), materials };
    read_model(&ModelFiles { nodes, mass: None, stiffness: None })
}

#[test]
fn each_group_of_solids_has_its_own_material() {
    let steel = assembled("p.msh", TWO, SolidsMaterial::all(Material::STEEL)).unwrap();
    let rubber = assembled("p.msh", TWO, SolidsMaterial::all(RUBBER)).unwrap();
    for (file, text, hub, rest) in [
        ("p.msh", TWO, "HUB", Some("volume_8")),
        ("p.msh", TWO, "HUB", None),
        ("p.msh", LEGACY, "HUB", Some("volume_8")),
        ("p.msh", LEGACY, "HUB", None),
        ("p.vtu", VTK, "part_7", Some("part_8")),
        ("p.vtu", VTK, "part_7", None),
    ] {
        let rest = SolidsMaterial { group: rest.map(str::to_owned), material: RUBBER };
        for materials in [[group(hub, Material::STEEL), rest.clone()], [rest, group(hub, Material::STEEL)]] {
            let model = assembled(file, text, materials.to_vec()).unwrap();
            // Node 1 is of the first solid alone, node 5 of the second alone; the others of both.
            let (mass, [hub_mass, rest_mass]) =
                (dense(&model.mass), [&steel, &rubber].map(|it| dense(&it.mass)));
            assert_eq!((mass[0][0], mass[4][4]), (hub_mass[0][0], rest_mass[4][4]), "{file}");
            let stiffness = |model: &FeModel| dense(model.stiffness.as_ref().unwrap());
            let (found, [hub_stiffness, rest_stiffness]) =
                (stiffness(&model), [&steel, &rubber].map(stiffness));
            assert_eq!(found[0][..3], hub_stiffness[0][..3], "{file}");
            assert_eq!(found[14][12..], rest_stiffness[14][12..], "{file}");
            // The second has twice the volume of the first.
            let total: f64 = mass.iter().flatten().sum();
            let expected = (7850.0 + 2.0 * 1100.0) / 6.0;
            assert!((total / expected - 1.0).abs() < ROUND_OFF, "{file}: {total}");
            let hub_material = materials.iter().position(|it| it.material == Material::STEEL).unwrap();
            assert_eq!(model.element_materials, [hub_material, 1 - hub_material]);
            assert_eq!(model.materials[hub_material].name, hub);
            let parts =
                ["assembled of 2 solids of 2 materials: ", "1 of group ", "density 7850.0", "density 1100.0"];
            assert_parts(model.notes.last().unwrap(), &parts);
        }
    }
}

#[test]
fn solids_of_no_material_or_of_two_are_refused_with_the_groups() {
    let all = |material| SolidsMaterial { group: None, material };
    let (hub, known) =
        (group("HUB", RUBBER), "groups of solids: ALL (2 solids), HUB (1 solid), volume_8 (1 solid)");
    let cases = [
        (
            vec![hub.clone()],
            "p.msh:33: nothing says what this solid is made of, the first of 1: name a material",
        ),
        (vec![hub.clone()], known),
        (vec![group("HUG", RUBBER), all(RUBBER)], "p.msh: no solid is in a group HUG; groups of solids: ALL"),
        (
            vec![hub.clone(), group("ALL", RUBBER)],
            "p.msh:31: this solid is in the groups HUB and ALL, which both",
        ),
        (vec![hub.clone(), hub.clone()], "the material of the group HUB is given a second time"),
        (vec![all(RUBBER), all(RUBBER)], "the material is given a second time"),
        (
            vec![all(RUBBER), group("HUB", Material { density: 0.0, ..RUBBER })],
            "the material of the group HUB must have a density > 0",
        ),
    ];
    for (materials, message) in cases {
        let found = assembled("p.msh", TWO, materials).unwrap_err().to_string();
        assert!(found.contains(message), "{found}\n{message}");
    }
    let plain = TWO.replace("2 7 9", "0").replace("2 8 9", "0");
    let found = assembled("p.msh", &plain, vec![hub]).unwrap_err().to_string();
    assert!(found.ends_with("no solid is in a group HUB; groups of solids: none"), "{found}");
}
