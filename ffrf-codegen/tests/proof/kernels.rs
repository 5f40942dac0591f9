//! The fast kernels equal what the energy implies: coefficient by coefficient, at every layout and fidelity.

use std::time::Instant;

use ffrf_codegen::body::{BodyExpressions, raw_inertia};
use ffrf_codegen::derive::{EulerPoincare, KineticEnergy};
use ffrf_codegen::expression::{Expression, Input, dot};
use ffrf_codegen::fidelity::Fidelity;
use ffrf_codegen::formulate::kernels::PREPARE;
use ffrf_codegen::formulate::{
    DeformedBody, Draft, State, angular_momentum, gravity_force, internal_force, kinetic_energy,
    linear_momentum, mass_matrix, quadratic_velocity,
};
use ffrf_codegen::invariants::Invariant;
use ffrf_codegen::layout::{Layout, Structure};
use ffrf_codegen::polynomial::polynomials_of;

use crate::laws::all_fidelities;
use ffrf_test_kit::proof::compare::Equations;
use ffrf_test_kit::proof::mutated::every_mutant_is_found;

/// Every combination of structures that concern inertia, 600 of them.
fn all_layouts() -> Vec<Layout> {
    let mut layouts = vec![Layout::GENERAL];
    // Stiffness and damping do not enter the kinetic energy.
    for (invariant, _) in Layout::GENERAL.entries().take(6) {
        layouts = layouts
            .iter()
            .flat_map(|layout| {
                let admitted = invariant.description().admitted.iter();
                admitted.map(|structure| layout.with(invariant, *structure))
            })
            .collect();
    }
    assert!(layouts.iter().all(|layout| layout.check().is_ok()));
    layouts
}

/// Geometric stiffness of uniform loads, of linear loads, and of both.
fn stiffened_layouts() -> Vec<Layout> {
    let bases = [Layout::GENERAL, Layout::FREE_FREE];
    let each = [Invariant::UniformLoadStiffness, Invariant::LinearLoadStiffness];
    let single = bases.iter().flat_map(|base| each.map(|invariant| base.with(invariant, Structure::Dense)));
    single.chain(bases.map(Layout::stiffened)).collect()
}

/// Each structure of each invariant, the others as in the general and as in the free-free layout.
fn single_layouts() -> Vec<Layout> {
    let mut layouts = stiffened_layouts();
    for base in [Layout::GENERAL, Layout::FREE_FREE] {
        for (invariant, _) in base.entries().take(6) {
            for structure in invariant.description().admitted {
                let varied = base.with(invariant, *structure);
                if !layouts.contains(&varied) {
                    layouts.push(varied);
                }
            }
        }
    }
    layouts
}

/// Proves all polynomial kernels of one body; returns the number of monomials compared.
fn prove(mode_count: usize, layout: &Layout, fidelity: &Fidelity) -> usize {
    let mut graph = Draft::default();
    let g = &mut graph;
    let case = format!("M = {mode_count}, {layout}, {fidelity:?}");

    // What the energy implies
    let raw = raw_inertia(g, mode_count, layout);
    let energy = KineticEnergy::new(g, &raw).truncated(g, fidelity);
    let derived = EulerPoincare::new(g, energy, mode_count);
    let gravity: [Expression; 3] = [0, 1, 2].map(|i| g.symbol(Input::GRAVITY.symbol(i)));
    // A uniform field is an acceleration of the origin: the first three columns of the mass matrix.
    let weight: Vec<_> =
        derived.mass_matrix.iter().map(|row| dot(g, [row[0], row[1], row[2]], gravity)).collect();
    let mut expected = vec![energy];
    expected.extend(&derived.momentum[..6]);
    expected.extend(weight);

    // The fast kernels
    let body = BodyExpressions::symbolic(g, mode_count, layout).truncated(g, fidelity);
    let state = State::symbolic(g, mode_count);
    let deformed = DeformedBody::new(g, &body, &state);
    let columns = mass_matrix(g, &body, &deformed);
    let quadratic = quadratic_velocity(g, &body, &state, &deformed);
    let prepared = (PREPARE.formulate)(g, &body, &state, &deformed).unwrap();
    let internal = internal_force(g, &body, &state);
    assert_eq!(prepared, parts(&columns, &quadratic, &internal), "{case}: prepared state");
    let mut found = vec![kinetic_energy(g, &body, &state, &deformed)];
    found.extend(linear_momentum(g, &body, &state, &deformed));
    found.extend(angular_momentum(g, &state, &deformed));
    found.extend(gravity_force(g, &body, &state, &deformed));

    let fast = Equations::of(&graph, &columns, &quadratic);
    let slow = Equations::derived(&graph, &derived);
    assert_eq!(fast.differences(&slow), Vec::<String>::new(), "{case}");
    let found = polynomials_of(&graph, &found).unwrap();
    let expected = polynomials_of(&graph, &expected).unwrap();
    assert_eq!(found, expected, "{case}: energy, momenta or gravity");
    slow.monomials() + expected.iter().map(|polynomial| polynomial.term_count()).sum::<usize>()
}

/// What a prepared state holds, taken from the dense forms: the same expressions, proven with them.
fn parts(columns: &[Vec<Expression>], quadratic: &[Expression], internal: &[Expression]) -> Vec<Expression> {
    // m r~ in the columns of the rotation: x, y, z where they have no sign.
    let first_moment = [columns[5][1], columns[3][2], columns[4][0]];
    let modal = |row: usize| columns[6..].iter().map(move |column| column[row]);
    let mut parts = vec![columns[0][0]];
    parts.extend(first_moment);
    parts.extend((0..9).map(|k| columns[3 + k / 3][3 + k % 3]));
    parts.extend((0..6).flat_map(modal));
    parts.extend(quadratic);
    parts.extend(internal);
    parts
}

fn prove_all(mode_counts: &[usize], layouts: &[Layout], fidelities: &[Fidelity]) {
    for &mode_count in mode_counts {
        let start = Instant::now();
        let (mut proofs, mut monomials) = (0, 0);
        for layout in layouts {
            for fidelity in fidelities {
                monomials += prove(mode_count, layout, fidelity);
                proofs += 1;
            }
        }
        let time = start.elapsed().as_secs_f64();
        eprintln!("M = {mode_count}: {proofs} proofs, {monomials} monomials, {time:.2} s");
    }
}

#[test]
fn kernels_without_modes_and_with_one_equal_the_derived_equations() {
    prove_all(&[0], &single_layouts(), &Fidelity::LEVELS);
    prove_all(&[1], &all_layouts(), &Fidelity::LEVELS);
}

#[test]
fn kernels_with_two_modes_equal_the_derived_equations() {
    prove_all(&[2], &all_layouts(), &Fidelity::LEVELS);
}

/// Each structure by itself at each level, and a sample of the combinations (17 shares no factor with their numbers).
#[test]
fn kernels_with_more_modes_equal_the_derived_equations() {
    prove_all(&[3, 4], &single_layouts(), &Fidelity::LEVELS);
    let sample: Vec<_> = all_layouts().into_iter().step_by(17).collect();
    prove_all(&[3, 4], &sample, &[Fidelity::Full]);
}

#[test]
fn kernels_of_every_list_of_terms_equal_the_derived_equations() {
    let layouts = [Layout::GENERAL, Layout::FREE_FREE].map(Layout::stiffened);
    prove_all(&[0, 1, 2], &layouts, &all_fidelities());
}

/// One wrong sign or one wrong operand order anywhere in the fast kernels makes the proof fail.
#[test]
fn any_wrong_sign_in_the_kernels_breaks_the_proof() {
    let mode_count = 2;
    let mut graph = Draft::default();
    let body = BodyExpressions::symbolic(&mut graph, mode_count, &Layout::GENERAL.stiffened());
    let state = State::symbolic(&mut graph, mode_count);
    let deformed = DeformedBody::new(&mut graph, &body, &state);
    let columns = mass_matrix(&mut graph, &body, &deformed);
    let outputs = [columns.concat(), quadratic_velocity(&mut graph, &body, &state, &deformed)].concat();
    let mutants = every_mutant_is_found(&graph, &outputs);
    assert!(mutants > 200);
}

/// What the proof proves is not empty: the general layout has as many monomials as the written formulas.
#[test]
fn the_general_layout_leaves_every_invariant_a_symbol() {
    let counts: Vec<usize> =
        (0..5).map(|mode_count| prove(mode_count, &Layout::GENERAL, &Fidelity::Full)).collect();
    eprintln!("monomials of the general layout: {counts:?}");
    assert!(counts.windows(2).all(|pair| pair[0] < pair[1]));
    assert!(prove(4, &Layout::GENERAL.stiffened(), &Fidelity::Full) > counts[4]);
    let free = Layout::FREE_FREE.with(Invariant::ModalMass, Structure::Diagonal);
    assert!(prove(4, &free, &Fidelity::Full) < counts[4]);
}
