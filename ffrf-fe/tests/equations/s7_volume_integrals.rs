//! Section 7.4: the volume integrals behind the mass matrices, by element quadrature: (107) to (131).

use std::path::Path;

use faer::Mat;
use ffrf_fe::formulations::gcms::gram_matrix;
use ffrf_fe::formulations::quadrature::{LumpedMass, ShapeIntegrals, element_points, shape_integrals};
use ffrf_fe::import::{ModelFiles, NodeSource, read_model};
use ffrf_fe::{Element, ElementKind};
use ffrf_test_kit::random::Random;

use crate::check::{column, equal};

const DENSITY: f64 = 7.85;
const MODES: usize = 3;

struct Mesh {
    positions: Vec<[f64; 3]>,
    elements: Vec<Element>,
    shapes: Mat<f64>,
}

/// Corners of a distorted cube, numbered as the hexahedron.
fn corners() -> Vec<[f64; 3]> {
    let mut random = Random::new(31);
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]
        .map(|corner: [i32; 3]| corner.map(|x| f64::from(x) + 0.15 * random.number()))
        .to_vec()
}

/// Adds the middles of edges, once each; straight edges.
fn with_middles(positions: &mut Vec<[f64; 3]>, nodes: &[usize], edges: &[[usize; 2]]) -> Vec<usize> {
    let mut all = nodes.to_vec();
    for &[a, b] in edges {
        let middle = [0, 1, 2].map(|i| 0.5 * (positions[nodes[a]][i] + positions[nodes[b]][i]));
        let known = positions.iter().position(|x| *x == middle);
        all.push(known.unwrap_or_else(|| {
            positions.push(middle);
            positions.len() - 1
        }));
    }
    all
}

fn meshes() -> Vec<(ElementKind, Mesh)> {
    let tetrahedra = [[0, 1, 3, 4], [1, 2, 3, 6], [1, 6, 3, 4], [1, 5, 6, 4], [3, 6, 7, 4]];
    let hexahedron: Vec<usize> = (0..8).collect();
    let hexahedron_edges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
    let upright = [[0, 4], [1, 5], [2, 6], [3, 7]];
    let tetrahedron_edges = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];
    let kinds = [
        ElementKind::Tetrahedron4,
        ElementKind::Tetrahedron10,
        ElementKind::Hexahedron8,
        ElementKind::Hexahedron20,
    ];
    kinds
        .into_iter()
        .map(|kind| {
            let mut positions = corners();
            let edges: &[[usize; 2]] = match kind {
                ElementKind::Tetrahedron10 => &tetrahedron_edges,
                ElementKind::Hexahedron20 => &[hexahedron_edges.as_slice(), &upright].concat(),
                _ => &[],
            };
            let lists: Vec<Vec<usize>> = match kind {
                ElementKind::Tetrahedron4 | ElementKind::Tetrahedron10 => {
                    tetrahedra.map(|nodes| nodes.to_vec()).to_vec()
                }
                _ => vec![hexahedron.clone()],
            };
            let elements = lists
                .iter()
                .map(|nodes| Element { kind, nodes: with_middles(&mut positions, nodes, edges) })
                .collect();
            let mut random = Random::new(41);
            let shapes = Mat::from_fn(3 * positions.len(), MODES, |_, _| random.number());
            (kind, Mesh { positions, elements, shapes })
        })
        .collect()
}

fn each_mesh(mut test: impl FnMut(&Mesh, &ShapeIntegrals, &Mat<f64>)) {
    for (kind, mesh) in meshes() {
        println!("{kind:?}");
        let integrals = shape_integrals(&mesh.positions, &mesh.elements, DENSITY, mesh.shapes.as_ref())
            .expect("elements are sound");
        let mass = LumpedMass::Consistent.assemble(&mesh.positions, &mesh.elements, DENSITY).expect("a mass");
        test(&mesh, &integrals, &gram_matrix(&mesh.positions, mesh.shapes.as_ref(), &mass));
    }
}

fn part(gram: &Mat<f64>, row: usize, rows: usize, col: usize, columns: usize) -> Mat<f64> {
    crate::check::block(gram, row, col, rows, columns)
}

#[test]
fn equations_107_109_110_shape_functions_reproduce_constants_and_positions() {
    each_mesh(|mesh, _, _| {
        for (number, element) in mesh.elements.iter().enumerate() {
            let mut volume = 0.0;
            for point in element_points(&mesh.positions, element, number).expect("a sound element") {
                // (107): Σ N_n = 1.
                equal(&column(&[point.shape.iter().sum()]), &column(&[1.0]));
                volume += point.volume;
            }
            assert!(volume > 0.0);
            // (109), (110): Σ N_n x_n is the point itself. At the nodes, N_n(x_m) = δ_nm (32), it is so by definition;
            // inside, a linear field keeps its mean: ∫ Σ N_n (c·x_n) dV = c·∫ x dV.
            let first = |field: &dyn Fn([f64; 3]) -> f64| -> f64 {
                element_points(&mesh.positions, element, number)
                    .expect("a sound element")
                    .iter()
                    .map(|p| {
                        p.volume
                            * p.shape
                                .iter()
                                .zip(&element.nodes)
                                .map(|(n, &row)| n * field(mesh.positions[row]))
                                .sum::<f64>()
                    })
                    .sum()
            };
            let linear = first(&|x| 0.3 * x[0] - 0.7 * x[1] + 1.1 * x[2]);
            let parts = [0, 1, 2].map(|i| first(&|x| x[i]));
            equal(&column(&[linear]), &column(&[0.3 * parts[0] - 0.7 * parts[1] + 1.1 * parts[2]]));
        }
    });
}

#[test]
fn equations_112_117_centre_of_mass_by_quadrature() {
    each_mesh(|_, integrals, gram| {
        equal(&column(&[integrals.mass]), &part(gram, 0, 1, 0, 1));
        equal(&column(&integrals.first_moment), &part(gram, 1, 3, 0, 1));
    });
}

#[test]
fn equations_114_115_mean_mode_amplitudes_by_quadrature() {
    each_mesh(|_, integrals, gram| {
        for mu in 0..MODES {
            equal(&column(&integrals.modal_first_moment[mu]), &part(gram, 4 + 3 * mu, 3, 0, 1));
        }
    });
}

#[test]
fn equations_122_128_euler_tensor_by_quadrature() {
    each_mesh(|_, integrals, gram| equal(&integrals.second_moment, &part(gram, 1, 3, 1, 3)));
}

#[test]
fn equation_125_position_mode_moments_by_quadrature() {
    each_mesh(|_, integrals, gram| {
        for mu in 0..MODES {
            equal(&integrals.position_mode_moment[mu], &part(gram, 1, 3, 4 + 3 * mu, 3));
        }
    });
}

#[test]
fn equation_131_mode_mode_moments_by_quadrature() {
    each_mesh(|_, integrals, gram| {
        for mu in 0..MODES {
            for nu in 0..MODES {
                let expected = part(gram, 4 + 3 * mu, 3, 4 + 3 * nu, 3);
                equal(&integrals.mode_mode_moment[mu][nu], &expected);
            }
        }
    });
}

/// The same correspondence against a mass matrix that another program assembled: CalculiX, 157 C3D20.
#[test]
fn equations_112_122_quadrature_agrees_with_the_mass_matrix_of_calculix() {
    let deck = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../models/conrod/conrod.inp"));
    let files = ModelFiles { nodes: NodeSource::Calculix(deck.into()), mass: None, stiffness: None };
    let model = read_model(&files).expect("the connecting rod can be read");
    let positions = &model.nodes.positions;
    let density = 7850.0;
    let mut random = Random::new(43);
    let shapes = Mat::from_fn(3 * positions.len(), 2, |_, _| random.number());
    let integrals = shape_integrals(positions, &model.elements, density, shapes.as_ref()).expect("sound");
    let gram = gram_matrix(positions, shapes.as_ref(), &model.mass);
    let reach = positions.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
    let within = |a: &Mat<f64>, b: &Mat<f64>, scale: f64| {
        let off = (a - b).norm_max() / scale;
        println!("deviation from CalculiX: {off:e}");
        assert!(off < crate::check::PRINTED_MATRIX, "{off:e}");
    };
    within(&column(&[integrals.mass]), &part(&gram, 0, 1, 0, 1), integrals.mass);
    // The frame is at the centre of mass: the first moment vanishes but for the mesh, so m times the reach is its scale.
    within(&column(&integrals.first_moment), &part(&gram, 1, 3, 0, 1), integrals.mass * reach);
    within(&integrals.second_moment, &part(&gram, 1, 3, 1, 3), part(&gram, 1, 3, 1, 3).norm_max());
    for mu in 0..2 {
        within(
            &integrals.position_mode_moment[mu],
            &part(&gram, 1, 3, 4 + 3 * mu, 3),
            part(&gram, 1, 3, 4 + 3 * mu, 3).norm_max(),
        );
        within(
            &integrals.mode_mode_moment[mu][mu],
            &part(&gram, 4 + 3 * mu, 3, 4 + 3 * mu, 3),
            part(&gram, 4 + 3 * mu, 3, 4 + 3 * mu, 3).norm_max(),
        );
    }
}

/// Figures of the page on lumped masses in `docs/theory`.
#[test]
fn lumped_masses_keep_the_mass_and_miss_the_second_moments() {
    let deck = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../models/conrod/conrod.inp"));
    let files = ModelFiles { nodes: NodeSource::Calculix(deck.into()), mass: None, stiffness: None };
    let model = read_model(&files).expect("the connecting rod can be read");
    let positions = model.nodes.positions.clone();
    // Smooth test modes in place of eigenmodes: bending, torsion and stretch of the rod's length, quadratic in x.
    let smooth = Mat::from_fn(3 * positions.len(), 3, |row, mu| {
        let ([x, y, z], i) = (positions[row / 3], row % 3);
        match mu {
            0 => [-2.0 * x * y, x * x, 0.0][i],
            1 => [0.0, -x * z, x * y][i],
            _ => [x * x, 0.0, 0.0][i],
        }
    });
    let mut sets = vec![(ElementKind::Hexahedron20, positions, model.elements, smooth)];
    sets.extend(meshes().into_iter().map(|(kind, mesh)| (kind, mesh.positions, mesh.elements, mesh.shapes)));
    println!("| mesh | lumping | m | m a | T | T_mu | T_munu | smallest nodal mass |");
    for (kind, positions, elements, shapes) in sets {
        let tables = [LumpedMass::Consistent, LumpedMass::RowSum, LumpedMass::ScaledDiagonal].map(|way| {
            let mass = way.assemble(&positions, &elements, DENSITY).expect("a mass");
            let least = (0..positions.len()).map(|n| mass[(n, n)]).fold(f64::INFINITY, f64::min);
            (way, least, gram_matrix(&positions, shapes.as_ref(), &mass))
        });
        let modal = 3 * shapes.ncols();
        let consistent = &tables[0].2;
        for (way, least, gram) in &tables[1..] {
            let off = |row, rows, col, columns| {
                crate::check::deviation(
                    &part(gram, row, rows, col, columns),
                    &part(consistent, row, rows, col, columns),
                )
            };
            let (second, deformed) = (off(1, 3, 1, 3), off(4, modal, 4, modal));
            let moved = part(gram, 1, 3, 0, 1) - part(consistent, 1, 3, 0, 1);
            let reach = positions.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
            let first = moved.norm_max() / (consistent[(0, 0)] * reach);
            println!(
                "| {kind:?} x {} | {way:?} | {:.0e} | {:.1e} | {second:.1e} | {:.1e} | {:.1e} | {least:.1e} |",
                elements.len(),
                off(0, 1, 0, 1),
                first,
                off(1, 3, 4, modal),
                deformed,
            );
            assert!(off(0, 1, 0, 1) < 1e-12, "lumping keeps the mass");
            // Row sums even keep T where the shape functions reproduce quadratic fields; moments of modes are lost.
            assert!(deformed > 1e-6, "and does not keep the moments of the modes: {deformed:e}");
            let quadratic = matches!(kind, ElementKind::Tetrahedron10 | ElementKind::Hexahedron20);
            let unusable = *way == LumpedMass::RowSum && quadratic;
            assert_eq!(*least < 0.0, unusable, "row sums of quadratic elements are negative at corners");
        }
    }
}
