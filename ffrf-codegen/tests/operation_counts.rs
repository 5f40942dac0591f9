//! What each kernel costs, as snapshots: a change of cost is seen in the difference, by layout and by fidelity.

use std::fmt::Write as _;

use ffrf_codegen::invariants::Invariant;
use ffrf_codegen::layout::{Layout, Structure};
use ffrf_codegen::{Fidelity, GenerateOptions, GeneratedCode, generate, generate_with_layout};
use ffrf_test_kit::random_body::{Modes, random_body};

/// Modes that are made orthogonal in the test are so to some ulp; what is zero must count as zero.
const TOLERANCE: f64 = 1e-12;

fn table(title: &str, code: &GeneratedCode) -> String {
    let mut text = format!("{title}\n");
    for kernel in &code.report.kernels {
        let _ = writeln!(text, "  {:24} {}", kernel.name, kernel.counts);
    }
    text
}

#[test]
fn cost_by_number_of_modes_and_layout() {
    let mut text = String::new();
    for count in [0, 1, 2, 4] {
        for modes in [Modes::Random, Modes::Normalised, Modes::FreeFree] {
            let options = GenerateOptions { layout_tolerance: TOLERANCE, ..GenerateOptions::default() };
            let code = generate(&random_body(3, count, modes), &options).unwrap();
            text.push_str(&table(&format!("M = {count}, {modes:?}"), &code));
        }
    }
    insta::assert_snapshot!("cost_by_layout", text);
}

#[test]
fn cost_by_fidelity() {
    let mut text = String::new();
    for fidelity in Fidelity::LEVELS {
        let title = format!("M = 2, {}", fidelity.name());
        let options = GenerateOptions { fidelity, ..GenerateOptions::default() };
        let code = generate(&random_body(3, 2, Modes::Normalised), &options).unwrap();
        text.push_str(&table(&title, &code));
    }
    insta::assert_snapshot!("cost_by_fidelity", text);
}

#[test]
fn what_a_declared_layout_leaves_out_costs_nothing() {
    let total_at = |layout: &Layout, fidelity: Fidelity| -> usize {
        let options = GenerateOptions { fidelity, ..GenerateOptions::default() };
        let code = generate_with_layout(3, layout, &options).unwrap();
        // A contracted product and sum are two: without its sum the product is still there.
        code.report.kernels.iter().map(|kernel| kernel.counts.total() + kernel.counts.fused).sum()
    };
    let total = |layout: &Layout| total_at(layout, Fidelity::Full);
    let general = total(&Layout::GENERAL);
    let stiffened = Layout::GENERAL.stiffened();
    for (invariant, structure) in stiffened.entries() {
        let admitted = invariant.description().admitted;
        for special in admitted.iter().filter(|special| **special != structure) {
            // Declared apart from T_μν, Θ_ff has a factorisation to pay for, or not.
            let layout = stiffened.with(invariant, *special);
            // T_μν without trace is for fidelities that take no more from its even part.
            let consistent = layout.check_body(3, &Fidelity::Full).is_ok();
            let fidelity = if consistent { Fidelity::Full } else { Fidelity::Linear };
            let (cost, general) = (total_at(&layout, fidelity.clone()), total_at(&stiffened, fidelity));
            let name = invariant.name();
            assert!(cost < general, "{name}: {special} costs {cost}, {structure} {general}");
        }
    }
    let zero = Layout::FREE_FREE.with(Invariant::PositionModeMoment, Structure::Zero);
    assert!(total(&zero) < total(&Layout::FREE_FREE));
    // Measured: 0.6; a third less is promised.
    assert!(3 * total(&Layout::FREE_FREE) < 2 * general);
}
