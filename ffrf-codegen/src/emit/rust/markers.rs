//! Inherent constants of a body: its own numbers and its markers.

use ffrf_model::{Marker, ReducedBody, SectionMarker, StressMarker};

use super::structure::{RESERVED, constants, visibility};
use crate::emit::Subject;
use crate::emit::literal::literal;
use crate::emit::markers::{constant_names, loads};
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
        let [names, stress_names, section_names] = constant_names(body, &RESERVED);
        let loads = loads(body, &options.fidelity);
        for ((number, marker), name) in (0_u16..).zip(&body.markers).zip(names) {
            writer.blank();
            let stressing = loads.iter().any(|(loaded, _)| *loaded == number).then_some(number);
            marker_constant(writer, (marker, stressing), &name, report.mode_count, options);
        }
        for (marker, name) in body.stress_markers.iter().zip(stress_names) {
            writer.blank();
            stress_constant(writer, marker, &name, report.mode_count, options);
        }
        for (marker, name) in body.section_markers.iter().zip(section_names) {
            writer.blank();
            section_constant(writer, marker, &name, report.mode_count, options);
        }
    });
}

/// The method that bends the rows of the markers whose loads stress the body, if there are any.
pub(super) fn bent_marker(writer: &mut Writer, subject: &Subject<'_>, marker: &str, modal: &str) {
    let Some(model) = subject.model else { return };
    let loads = loads(model, &subject.options.fidelity);
    if loads.is_empty() {
        return;
    }
    writer.blank();
    writer.line("#[inline]");
    let head = format!(
        "fn bent_marker(&self, marker: &{marker}, q: &{modal}) -> ::core::option::Option<{marker}> {{"
    );
    writer.block(&head, "}", |writer| {
        for (number, load) in &loads {
            let (kind, modes) = (subject.options.scalar.constant_type_name(), subject.report.mode_count);
            writer.line(format!("// Γ of unit forces and moments at `{}`.", load.marker.escape_debug()));
            let head = format!("const STRESSED_{number}: [[[{kind}; {modes}]; {modes}]; 6] = [");
            writer.block(&head, "];", |writer| {
                for axis in 0..6 {
                    let rows = load.stiffness.iter().map(|row| {
                        let row = row.iter().map(|load| literal(load[axis], subject.options.scalar));
                        bracketed(&row.collect::<Vec<_>>(), 48)
                    });
                    writer.block("[", "],", |writer| rows.for_each(|row| writer.line(format!("{row},"))));
                }
            });
        }
        let convert = match subject.options.scalar {
            ScalarType::Generic => "::ffrf::generated_support::constant",
            _ => "::core::convert::identity",
        };
        writer.block("match marker.stressing {", "}", |writer| {
            for (number, _) in &loads {
                writer.line(format!(
                    "::core::option::Option::Some({number}) => \
                     ::core::option::Option::Some(::ffrf::generated_support::bent(marker, &STRESSED_{number}, q, {convert})),"
                ));
            }
            writer.line("_ => ::core::option::Option::None,");
        });
    });
}

/// The methods of the trait that knows markers by name; those for stress and sections if there are any.
pub(super) fn trait_methods(writer: &mut Writer, subject: &Subject<'_>, marker: &str) {
    let [constants, stress_constants, section_constants] =
        subject.model.map_or([Vec::new(), Vec::new(), Vec::new()], |model| constant_names(model, &RESERVED));
    let names =
        subject.model.map_or(Vec::new(), |model| quoted(model.markers.iter().map(|marker| &marker.name)));
    lookup(writer, subject, ["marker_names", "marker"], marker, names.into_iter().zip(constants).collect());
    let Some(model) = subject.model else { return };
    let stress = quoted(model.stress_markers.iter().map(|marker| &marker.name));
    let sections = quoted(model.section_markers.iter().map(|marker| &marker.name));
    for (kind, methods, names, constants) in [
        ("StressMarker", ["stress_marker_names", "stress_marker"], stress, stress_constants),
        ("SectionMarker", ["section_marker_names", "section_marker"], sections, section_constants),
    ] {
        if names.is_empty() {
            continue;
        }
        writer.blank();
        let kind = marker.replacen("Marker", kind, 1);
        lookup(writer, subject, methods, &kind, names.into_iter().zip(constants).collect());
    }
}

fn quoted<'a>(names: impl Iterator<Item = &'a String>) -> Vec<String> {
    names.map(|name| format!("{name:?}")).collect()
}

/// The names, and the constant of each.
fn lookup(
    writer: &mut Writer,
    subject: &Subject<'_>,
    [all, one]: [&str; 2],
    kind: &str,
    entries: Vec<(String, String)>,
) {
    let names: Vec<String> = entries.iter().map(|(name, _)| name.clone()).collect();
    writer.line("#[inline]");
    writer.block(&format!("fn {all}(&self) -> &'static [&'static str] {{"), "}", |writer| {
        writer.line(format!("&{}", bracketed(&names, 12)));
    });
    writer.blank();
    writer.line("#[inline]");
    let head = format!("fn {one}(&self, name: &str) -> ::core::option::Option<{kind}> {{");
    writer.block(&head, "}", |writer| {
        writer.block("match name {", "}", |writer| {
            let cast = if subject.options.scalar == ScalarType::Generic { ".cast()" } else { "" };
            for (name, constant) in entries {
                writer.line(format!("{name} => ::core::option::Option::Some(Self::{constant}{cast}),"));
            }
            writer.line("_ => ::core::option::Option::None,");
        });
    });
}

/// A vector of literals.
fn vector(entries: &mut dyn Iterator<Item = f64>, scalar: ScalarType) -> String {
    let entries: Vec<String> = entries.map(|value| literal(value, scalar)).collect();
    format!("::ffrf::generated_support::vector({})", bracketed(&entries, 48))
}

fn stress_constant(
    writer: &mut Writer,
    marker: &StressMarker,
    name: &str,
    modes: usize,
    options: &GenerateOptions,
) {
    let scalar = options.scalar.constant_type_name();
    writer.documentation([format!(
        "Stress marker `{}`: xx, yy, zz, xy, xz, yz. Units: N/m², per unit modal coordinate. Frame: body.",
        marker.name
    )]);
    let kind = format!("::ffrf::StressMarker<::ffrf::nalgebra::SVector<{scalar}, {modes}>, {scalar}>");
    let head = format!("{}const {name}: {kind} = ::ffrf::StressMarker {{", visibility(options));
    writer.block(&head, "};", |writer| {
        let position = vector(&mut marker.position.into_iter(), options.scalar);
        writer.line(format!("position: {position},"));
        writer.block("stress: [", "],", |writer| {
            for component in 0..6 {
                let row = &mut marker.stress.iter().map(|stress| stress[component]);
                writer.line(format!("{},", vector(row, options.scalar)));
            }
        });
    });
}

fn section_constant(
    writer: &mut Writer,
    marker: &SectionMarker,
    name: &str,
    modes: usize,
    options: &GenerateOptions,
) {
    let scalar = options.scalar.constant_type_name();
    writer.documentation([format!(
        "Section `{}`: force and moment through it. Units: N and N m, per unit modal coordinate; a row for each axis. Frame: body.",
        marker.name
    )]);
    let kind = format!("::ffrf::SectionMarker<::ffrf::nalgebra::SVector<{scalar}, {modes}>, {scalar}>");
    let head = format!("{}const {name}: {kind} = ::ffrf::SectionMarker {{", visibility(options));
    writer.block(&head, "};", |writer| {
        let position = vector(&mut marker.position.into_iter(), options.scalar);
        writer.line(format!("position: {position},"));
        for (field, first) in [("force", 0), ("moment", 3)] {
            writer.block(&format!("{field}: ["), "],", |writer| {
                for component in first..first + 3 {
                    let row = &mut marker.force.iter().map(|force| force[component]);
                    writer.line(format!("{},", vector(row, options.scalar)));
                }
            });
        }
    });
}

fn marker_constant(
    writer: &mut Writer,
    (marker, stressing): (&Marker, Option<u16>),
    name: &str,
    modes: usize,
    options: &GenerateOptions,
) {
    let scalar = options.scalar.constant_type_name();
    let vector = |entries: &mut dyn Iterator<Item = f64>| vector(entries, options.scalar);
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
        let stressing = stressing.map_or("None".to_owned(), |number| format!("Some({number})"));
        writer.line(format!("stressing: ::core::option::Option::{stressing},"));
    });
}
