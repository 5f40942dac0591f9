//! Degrees of freedom that boundary conditions hold in the export.

use super::*;

/// The pair with node 0 held in x and y: rows left out or marked.
fn held_stiffness() -> Vec<Vec<f64>> {
    let mut matrix = stiffness();
    for held in [0, 1] {
        for other in 0..6 {
            matrix[held][other] = 0.0;
            matrix[other][held] = 0.0;
        }
    }
    matrix
}

#[test]
fn huge_diagonals_and_left_out_rows_are_recognised() {
    let mut marked = stiffness();
    marked[0][0] = 1e36;
    marked[1][1] = 1e36;
    let left_out = list(&held_stiffness(), |_, _| true);
    let mut mass = full_mass();
    for dof in [0, 1] {
        mass[dof] = vec![0.0; 6];
        mass.iter_mut().for_each(|row| row[dof] = 0.0);
    }
    for stiffness in [list(&marked, |_, _| true), list(&marked, |i, j| i <= j), left_out] {
        for mass in [list(&full_mass(), |_, _| true), list(&mass, |_, _| true)] {
            let text = (mass.join("\n") + "\n", stiffness.join("\n") + "\n");
            let folder = Folder::new(&[("x.txt", NODES), ("m.mtx", &text.0), ("k.mtx", &text.1)]);
            let model = folder.plain().unwrap();
            assert_eq!(model.fixed_dofs, [0, 1]);
            assert_eq!(dense(model.stiffness.as_ref().unwrap()), held_stiffness());
            assert_eq!(dense(&model.mass), MASS, "the z direction shows the mass");
        }
    }
}

#[test]
fn calculix_leaves_held_rows_out() {
    let deck = "*NODE\n1,0,0,0\n2,1,0,0\n*ELEMENT,TYPE=T3D2\n1,1,2\n*BOUNDARY\n1,1,2\n";
    let rows = |matrix: &[Vec<f64>], free: &[usize]| {
        let row = |&i: &usize| free.iter().map(|&j| matrix[i][j]).collect();
        let kept: Vec<Vec<f64>> = free.iter().map(row).collect();
        list(&kept, |i, j| i <= j).join("\n") + "\n"
    };
    let import = |dofs: &str, free: &[usize]| {
        let folder = Folder::new(&[
            ("rod.inp", deck),
            ("rod.dof", dofs),
            ("rod.sti", &rows(&stiffness(), free)),
            ("rod.mas", &rows(&full_mass(), free)),
        ]);
        let nodes = NodeSource::Calculix(folder.path("rod.inp"));
        read_model(&ModelFiles { nodes, mass: None, stiffness: None })
    };
    let model = import("1.3\n2.1\n2.2\n2.3\n", &[2, 3, 4, 5]).unwrap();
    assert_eq!(model.fixed_dofs, [0, 1]);
    assert_eq!(dense(&model.mass), MASS);
    assert_eq!(dense(model.stiffness.as_ref().unwrap()), held_stiffness());

    let message = import("2.1\n2.2\n2.3\n", &[3, 4, 5]).unwrap_err().to_string();
    assert!(message.contains("rod.mas: the mass of 1 nodes (first: node 1) is not in the file"), "{message}");
    let message = import("2.1\n2.2\n2.3\n", &[2, 3, 4, 5]).unwrap_err().to_string();
    assert!(
        message.contains("rod.mas: expected a matrix of 3 rows") && message.contains("found 4"),
        "{message}"
    );
    let message = import("1.3\n2.1\n2.2\n", &[2, 3, 4]).unwrap_err().to_string();
    assert!(message.contains("the mass of 2 nodes (first: node 1)"), "no common direction: {message}");
    let message = import("2.1\n2.4\n2.3\n", &[3, 4, 5]).unwrap_err().to_string();
    assert!(message.contains("rod.dof:2: expected `node.direction`"), "{message}");
    let message = import("2.1\n5.2\n2.3\n", &[3, 4, 5]).unwrap_err().to_string();
    assert!(message.contains("rod.dof:2: ") && message.contains("node 5"), "{message}");
}

/// Output of CalculiX itself: 12 nodes, three of whose degrees of freedom are held.
#[test]
fn a_held_export_of_calculix() {
    let deck = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/held_brick.inp"));
    let files = ModelFiles { nodes: NodeSource::Calculix(deck.to_path_buf()), mass: None, stiffness: None };
    let model = read_model(&files).unwrap();
    assert_eq!(model.fixed_dofs, [0, 1, 4], "node 1 in x and y, node 2 in y");
    // 14 printed digits
    let total: f64 = model.mass.val().iter().sum();
    assert!((total / (7800.0 * 2.0) - 1.0).abs() < 1e-12, "{total}");
    assert!(model.mass_anisotropy < 1e-13, "{:e}", model.mass_anisotropy);
    // Nodes 9 to 12 share no element with a held one: a translation puts no force on them.
    let stiffness = dense(model.stiffness.as_ref().unwrap());
    for row in &stiffness[24..] {
        for direction in 0..3 {
            let force: f64 = row.iter().skip(direction).step_by(3).sum();
            assert!(force.abs() < 1e-12 * 5e10, "{force:e}");
        }
    }
    assert!(stiffness[4].iter().all(|&entry| entry == 0.0));
}
