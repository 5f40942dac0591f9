//! The struct of a body and its constants.

use std::fmt::Write as _;

use ffrf_model::ReducedBody;

use super::function::bracketed;
use super::literal::literal;
use crate::report::Report;
use crate::{GenerateOptions, ScalarType};

/// The unit struct, with the user's attributes.
pub(super) fn unit_struct(body: &ReducedBody, report: &Report, options: &GenerateOptions) -> String {
    let mut text = String::new();
    for attribute in &options.attributes {
        let _ = writeln!(text, "{attribute}");
    }
    if !options.attributes.iter().any(|attribute| is_documentation(attribute)) {
        let _ =
            writeln!(text, "/// Flexible body \"{}\" with {} modes.", plain(&body.title), report.mode_count);
    }
    let visibility = visibility(options);
    let _ = writeln!(text, "#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]");
    let _ = writeln!(text, "{visibility}struct {};", options.name);
    text
}

pub(super) fn is_documentation(attribute: &str) -> bool {
    attribute.trim_start().starts_with("///") || attribute.replace(' ', "").starts_with("#[doc=")
}

/// The visibility with a space after it, if there is one.
pub(super) fn visibility(options: &GenerateOptions) -> String {
    match options.visibility.as_str() {
        "" => String::new(),
        visibility => format!("{visibility} "),
    }
}

/// A title on one line, without characters that a terminal obeys.
pub(super) fn plain(title: &str) -> String {
    let visible: String = title.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    visible.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Constants that every baked body has. Names that markers cannot take.
pub(super) fn constants(
    body: &ReducedBody,
    report: &Report,
    options: &GenerateOptions,
) -> Vec<(String, String)> {
    let visibility = visibility(options);
    let modes = report.mode_count;
    let frequencies: Vec<String> = body
        .modes
        .iter()
        .map(|mode| match mode.frequency_hz {
            Some(frequency) => {
                format!("::core::option::Option::Some({})", literal(frequency, ScalarType::F64))
            }
            None => "::core::option::Option::None".to_owned(),
        })
        .collect();
    let list = bracketed(&frequencies, "    ").join("\n");
    let scalar = options.scalar.constant_type_name();
    let mass = literal(body.inertia.mass, options.scalar);
    let mut constants = vec![
        (
            "MODE_COUNT",
            format!("    /// Number of modes M.\n    {visibility}const MODE_COUNT: usize = {modes};\n"),
        ),
        ("MASS", format!("    /// Mass m. Units: kg.\n    {visibility}const MASS: {scalar} = {mass};\n")),
        (
            "FREQUENCIES_HZ",
            format!(
                "    /// Natural frequency of each mode that is an eigenmode. Units: Hz.\n    {visibility}const FREQUENCIES_HZ: [::core::option::Option<f64>; {modes}] = {};\n",
                list.trim_start()
            ),
        ),
    ];
    constants.push((
        "LARGEST_STABLE_STEP",
        format!(
            "    /// Largest step with which the classical Runge-Kutta method of order four is stable for small motions of the\n    /// free body, from its highest frequency and its damping; infinite without either. Units: s.\n    {visibility}const LARGEST_STABLE_STEP: f64 = {};\n",
            stable_step(body)
        ),
    ));
    if let Some(source) = &report.source {
        constants.push((
            "MODEL_FINGERPRINT",
            format!(
                "    /// Hash of the model's content, to tell versions apart.\n    {visibility}const MODEL_FINGERPRINT: u64 = 0x{:016x};\n",
                source.fingerprint
            ),
        ));
    }
    constants.into_iter().map(|(name, text)| (name.to_owned(), text)).collect()
}

/// The literal of the largest stable step; a body without positive modal masses has none, and is refused before.
fn stable_step(body: &ReducedBody) -> String {
    match body.largest_stable_step() {
        Some(step) if step.is_finite() => literal(step, ScalarType::F64),
        Some(_) => "::core::primitive::f64::INFINITY".to_owned(),
        None => "0.0".to_owned(),
    }
}
