//! Tests of the deck reader on small decks.

use std::path::PathBuf;

use super::read;
use crate::import::ImportError;
use crate::import::nodes::NodeTable;
use crate::{Element, ElementKind};

fn deck(text: &str) -> Result<NodeTable, ImportError> {
    let folder = tempfile::tempdir().unwrap();
    let path: PathBuf = folder.path().join("part.inp");
    std::fs::write(&path, text).unwrap();
    read(&path, 0).map(|(table, _)| table)
}

#[test]
fn flat_deck_with_sets_and_a_continued_element() {
    let nodes: String = (1..=20).map(|n| format!("{n}, {n}., 0.5\n")).collect();
    let table = deck(&format!(
        "*Heading\n title, with, commas\n** comment\n*NODE, NSET=Nall\n{nodes}100, 1, 2, 3\n\
         *ELEMENT, TYPE=C3D20R, ELSET=E\n1, 1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,\n16,17,18,19,20\n\
         *NSET, NSET=odd, GENERATE\n1, 20, 2\n*NSET, NSET=more\nodd, 100,\n4\n*NSET, NSET=more\n6\n"
    ))
    .unwrap();
    assert_eq!(table.nodes.len(), 21);
    assert_eq!(table.nodes.positions[3], [4.0, 0.5, 0.0]);
    assert_eq!(
        table.elements,
        [Element { kind: ElementKind::Hexahedron20, nodes: (0..20).collect::<Vec<_>>() }]
    );
    let attached = table.attached.unwrap();
    assert!(attached[19] && !attached[20]);
    assert_eq!(table.nodes.sets["odd"], (0..20).step_by(2).collect::<Vec<_>>());
    assert_eq!(table.nodes.sets["more"], [0, 2, 3, 4, 5, 6, 8, 10, 12, 14, 16, 18, 20]);
    assert_eq!(table.nodes.sets["Nall"].len(), 21);
    assert!(!table.has_boundary);
}

#[test]
fn instances_are_moved_then_turned() {
    let table = deck(
        "*Part, name=bar\n*Node\n1, 1., 0., 0.\n2, 2., 0., 0.\n*Nset, nset=tip\n2\n*End Part\n\
         *Assembly, name=A\n*Instance, name=bar-1, part=bar\n*End Instance\n\
         *Instance, name=bar-2, part=BAR\n1., 0., 0.\n1., 0., 0., 1., 0., 1., 90.\n*End Instance\n\
         *Nset, nset=root, instance=bar-2\n1\n*Nset, nset=both\nbar-1.2, bar-2.2\n*End Assembly\n",
    )
    .unwrap();
    assert_eq!(table.nodes.ids, [1, 2, 3, 4], "clashing labels of the second instance are raised");
    // (1,0,0) + (1,0,0) turned by 90 degrees about the vertical axis through (1,0,0)
    for (found, wanted) in
        table.nodes.positions.iter().zip([[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 2.0, 0.0]])
    {
        for i in 0..3 {
            assert!((found[i] - wanted[i]).abs() < 4.0 * f64::EPSILON, "{found:?} {wanted:?}");
        }
    }
    assert_eq!(table.nodes.sets["root"], [2]);
    assert_eq!(table.nodes.sets["both"], [1, 3]);
    assert_eq!(table.nodes.sets["bar-2.tip"], [3]);
}

#[test]
fn defects_name_the_line() {
    for (text, parts) in [
        ("*Node\n1, 0, 0, 0\n2, 0, x, 0\n", vec!["part.inp:3:", "`id, x, y, z`", "`x` in `2, 0, x, 0`"]),
        ("*Node\n1, 0, nan, 0\n", vec!["part.inp:2:", "finite", "nan"]),
        ("*Node\n1, 0, 0, 0\n1, 0, 0, 1\n", vec!["part.inp:3:", "node 1 "]),
        ("*Node\n1, 0, 0, 0\n*Element, type=C3D4\n1, 1, 2\n", vec!["part.inp:4:", "only 2 given"]),
        ("*Node\n1, 0, 0, 0\n*Element, type=C3D4\n1, 1, 1, 1, 9\n", vec!["part.inp:4:", "node 9", "1 nodes"]),
        ("*Node\n1, 0, 0, 0\n*Nset, nset=a\n5\n", vec!["part.inp:4:", "node 5"]),
        ("*Node, system=C\n1, 1, 90, 0\n", vec!["part.inp:1:", "*NODE", "rectangular"]),
        ("*Instance, part=none, name=i\n", vec!["part.inp:1:", "`none`"]),
        ("*Heading\n", vec!["part.inp: expected nodes, found none"]),
    ] {
        let message = deck(text).unwrap_err().to_string();
        for part in parts {
            assert!(message.contains(part), "`{message}` lacks `{part}`");
        }
    }
}

#[test]
fn included_files_are_read_and_listed() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("mesh.inp"), "*NODE\n1,0,0,0\n2,1,0,0\n").unwrap();
    let path = folder.path().join("part.inp");
    std::fs::write(&path, "*INCLUDE, INPUT=mesh.inp\n*NSET, NSET=a\n2\n").unwrap();
    let (table, sources) = read(&path, 0).unwrap();
    assert_eq!(table.nodes.sets["a"], [1]);
    assert_eq!(sources.len(), 2);
    std::fs::write(&path, "*INCLUDE, INPUT=part.inp\n").unwrap();
    assert!(read(&path, 0).unwrap_err().to_string().contains("does not include itself (not `part.inp`)"));
}

#[test]
fn materials_are_read_where_they_are_isotropic() {
    let table = deck(
        "*Node\n1, 0., 0., 0.\n*Material, name=STEEL\n*Density\n7850.,\n*Elastic\n 2.1D11, 0.3\n\
         *MATERIAL, NAME=ALUMINIUM\n*ELASTIC, TYPE=ISO\n70e9, 0.33, 20.\n\
         *MATERIAL, NAME=HOT\n*ELASTIC\n70e9, 0.33, 20.\n60e9, 0.33, 200.\n\
         *MATERIAL, NAME=PLY\n*ELASTIC, TYPE=ENGINEERING CONSTANTS\n1., 2., 3., 4., 5., 6., 7., 8.\n9.\n\
         *MATERIAL, NAME=TYPO\n*ELASTIC\n70e9; 0.3\n",
    )
    .unwrap();
    let found: Vec<(&str, Option<[f64; 2]>)> = table
        .materials
        .iter()
        .map(|material| {
            let constants = material.elasticity.map(|it| [it.youngs_modulus, it.poisson_ratio]);
            (material.name.as_str(), constants)
        })
        .collect();
    let expected = [
        ("STEEL", Some([2.1e11, 0.3])),
        ("ALUMINIUM", Some([70e9, 0.33])),
        ("HOT", None),
        ("PLY", None),
        ("TYPO", None),
    ];
    assert_eq!(found, expected);
}
