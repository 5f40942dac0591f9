//! What stands about a function: its prototype and what its documentation says.

use super::Style;
use crate::emit::documentation;
use crate::emit::listing::Listing;
use crate::expression::Input;
use crate::formulate::{Output, Shape};

/// The prototype of a kernel.
pub(super) struct Declaration {
    name: String,
    kind: &'static str,
    mode_count: usize,
    /// Whether no other file sees it.
    pub(super) is_local: bool,
    /// Inputs that have entries.
    pub(super) inputs: Vec<Input>,
    /// Results that have entries.
    pub(super) outputs: Vec<Output>,
}

impl Declaration {
    pub(super) fn of(listing: &Listing, style: &Style) -> Self {
        let (signature, mode_count) = (&listing.signature, style.mode_count);
        Self {
            name: format!("{}_{}", style.prefix, signature.name),
            kind: style.type_name(),
            mode_count,
            is_local: false,
            inputs: signature.inputs.iter().copied().filter(|input| input.size(mode_count) > 0).collect(),
            outputs: signature
                .outputs
                .iter()
                .copied()
                .filter(|output| output.shape.entries(mode_count) > 0)
                .collect(),
        }
    }

    pub(super) fn has_results(&self) -> bool {
        !self.outputs.is_empty()
    }

    /// Whether the result is a number that is returned.
    pub(super) fn returns(&self) -> bool {
        matches!(self.outputs.as_slice(), [Output { shape: Shape::Scalar, .. }])
    }

    /// The name of the argument that a result is written to. An input keeps its name.
    pub(super) fn result_name(&self, output: &Output) -> String {
        let is_taken = self.inputs.iter().any(|input| input.name == output.name);
        if is_taken { format!("{}_result", output.name) } else { output.name.to_owned() }
    }

    /// The prototype without its semicolon.
    pub(super) fn prototype(&self) -> String {
        let Self { name, kind, mode_count, is_local, .. } = self;
        let mut arguments: Vec<String> = self
            .inputs
            .iter()
            .map(|input| format!("const {kind} {}[{}]", input.name, input.size(*mode_count)))
            .collect();
        if !self.returns() {
            arguments.extend(self.outputs.iter().map(|output| match output.shape {
                Shape::Scalar => format!("{kind} *{}", self.result_name(output)),
                shape => format!("{kind} {}[{}]", self.result_name(output), shape.entries(*mode_count)),
            }));
        }
        let result = if self.returns() { kind } else { "void" };
        let result = if *is_local { format!("static {result}") } else { (*result).to_owned() };
        if arguments.is_empty() {
            arguments.push("void".to_owned());
        }
        let short = format!("{result} {name}({})", arguments.join(", "));
        if short.len() <= LONGEST {
            short
        } else {
            format!("{result} {name}(\n    {}\n)", arguments.join(",\n    "))
        }
    }

    /// What it computes, shape, units, source and cost, one line each.
    pub(super) fn documentation(&self, listing: &Listing) -> Vec<String> {
        let mut lines = documentation::of(&listing.signature, self.mode_count);
        if self.outputs.iter().any(|output| output.shape.columns(self.mode_count) > 1) {
            lines.push("Matrices stand column by column.".to_owned());
        }
        lines.push(format!("Cost: {}.", listing.counts));
        lines
    }
}

const LONGEST: usize = 100;
