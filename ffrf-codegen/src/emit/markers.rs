//! Inherent constants of a body: its own numbers and its markers.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use ffrf_model::{Marker, ReducedBody, Vector3};

use super::function::bracketed;
use super::literal::literal;
use super::structure::{constants, visibility};
use crate::report::Report;
use crate::{GenerateOptions, ScalarType};

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

/// The methods of the trait that know markers by name.
pub(super) fn trait_methods(body: &ReducedBody, options: &GenerateOptions) -> String {
    if body.markers.is_empty() {
        return String::new();
    }
    let marker = format!("::ffrf::Marker<{}, {}>", body.mode_count(), options.scalar.type_name());
    let names: Vec<String> = body.markers.iter().map(|marker| format!("{:?}", marker.name)).collect();
    let names = bracketed(&names, "            ").join("\n");
    let mut text = format!(
        "
        #[inline]
        fn marker_names(&self) -> &'static [&'static str] {{
            &{}
        }}

        #[inline]
        fn marker(&self, name: &str) -> ::core::option::Option<{marker}> {{
            match name {{
",
        names.trim_start()
    );
    let cast = if options.scalar == ScalarType::Generic { ".cast()" } else { "" };
    for (marker, name) in body.markers.iter().zip(&constant_names(body)) {
        let _ = writeln!(
            text,
            "                {:?} => ::core::option::Option::Some({}::{name}{cast}),",
            marker.name, options.name
        );
    }
    text.push_str("                _ => ::core::option::Option::None,\n            }\n        }\n");
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
    let scalar = options.scalar.constant_type_name();
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
