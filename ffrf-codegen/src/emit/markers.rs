//! Inherent constants of a body: its own numbers and its markers.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use ffrf_model::{Marker, ReducedBody, Vector3};

use super::function::bracketed;
use super::literal::literal;
use super::structure::{constants, visibility};
use crate::GenerateOptions;
use crate::report::Report;

/// `impl NAME { ... }` with one constant per number and marker.
pub(super) fn inherent_constants(body: &ReducedBody, report: &Report, options: &GenerateOptions) -> String {
    let mut entries: Vec<String> =
        constants(body, report, options).into_iter().map(|(_, text)| text).collect();
    for (marker, name) in body.markers.iter().zip(constant_names(body)) {
        entries.push(marker_constant(marker, &name, report.mode_count, options));
    }
    format!(
        "#[allow(dead_code, clippy::all, clippy::pedantic)]\nimpl {} {{\n{}}}\n",
        options.name,
        entries.join("\n")
    )
}

/// The method `markers` of the trait.
pub(super) fn trait_method(body: &ReducedBody, options: &GenerateOptions) -> String {
    let modes = body.mode_count();
    let marker = format!("::ffrf::Marker<{modes}, {}>", options.scalar.name());
    let mut text = format!(
        "
        #[inline]
        fn markers(&self) -> &'static [(&'static str, {marker})] {{
            const MARKERS: &[(&str, {marker})] = &["
    );
    let names = constant_names(body);
    for (marker, name) in body.markers.iter().zip(&names) {
        let _ = write!(text, "\n                ({:?}, {}::{name}),", marker.name, options.name);
    }
    let end = if names.is_empty() { "];" } else { "\n            ];" };
    let _ = writeln!(text, "{end}\n            MARKERS\n        }}");
    text
}

/// The names of the markers in upper case, made unique.
fn constant_names(body: &ReducedBody) -> Vec<String> {
    let mut taken: BTreeSet<String> =
        ["MODE_COUNT", "MASS", "FREQUENCIES_HZ", "MODEL_FINGERPRINT"].map(str::to_owned).into();
    body.markers
        .iter()
        .map(|marker| {
            let base: String = marker
                .name
                .chars()
                .map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' })
                .collect();
            let base =
                if base.starts_with(|c: char| c.is_ascii_alphabetic()) { base } else { format!("M_{base}") };
            let mut name = base.clone();
            let mut copy = 2;
            while !taken.insert(name.clone()) {
                name = format!("{base}_MARKER{copy}");
                copy += 1;
            }
            name
        })
        .collect()
}

fn marker_constant(marker: &Marker, name: &str, modes: usize, options: &GenerateOptions) -> String {
    let scalar = options.scalar.name();
    let visibility = visibility(options);
    let vector = |vector: &Vector3| {
        let entries = vector.map(|value| literal(value, options.scalar));
        format!("[{}]", entries.join(", "))
    };
    let rows = |rows: &[Vector3]| {
        let rows: Vec<String> = rows.iter().map(vector).collect();
        bracketed(&rows, "        ").join("\n").trim_start().to_owned()
    };
    let (translation, rotation) = (rows(&marker.translation), rows(&marker.rotation));
    format!(
        "    /// Marker `{0}`. Units: m, and per unit modal coordinate. Frame: body.
    {visibility}const {name}: ::ffrf::Marker<{modes}, {scalar}> = ::ffrf::Marker {{
        position: {1},
        translation: {translation},
        rotation: {rotation},
    }};
",
        marker.name,
        vector(&marker.position)
    )
}
