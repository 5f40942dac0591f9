//! What `ffrf tradeoff` and `ffrf plan` say in the same words.

use std::fmt::Write as _;

use ffrf_codegen::Fidelity;
use ffrf_host::tradeoff::Reference;

/// What the reference is, in words.
pub fn describe_reference(reference: &Reference) -> String {
    let terms = match &reference.fidelity {
        Fidelity::Full => "every term".to_owned(),
        held => format!("every term that all bodies hold ({held})"),
    };
    let mut text = format!(
        "reference: {} modes, {terms}, Dormand-Prince 5(4) with the relative tolerance {:e} per step, {} steps\n",
        reference.modes, reference.tolerance, reference.steps
    );
    text.push_str(
        "its own error, the difference to a run of a coarser tolerance, over the scale of each quantity:\n",
    );
    let channels = reference.channels.iter().zip(&reference.scales).zip(&reference.own_errors);
    for ((channel, scale), own) in channels {
        let _ = writeln!(text, "  {}: {own:.1e} (scale {scale:.4e} {})", channel.name, channel.unit);
    }
    text
}
