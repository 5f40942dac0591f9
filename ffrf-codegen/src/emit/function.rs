//! One kernel as a Rust function on arrays.

use std::fmt::Write as _;

use super::expression_text::Text;
use super::names::Names;
use crate::ScalarType;
use crate::counts::OperationCounts;
use crate::expression::{Node, Symbol};
use crate::formulate::{Argument, Kernel, OutputShape};
use crate::layout::Layout;
use crate::passes::use_counts;
use crate::validate::ValidKernel;

/// Longest expression that is printed inside another one.
const LONGEST_INLINE: usize = 60;
/// Width of generated lines.
pub(super) const LINE_WIDTH: usize = 110;

/// What the functions of one body have in common.
#[derive(Debug, Clone, Copy)]
pub(super) struct FunctionStyle<'a> {
    /// Scalar type of all values.
    pub(super) scalar: ScalarType,
    /// Name and layout of the struct, if its fields are inputs of the functions.
    pub(super) parameters: Option<(&'a str, &'a Layout)>,
}

/// Documentation and text of the function, indented by `indent`.
pub(super) fn function(kernel: &ValidKernel, style: FunctionStyle<'_>, indent: &str) -> String {
    let kernel = kernel.kernel();
    let mut lines = Vec::new();
    let mut statements = Statements::new(kernel, style);
    statements.write_all();

    for line in super::documentation::of(kernel.kind, kernel.mode_count) {
        lines.push(format!("/// {line}").trim_end().to_owned());
    }
    lines.push(format!("/// Cost: {}.", OperationCounts::of(kernel)));
    lines.push("#[inline]".to_owned());
    lines.push(signature(kernel, style, &statements.used));
    for (argument, pattern) in statements.patterns() {
        lines.push(format!("    let {pattern} = *{};", argument_name(argument)));
    }
    if statements.has_generic_constants() {
        lines.push("    let constant = support::constant::<T>;".to_owned());
    }
    for section in statements.sections {
        if !section.name.is_empty() {
            lines.push(String::new());
            lines.push(format!("    // {} ({})", section.name, section.counts));
        }
        lines.extend(section.lines.into_iter().map(|line| format!("    {line}")));
    }
    lines.push(String::new());
    lines.extend(statements.results.into_iter().map(|line| format!("    {line}")));
    lines.push("}".to_owned());

    let mut text = String::new();
    for line in lines {
        let line = format!("{indent}{line}");
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text
}

fn argument_name(argument: Argument) -> &'static str {
    match argument {
        Argument::Coordinates => "q",
        Argument::Velocity => "velocity",
        Argument::AngularVelocity => "omega",
        Argument::Rates => "q_dot",
        Argument::Force => "force",
        Argument::Gravity => "gravity",
        Argument::Acceleration => "acceleration",
    }
}

fn shape_type(shape: OutputShape, scalar: ScalarType) -> String {
    let scalar = scalar.type_name();
    match shape {
        OutputShape::Scalar => scalar.to_owned(),
        OutputShape::Vector(size) => format!("[{scalar}; {size}]"),
        OutputShape::Matrix(size) => format!("[[{scalar}; {size}]; {size}]"),
        OutputShape::Columns { rows, columns } => format!("[[{scalar}; {rows}]; {columns}]"),
    }
}

fn signature(kernel: &Kernel, style: FunctionStyle<'_>, used: &[Symbol]) -> String {
    let mut inputs = Vec::new();
    if let Some((name, _)) = style.parameters {
        let unused = if used.iter().any(|symbol| symbol.is_parameter()) { "" } else { "_" };
        inputs.push(format!("{unused}body: &{name}"));
    }
    for argument in kernel.kind.arguments() {
        let size = argument.size(kernel.mode_count);
        let is_used = (0..size).any(|k| used.contains(&argument.symbol(k)));
        let unused = if is_used { "" } else { "_" };
        inputs.push(format!("{unused}{}: &[{}; {size}]", argument_name(*argument), style.scalar.type_name()));
    }
    let outputs = kernel.kind.outputs(kernel.mode_count);
    let types: Vec<_> = outputs.iter().map(|shape| shape_type(*shape, style.scalar)).collect();
    let result = match types.as_slice() {
        [single] => single.clone(),
        several => format!("({})", several.join(", ")),
    };
    let name = format!("{}{}", kernel.kind.name(), style.scalar.generics());
    let line = format!("fn {name}({}) -> {result} {{", inputs.join(", "));
    if line.len() <= LINE_WIDTH - 4 {
        return line;
    }
    format!("fn {name}(\n        {},\n    ) -> {result} {{", inputs.join(",\n        "))
}

/// The statements of one section.
struct Section {
    name: String,
    counts: OperationCounts,
    lines: Vec<String>,
}

/// The body of a function while it is written.
struct Statements<'a> {
    kernel: &'a Kernel,
    style: FunctionStyle<'a>,
    uses: Vec<usize>,
    names: Names,
    texts: Vec<Option<Text>>,
    used: Vec<Symbol>,
    sections: Vec<Section>,
    results: Vec<String>,
}

impl<'a> Statements<'a> {
    fn new(kernel: &'a Kernel, style: FunctionStyle<'a>) -> Self {
        let uses = use_counts(kernel);
        Self {
            kernel,
            style,
            names: Names::new(kernel, &uses),
            texts: vec![None; uses.len()],
            uses,
            used: Vec::new(),
            sections: Vec::new(),
            results: Vec::new(),
        }
    }

    fn write_all(&mut self) {
        let graph = &self.kernel.graph;
        for (handle, node) in graph.nodes().take(self.uses.len()) {
            let uses = self.uses[handle.index()];
            if uses == 0 {
                continue;
            }
            let text = match node {
                Node::Symbol(symbol) => {
                    self.used.push(symbol);
                    let place =
                        super::parameters::place(symbol, self.style.parameters.map(|(_, layout)| layout));
                    match self.style.scalar {
                        ScalarType::Generic if symbol.is_parameter() => {
                            Text::atom(format!("constant({place})"))
                        }
                        _ => Text::atom(place),
                    }
                }
                _ => {
                    let operands: Vec<Text> =
                        node.operands().filter_map(|operand| self.texts[operand.index()].clone()).collect();
                    Text::of(node, &operands, self.style.scalar)
                }
            };
            self.texts[handle.index()] = Some(if node.is_operation() {
                let section = self.section(graph.section_of(handle));
                section.counts.add(node);
                let named = graph.label_of(handle).is_some();
                if uses > 1 || named || text.text.len() > LONGEST_INLINE {
                    let name = self.names.of(handle);
                    let section = self.section(graph.section_of(handle));
                    section.lines.push(format!("let {name} = {};", text.text));
                    Text::atom(name)
                } else {
                    text
                }
            } else {
                text
            });
        }
        self.write_results();
    }

    fn section(&mut self, name: &str) -> &mut Section {
        let position = self.sections.iter().position(|section| section.name == name);
        let position = position.unwrap_or_else(|| {
            let counts = OperationCounts::default();
            self.sections.push(Section { name: name.to_owned(), counts, lines: Vec::new() });
            self.sections.len() - 1
        });
        &mut self.sections[position]
    }

    /// Whether constants are turned into values of a generic type.
    fn has_generic_constants(&self) -> bool {
        let lines = self.sections.iter().flat_map(|section| &section.lines).chain(&self.results);
        self.style.scalar == ScalarType::Generic && lines.into_iter().any(|line| line.contains("constant("))
    }

    /// One destructuring pattern per argument that is used.
    fn patterns(&self) -> Vec<(Argument, String)> {
        let mut patterns = Vec::new();
        for argument in self.kernel.kind.arguments() {
            let size = argument.size(self.kernel.mode_count);
            let symbols: Vec<Symbol> = (0..size).map(|k| argument.symbol(k)).collect();
            if symbols.iter().any(|symbol| self.used.contains(symbol)) {
                let entries: Vec<String> = symbols
                    .iter()
                    .map(|symbol| match self.used.contains(symbol) {
                        true => symbol.to_string(),
                        false => "_".to_owned(),
                    })
                    .collect();
                patterns.push((*argument, format!("[{}]", entries.join(", "))));
            }
        }
        patterns
    }

    fn write_results(&mut self) {
        let entries: Vec<String> = self
            .kernel
            .outputs
            .iter()
            .map(|output| match &self.texts[output.index()] {
                Some(text) => text.text.clone(),
                None => String::new(),
            })
            .collect();
        let mut rest = entries.as_slice();
        let shapes = self.kernel.kind.outputs(self.kernel.mode_count);
        let (open, close) = if shapes.len() == 1 { ("", "") } else { ("(", ")") };
        let mut lines: Vec<String> = Vec::new();
        for shape in &shapes {
            let (these, later) = rest.split_at(shape.entries());
            rest = later;
            let mut block = match shape {
                OutputShape::Scalar => vec![these.concat()],
                OutputShape::Vector(_) => bracketed(these, ""),
                OutputShape::Matrix(size) | OutputShape::Columns { rows: size, .. } => {
                    let mut rows = vec!["[".to_owned()];
                    for column in these.chunks((*size).max(1)) {
                        let mut column = bracketed(column, "    ");
                        if let Some(last) = column.last_mut() {
                            last.push(',');
                        }
                        rows.extend(column);
                    }
                    rows.push("]".to_owned());
                    rows
                }
            };
            if shapes.len() > 1 {
                block.iter_mut().for_each(|line| line.insert_str(0, "    "));
                if let Some(last) = block.last_mut() {
                    last.push(',');
                }
            }
            lines.extend(block);
        }
        if !open.is_empty() {
            lines.insert(0, open.to_owned());
            lines.push(close.to_owned());
        }
        self.results = lines;
    }
}

/// `[a, b, c]` on one line if it fits, else several entries a line.
pub(super) fn bracketed(entries: &[String], indent: &str) -> Vec<String> {
    let single = format!("{indent}[{}]", entries.join(", "));
    if single.len() <= LINE_WIDTH - 16 {
        return vec![single];
    }
    let mut lines = vec![format!("{indent}[")];
    let mut line = String::new();
    for entry in entries {
        if !line.is_empty() && line.len() + entry.len() + 2 > LINE_WIDTH - 20 {
            lines.push(format!("{indent}    {}", line.trim_end()));
            line.clear();
        }
        let _ = write!(line, "{entry}, ");
    }
    if !line.is_empty() {
        lines.push(format!("{indent}    {}", line.trim_end()));
    }
    lines.push(format!("{indent}]"));
    lines
}
