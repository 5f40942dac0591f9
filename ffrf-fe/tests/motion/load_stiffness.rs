//! Geometric stiffness of unit loads: closed forms of rods, and the work of loads on displacements of second order.

use faer::Mat;
use ffrf_fe::elements::{Material, assemble_materials, quadratic_brick};
use ffrf_fe::geometric_stiffness::{GeometricStiffnessError, PrestressSupport, geometric_stiffness};
use ffrf_fe::modes::{ModeRequest, compute_modes};
use ffrf_fe::stress::nodal_stress;
use ffrf_fe::{Elasticity, FeError, FeModel, ModeBasis, PartElasticity};
use ffrf_model::{GeometricStiffness, Mode, ModeKind};

/// Without Poisson's effect the stress of a pulled rod is that of the closed form everywhere.
const ROD: Material = Material { youngs_modulus: 2.0e6, poisson_ratio: 0.0, density: 1200.0 };
const LENGTHS: [f64; 3] = [1.0, 0.1, 0.05];

/// Polynomials that the elements and their quadrature hold: round-off of the static solution.
const EXACT: f64 = 1e-10;
/// Cubic displacements in ten quadratic elements: h⁴ of the energy.
const DISCRETISED: f64 = 1e-4;

fn rod() -> FeModel {
    quadratic_brick(LENGTHS, [10, 1, 1], &ROD).expect("a sound mesh")
}

/// Mass per length.
fn line_mass() -> f64 {
    ROD.density * LENGTHS[1] * LENGTHS[2]
}

/// u_y = x² and u_x = x²: slopes of 2 x.
fn parabolas(model: &FeModel) -> ModeBasis {
    let shapes = Mat::from_fn(3 * model.nodes.len(), 2, |row, mode| {
        let x = model.nodes.positions[row / 3][0];
        if row % 3 == [1, 0][mode] { x * x } else { 0.0 }
    });
    ModeBasis { shapes, modes: vec![Mode { kind: ModeKind::User, frequency_hz: None }; 2] }
}

fn root(model: &FeModel) -> Vec<usize> {
    (0..model.nodes.len()).filter(|&row| model.nodes.positions[row][0] == 0.0).collect()
}

fn of(model: &FeModel, support: &PrestressSupport) -> GeometricStiffness {
    geometric_stiffness(model, &parabolas(model), support, None).expect("one material")
}

#[track_caller]
fn near(what: &str, found: f64, expected: f64, within: f64) {
    assert!((found - expected).abs() <= within, "{what}: {found:e}, expected {expected:e} within {within:e}");
}

/// A pull of ρ e_x leaves N = ρA (L - x), one of ρ x e_x leaves ρA (L² - x²) / 2: Γ = ∫ N (2 x)².
#[test]
fn a_rod_held_at_one_end_has_the_stiffness_of_its_axial_force() {
    let model = rod();
    let found = of(&model, &PrestressSupport::Clamped { nodes: root(&model) });
    // ∫ (1 - x) 4 x² = 1/3, ∫ (1 - x²) 2 x² = 4/15
    let (uniform, linear) = (line_mass() / 3.0, line_mass() * 4.0 / 15.0);
    for mode in 0..2 {
        near("uniform", found.uniform_load[mode][mode][0], uniform, EXACT * uniform);
        near("linear", found.linear_load[mode][mode][0][0], linear, DISCRETISED * linear);
    }
    near("across", found.uniform_load[0][1][0], 0.0, EXACT * uniform);
    // Moved by 0.3 along x, the load ρ x e_x is ρ 0.3 e_x more.
    let mut moved = model.clone();
    moved.nodes.positions.iter_mut().for_each(|x| x[0] += 0.3);
    let basis = parabolas(&model);
    let support = PrestressSupport::Clamped { nodes: root(&model) };
    let shifted = geometric_stiffness(&moved, &basis, &support, None).expect("one material");
    let expected = linear + 0.3 * uniform;
    near("moved", shifted.linear_load[0][0][0][0], expected, DISCRETISED * expected);
}

/// Two rods end to end, the second lighter and stiffer: the axial force knows their densities only, the displacements both moduli.
#[test]
fn a_rod_of_two_materials_has_the_stiffness_of_its_axial_force_and_its_stress() {
    let whole = rod();
    let light = Material { youngs_modulus: 9.0e6, poisson_ratio: 0.0, density: 300.0 };
    let middle = |element: &ffrf_fe::Element| {
        element.nodes.iter().map(|&row| whole.nodes.positions[row][0]).sum::<f64>()
            / element.nodes.len() as f64
    };
    const SEAM: f64 = 0.4;
    let of_element = whole.elements.iter().map(|element| usize::from(middle(element) > SEAM)).collect();
    let materials = [("heavy".to_owned(), ROD), ("light".to_owned(), light)];
    let model = assemble_materials(whole.nodes.clone(), whole.elements.clone(), &materials, of_element);
    let model = model.expect("sound elements");
    let area = LENGTHS[1] * LENGTHS[2];
    let masses = [ROD.density * area * SEAM, light.density * area * (1.0 - SEAM)];
    let total: f64 = model.mass.val().iter().sum();
    near("mass", total, masses[0] + masses[1], EXACT * total);
    let entries = model.mass.triplet_iter();
    let first: f64 = entries.map(|entry| model.nodes.positions[entry.row][0] * entry.val).sum();
    let expected = 0.5 * SEAM * masses[0] + 0.5 * (1.0 + SEAM) * masses[1];
    near("first moment of mass", first, expected, EXACT * expected);

    // N = A (ρ₁ (c - x) + ρ₂ (1 - c)) before the seam at c, A ρ₂ (1 - x) behind it: Γ = ∫ N 4 x².
    let found = of(&model, &PrestressSupport::Clamped { nodes: root(&model) });
    let c = SEAM;
    let before = ROD.density * c.powi(4) / 3.0 + light.density * (1.0 - c) * c.powi(3) * 4.0 / 3.0;
    let behind = light.density * (1.0 / 3.0 - c.powi(3) * 4.0 / 3.0 + c.powi(4));
    let expected = area * (before + behind);
    for mode in 0..2 {
        near("uniform", found.uniform_load[mode][mode][0], expected, EXACT * expected);
    }

    // A pull of σ: the strain is σ / E in each.
    const PULL: f64 = 5000.0;
    let shapes = Mat::from_fn(3 * model.nodes.len(), 1, |row, _| {
        let x = model.nodes.positions[row / 3][0];
        let along = x.min(c) / ROD.youngs_modulus + (x - c).max(0.0) / light.youngs_modulus;
        if row % 3 == 0 { PULL * along } else { 0.0 }
    });
    let elasticity = PartElasticity::of_model(&model).expect("two materials");
    for row in 0..model.nodes.len() {
        let found = nodal_stress(&model, shapes.as_ref(), &elasticity, row).expect("sound elements");
        let stress = found.expect("a node of an element")[0];
        near("pull", stress[0], PULL, EXACT * PULL);
        stress[1..].iter().for_each(|&other| near("other stresses", other, 0.0, EXACT * PULL));
    }
    let mut short = model;
    short.element_materials.pop();
    let elasticity = PartElasticity::of_model(&short).expect("two materials");
    assert!(nodal_stress(&short, shapes.as_ref(), &elasticity, short.nodes.len() - 1).is_err());
}

/// In mean axes a rod about its middle is pulled by centrifugal forces only, N = ρA (L²/4 - s²) / 2; accelerations of the frame
/// are balanced by its own inertia and leave nothing.
#[test]
fn a_free_rod_has_the_stiffness_of_centrifugal_forces_and_no_other() {
    let mut model = rod();
    for x in &mut model.nodes.positions {
        *x = [x[0] - 0.5, x[1] - 0.05, x[2] - 0.025];
    }
    let found = of(&model, &PrestressSupport::MeanAxes);
    // ∫ (1/4 - s²) 2 s² over [-1/2, 1/2] = 1/60
    let expected = line_mass() / 60.0;
    near("centrifugal", found.linear_load[0][0][0][0], expected, DISCRETISED * expected);
    assert_eq!(found.uniform_load, vec![vec![[0.0; 3]; 2]; 2]);
    for moment in found.linear_load.iter().flatten() {
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            assert_eq!(moment[i][j], moment[j][i], "angular acceleration");
        }
    }
}

/// -Γ q q is the work of the load on the displacement g of second order that the stresses of q leave: the load's own displacement
/// u_b weighted by the force of second order, ∫ σ(u_b) : ∇uᵀ∇u, is the same integral with another order of sums.
#[test]
fn the_stiffness_is_the_work_of_the_load_on_displacements_of_second_order() {
    let material = Material { youngs_modulus: 7e10, poisson_ratio: 0.3, density: 2700.0 };
    let model = quadratic_brick([0.5, 0.06, 0.04], [5, 1, 1], &material).expect("a sound mesh");
    let root = root(&model);
    let solution =
        compute_modes(&model, &ModeRequest::clamped(3, root.clone()), &mut |_| {}).expect("three modes");
    let shapes = &solution.basis.shapes;
    let support = PrestressSupport::Clamped { nodes: root.clone() };
    let found = geometric_stiffness(&model, &solution.basis, &support, None).expect("one material");
    let q = [0.7, -0.4, 0.9];
    let size = 3 * model.nodes.len();
    let field: Vec<f64> = (0..size).map(|row| (0..3).map(|mu| shapes[(row, mu)] * q[mu]).sum()).collect();

    // K g = -f with f·w = ∫ σ(w) : ∇uᵀ∇u, element by element; dense, on the free degrees of freedom
    let force = second_order_force(&model, &material, &field);
    let free: Vec<usize> = (0..size).filter(|dof| !root.contains(&(dof / 3))).collect();
    let stiffness = model.stiffness.as_ref().expect("a stiffness") * Mat::<f64>::identity(size, size);
    let reduced = Mat::from_fn(free.len(), free.len(), |i, j| stiffness[(free[i], free[j])]);
    let right = Mat::from_fn(free.len(), 1, |i, _| -force[free[i]]);
    let solved = faer::linalg::solvers::Solve::solve(&reduced.partial_piv_lu(), &right);
    let mut second = vec![0.0; size];
    for (i, &dof) in free.iter().enumerate() {
        second[dof] = solved[(i, 0)];
    }
    // ∫ρ g and ∫ρ x ⊗ g by the mass matrix
    let weigh = |weights: &dyn Fn(usize) -> f64, j: usize| -> f64 {
        let entries = model.mass.triplet_iter();
        entries.map(|entry| *entry.val * weights(entry.row) * second[3 * entry.col + j]).sum()
    };
    let quadratic = |entry: &dyn Fn(usize, usize) -> f64| -> f64 {
        (0..3)
            .flat_map(|mu| (0..3).map(move |nu| (mu, nu)))
            .map(|(mu, nu)| q[mu] * q[nu] * entry(mu, nu))
            .sum()
    };
    let largest = quadratic(&|mu, nu| found.uniform_load[mu][nu][0]).abs();
    for j in 0..3 {
        let expected = -weigh(&|_| 1.0, j);
        near("uniform", quadratic(&|mu, nu| found.uniform_load[mu][nu][j]), expected, 1e-8 * largest);
        for i in 0..3 {
            let expected = -weigh(&|node| model.nodes.positions[node][i], j);
            let linear = quadratic(&|mu, nu| found.linear_load[mu][nu][i][j]);
            near("linear", linear, expected, 1e-8 * largest);
        }
    }
    assert!(largest > 0.0);
}

/// f with f·w = ∫ σ(w) : ∇uᵀ∇u.
fn second_order_force(model: &FeModel, material: &Material, field: &[f64]) -> Vec<f64> {
    let (lambda, mu) = (material.lame_lambda(), material.shear_modulus());
    let mut force = vec![0.0; field.len()];
    for element in &model.elements {
        let corners: Vec<[f64; 3]> = element.nodes.iter().map(|&row| model.nodes.positions[row]).collect();
        for point in ffrf_fe::elements::quadrature(element.kind, &corners).expect("a sound element") {
            let slope = |i: usize, k: usize| -> f64 {
                element.nodes.iter().zip(&point.gradient).map(|(&row, g)| field[3 * row + i] * g[k]).sum()
            };
            let square = |k: usize, l: usize| -> f64 { (0..3).map(|i| slope(i, k) * slope(i, l)).sum() };
            let trace = square(0, 0) + square(1, 1) + square(2, 2);
            for (&row, g) in element.nodes.iter().zip(&point.gradient) {
                for i in 0..3 {
                    // σ : C with ε(w) = sym(e_i ⊗ g): λ g_i tr C + 2 μ g_k C_ik
                    let shear: f64 = (0..3).map(|k| g[k] * square(i, k)).sum();
                    force[3 * row + i] += point.volume * (lambda * g[i] * trace + 2.0 * mu * shear);
                }
            }
        }
    }
    force
}

#[test]
fn what_cannot_be_computed_is_refused_with_what_is_missing() {
    let model = rod();
    let support = PrestressSupport::Clamped { nodes: root(&model) };
    let refused = |model: &FeModel, elasticity: Option<Elasticity>| match geometric_stiffness(
        model,
        &parabolas(model),
        &support,
        elasticity,
    ) {
        Err(FeError::GeometricStiffness(error)) => error,
        other => panic!("{other:?}"),
    };
    let without = FeModel { elements: Vec::new(), ..model.clone() };
    assert_eq!(refused(&without, None), GeometricStiffnessError::NoElements);
    let without = FeModel { materials: Vec::new(), ..model.clone() };
    assert_eq!(refused(&without, None), GeometricStiffnessError::NoMaterial);
    let mut two = model.clone();
    two.materials.push(ffrf_fe::SolidMaterial {
        name: "RUBBER".to_owned(),
        elasticity: Some(Elasticity { youngs_modulus: 1e6, poisson_ratio: 0.4 }),
    });
    // Not known which element is of which.
    two.element_materials.clear();
    assert!(refused(&two, None).to_string().contains("RUBBER"));
    two.materials[1].elasticity = None;
    assert!(matches!(refused(&two, None), GeometricStiffnessError::NotIsotropic { .. }));
    // N/mm² in the place of N/m²
    let wrong = Elasticity { youngs_modulus: 2.0, poisson_ratio: 0.0 };
    let error = refused(&model, Some(wrong));
    assert!(matches!(error, GeometricStiffnessError::Energy { ratio, .. } if ratio < 1e-5), "{error}");
    let liquid = Elasticity { youngs_modulus: 2e6, poisson_ratio: 0.5 };
    assert!(matches!(refused(&model, Some(liquid)), GeometricStiffnessError::Unstable { .. }));
}
