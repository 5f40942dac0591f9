//! A listing as a C function.

use std::collections::{BTreeMap, BTreeSet};

use super::Style;
use super::declaration::Declaration;
use super::notation::Notation;
use super::text::Text;
use crate::emit::expression::{Notation as _, expression};
use crate::emit::listing::Listing;
use crate::formulate::Shape;

/// Writes the function. Every input is read before a result is written: they may be the same memory.
pub(super) fn function(text: &mut Text, listing: &Listing, declaration: &Declaration, style: &Style) {
    let results: Vec<String> =
        declaration.outputs.iter().map(|output| declaration.result_name(output)).collect();
    let inputs = declaration.inputs.iter().map(|input| input.name);
    let taken: BTreeSet<&str> = inputs.chain(results.iter().map(String::as_str)).collect();
    let notation = Notation::new(style, Some(&taken));
    let (needs, kind) = (listing.needs(), style.type_name());
    text.block(&format!("{} {{", declaration.prototype()), "}\n", |text| {
        for &input in &declaration.inputs {
            let mut is_used = false;
            for (k, symbol) in input.symbols(style.mode_count).enumerate() {
                if needs.symbols.contains(&symbol) {
                    is_used = true;
                    text.line(format!("const {kind} {} = {}[{k}];", notation.symbol(symbol), input.name));
                }
            }
            if !is_used {
                text.line(format!("(void){};", input.name));
            }
        }
        statements(text, listing, kind, &notation);
        text.blank();
        let values: Vec<String> = listing.results.iter().map(|tree| expression(tree, &notation)).collect();
        if declaration.returns() {
            text.line(format!("return {};", values.concat()));
            return;
        }
        let mut rest = values.iter();
        for (output, name) in declaration.outputs.iter().zip(&results) {
            let is_scalar = matches!(output.shape, Shape::Scalar);
            for (k, value) in rest.by_ref().take(output.shape.entries(style.mode_count)).enumerate() {
                text.line(match is_scalar {
                    true => format!("*{name} = {value};"),
                    false => format!("{name}[{k}] = {value};"),
                });
            }
        }
    });
}

/// Writes the temporaries. One that a running sum is taken up in again is assigned to, not declared again.
fn statements(text: &mut Text, listing: &Listing, kind: &str, notation: &Notation<'_>) {
    let mut uses: BTreeMap<&str, usize> = BTreeMap::new();
    for statement in listing.sections.iter().flat_map(|section| &section.statements) {
        *uses.entry(&statement.name).or_default() += 1;
    }
    let mut declared: BTreeSet<&str> = BTreeSet::new();
    for section in &listing.sections {
        if !section.heading.is_empty() {
            text.blank();
            text.comment([format!("{} ({})", section.heading, section.counts)]);
        }
        for statement in &section.statements {
            let is_new = declared.insert(&statement.name);
            let is_once = uses.get(statement.name.as_str()) == Some(&1);
            let declaration = match (is_new, is_once) {
                (true, true) => format!("const {kind} "),
                (true, false) => format!("{kind} "),
                (false, _) => String::new(),
            };
            let name = notation.name(&statement.name);
            text.line(format!("{declaration}{name} = {};", expression(&statement.value, notation)));
        }
    }
}
