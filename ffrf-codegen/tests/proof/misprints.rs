//! The written-out formulas equal the derived equations, and with any misprint of the paper they do not.

use ffrf_codegen::body::RawInertia;
use ffrf_codegen::derive::{EulerPoincare, KineticEnergy};
use ffrf_codegen::expression::{Expression, Graph};
use ffrf_codegen::fidelity::Fidelity;

use crate::formulas::{Misprint, write};
use crate::laws::power_defect;
use ffrf_test_kit::proof::compare::Equations;

struct Case {
    graph: Graph,
    inertia: RawInertia,
    energy: Expression,
    derived: Equations,
}

fn dense(mode_count: usize) -> Case {
    let mut graph = Graph::new();
    let inertia = RawInertia::dense(&mut graph, mode_count);
    let energy = KineticEnergy::new(&mut graph, &inertia).truncated(&mut graph, &Fidelity::Full);
    let derived = EulerPoincare::new(&mut graph, energy, mode_count);
    let derived = Equations::derived(&graph, &derived);
    Case { graph, inertia, energy, derived }
}

#[test]
fn written_formulas_equal_the_derived_equations() {
    for mode_count in 0..5 {
        let Case { mut graph, inertia, derived, .. } = dense(mode_count);
        let written = write(&mut graph, &inertia, None);
        let written = Equations::of(&graph, &written.mass_matrix, &written.quadratic_velocity);
        assert_eq!(written.differences(&derived), Vec::<String>::new(), "M = {mode_count}");
        eprintln!("M = {mode_count}: {} monomials", derived.monomials());
    }
}

#[test]
fn each_misprint_breaks_the_proof_from_the_mode_count_on_where_it_shows() {
    for mode_count in 0..3 {
        let Case { mut graph, inertia, derived, .. } = dense(mode_count);
        for misprint in Misprint::ALL {
            let written = write(&mut graph, &inertia, Some(misprint));
            let written = Equations::of(&graph, &written.mass_matrix, &written.quadratic_velocity);
            let differences = written.differences(&derived);
            let visible = mode_count >= misprint.visible_from();
            assert_eq!(!differences.is_empty(), visible, "M = {mode_count}, {misprint:?}: {differences:#?}");
        }
    }
}

/// Energy and both momenta are blind to the sign of L_ff: conservation alone proves nothing.
#[test]
fn a_wrong_sign_of_the_modal_coriolis_term_conserves_energy_and_momentum() {
    let Case { mut graph, inertia, energy, derived } = dense(2);
    let written = write(&mut graph, &inertia, Some(Misprint::CoriolisSign));
    let defect = power_defect(&mut graph, energy, &written.mass_matrix, &written.quadratic_velocity);
    assert!(defect.is_zero(), "power balance: {defect}");
    // The rows of force and moment are d/dt of the momenta; they do not change.
    let wrong = Equations::of(&graph, &written.mass_matrix, &written.quadratic_velocity);
    let differences = wrong.differences(&derived);
    assert_eq!(differences.len(), 2, "{differences:#?}");
    assert!(differences[0].starts_with("Q[6]") && differences[1].starts_with("Q[7]"), "{differences:#?}");
}

/// A wrong sign of m r~ does break the power balance: the check itself can fail.
#[test]
fn a_wrong_sign_of_the_mass_coupling_breaks_the_power_balance() {
    let Case { mut graph, inertia, energy, .. } = dense(1);
    let written = write(&mut graph, &inertia, Some(Misprint::MassCouplingSign));
    let defect = power_defect(&mut graph, energy, &written.mass_matrix, &written.quadratic_velocity);
    assert!(!defect.is_zero());
}
