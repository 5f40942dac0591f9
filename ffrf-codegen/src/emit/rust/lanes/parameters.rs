//! Tables made from the fields of a body whose invariants come at run time, in every call.

use super::form::Form;
use super::kernels::Loops;
use crate::GenerateOptions;
use crate::emit::writer::Writer;
use crate::formulate::kernels::INTERNAL_FORCE;
use crate::invariants::{Invariant, Structure};
use crate::lanes::LaneParameters;

/// How the kernels are written over fields.
pub(super) fn loops(lanes: &LaneParameters, options: &GenerateOptions) -> Loops {
    let (modes, scalar) = (lanes.modes, options.scalar);
    let form = Form::of(scalar);
    let (q, q_dot) = (form.input("q"), form.input("q_dot"));
    let zeros = |count: usize| match form {
        Form::Plain => format!("[0.0; {count}]"),
        Form::Wrapped => format!("support::lanes::reals::<T, {count}>(&[{}; {count}])", form.zero()),
    };
    let evaluation = |omega: &str, q_dot: &str| format!("let state = lanes.state({q}, {omega}, {q_dot});");
    let net_force = if lanes.has_internal() {
        form.input("force")
    } else {
        form.net_force(&format!("&{}(body, q, q_dot)", INTERNAL_FORCE.signature.name))
    };
    let on = if form.finds_registers() { "\nlet lanes = lanes.on(registers);" } else { "" };
    Loops {
        modes,
        scalar,
        body: Some(options.name.clone()),
        preparation: vec![
            "let tables = tables(body);".to_owned(),
            format!("let lanes = tables.body(moments(body));{on}"),
        ],
        receiver: "lanes",
        state: evaluation(&form.value("omega"), q_dot.as_str()),
        state_at_rest: evaluation(&zeros(3), &format!("&{}", zeros(modes))),
        net_force,
    }
}

/// Writes the functions that make tables and moments from the fields.
pub(super) fn functions(writer: &mut Writer, lanes: &LaneParameters, options: &GenerateOptions) {
    let (name, constant) = (&options.name, options.scalar.constant_type_name());
    let (modes, groups) = (lanes.modes, lanes.groups());
    let some = |invariant: Invariant, value: &str| match lanes.keeps(invariant) {
        true => format!("::core::option::Option::Some({value})"),
        false => "::core::option::Option::None".to_owned(),
    };
    let field = |invariant: Invariant| format!("body.{}", invariant.name());
    let components = |invariant: Invariant| {
        let kind = structure(lanes.layout[invariant]);
        format!("<support::lanes::{kind} as support::lanes::MomentStructure<{constant}>>::components")
    };
    // Off-diagonal stiffness or damping: the whole of both is taken from the force before the loops.
    let internal = |invariant: Invariant| {
        let kind = if lanes.has_internal() { lanes.layout[invariant] } else { Structure::Zero };
        diagonal(kind, &field(invariant))
    };
    let (position_even, position_odd) = lanes.position_parts();
    let position = |is_kept: bool| match is_kept {
        true => "::core::option::Option::Some(position_mode)",
        false => "::core::option::Option::None",
    };
    let position_mode = match position_even || position_odd {
        true => format!(
            "{}.map(|moment| {}(&moment))",
            field(Invariant::PositionModeMoment),
            components(Invariant::PositionModeMoment)
        ),
        false => "()".to_owned(),
    };
    let moments_field = field(Invariant::ModeModeMoment);
    let moments = structure(lanes.layout[Invariant::ModeModeMoment]);
    let own_modal_mass = lanes.layout.is_data(Invariant::ModalMass);
    let modal_mass = match own_modal_mass {
        true => field(Invariant::ModalMass),
        false => format!(
            "support::lanes::traces::<{constant}, support::lanes::{moments}, {modes}>(&{moments_field})"
        ),
    };
    writer.documentation(["The invariants in lanes, from the fields."]);
    writer.line("#[inline(always)]");
    let result = format!("support::lanes::ParameterTables<{constant}, {modes}, {groups}>");
    writer.block(&format!("fn tables(body: &{name}) -> {result} {{"), "}", |writer| {
        writer.line(format!("let position_mode = {position_mode};"));
        writer.block("support::lanes::Parameters {", "}", |writer| {
            let second_moment = Invariant::SecondMoment;
            for (name, value) in [
                ("mass", field(Invariant::Mass)),
                ("first_moment", some(Invariant::FirstMoment, &field(Invariant::FirstMoment))),
                (
                    "modal_first_moment",
                    some(Invariant::ModalFirstMoment, &field(Invariant::ModalFirstMoment)),
                ),
                ("second_moment", format!("{}(&{})", components(second_moment), field(second_moment))),
                ("position_mode_even", position(position_even).to_owned()),
                ("position_mode_odd", position(position_odd).to_owned()),
                ("modal_mass", diagonal(lanes.layout[Invariant::ModalMass], &modal_mass)),
                ("has_trace", lanes.has_trace().to_string()),
                ("stiffness", internal(Invariant::Stiffness)),
                ("damping", internal(Invariant::Damping)),
            ] {
                writer.line(format!("{name}: {value},"));
            }
        });
        writer.line(".tables()");
    });
    writer.blank();
    let (even, odd) = lanes.moment_parts();
    let (kind, value) = match even || odd {
        true => (
            format!(
                "support::lanes::ParameterMoments<'_, {constant}, support::lanes::{moments}, {modes}, {even}, {odd}>"
            ),
            format!("support::lanes::ParameterMoments::new(&{moments_field})"),
        ),
        false => ("()".to_owned(), "()".to_owned()),
    };
    writer.documentation(["The moments T_μν where they are."]);
    writer.line("#[inline(always)]");
    writer.block(&format!("fn moments(body: &{name}) -> {kind} {{"), "}", |writer| writer.line(value));
}

/// The marker type of the runtime for a list of moments.
fn structure(structure: Structure) -> &'static str {
    match structure {
        Structure::Diagonal => "Diagonal3",
        Structure::Symmetric => "Symmetric",
        Structure::Antisymmetric => "Antisymmetric",
        Structure::Zero | Structure::Identity | Structure::Dense => "Dense",
    }
}

fn diagonal(kind: Structure, field: &str) -> String {
    match kind {
        Structure::Zero => "support::lanes::ParameterDiagonal::Zero".to_owned(),
        Structure::Identity => "support::lanes::ParameterDiagonal::Identity".to_owned(),
        _ => format!("support::lanes::ParameterDiagonal::Entries({field})"),
    }
}
