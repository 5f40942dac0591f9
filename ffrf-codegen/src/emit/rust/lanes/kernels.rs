//! The kernels over lanes as functions, whatever the loops get their invariants from.

use super::form::Form;
use crate::ScalarType;
use crate::emit::documentation;
use crate::emit::rust::function::{argument, result_type};
use crate::emit::writer::{FunctionHead, Writer};
use crate::expression::Input;
use crate::formulate::{Definition, KERNELS, Loop};

/// What the functions of one body have in common.
pub(super) struct Loops {
    pub(super) modes: usize,
    pub(super) scalar: ScalarType,
    /// The type of the argument `body`, if there is one.
    pub(super) body: Option<String>,
    /// Statements at the start of every function.
    pub(super) preparation: Vec<String>,
    /// What the loops are methods of.
    pub(super) receiver: &'static str,
    /// Statements that make a variable `state` of q, omega and q_dot.
    pub(super) state: String,
    /// The same of q, at rest.
    pub(super) state_at_rest: String,
    /// The force less what the loops do not know, a reference.
    pub(super) net_force: String,
}

/// Writes every kernel that loops compute.
pub(super) fn functions(writer: &mut Writer, loops: &Loops) {
    for definition in KERNELS {
        if let Some(run) = definition.lanes {
            writer.blank();
            function(writer, loops, definition, run);
        }
    }
}

fn function(writer: &mut Writer, loops: &Loops, definition: &Definition, run: Loop) {
    let (signature, modes, scalar) = (&definition.signature, loops.modes, loops.scalar);
    let form = Form::of(scalar);
    writer.documentation(documentation::of(signature, modes));
    // What runs in registers that are found when running must be part of the code that is compiled for them.
    writer.line(if form.finds_registers() { "#[inline(always)]" } else { "#[inline]" });
    let body = loops.body.iter().map(|name| format!("body: &{name}"));
    let inputs = signature.inputs.iter().map(|input| argument(*input, modes, scalar));
    let head = FunctionHead {
        name: &format!("{}{}", signature.name, form.generics(scalar)),
        inputs: &form.registers().chain(body).chain(inputs).collect::<Vec<_>>(),
        result: &result_type(signature, modes, scalar),
        may_be_short: false,
    };
    let arguments = run.inputs.iter().map(|input| match *input {
        Input::FORCE => format!(", {}", loops.net_force),
        input => format!(", {}", form.input(input.name)),
    });
    let call = format!("{}.{}(&state{})", loops.receiver, signature.name, arguments.collect::<String>());
    let rest = run.rest.map(|rest| {
        let body = loops.body.iter().map(|_| "body");
        let inputs = body.chain(rest.signature.inputs.iter().map(|input| input.name));
        format!("{}({})", rest.signature.name, inputs.collect::<Vec<_>>().join(", "))
    });
    let moves = signature.inputs.contains(&Input::ANGULAR_VELOCITY);
    let state = if moves { &loops.state } else { &loops.state_at_rest };
    writer.function(&head, |writer| {
        for statement in &loops.preparation {
            writer.line(statement);
        }
        writer.line(state);
        form.result(writer, signature.outputs, &call, rest.as_deref());
    });
}
