//! Mass matrix, quadratic velocity vector, energy and angular momentum: polynomials in state and invariants.

use std::time::Instant;

use ffrf_codegen::body::{BodyExpressions, raw_inertia};
use ffrf_codegen::derive::{EulerPoincare, KineticEnergy};
use ffrf_codegen::expression::{Expression, Graph};
use ffrf_codegen::fidelity::Fidelity;
use ffrf_codegen::invariants::{Invariant, Structure};
use ffrf_codegen::layout::Layout;
use ffrf_codegen::polynomial::polynomials_of;

use crate::loops::{Compiled, Loops, fields, half, whole};
use crate::{fidelities, layouts};
use ffrf_test_kit::proof::compare::Equations;

/// Proves the polynomial kernels of one body; returns the number of monomials compared.
fn prove(modes: usize, compiled: Compiled, layout: &Layout, fidelity: &Fidelity) -> usize {
    let mut graph = Graph::new();
    let case = format!("M = {modes}, {layout}, {fidelity:?}");
    let raw = raw_inertia(&mut graph, modes, layout);
    let energy = KineticEnergy::new(&mut graph, &raw).truncated(&mut graph, fidelity);
    let derived = EulerPoincare::new(&mut graph, energy, modes);
    let body = BodyExpressions::symbolic(&mut graph, modes, layout).truncated(&mut graph, fidelity);
    let loops = compiled(&mut graph, &body);
    compare(&graph, loops, energy, &derived, &case)
}

/// Compares all polynomials; returns the number of monomials.
fn compare(graph: &Graph, loops: Loops, energy: Expression, derived: &EulerPoincare, case: &str) -> usize {
    let fast = Equations::of(graph, &loops.mass_matrix, &loops.quadratic_velocity);
    let slow = Equations::derived(graph, derived);
    assert_eq!(fast.differences(&slow), Vec::<String>::new(), "{case}");
    let found = [vec![loops.kinetic_energy], loops.angular_momentum].concat();
    let expected = [&[energy], &derived.momentum[3..6]].concat();
    let found = polynomials_of(graph, &found).unwrap();
    let expected = polynomials_of(graph, &expected).unwrap();
    assert_eq!(found, expected, "{case}: energy or angular momentum");
    slow.monomials() + expected.iter().map(|polynomial| polynomial.term_count()).sum::<usize>()
}

fn prove_all(modes: usize, compiled: Compiled, layouts: &[Layout], fidelities: &[Fidelity]) {
    let start = Instant::now();
    let (mut proofs, mut monomials) = (0, 0);
    for layout in layouts {
        for fidelity in fidelities {
            monomials += prove(modes, compiled, layout, fidelity);
            proofs += 1;
        }
    }
    let time = start.elapsed().as_secs_f64();
    eprintln!("M = {modes}: {proofs} proofs, {monomials} monomials, {time:.2} s");
}

#[test]
fn loops_over_one_group_equal_the_derived_equations() {
    prove_all(1, whole::<1, 7, 1, 0, 1>, &layouts(), &fidelities());
    prove_all(2, whole::<2, 8, 1, 0, 1>, &layouts(), &fidelities());
    prove_all(3, whole::<3, 9, 1, 0, 1>, &layouts(), &fidelities());
    prove_all(4, whole::<4, 10, 1, 0, 1>, &layouts(), &fidelities());
}

/// The general layout with a diagonal and with a dense Θ_ff, and the free-free one with the identity.
fn three_layouts() -> [Layout; 3] {
    [
        Layout::GENERAL.with(Invariant::ModalMass, Structure::Diagonal),
        Layout::FREE_FREE.with(Invariant::ModalMass, Structure::Identity),
        Layout::GENERAL,
    ]
}

/// Free-free modes with the geometric stiffness of linear loads.
fn stiffened() -> [Layout; 1] {
    let base = Layout::FREE_FREE.with(Invariant::ModalMass, Structure::Identity);
    [base.with(Invariant::LinearLoadStiffness, Structure::Dense)]
}

/// A pair of groups, and a pair with a single group after it; with padding.
#[test]
fn loops_over_pairs_of_groups_equal_the_derived_equations() {
    prove_all(6, whole::<6, 12, 2, 1, 0>, &three_layouts(), &[Fidelity::Full, Fidelity::Linear]);
    prove_all(9, whole::<9, 15, 3, 1, 1>, &three_layouts(), &[Fidelity::Full]);
    prove_all(6, whole::<6, 12, 2, 1, 0>, &stiffened(), &[Fidelity::Full]);
    prove_all(9, whole::<9, 15, 3, 1, 1>, &stiffened(), &[Fidelity::Full]);
}

/// The smallest bodies whose moments are stored by half, in blocks of four (f64) and of eight (f32).
#[test]
fn loops_over_half_of_the_moments_equal_the_derived_equations() {
    prove_all(21, half::<21, 27, 6, 4, 6, 120>, &three_layouts(), &[Fidelity::Full]);
    prove_all(21, half::<21, 27, 6, 4, 6, 120>, &stiffened(), &[Fidelity::Full]);
    prove_all(28, half::<28, 34, 8, 8, 4, 48>, &three_layouts()[..1], &[Fidelity::Full]);
}

/// Invariants that come at run time, read from the fields of a struct.
#[test]
fn loops_over_fields_equal_the_derived_equations() {
    fn prove<const M: usize, const N: usize, const G: usize>(modal_mass: Structure) -> usize {
        let layout = Layout::GENERAL.with(Invariant::ModalMass, modal_mass);
        let mut graph = Graph::new();
        let raw = raw_inertia(&mut graph, M, &layout);
        let energy = KineticEnergy::new(&mut graph, &raw);
        let energy = energy.truncated(&mut graph, &Fidelity::Full);
        let derived = EulerPoincare::new(&mut graph, energy, M);
        let loops = fields::<M, N, G>(&mut graph, &layout);
        compare(&graph, loops, energy, &derived, &format!("M = {M}, {layout}"))
    }
    for modal_mass in [Structure::Identity, Structure::Diagonal] {
        let monomials = prove::<1, 7, 1>(modal_mass)
            + prove::<2, 8, 1>(modal_mass)
            + prove::<3, 9, 1>(modal_mass)
            + prove::<4, 10, 1>(modal_mass)
            + prove::<6, 12, 2>(modal_mass);
        eprintln!("fields, {modal_mass:?}: {monomials} monomials");
    }
}
