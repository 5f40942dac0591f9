//! A kernel that writes each of its results where it belongs, as soon as it is complete.
//!
//! A large matrix that is returned is written when everything is computed: compilers move its stores to the end in any case,
//! behind the divisions that the accelerations wait for, and a processor cannot begin with the next call before they have
//! left its store queue. Here results are written where their last operation stands, a barrier for the compiler keeps them
//! there, and inputs are read behind it where they are not needed before. Nanoseconds of the equations of motion (x86-64, AMD
//! EPYC, `benches/peers`) with results returned and written in place: M = 1: 35, 33; 2: 43, 44; 3: 56, 59; 4: 77, 63;
//! 5: 88, 80; 6: 97, 89.

use std::collections::{BTreeMap, BTreeSet};

use super::Style;
use super::function::{argument, pattern, result_type_of, value};
use super::method::Types;
use crate::emit::documentation;
use crate::emit::expression::expression;
use crate::emit::listing::{Listing, Tree};
use crate::emit::writer::{FunctionHead, Writer};
use crate::expression::{Extent, Input, Symbol};
use crate::formulate::{Interface, Output, Shape, Signature};

/// Whether a kernel writes its results in place: it has several, the first of them a matrix over the velocities.
pub(super) fn is_in_place(signature: &Signature) -> bool {
    matches!(signature.outputs, [Output { shape: Shape::Symmetric(Extent::Velocities), .. }, _, ..])
}

/// The name of the function and of the method.
fn name(signature: &Signature) -> String {
    format!("write_{}", signature.name)
}

/// Writes documentation and text of the function.
pub(super) fn function(writer: &mut Writer, listing: &Listing, style: Style<'_>) {
    let (signature, modes) = (&listing.signature, listing.mode_count);
    let (needs, order) = (listing.needs(), Order::of(listing));
    writer.documentation(documentation::of(signature, modes));
    writer.documentation([format!("Cost: {}.", listing.counts)]);
    writer.line("#[inline]");
    let body = style.parameters.map(|parameters| {
        let unused = if needs.invariants() { "" } else { "_" };
        format!("{unused}body: &{}", parameters.name)
    });
    let inputs = signature.inputs.iter().map(|&input| {
        let unused = if order.first_use(input, modes).is_some() { "" } else { "_" };
        format!("{unused}{}", argument(input, modes, style.scalar))
    });
    let outputs = signature
        .outputs
        .iter()
        .map(|output| format!("{}: &mut {}", output.name, result_type_of(output.shape, modes, style.scalar)));
    let inputs: Vec<String> = body.into_iter().chain(inputs).chain(outputs).collect();
    let name = format!("{}{}", name(signature), style.scalar.generics());
    let head = FunctionHead { name: &name, inputs: &inputs, result: "", may_be_short: false };
    let last = listing.sections.len().saturating_sub(1);
    writer.function(&head, |writer| {
        let read = |writer: &mut Writer, position: usize| {
            for &input in signature.inputs {
                if order.first_use(input, modes) == Some(position) {
                    writer.line(format!("let {} = *{};", pattern(input, modes, &needs), input.name));
                }
            }
        };
        let write = |writer: &mut Writer, position: usize| {
            let mut is_any = false;
            let mut results = listing.results.as_slice();
            for (output, complete) in signature.outputs.iter().zip(&order.complete) {
                let (own, rest) = results.split_at(output.shape.entries(modes).min(results.len()));
                results = rest;
                if *complete == position {
                    let entries: Vec<String> = own.iter().map(|tree| entry(tree, &style)).collect();
                    writer.blank();
                    if own.contains(&Tree::Number(0.0)) {
                        writer.line("let zero = support::zero_entry();");
                    }
                    value(writer, &format!("*{} = ", output.name), output.shape, &entries, modes, ";");
                    is_any = true;
                }
            }
            if is_any && position < last {
                writer.line("support::keep_stores_above();");
            }
        };
        if style.scalar == crate::ScalarType::Generic && (needs.numbers || needs.invariants()) {
            writer.line("let constant = support::constant::<T>;");
        }
        for (position, section) in listing.sections.iter().enumerate() {
            read(writer, position);
            if !section.heading.is_empty() {
                writer.blank();
                writer.line(format!("// {} ({})", section.heading, section.counts));
            }
            for statement in &section.statements {
                writer.line(format!("let {} = {};", statement.name, expression(&statement.value, &style)));
            }
            write(writer, position);
        }
        if listing.sections.is_empty() {
            read(writer, 0);
            write(writer, 0);
        }
    });
}

/// A result; zeros have a name, see `support::zero_entry`.
fn entry(tree: &Tree, style: &Style<'_>) -> String {
    if *tree == Tree::Number(0.0) { "zero".to_owned() } else { expression(tree, style) }
}

/// In which section inputs are needed for the first time, and results are complete.
struct Order {
    first_uses: BTreeMap<Symbol, usize>,
    /// For each result.
    complete: Vec<usize>,
}

impl Order {
    fn of(listing: &Listing) -> Self {
        let mut first_uses = BTreeMap::new();
        // A running sum has its total's name: what counts is where a name is given for the last time.
        let mut given: BTreeMap<&str, usize> = BTreeMap::new();
        for (position, section) in listing.sections.iter().enumerate() {
            for statement in &section.statements {
                for symbol in symbols(&statement.value) {
                    first_uses.entry(symbol).or_insert(position);
                }
                given.insert(&statement.name, position);
            }
        }
        let mut results = listing.results.as_slice();
        let mut complete: Vec<usize> = Vec::new();
        for output in listing.signature.outputs {
            let entries = output.shape.entries(listing.mode_count).min(results.len());
            let (own, rest) = results.split_at(entries);
            results = rest;
            let names = own.iter().flat_map(names).filter_map(|name| given.get(name));
            let position = names.copied().max().unwrap_or(0);
            for symbol in own.iter().flat_map(symbols) {
                let first = first_uses.entry(symbol).or_insert(position);
                *first = position.min(*first);
            }
            complete.push(position);
        }
        Self { first_uses, complete }
    }

    fn first_use(&self, input: Input, modes: usize) -> Option<usize> {
        input.symbols(modes).filter_map(|symbol| self.first_uses.get(&symbol)).min().copied()
    }
}

fn symbols(tree: &Tree) -> BTreeSet<Symbol> {
    let mut found = BTreeSet::new();
    tree.visit(&mut |tree| {
        if let Tree::Symbol(symbol) = tree {
            found.insert(*symbol);
        }
    });
    found
}

fn names(tree: &Tree) -> Vec<&str> {
    let mut found = Vec::new();
    tree.visit(&mut |tree| {
        if let Tree::Name(name) = tree {
            found.push(name.as_str());
        }
    });
    found
}

/// Writes the methods of the trait: as a value, and into given places.
pub(super) fn methods(writer: &mut Writer, types: &Types, interface: Interface, signature: &Signature) {
    let name = name(signature);
    writer.line("#[inline]");
    let inputs = arguments(types, interface, signature);
    let result = types.result(interface, signature);
    let head = FunctionHead { name: signature.name, inputs: &inputs, result: &result, may_be_short: false };
    writer.function(&head, |writer| {
        writer.line(format!("let mut results = ::ffrf::{}::zeros();", signature.results));
        let inputs = signature.inputs.iter().map(|input| input.name.to_owned());
        let outputs = signature.outputs.iter().map(|output| format!("&mut results.{}", output.name));
        call(writer, &format!("self.{name}"), inputs.chain(outputs));
        writer.line("results");
    });
    writer.blank();
    method(writer, types, interface, signature, |writer| {
        let body = types.has_parameters.then(|| "self".to_owned());
        let inputs = signature.inputs.iter().map(|input| format!("support::array({})", input.name));
        call(writer, &name, body.into_iter().chain(inputs).chain(places(signature)));
    });
}

/// Writes the method into given places; `body` writes what it does.
pub(super) fn method(
    writer: &mut Writer,
    types: &Types,
    interface: Interface,
    signature: &Signature,
    body: impl FnOnce(&mut Writer),
) {
    let mut inputs = arguments(types, interface, signature);
    for output in signature.outputs {
        inputs.push(format!("{}: &mut {}", output.name, types.output(interface, output.shape)));
    }
    writer.line("#[inline]");
    let head = FunctionHead { name: &name(signature), inputs: &inputs, result: "", may_be_short: false };
    writer.function(&head, body);
}

fn arguments(types: &Types, interface: Interface, signature: &Signature) -> Vec<String> {
    let inputs = signature.inputs.iter();
    let inputs = inputs.map(|&input| format!("{}: &{}", input.name, types.input(interface, input)));
    std::iter::once("&self".to_owned()).chain(inputs).collect()
}

/// The places of the results as the functions on arrays take them.
pub(super) fn places(signature: &Signature) -> impl Iterator<Item = String> {
    signature.outputs.iter().map(|output| match output.shape {
        Shape::Symmetric(_) | Shape::Columns { .. } => format!("support::columns_mut({})", output.name),
        _ => format!("support::array_mut({})", output.name),
    })
}

/// Writes a call as a statement, an argument a line.
pub(super) fn call(writer: &mut Writer, function: &str, arguments: impl Iterator<Item = String>) {
    writer.block(&format!("{function}("), ");", |writer| {
        for argument in arguments {
            writer.line(format!("{argument},"));
        }
    });
}
