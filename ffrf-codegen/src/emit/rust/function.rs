//! A listing as a Rust function on arrays.

use super::Style;
use crate::ScalarType;
use crate::emit::documentation;
use crate::emit::expression::expression;
use crate::emit::listing::{Listing, Needs};
use crate::emit::writer::{FunctionHead, Writer, bracketed};
use crate::expression::Input;
use crate::formulate::{Shape, Signature};

/// Writes documentation and text of the function.
pub(super) fn function(writer: &mut Writer, listing: &Listing, style: Style<'_>) {
    let (signature, modes) = (&listing.signature, listing.mode_count);
    let needs = listing.needs();
    writer.documentation(documentation::of(signature, modes));
    writer.documentation([format!("Cost: {}.", listing.counts)]);
    writer.line("#[inline]");
    let is_used = |input: Input| input.symbols(modes).any(|symbol| needs.symbols.contains(&symbol));
    let mut inputs = Vec::new();
    if let Some(parameters) = style.parameters {
        let unused = if needs.invariants() { "" } else { "_" };
        inputs.push(format!("{unused}body: &{}", parameters.name));
    }
    for &input in signature.inputs {
        let unused = if is_used(input) { "" } else { "_" };
        inputs.push(format!("{unused}{}", argument(input, modes, style.scalar)));
    }
    let head = FunctionHead {
        name: &format!("{}{}", signature.name, style.scalar.generics()),
        inputs: &inputs,
        result: &result_type(signature, modes, style.scalar),
        may_be_short: true,
    };
    writer.function(&head, |writer| {
        for &input in signature.inputs.iter().filter(|input| is_used(**input)) {
            writer.line(format!("let {} = *{};", pattern(input, modes, &needs), input.name));
        }
        if style.scalar == ScalarType::Generic && (needs.numbers || needs.invariants()) {
            writer.line("let constant = support::constant::<T>;");
        }
        for section in &listing.sections {
            if !section.heading.is_empty() {
                writer.blank();
                writer.line(format!("// {} ({})", section.heading, section.counts));
            }
            for statement in &section.statements {
                writer.line(format!("let {} = {};", statement.name, expression(&statement.value, &style)));
            }
        }
        writer.blank();
        results(writer, listing, style);
    });
}

/// An argument with its type.
pub(super) fn argument(input: Input, modes: usize, scalar: ScalarType) -> String {
    format!("{}: &[{}; {}]", input.name, scalar.type_name(), input.size(modes))
}

/// The type of all results: a tuple if there are several.
pub(super) fn result_type(signature: &Signature, modes: usize, scalar: ScalarType) -> String {
    let types: Vec<String> =
        signature.outputs.iter().map(|output| result_type_of(output.shape, modes, scalar)).collect();
    match types.as_slice() {
        [single] => single.clone(),
        several => format!("({})", several.join(", ")),
    }
}

/// The type of one result.
pub(super) fn result_type_of(shape: Shape, modes: usize, scalar: ScalarType) -> String {
    let name = scalar.type_name();
    match shape {
        Shape::Scalar => name.to_owned(),
        Shape::Vector(_) | Shape::Motion | Shape::Force => format!("[{name}; {}]", shape.entries(modes)),
        Shape::Symmetric(extent) => format!("[[{name}; {0}]; {0}]", extent.size(modes)),
        Shape::Columns { rows, columns } => {
            format!("[[{name}; {}]; {}]", rows.size(modes), columns.size(modes))
        }
    }
}

/// The entries of an argument that are needed, by name.
pub(super) fn pattern(input: Input, modes: usize, needs: &Needs) -> String {
    let entries = input.symbols(modes).map(|symbol| match needs.symbols.contains(&symbol) {
        true => symbol.to_string(),
        false => "_".to_owned(),
    });
    format!("[{}]", entries.collect::<Vec<_>>().join(", "))
}

/// Writes the entries of a result between `start` and `end`.
pub(super) fn value(
    writer: &mut Writer,
    start: &str,
    shape: Shape,
    entries: &[String],
    modes: usize,
    end: &str,
) {
    match shape {
        Shape::Scalar => writer.line(format!("{start}{}{end}", entries.concat())),
        Shape::Vector(_) | Shape::Motion | Shape::Force => {
            writer.line(format!("{start}{}{end}", bracketed(entries, start.len())));
        }
        Shape::Symmetric(rows) | Shape::Columns { rows, .. } => {
            let rows = rows.size(modes);
            writer.block(&format!("{start}["), &format!("]{end}"), |writer| {
                for column in 0..shape.columns(modes) {
                    let column = entries.get(rows * column..rows * (column + 1)).unwrap_or_default();
                    writer.line(format!("{},", bracketed(column, 4)));
                }
            });
        }
    }
}

fn results(writer: &mut Writer, listing: &Listing, style: Style<'_>) {
    let entries: Vec<String> = listing.results.iter().map(|tree| expression(tree, &style)).collect();
    let modes = listing.mode_count;
    let mut rest = entries.as_slice();
    let mut parts = Vec::new();
    for output in listing.signature.outputs {
        let (part, later) = rest.split_at(output.shape.entries(modes).min(rest.len()));
        parts.push((output.shape, part));
        rest = later;
    }
    match parts.as_slice() {
        [(shape, part)] => value(writer, "", *shape, part, modes, ""),
        parts => writer.block("(", ")", |writer| {
            for (shape, part) in parts {
                value(writer, "", *shape, part, modes, ",");
            }
        }),
    }
}
