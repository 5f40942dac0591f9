//! A function on arrays.

use std::collections::BTreeSet;

use super::{ALLOWED, Style, import, multiply_add};
use crate::emit::expression::expression;
use crate::emit::listing::{Listing, Needs, Operation, Tree, listing};
use crate::emit::units::UnitNames;
use crate::emit::writer::{FunctionHead, Writer, bracketed};
use crate::expression::{Expression, Graph, Node, Symbol};
use crate::validate::ValidKernel;
use crate::{ArrayFunction, ArrayInput, Call, Function, GenerateOptions, InputForm, Relation};

/// The text of the function.
pub(in crate::emit) fn array_function(
    function: &ArrayFunction,
    kernel: &ValidKernel,
    options: &GenerateOptions,
) -> String {
    let style = Style { scalar: options.scalar, parameters: None };
    let listing = listing(kernel, |tree| expression(tree, &style).chars().count());
    let mut needs = listing.needs();
    let calls = calls(function, &mut needs, style);
    let number = options.scalar.type_name();
    let mut writer = Writer::new(UnitNames::of(None));
    writer.documentation(&function.documentation);
    writer.documentation([String::new(), format!("Cost: {}.", listing.counts)]);
    writer.line(ALLOWED);
    let mut inputs: Vec<String> = function
        .inputs
        .iter()
        .map(|input| {
            let unused = if is_used(input, &needs.symbols) { "" } else { "_" };
            format!("{unused}{}: {}", input.name, argument_type(input, number))
        })
        .collect();
    inputs.push(format!("{}: &mut [{number}; {}]", function.output, function.results.len()));
    let head = FunctionHead { name: &function.name, inputs: &inputs, result: "bool", may_be_short: true };
    writer.prefixed_function("pub ", &head, |writer| {
        if needs.multiply_add {
            writer.line(import(multiply_add(options), "fma", options.scalar));
        }
        if needs.square_root {
            writer.line(import("square_root", "square_root", options.scalar));
        }
        for input in function.inputs.iter().filter(|input| is_used(input, &needs.symbols)) {
            let read = if input.form == InputForm::Number { "" } else { "*" };
            writer.line(format!("let {} = {read}{};", pattern(input, &needs.symbols), input.name));
        }
        calls.iter().for_each(|call| writer.line(call));
        for statement in listing.sections.iter().flat_map(|section| &section.statements) {
            writer.line(format!("let {} = {};", statement.name, expression(&statement.value, &style)));
        }
        results(writer, function, &listing, style);
    });
    writer.finish()
}

/// The values of functions that are needed, a line for each, and what their arguments need.
fn calls(function: &ArrayFunction, needs: &mut Needs, style: Style<'_>) -> Vec<String> {
    let mut lines = Vec::new();
    for (index, call) in function.calls.iter().enumerate().rev() {
        if !needs.symbols.contains(&Call::symbol(index)) {
            continue;
        }
        let argument = tree(&function.graph, call.argument);
        argument.visit(&mut |tree| match tree {
            Tree::Symbol(symbol) => {
                needs.symbols.insert(*symbol);
            }
            Tree::SquareRoot(_) => needs.square_root = true,
            _ => {}
        });
        let name = match call.function {
            Function::Sine => "sin",
            Function::Cosine => "cos",
        };
        let value = expression(&argument, &style);
        lines.push(format!("let {} = ::ffrf::nalgebra::ComplexField::{name}({value});", Call::symbol(index)));
    }
    lines.reverse();
    lines
}

/// An expression as one tree: for what is small.
fn tree(graph: &Graph, root: Expression) -> Tree {
    let at = |operand| tree(graph, operand);
    let binary = |operation, a, b| Tree::Binary(operation, Box::new([at(a), at(b)]));
    match graph.node(root) {
        Node::Constant(constant) => Tree::Number(constant.value()),
        Node::Symbol(symbol) => Tree::Symbol(symbol),
        Node::Negate(a) => Tree::Negate(Box::new(at(a))),
        Node::Add(a, b) => binary(Operation::Add, a, b),
        Node::Subtract(a, b) => binary(Operation::Subtract, a, b),
        Node::Multiply(a, b) => binary(Operation::Multiply, a, b),
        Node::Divide(a, b) => binary(Operation::Divide, a, b),
        Node::MultiplyAdd(a, b, c) => Tree::MultiplyAdd(Box::new([at(a), at(b), at(c)])),
        Node::SquareRoot(a) => Tree::SquareRoot(Box::new(at(a))),
    }
}

fn is_used(input: &ArrayInput, symbols: &BTreeSet<Symbol>) -> bool {
    (0..input.count).any(|index| symbols.contains(&input.symbol(index)))
}

fn argument_type(input: &ArrayInput, number: &str) -> String {
    match input.form {
        InputForm::Number => number.to_owned(),
        InputForm::Flat => format!("&[{number}; {}]", input.count),
        InputForm::Nested(inner) => format!("&[[{number}; {inner}]; {}]", input.count / inner.max(1)),
    }
}

/// The entries that are needed, by name.
fn pattern(input: &ArrayInput, symbols: &BTreeSet<Symbol>) -> String {
    let names: Vec<String> = (0..input.count)
        .map(|index| match input.symbol(index) {
            symbol if symbols.contains(&symbol) => symbol.to_string(),
            _ => "_".to_owned(),
        })
        .collect();
    match input.form {
        InputForm::Number => names.join(", "),
        InputForm::Flat => bracketed(&names, 0),
        InputForm::Nested(inner) => {
            let inner: Vec<String> =
                names.chunks(inner.max(1)).map(|names| format!("[{}]", names.join(", "))).collect();
            bracketed(&inner, 0)
        }
    }
}

/// Writes the results where they belong, and whether the conditions hold.
fn results(writer: &mut Writer, function: &ArrayFunction, listing: &Listing, style: Style<'_>) {
    let (results, sides) = listing.results.split_at(function.results.len().min(listing.results.len()));
    let entries: Vec<String> = results.iter().map(|tree| expression(tree, &style)).collect();
    writer.line(format!("*{} = {};", function.output, bracketed(&entries, 0)));
    let typed = |tree: &Tree| match tree {
        Tree::Number(_) => format!("{}_{}", expression(tree, &style), style.scalar.type_name()),
        _ => expression(tree, &style),
    };
    let conditions = function.conditions.iter().zip(sides.chunks(2)).filter_map(|(condition, sides)| {
        let [left, right] = sides else { return None };
        let [left, right] = [typed(left), typed(right)];
        let sign = match condition.relation {
            Relation::Finite => return Some(format!("({left}).is_finite()")),
            Relation::Less => "<",
            Relation::LessOrEqual => "<=",
            Relation::Equal => "==",
            Relation::NotEqual => "!=",
            Relation::Greater => ">",
            Relation::GreaterOrEqual => ">=",
        };
        let comparison = format!("{left} {sign} {right}");
        Some(if function.conditions.len() > 1 { format!("({comparison})") } else { comparison })
    });
    // each is evaluated: a branch for each would cost more
    let conditions: Vec<String> = conditions.collect();
    match conditions.as_slice() {
        [] => writer.line("true"),
        [first, rest @ ..] => {
            writer.line(first);
            writer.indent();
            rest.iter().for_each(|condition| writer.line(format!("& {condition}")));
            writer.outdent();
        }
    }
}
