//! Recovered stresses against those that CalculiX 2.20 prints for the same displacements of the same elements.
//!
//! In `calculix_stress/`: decks of a few distorted elements, and for each node its displacement and stress (`*NODE FILE U`, `*EL FILE
//! S`: extrapolated from the integration points, mean over the elements), in N and mm.

use faer::Mat;
use ffrf_fe::stress::{StressRequest, nodal_stress, stress_marker};
use ffrf_fe::{Elasticity, Element, ElementKind, FeModel, ModeBasis, Nodes, SparseMatrix};
use ffrf_model::{Mode, ModeKind};

/// CalculiX prints six digits of displacements and stresses; differences of displacements over strains of 1e-3 cost one or two.
const PRINTED: f64 = 2e-4;

const STEEL: Elasticity = Elasticity { youngs_modulus: 2.1e5, poisson_ratio: 0.3 };

/// The nodes and elements of a deck, with matrices that nothing here reads.
fn read(kind: ElementKind, deck: &str) -> FeModel {
    let (mut section, mut nodes, mut elements) = ("", Nodes::default(), Vec::new());
    let mut open: Vec<u64> = Vec::new();
    for line in deck.lines() {
        if let Some(keyword) = line.strip_prefix('*') {
            section = keyword.split(',').next().unwrap_or_default();
            continue;
        }
        let numbers: Vec<f64> = line.split(',').filter_map(|field| field.trim().parse().ok()).collect();
        match section {
            "NODE" => {
                nodes.ids.push(numbers[0] as u64);
                nodes.positions.push([numbers[1], numbers[2], numbers[3]]);
            }
            "ELEMENT" => {
                open.extend(numbers.iter().map(|&number| number as u64));
                if !line.trim_end().ends_with(',') {
                    let rows = open.drain(..).skip(1).map(|id| nodes.row_of(id).expect("a node"));
                    elements.push(Element { kind, nodes: rows.collect() });
                }
            }
            _ => {}
        }
    }
    let nothing = |size| SparseMatrix::try_new_from_triplets(size, size, &[]).expect("an empty matrix");
    FeModel {
        mass: nothing(nodes.len()),
        mass_anisotropy: 0.0,
        stiffness: None,
        fixed_dofs: Vec::new(),
        elements,
        materials: Vec::new(),
        element_materials: Vec::new(),
        sources: Vec::new(),
        notes: Vec::new(),
        nodes,
    }
}

/// Displacements, 3N, and stresses xx, yy, zz, xy, yz, zx of every node.
fn results(model: &FeModel, table: &str) -> (Mat<f64>, Vec<[f64; 6]>) {
    let mut shapes = Mat::zeros(3 * model.nodes.len(), 1);
    let mut stresses = vec![[0.0; 6]; model.nodes.len()];
    for line in table.lines() {
        let numbers: Vec<f64> =
            line.split_whitespace().map(|field| field.parse().expect("a number")).collect();
        let row = model.nodes.row_of(numbers[0] as u64).expect("a node");
        for i in 0..3 {
            shapes[(3 * row + i, 0)] = numbers[1 + i];
        }
        stresses[row] = std::array::from_fn(|k| numbers[4 + k]);
    }
    (shapes, stresses)
}

/// Compares the mean over each `group` of nodes that follow each other.
#[track_caller]
fn compare(kind: ElementKind, deck: &str, table: &str, group: usize) {
    let model = read(kind, deck);
    let (shapes, expected) = results(&model, table);
    let largest = expected.iter().flatten().fold(0.0_f64, |most, stress| most.max(stress.abs()));
    let found: Vec<[f64; 6]> = (0..expected.len())
        .map(|row| {
            let found = nodal_stress(&model, shapes.as_ref(), &STEEL.into(), row).expect("sound elements");
            let [xx, yy, zz, xy, xz, yz] = found.expect("a node of an element")[0];
            [xx, yy, zz, xy, yz, xz]
        })
        .collect();
    let mut worst = 0.0_f64;
    for (found, expected) in found.chunks(group).zip(expected.chunks(group)) {
        for k in 0..6 {
            let mean = |list: &[[f64; 6]]| list.iter().map(|stress| stress[k]).sum::<f64>() / group as f64;
            worst = worst.max((mean(found) - mean(expected)).abs() / largest);
        }
    }
    println!("{kind:?}: stresses up to {largest} N/mm², difference {worst:.1e} of it");
    assert!(worst < PRINTED, "{kind:?}: {worst:e}");
}

#[test]
fn stresses_are_those_of_calculix() {
    compare(
        ElementKind::Tetrahedron4,
        include_str!("calculix_stress/C3D4.inp"),
        include_str!("calculix_stress/C3D4.txt"),
        1,
    );
    compare(
        ElementKind::Tetrahedron10,
        include_str!("calculix_stress/C3D10.inp"),
        include_str!("calculix_stress/C3D10.txt"),
        1,
    );
    // CalculiX gives the nodes of each end of a wedge the stress of the nearer of its two points, here it is extrapolated: the mean of
    // a node and the one above it is the same.
    compare(
        ElementKind::Wedge6,
        include_str!("calculix_stress/C3D6.inp"),
        include_str!("calculix_stress/C3D6.txt"),
        2,
    );
    compare(
        ElementKind::Hexahedron8,
        include_str!("calculix_stress/C3D8.inp"),
        include_str!("calculix_stress/C3D8.txt"),
        1,
    );
    compare(
        ElementKind::Hexahedron20,
        include_str!("calculix_stress/C3D20R.inp"),
        include_str!("calculix_stress/C3D20R.txt"),
        1,
    );
}

/// A marker is the mean of its nodes, mode by mode.
#[test]
fn a_stress_marker_is_the_mean_over_its_nodes() {
    let model = read(ElementKind::Hexahedron8, include_str!("calculix_stress/C3D8.inp"));
    let (field, _) = results(&model, include_str!("calculix_stress/C3D8.txt"));
    let basis = ModeBasis {
        shapes: Mat::from_fn(field.nrows(), 2, |row, mode| [1.0, -2.0][mode] * field[(row, 0)]),
        modes: vec![Mode { kind: ModeKind::User, frequency_hz: None }; 2],
    };
    let request = |nodes: &[usize]| StressRequest { name: "NOTCH".to_owned(), nodes: nodes.to_vec() };
    let marker = stress_marker(&model, &basis, &STEEL.into(), &request(&[3, 5])).expect("two nodes");
    let at = |row: usize| {
        nodal_stress(&model, field.as_ref(), &STEEL.into(), row).expect("sound").expect("an element")[0]
    };
    for k in 0..6 {
        let mean = 0.5 * (at(3)[k] + at(5)[k]);
        for (mode, factor) in [1.0, -2.0].into_iter().enumerate() {
            assert!((marker.stress[mode][k] - factor * mean).abs() < 1e-9 * mean.abs().max(1.0));
        }
    }
    for nodes in [&[][..], &[99]] {
        assert!(stress_marker(&model, &basis, &STEEL.into(), &request(nodes)).is_err());
    }
    let without = FeModel { elements: Vec::new(), ..model };
    let error = stress_marker(&without, &basis, &STEEL.into(), &request(&[3])).expect_err("no element");
    assert!(error.to_string().contains("NOTCH") && error.to_string().contains("node 4"), "{error}");
}
