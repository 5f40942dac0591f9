//! Inherent constants of a body: its own numbers and its markers.

use std::collections::BTreeSet;

use ffrf_model::{Marker, ReducedBody, Vector3};

use super::literal::literal;
use super::structure::{RESERVED, constants, visibility};
use super::writer::{Writer, bracketed};
use crate::report::Report;
use crate::{GenerateOptions, ScalarType};

/// `impl NAME { ... }` with one constant per number and marker.
pub(super) fn inherent_constants(
    writer: &mut Writer,
    body: &ReducedBody,
    report: &Report,
    options: &GenerateOptions,
) {
    writer.line("#[allow(dead_code, clippy::all, clippy::pedantic)]");
    writer.block(&format!("impl {} {{", options.name), "}", |writer| {
        let constants = constants(body, report, options);
        for (position, constant) in constants.iter().enumerate() {
            if position > 0 {
                writer.blank();
            }
            constant.write(writer, options);
        }
        for (marker, name) in body.markers.iter().zip(constant_names(body)) {
            writer.blank();
            marker_constant(writer, marker, &name, report.mode_count, options);
        }
    });
}

/// The methods of the trait that know markers by name.
pub(super) fn trait_methods(writer: &mut Writer, body: &ReducedBody, options: &GenerateOptions) {
    if body.markers.is_empty() {
        return;
    }
    let marker = format!("::ffrf::Marker<{}, {}>", body.mode_count(), options.scalar.type_name());
    let names: Vec<String> = body.markers.iter().map(|marker| format!("{:?}", marker.name)).collect();
    writer.blank();
    writer.line("#[inline]");
    writer.block("fn marker_names(&self) -> &'static [&'static str] {", "}", |writer| {
        writer.line(format!("&{}", bracketed(&names, 12)));
    });
    writer.blank();
    writer.line("#[inline]");
    let head = format!("fn marker(&self, name: &str) -> ::core::option::Option<{marker}> {{");
    writer.block(&head, "}", |writer| {
        writer.block("match name {", "}", |writer| {
            let cast = if options.scalar == ScalarType::Generic { ".cast()" } else { "" };
            for (name, constant) in names.iter().zip(constant_names(body)) {
                writer.line(format!(
                    "{name} => ::core::option::Option::Some({}::{constant}{cast}),",
                    options.name
                ));
            }
            writer.line("_ => ::core::option::Option::None,");
        });
    });
}

/// The names of the markers in upper case, made unique.
fn constant_names(body: &ReducedBody) -> Vec<String> {
    let mut taken: BTreeSet<String> = RESERVED.map(str::to_owned).into();
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

fn marker_constant(
    writer: &mut Writer,
    marker: &Marker,
    name: &str,
    modes: usize,
    options: &GenerateOptions,
) {
    let scalar = options.scalar.constant_type_name();
    let vector = |vector: &Vector3| {
        let entries = vector.map(|value| literal(value, options.scalar));
        format!("[{}]", entries.join(", "))
    };
    let rows = |rows: &[Vector3]| bracketed(&rows.iter().map(vector).collect::<Vec<_>>(), 8);
    writer.documentation([format!(
        "Marker `{}`. Units: m, and per unit modal coordinate. Frame: body.",
        marker.name
    )]);
    let head =
        format!("{}const {name}: ::ffrf::Marker<{modes}, {scalar}> = ::ffrf::Marker {{", visibility(options));
    writer.block(&head, "};", |writer| {
        writer.line(format!("position: {},", vector(&marker.position)));
        writer.line(format!("translation: {},", rows(&marker.translation)));
        writer.line(format!("rotation: {},", rows(&marker.rotation)));
    });
}
