//! The state of constant tables: one function that the kernels share.

use super::form::Form;
use super::kernels::Loops;
use crate::ScalarType;
use crate::emit::rust::found_registers::on_registers;
use crate::emit::rust::function::argument;
use crate::emit::rust::in_place;
use crate::emit::rust::method::Types;
use crate::emit::writer::{FunctionHead, Writer};
use crate::expression::Input;
use crate::formulate::kernels::EQUATIONS_OF_MOTION;
use crate::lanes::LaneTables;

/// Up to this number of modes, the common part of the kernels is inlined into each of them.
const LARGEST_INLINE: usize = 16;

/// Writes the function that computes the state.
pub(super) fn function(writer: &mut Writer, tables: &LaneTables, scalar: ScalarType) {
    let (modes, groups, form) = (tables.modes, tables.groups, Form::of(scalar));
    let state = format!("support::lanes::State<{}, {groups}>", form.register_scalar(scalar.type_name()));
    let arguments = [form.input("q"), form.value("omega"), form.input("q_dot")].join(", ");
    let mut inputs: Vec<String> = [Input::COORDINATES, Input::ANGULAR_VELOCITY, Input::RATES]
        .map(|input| argument(input, modes, scalar))
        .into();
    // Few modes: one function is fastest. Many: what all kernels share is kept once, and the state is not moved.
    let is_apart = modes > LARGEST_INLINE;
    let receiver = receiver(form);
    let (inline, name, generics, result, body) = if is_apart {
        inputs.push(format!("state: &mut {state}"));
        (
            "never",
            "write_state",
            scalar.generics().to_owned(),
            String::new(),
            format!("{receiver}.write_state({arguments}, state)"),
        )
    } else {
        inputs = form.registers().chain(inputs).collect();
        ("always", "state", form.generics(scalar), state, format!("{receiver}.state({arguments})"))
    };
    writer.documentation([
        "What follows from a state before forces are known: deformed invariants and quadratic velocity vector.",
    ]);
    writer.line(format!("#[inline({inline})]"));
    let name = format!("{name}{generics}");
    let head = FunctionHead { name: &name, inputs: &inputs, result: &result, may_be_short: false };
    writer.function(&head, |writer| {
        on_registers(writer, is_apart && form.finds_registers(), |writer| writer.line(body));
    });
}

/// How the kernels are written over constant tables.
pub(super) fn loops(tables: &LaneTables, scalar: ScalarType) -> Loops {
    let (modes, form) = (tables.modes, Form::of(scalar));
    let zero = form.zero();
    Loops {
        modes,
        scalar,
        body: None,
        preparation: Vec::new(),
        receiver: receiver(form),
        state: evaluation(modes, form, "omega", "q_dot"),
        state_at_rest: evaluation(modes, form, &format!("&[{zero}; 3]"), &format!("&[{zero}; {modes}]")),
        net_force: form.input("force"),
    }
}

/// What the loops are methods of.
fn receiver(form: Form) -> &'static str {
    if form.finds_registers() { "BODY.on(registers)" } else { "BODY" }
}

/// The statements that make the variable `state`.
fn evaluation(modes: usize, form: Form, omega: &str, q_dot: &str) -> String {
    if modes <= LARGEST_INLINE {
        let registers = if form.finds_registers() { "registers, " } else { "" };
        format!("let state = state({registers}q, {omega}, {q_dot});")
    } else {
        format!(
            "let mut state = support::lanes::State::zero();\nwrite_state(q, {omega}, {q_dot}, &mut state);"
        )
    }
}

/// Writes the method of the trait that writes its results in place.
pub(super) fn trait_method(writer: &mut Writer, types: &Types, tables: &LaneTables) {
    let signature = &EQUATIONS_OF_MOTION.signature;
    in_place::method(writer, types, EQUATIONS_OF_MOTION.interface, signature, |writer| {
        writer.line("let (q, q_dot) = (support::array(q), support::array(q_dot));");
        writer.line("let force = support::array(force);");
        let state = evaluation(tables.modes, Form::Plain, "support::array(omega)", "q_dot");
        let is_apart = tables.modes > LARGEST_INLINE;
        if is_apart {
            writer.line(&state);
        }
        on_registers(writer, true, |writer| {
            if !is_apart {
                writer.line(&state);
            }
            let inputs = ["&state", "q", "q_dot", "force"].map(str::to_owned).into_iter();
            let method = format!("{}.write_equations_of_motion", receiver(Form::Plain));
            in_place::call(writer, &method, inputs.chain(in_place::places(signature)));
        });
    });
}
