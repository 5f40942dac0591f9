//! Interfaces: choosing nodes, weights, and what is refused.

use ffrf_fe::component_modes::{
    ComponentRequest, Interface, NodeSelection, area_weights, component_modes, mac, mass_weighted_mac,
};

use super::parts::{bar, compute, rigid_ends, section};

#[test]
fn nodes_are_chosen_by_where_they_are() {
    let mut model = bar();
    let rows = |selection: NodeSelection| selection.rows(&model.nodes);
    let end = section(&model, 0.0);
    assert_eq!(end.len(), 9);
    assert_eq!(rows(NodeSelection::Box { from: [0.0, 0.04, 0.03], to: [0.0, 0.0, 0.0] }).unwrap(), end);
    let ids = end.iter().map(|&row| model.nodes.ids[row]).collect();
    assert_eq!(rows(NodeSelection::Ids(ids)).unwrap(), end);
    // The middle line is a cylinder without radius; the four corner lines lie on one of 25 mm.
    let cylinder = |radius| NodeSelection::Cylinder {
        point: [1.0, 0.02, 0.015],
        axis: [3.0, 0.0, 0.0],
        radius,
        tolerance: 0.0,
    };
    assert_eq!(rows(cylinder(0.0)).unwrap().len(), 7);
    assert_eq!(rows(cylinder(0.025)).unwrap().len(), 28);
    for (selection, part) in [
        (cylinder(0.5), "cylinder:1,0.02,0.015,3,0,0,0.5,0 holds none of the 63 nodes"),
        (NodeSelection::Set("hub".to_owned()), "no node set `hub`: the files have none"),
        (NodeSelection::Ids(vec![64]), "no node 64: expected one of 63 ids from 1 to 63"),
        (NodeSelection::Plane { point: [0.0; 3], normal: [0.0; 3], tolerance: 0.0 }, "length above 0"),
    ] {
        let message = rows(selection).unwrap_err().to_string();
        assert!(message.contains(part), "`{message}` lacks `{part}`");
    }
    model.nodes.sets.insert("Hub".to_owned(), end.clone());
    assert_eq!(NodeSelection::Set("HUB".to_owned()).rows(&model.nodes).unwrap(), end);
}

#[test]
fn area_weights_sum_to_the_area_of_the_face() {
    let model = bar();
    let end = section(&model, 0.24);
    let weights = area_weights(&model, &end).unwrap();
    let total: f64 = weights.iter().sum();
    assert!((total - 0.04 * 0.03).abs() < 1e-15, "{total}");
    let corner = weights.iter().copied().fold(f64::INFINITY, f64::min);
    let middle = weights.iter().copied().fold(0.0, f64::max);
    assert!((middle / corner - 4.0).abs() < 1e-9, "a node inside has four times the area of a corner");
    let message = area_weights(&model, &[0, 1]).unwrap_err().to_string();
    assert!(message.contains("node 1"), "{message}");
}

#[test]
fn interfaces_that_cannot_be_are_refused() {
    let model = bar();
    let end = section(&model, 0.0);
    let refuse = |name: &str, rows: &[usize]| Interface::rigid(&model, name, rows).unwrap_err().to_string();
    assert!(refuse("1st", &end).contains("letters, digits"));
    assert!(refuse("line", &end[..3]).contains("3 nodes off one line, but its 3 nodes spread by only"));
    assert!(refuse("none", &[]).contains("its 0 nodes"));
    assert!(refuse("far", &[0, 7, 999]).contains("row 999"));
    let left = Interface::rigid(&model, "left", &end).unwrap();
    let message = left.clone().at([f64::NAN, 0.0, 0.0]).unwrap_err().to_string();
    assert!(message.contains("finite"), "{message}");
    let message = left.clone().weighted(&model, vec![1.0; 3]).unwrap_err().to_string();
    assert!(message.contains("expected 9 positive finite weights"), "{message}");

    let request = |interfaces| ComponentRequest::craig_bampton(interfaces, 2);
    let refuse = |interfaces: Vec<Interface>| {
        component_modes(&model, &request(interfaces), &mut |_| {}).unwrap_err().to_string()
    };
    assert!(refuse(Vec::new()).contains("at least one interface"));
    assert!(refuse(vec![left.clone(), left.clone()]).contains("given twice"));
    let other = Interface::rigid(&model, "other", &end[2..]).unwrap();
    assert!(refuse(vec![left.clone(), other.clone()]).contains("rigid interfaces `left` and `other`"));
    // The same nodes by their mean twice: the motions cannot differ.
    let same = Interface::rigid(&model, "same", &end).unwrap().averaged();
    assert!(refuse(vec![left.clone().averaged(), same]).contains("do not move independently"));
    let mut held = bar();
    held.fixed_dofs = vec![3 * end[4] + 1];
    let message = component_modes(&held, &request(vec![left.clone()]), &mut |_| {}).unwrap_err().to_string();
    assert!(message.contains("held by the boundary conditions"), "{message}");
    let too_many = ComponentRequest::craig_bampton(vec![left], 500);
    let message = component_modes(&model, &too_many, &mut |_| {}).unwrap_err().to_string();
    assert!(message.contains("500 normal modes wanted, but only"), "{message}");
}

#[test]
fn the_assurance_criterion_tells_modes_apart() {
    let model = bar();
    let modes = compute(&model, &ComponentRequest::craig_bampton(rigid_ends(&model), 4));
    let shapes = &modes.basis.shapes;
    let weighted = mass_weighted_mac(&model, shapes, shapes).unwrap();
    for i in 0..weighted.nrows() {
        for j in 0..weighted.ncols() {
            let expected = if i == j { 1.0 } else { 0.0 };
            assert!((weighted[(i, j)] - expected).abs() < 1e-12, "({i}, {j}): {}", weighted[(i, j)]);
        }
    }
    // Scale and sign do not matter.
    let turned = faer::Scale(-3.0) * shapes;
    let plain = mac(shapes.as_ref(), turned.as_ref()).unwrap();
    assert!((0..plain.nrows()).all(|i| (plain[(i, i)] - 1.0).abs() < 1e-12));
    assert!(
        mac(shapes.as_ref(), shapes.get(1.., ..))
            .unwrap_err()
            .to_string()
            .contains("expected 189, found 188")
    );
}
