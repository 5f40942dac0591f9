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
    let rows = |matrix: &[Vec<f64>], from: usize| {
        let kept: Vec<Vec<f64>> = matrix[from..].iter().map(|row| row[from..].to_vec()).collect();
        list(&kept, |i, j| i <= j).join("\n") + "\n"
    };
    let import = |dofs: &str, from: usize| {
        let folder = Folder::new(&[
            ("rod.inp", deck),
            ("rod.dof", dofs),
            ("rod.sti", &rows(&stiffness(), from)),
            ("rod.mas", &rows(&full_mass(), from)),
        ]);
        let nodes = NodeSource::Calculix(folder.path("rod.inp"));
        read_model(&ModelFiles { nodes, mass: None, stiffness: None })
    };
    let model = import("1.3\n2.1\n2.2\n2.3\n", 2).unwrap();
    assert_eq!(model.fixed_dofs, [0, 1]);
    assert_eq!(dense(&model.mass), MASS);
    assert_eq!(dense(model.stiffness.as_ref().unwrap()), held_stiffness());

    let message = import("2.1\n2.2\n2.3\n", 3).unwrap_err().to_string();
    assert!(message.contains("rod.mas: the mass of 1 nodes (first: node 1) is not in the file"), "{message}");
    let message = import("2.1\n2.2\n2.3\n", 2).unwrap_err().to_string();
    assert!(
        message.contains("rod.mas: expected a matrix of 3 rows") && message.contains("found 4"),
        "{message}"
    );
    let message = import("2.1\n2.4\n2.3\n", 3).unwrap_err().to_string();
    assert!(message.contains("rod.dof:2: expected `node.direction`"), "{message}");
    let message = import("2.1\n5.2\n2.3\n", 3).unwrap_err().to_string();
    assert!(message.contains("rod.dof:2: ") && message.contains("node 5"), "{message}");
}
