//! Inherent constants of a body: its own numbers and its markers.

use ffrf_model::{Marker, ReducedBody};

use super::structure::{RESERVED, constants, visibility};
use crate::emit::Subject;
use crate::emit::literal::literal;
use crate::emit::markers::constant_names;
use crate::emit::writer::{Writer, bracketed};
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
        for (marker, name) in body.markers.iter().zip(constant_names(&body.markers, &RESERVED)) {
            writer.blank();
            marker_constant(writer, marker, &name, report.mode_count, options);
        }
    });
}

/// The methods of the trait that knows markers by name.
pub(super) fn trait_methods(writer: &mut Writer, subject: &Subject<'_>, marker: &str) {
    let markers = subject.model.map_or(&[][..], |model| &model.markers);
    let names: Vec<String> = markers.iter().map(|marker| format!("{:?}", marker.name)).collect();
    writer.line("#[inline]");
    writer.block("fn marker_names(&self) -> &'static [&'static str] {", "}", |writer| {
        writer.line(format!("&{}", bracketed(&names, 12)));
    });
    writer.blank();
    writer.line("#[inline]");
    let head = format!("fn marker(&self, name: &str) -> ::core::option::Option<{marker}> {{");
    writer.block(&head, "}", |writer| {
        writer.block("match name {", "}", |writer| {
            let cast = if subject.options.scalar == ScalarType::Generic { ".cast()" } else { "" };
            for (name, constant) in names.iter().zip(constant_names(markers, &RESERVED)) {
                writer.line(format!("{name} => ::core::option::Option::Some(Self::{constant}{cast}),"));
            }
            writer.line("_ => ::core::option::Option::None,");
        });
    });
}

fn marker_constant(
    writer: &mut Writer,
    marker: &Marker,
    name: &str,
    modes: usize,
    options: &GenerateOptions,
) {
    let scalar = options.scalar.constant_type_name();
    let vector = |entries: &mut dyn Iterator<Item = f64>| {
        let entries: Vec<String> = entries.map(|value| literal(value, options.scalar)).collect();
        format!("::ffrf::generated_support::vector({})", bracketed(&entries, 48))
    };
    writer.documentation([format!(
        "Marker `{}`. Units: m, and per unit modal coordinate; a row for each axis. Frame: body.",
        marker.name
    )]);
    let kind = format!("::ffrf::Marker<::ffrf::nalgebra::SVector<{scalar}, {modes}>, {scalar}>");
    let head = format!("{}const {name}: {kind} = ::ffrf::Marker {{", visibility(options));
    writer.block(&head, "};", |writer| {
        writer.line(format!("position: {},", vector(&mut marker.position.into_iter())));
        for (field, shapes) in [("translation", &marker.translation), ("rotation", &marker.rotation)] {
            writer.block(&format!("{field}: ["), "],", |writer| {
                for axis in 0..3 {
                    writer.line(format!("{},", vector(&mut shapes.iter().map(|shape| shape[axis]))));
                }
            });
        }
    });
}
