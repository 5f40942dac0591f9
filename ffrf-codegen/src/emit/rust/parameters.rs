//! Invariants that come at run time: the fields of the struct, and how functions read them.

use super::structure::{is_documentation, visibility};
use crate::GenerateOptions;
use crate::emit::writer::Writer;
use crate::expression::Indices;
use crate::invariants::Invariant;
use crate::layout::Layout;

/// The Rust expression of an entry of an invariant.
pub(super) fn place(invariant: Invariant, indices: &Indices, layout: &Layout) -> String {
    let description = invariant.description();
    let stored = indices.iter().take(description.stored_rank(layout[invariant]));
    let indices: Vec<String> = stored.map(|index| format!("[{index}]")).collect();
    format!("body.{}{}", description.name, indices.concat())
}

/// The struct with one field for each invariant that the layout leaves open.
pub(super) fn parameter_struct(
    writer: &mut Writer,
    mode_count: usize,
    layout: &Layout,
    options: &GenerateOptions,
) {
    for attribute in &options.attributes {
        writer.line(attribute);
    }
    if !options.attributes.iter().any(|attribute| is_documentation(attribute)) {
        writer.documentation([format!(
            "Flexible body with {mode_count} modes; its invariants are supplied at run time: call [`Self::check`] once \
             they are."
        )]);
    }
    writer.line("#[derive(Debug, Clone, Copy, PartialEq)]");
    let scalar = options.scalar.constant_type_name();
    writer.block(&format!("{}struct {} {{", visibility(options), options.name), "}", |writer| {
        for invariant in fields(layout) {
            let (description, structure) = (invariant.description(), layout[invariant]);
            let lengths = description.stored_lengths(structure, mode_count);
            let kind = lengths.iter().rev().fold(scalar.to_owned(), |inner, n| format!("[{inner}; {n}]"));
            writer.documentation([description.documentation(structure, mode_count)]);
            writer.line(format!("pub {}: {kind},", description.name));
        }
    });
}

/// The invariants that are fields, in their order.
pub(super) fn fields(layout: &Layout) -> impl Iterator<Item = Invariant> + '_ {
    Invariant::ALL.into_iter().filter(|invariant| layout.is_data(*invariant))
}
