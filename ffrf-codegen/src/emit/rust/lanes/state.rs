//! The state of constant tables: one function that the kernels share.

use super::form::Form;
use super::kernels::Loops;
use crate::ScalarType;
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
    let (inline, name, result, body) = if modes <= LARGEST_INLINE {
        ("always", "state", state, format!("BODY.state({arguments})"))
    } else {
        inputs.push(format!("state: &mut {state}"));
        ("never", "write_state", String::new(), format!("BODY.write_state({arguments}, state);"))
    };
    writer.documentation([
        "What follows from a state before forces are known: deformed invariants and quadratic velocity vector.",
    ]);
    writer.line(format!("#[inline({inline})]"));
    let name = format!("{name}{}", scalar.generics());
    let head = FunctionHead { name: &name, inputs: &inputs, result: &result, may_be_short: false };
    writer.function(&head, |writer| writer.line(body));
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
        receiver: "BODY",
        state: evaluation(modes, "omega", "q_dot"),
        state_at_rest: evaluation(modes, &format!("&[{zero}; 3]"), &format!("&[{zero}; {modes}]")),
        net_force: form.input("force"),
    }
}

/// The statements that make the variable `state`.
fn evaluation(modes: usize, omega: &str, q_dot: &str) -> String {
    if modes <= LARGEST_INLINE {
        format!("let state = state(q, {omega}, {q_dot});")
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
        writer.line(evaluation(tables.modes, "support::array(omega)", "q_dot"));
        let inputs = ["&state", "q", "q_dot", "force"].map(str::to_owned).into_iter();
        in_place::call(writer, "BODY.write_equations_of_motion", inputs.chain(in_place::places(signature)));
    });
}
