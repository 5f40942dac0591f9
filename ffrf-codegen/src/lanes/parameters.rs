//! Loops over lanes for bodies whose invariants come at run time: tables made from the fields in every call.

use super::choice::in_lanes;
use super::kernels_text::{Form, KernelText};
use crate::fidelity::{EnergyTerm, Fidelity};
use crate::formulate::KernelKind;
use crate::layout::{Layout, Structure};
use crate::{CodegenError, GenerateOptions};

/// A body in lanes whose invariants are fields.
#[derive(Debug, Clone)]
pub(crate) struct LaneParameters {
    modes: usize,
    layout: Layout,
    fidelity: Fidelity,
}

/// The body in lanes if that is to be its form, `None` for statements.
///
/// Errors: lanes were demanded where they cannot be had.
pub(crate) fn choose_parameters(
    modes: usize,
    layout: &Layout,
    options: &GenerateOptions,
) -> Result<Option<LaneParameters>, CodegenError> {
    let is_diagonal = matches!(layout.modal_mass, Structure::Identity | Structure::Diagonal);
    let obstacle =
        (!is_diagonal).then_some("they need a modal mass that the layout declares identity or diagonal");
    let lanes = LaneParameters { modes, layout: *layout, fidelity: options.fidelity.clone() };
    Ok(in_lanes(modes, obstacle, options)?.then_some(lanes))
}

impl LaneParameters {
    /// The strategy in words, for the banner.
    pub(crate) fn description(&self) -> String {
        format!("lanes over modes, {} groups of 4; moments read from the fields", self.groups())
    }

    fn groups(&self) -> usize {
        self.modes.div_ceil(4)
    }

    /// The functions, with the documentation that `document` gives for each.
    pub(crate) fn functions(
        &self,
        options: &GenerateOptions,
        document: impl Fn(KernelKind) -> Vec<String>,
    ) -> String {
        let (modes, scalar) = (self.modes, options.scalar);
        let form = Form::of(scalar);
        let (q, q_dot) = (form.input("q"), form.input("q_dot"));
        let zeros = |count: usize| match form {
            Form::Plain => format!("[0.0; {count}]"),
            Form::Wrapped => format!("support::lanes::reals::<T, {count}>(&[{}; {count}])", form.zero()),
        };
        let evaluation =
            |omega: &str, q_dot: &str| format!("        let state = lanes.state({q}, {omega}, {q_dot});\n");
        let net_force = if self.has_internal() {
            form.input("force")
        } else {
            form.net_force("&internal_force(body, q, q_dot)")
        };
        let kernels = KernelText {
            modes,
            scalar,
            parameters: format!("body: &{},\n        ", options.name),
            preparation: "        let tables = tables(body);\n        let lanes = tables.body(moments(body));\n",
            loops: "lanes",
            state: evaluation(&form.value("omega"), q_dot.as_str()),
            state_at_rest: evaluation(&zeros(3), &format!("&{}", zeros(modes))),
            net_force,
        };
        format!("{}{}", self.tables(options), kernels.functions(document))
    }

    /// Whether the loops know K_ff and D_ff.
    fn has_internal(&self) -> bool {
        let is_diagonal = |structure| structure != Structure::Symmetric;
        is_diagonal(self.layout.stiffness) && is_diagonal(self.layout.damping)
    }

    /// The functions that make tables and moments from the fields.
    fn tables(&self, options: &GenerateOptions) -> String {
        let (layout, fidelity, modes) = (&self.layout, &self.fidelity, self.modes);
        let constant = options.scalar.constant_type_name();
        let some = |is_kept: bool, value: &str| match is_kept {
            true => format!("::core::option::Option::Some({value})"),
            false => "::core::option::Option::None".to_owned(),
        };
        let structure = |structure: Structure| match structure {
            Structure::Diagonal => "Diagonal3",
            Structure::Symmetric => "Symmetric",
            Structure::Antisymmetric => "Antisymmetric",
            _ => "Dense",
        };
        let components = |kind: Structure| {
            let kind = structure(kind);
            format!("<support::lanes::{kind} as support::lanes::MomentStructure<{constant}>>::components")
        };
        let diagonal = |kind: Structure, field: &str| match kind {
            Structure::Zero => "support::lanes::ParameterDiagonal::Zero".to_owned(),
            Structure::Identity => "support::lanes::ParameterDiagonal::Identity".to_owned(),
            _ => format!("support::lanes::ParameterDiagonal::Entries({field})"),
        };
        // Off-diagonal stiffness or damping: the whole of both is taken from the force before the loops.
        let internal = |kind: Structure, field: &str| {
            diagonal(if self.has_internal() { kind } else { Structure::Zero }, field)
        };
        let moments = layout.mode_mode_moment;
        let even = fidelity.keeps(EnergyTerm::RotationQuadratic)
            && !matches!(moments, Structure::Zero | Structure::Antisymmetric);
        let odd = fidelity.keeps(EnergyTerm::ModalRotationDeformed)
            && matches!(moments, Structure::Dense | Structure::Antisymmetric);
        let position = layout.position_mode_moment;
        let position_even = fidelity.keeps(EnergyTerm::RotationLinear)
            && !matches!(position, Structure::Zero | Structure::Antisymmetric);
        let position_odd = fidelity.keeps(EnergyTerm::ModalRotation)
            && matches!(position, Structure::Dense | Structure::Antisymmetric);
        let of = |kind: Structure| {
            format!(
                "support::lanes::ParameterMoments<'_, {constant}, support::lanes::{}, {modes}, {even}, {odd}>",
                structure(kind)
            )
        };
        let all = "support::lanes::ParameterMoments::new(&body.mode_mode_moment)";
        let (moments_type, moments_value) = match even || odd {
            true => (of(moments), all.to_owned()),
            false => ("()".to_owned(), "()".to_owned()),
        };
        let modal_mass = match layout.has_own_modal_mass() {
            true => diagonal(layout.modal_mass, "body.modal_mass"),
            false => {
                let kind = structure(moments);
                let traces = format!(
                    "support::lanes::traces::<{constant}, support::lanes::{kind}, {modes}>(&body.mode_mode_moment)"
                );
                diagonal(layout.modal_mass, &traces)
            }
        };
        let position_mode = match position_even || position_odd {
            true => format!("body.position_mode_moment.map(|moment| {}(&moment))", components(position)),
            false => "()".to_owned(),
        };
        format!(
            "    /// The invariants in lanes, from the fields.
    #[inline(always)]
    fn tables(body: &{name}) -> support::lanes::ParameterTables<{constant}, {modes}, {groups}> {{
        let position_mode = {position_mode};
        support::lanes::Parameters {{
            mass: body.mass,
            first_moment: {first_moment},
            modal_first_moment: {modal_first_moment},
            second_moment: {second_moment}(&body.second_moment),
            position_mode_even: {position_even},
            position_mode_odd: {position_odd},
            modal_mass: {modal_mass},
            has_trace: {has_trace},
            stiffness: {stiffness},
            damping: {damping},
        }}
        .tables()
    }}

    /// The moments T_μν where they are.
    #[inline(always)]
    fn moments(body: &{name}) -> {moments_type} {{
        {moments_value}
    }}
",
            name = options.name,
            groups = self.groups(),
            first_moment = some(
                fidelity.keeps(EnergyTerm::FirstMoment) && layout.first_moment != Structure::Zero,
                "body.first_moment"
            ),
            modal_first_moment = some(
                fidelity.keeps(EnergyTerm::ModalMomentum) && layout.modal_first_moment != Structure::Zero,
                "body.modal_first_moment"
            ),
            second_moment = components(layout.second_moment),
            position_even = some(position_even, "position_mode"),
            position_odd = some(position_odd, "position_mode"),
            has_trace = fidelity.keeps(EnergyTerm::RotationQuadratic),
            stiffness = internal(layout.stiffness, "body.stiffness"),
            damping = internal(layout.damping, "body.damping"),
        )
    }
}
