//! The same structure as a CalculiX deck: C3D20 solids, rigid bodies at interfaces, equations at joints, and springs. Numbers carry a point: CalculiX refuses some that do not.

use std::fmt::Write as _;

use ffrf_test_kit::calculix;

use super::structure::{Motion, Structure};

/// Frequencies that CalculiX finds, or `None`, said loudly, if there is no `ccx`. Units: Hz.
pub fn frequencies(structure: &Structure, count: usize) -> Option<Vec<f64>> {
    let folder = tempfile::tempdir().unwrap();
    let results = calculix::results(folder.path(), &deck(structure, count))?;
    Some(calculix::frequencies(&results, count))
}

fn deck(structure: &Structure, count: usize) -> String {
    let mut text = String::from("*NODE, NSET=ALL\n");
    let mut first = Vec::new();
    let mut last = 0;
    for part in &structure.parts {
        first.push(last + 1);
        for [x, y, z] in &part.model.nodes.positions {
            last += 1;
            writeln!(text, "{last}, {x:.12e}, {y:.12e}, {z:.12e}").unwrap();
        }
    }
    // Behind the solids' nodes a reference node and a rotation node for each interface.
    let mut points = Vec::new();
    for part in &structure.parts {
        let mut of_part = Vec::new();
        for interface in &part.interfaces {
            let [x, y, z] = interface.reference_point();
            writeln!(text, "{}, {x:.12e}, {y:.12e}, {z:.12e}", last + 1).unwrap();
            writeln!(text, "{}, {x:.12e}, {y:.12e}, {z:.12e}", last + 2).unwrap();
            of_part.push(last + 1);
            last += 2;
        }
        points.push(of_part);
    }
    // Node and direction of a motion.
    let place = |motion: &Motion| {
        let point = points[motion.part][motion.interface];
        if motion.axis < 3 { (point, motion.axis + 1) } else { (point + 1, motion.axis - 2) }
    };
    let mut number = 0;
    for (index, part) in structure.parts.iter().enumerate() {
        writeln!(text, "*ELEMENT, TYPE=C3D20, ELSET={}", part.name).unwrap();
        for element in &part.model.elements {
            number += 1;
            let mut fields = vec![number.to_string()];
            fields.extend(element.nodes.iter().map(|node| (first[index] + node).to_string()));
            let lines: Vec<String> = fields.chunks(11).map(|line| line.join(", ")).collect();
            writeln!(text, "{}", lines.join(",\n")).unwrap();
        }
        let material = &part.material;
        write!(
            text,
            "*MATERIAL, NAME={0}\n*ELASTIC\n{1:e}, {2}\n*DENSITY\n{3}\n*SOLID SECTION, ELSET={0}, MATERIAL={0}\n",
            part.name, material.youngs_modulus, material.poisson_ratio, material.density
        )
        .unwrap();
        for (k, interface) in part.interfaces.iter().enumerate() {
            writeln!(text, "*NSET, NSET={}_{k}", part.name).unwrap();
            for node in interface.nodes() {
                writeln!(text, "{},", first[index] + node).unwrap();
            }
            let point = points[index][k];
            writeln!(text, "*RIGID BODY, NSET={}_{k}, REF NODE={point}, ROT NODE={}", part.name, point + 1)
                .unwrap();
        }
    }
    for (first, second) in &structure.shared {
        let ((a, i), (b, j)) = (place(second), place(first));
        writeln!(text, "*EQUATION\n2\n{a}, {i}, 1., {b}, {j}, -1.").unwrap();
    }
    for (k, (motion, stiffness)) in structure.springs.iter().enumerate() {
        let (node, direction) = place(motion);
        number += 1;
        writeln!(text, "*ELEMENT, TYPE=SPRING1, ELSET=SPRING{k}\n{number}, {node}").unwrap();
        writeln!(text, "*SPRING, ELSET=SPRING{k}\n{direction}\n{stiffness:.9e}").unwrap();
    }
    // A mass is a node of its own, which goes along: CalculiX 2.20 does not take one at the point of a rigid body.
    let mut carried = String::new();
    for (k, (motion, mass)) in structure.masses.iter().enumerate() {
        let (node, direction) = place(motion);
        let point = last + 1 + k;
        number += 1;
        let [x, y, z] = structure.parts[motion.part].interfaces[motion.interface].reference_point();
        writeln!(text, "*NODE\n{point}, {x:.12e}, {y:.12e}, {z:.12e}").unwrap();
        writeln!(text, "*ELEMENT, TYPE=MASS, ELSET=MASS{k}\n{number}, {point}").unwrap();
        writeln!(text, "*MASS, ELSET=MASS{k}\n{mass:.9e}").unwrap();
        writeln!(text, "*EQUATION\n2\n{point}, {direction}, 1., {node}, {direction}, -1.").unwrap();
        for other in (1..=3).filter(|&other| other != direction) {
            writeln!(carried, "{point}, {other}, {other}").unwrap();
        }
    }
    text.push_str("*BOUNDARY\n");
    text.push_str(&carried);
    for motion in &structure.held {
        let (node, direction) = place(motion);
        writeln!(text, "{node}, {direction}, {direction}").unwrap();
    }
    writeln!(text, "*STEP\n*FREQUENCY\n{}\n*END STEP", count + 4).unwrap();
    text
}
