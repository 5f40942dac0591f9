//! Why modes and terms are kept or dropped: the words of `ffrf plan` about the motion that it looked at.

use std::fmt::Write as _;

use ffrf_host::tradeoff::{ModeUse, Plan, TermUse, Truncation};
use ffrf_model::ModeKind;

/// A mode with a smaller share of the elastic energy is moved by round-off.
const MOVED: f64 = 1e-9;
/// A static part that takes this much of what truncation loses is worth a shape of its own.
const WORTH: f64 = 0.5;

/// Modes, terms and models of a plan.
pub fn describe(text: &mut String, plan: &Plan, budget: f64) {
    if !plan.motion.modes.is_empty() {
        text.push_str(
            "\nmodes: effective mass in translation and rotation, how fast their load changes (90 % of its power), and how far \
             they move markers in the motion of the whole model, statically (load over stiffness) and altogether\n",
        );
    }
    for mode in &plan.motion.modes {
        let _ = writeln!(
            text,
            "  {} {}: {:.4} Hz, mass {:.1e} and {:.1e}, load up to {:.3} Hz, static {:.1e} m, all {:.1e} m, {:.1e} of the elastic \
             energy: {}",
            mode.body,
            mode.mode,
            mode.frequency,
            mode.effective_mass[0],
            mode.effective_mass[1],
            mode.load_frequency,
            mode.static_displacement,
            mode.displacement,
            mode.energy_share,
            reason_of_mode(mode, plan)
        );
    }
    describe_truncations(text, plan, budget);
    if !plan.motion.terms.is_empty() {
        text.push_str(
            "\nterms of the kinetic energy: the most that they can be, by the speeds and amplitudes of the scene, of the forces of \
             inertia and gravity on the frame, their moment, and the forces on modes, over the largest of any; in brackets what they reach\n",
        );
    }
    for term in &plan.motion.terms {
        let [force, moment, modal] = term.bound;
        let _ = writeln!(
            text,
            "  {} {}: {force:.1e}, {moment:.1e}, {modal:.1e} ({:.1e}, {:.1e}, {:.1e}), {:.1e} of the kinetic energy: {}",
            term.body,
            term.name(),
            term.reached[0],
            term.reached[1],
            term.reached[2],
            term.share,
            reason_of_term(term, plan, budget)
        );
    }
    text.push_str("\nmodels: their error with exact steps\n");
    for choice in &plan.models {
        let _ = writeln!(text, "  {} modes, {}: {:.2e}", choice.modes, choice.fidelity, choice.error);
    }
}

fn reason_of_mode(mode: &ModeUse, plan: &Plan) -> String {
    let (is_moved, is_static) = (mode.energy_share > MOVED, mode.is_quasi_static());
    let nature = match (is_moved, is_static) {
        (false, _) => "nothing moves it",
        (true, true) => "it follows its load as if that were at rest",
        (true, false) => "its load is near its frequency or above: it vibrates",
    };
    if plan.configuration.modes.has(mode.mode - 1) {
        return format!("kept: {nature}; with fewer the error is {}", error_with_fewer(plan));
    }
    let correction = if is_static && is_moved { "; a static shape could stand for it" } else { "" };
    format!("dropped: {nature}{correction}; the error without it is {}", error_of(plan))
}

/// The error of the chosen model.
fn error_of(plan: &Plan) -> String {
    let one = &plan.configuration;
    let chosen = plan.models.iter().find(|model| model.modes == one.modes && model.fidelity == one.fidelity);
    chosen.map_or("that of the model".to_owned(), |model| format!("{:.1e}", model.error))
}

/// The least error that was found with fewer modes.
fn error_with_fewer(plan: &Plan) -> String {
    let fewer = plan.models.iter().filter(|model| model.modes.count() < plan.configuration.modes.count());
    let least = fewer.map(|model| model.error).fold(f64::INFINITY, f64::min);
    if least.is_finite() { format!("{least:.1e} or more") } else { "not allowed".to_owned() }
}

fn reason_of_term(term: &TermUse, plan: &Plan, budget: f64) -> String {
    let bound = term.largest_bound();
    match (plan.configuration.modes.count(), term.is_kept_by(&plan.configuration.fidelity)) {
        (0, _) => "kept as far as a rigid body has it".to_owned(),
        (_, true) if bound == 0.0 => "kept: the model does not have it, it costs nothing".to_owned(),
        (_, true) if bound <= budget => {
            "kept: it costs nothing, or no cheaper model without it keeps the budget".to_owned()
        }
        (_, true) => "kept: its bound is above the budget".to_owned(),
        (_, false) if bound == 0.0 => "dropped: the model does not have it".to_owned(),
        (_, false) if bound <= budget => {
            format!(
                "dropped: its bound is below the budget; without it and others the error is {}",
                error_of(plan)
            )
        }
        (_, false) => format!(
            "dropped: forces that it changes do not reach what is asked for; without it and others the error is {}",
            error_of(plan)
        ),
    }
}

fn describe_truncations(text: &mut String, plan: &Plan, budget: f64) {
    let dropped: Vec<&ModeUse> =
        plan.motion.modes.iter().filter(|mode| !plan.configuration.modes.has(mode.mode - 1)).collect();
    if dropped.is_empty() || plan.truncations.is_empty() {
        return;
    }
    text.push_str("\ndropped modes: how far they move what is asked for, and what static shapes in their place would leave\n");
    let mut is_worth = false;
    for Truncation { channel, lost, with_static_correction } in &plan.truncations {
        let _ = writeln!(text, "  {channel}: {lost:.1e} of its scale, {with_static_correction:.1e}");
        is_worth |= *with_static_correction < WORTH * lost && *lost > WORTH * WORTH * budget;
    }
    let shapes: Vec<String> = dropped
        .iter()
        .filter(|mode| matches!(mode.kind, ModeKind::Attachment | ModeKind::Constraint))
        .map(|mode| format!("{} {}", mode.body, mode.mode))
        .collect();
    text.push_str(&match (is_worth, shapes.is_empty()) {
        (false, _) => "  a static correction is not worth a mode at this budget\n".to_owned(),
        (true, false) => format!("  worth it: the basis has static shapes among them, {}\n", shapes.join(", ")),
        (true, true) => "  worth it: reduce with `ffrf reduce --basis rubin` or `--static-load`, whose residual shapes hold the static part \
                         with fewer modes\n"
            .to_owned(),
    });
}
