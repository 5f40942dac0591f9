//! Invariants that come at run time: the fields of the struct, and how functions read them.

use std::fmt::Write as _;

use super::structure::{is_documentation, visibility};
use crate::GenerateOptions;
use crate::expression::Symbol;
use crate::layout::{Layout, Structure};

/// The Rust expression of an input: a name for the state, a field of the body for an invariant.
pub(super) fn place(symbol: Symbol, layout: Option<&Layout>) -> String {
    let Some(layout) = layout else { return symbol.to_string() };
    let modal = |name: &str, structure: Structure, mu: usize, nu: usize| match structure {
        Structure::Diagonal => format!("body.{name}[{mu}]"),
        _ => format!("body.{name}[{mu}][{nu}]"),
    };
    let moment = |list: String, structure: Structure, i: usize, j: usize| match structure {
        Structure::Diagonal => format!("body.{list}[{i}]"),
        _ => format!("body.{list}[{i}][{j}]"),
    };
    match symbol {
        Symbol::Mass => "body.mass".to_owned(),
        Symbol::FirstMoment(i) => format!("body.first_moment[{i}]"),
        Symbol::ModalFirstMoment(mu, i) => format!("body.modal_first_moment[{mu}][{i}]"),
        Symbol::SecondMoment(i, j) => moment("second_moment".to_owned(), layout.second_moment, i, j),
        Symbol::PositionModeMoment(mu, i, j) => {
            moment(format!("position_mode_moment[{mu}]"), layout.position_mode_moment, i, j)
        }
        Symbol::ModeModeMoment(mu, nu, i, j) => {
            moment(format!("mode_mode_moment[{mu}][{nu}]"), layout.mode_mode_moment, i, j)
        }
        Symbol::ModalMass(mu, nu) => modal("modal_mass", layout.modal_mass, mu, nu),
        Symbol::Stiffness(mu, nu) => modal("stiffness", layout.stiffness, mu, nu),
        Symbol::Damping(mu, nu) => modal("damping", layout.damping, mu, nu),
        state => state.to_string(),
    }
}

/// The struct with one field for each invariant that the layout leaves open.
pub(super) fn parameter_struct(mode_count: usize, layout: &Layout, options: &GenerateOptions) -> String {
    let mut text = String::new();
    for attribute in &options.attributes {
        let _ = writeln!(text, "{attribute}");
    }
    if !options.attributes.iter().any(|attribute| is_documentation(attribute)) {
        let _ = writeln!(
            text,
            "/// Flexible body with {mode_count} modes; its invariants are supplied at run time: call [`Self::check`] once \
             they are."
        );
    }
    let visibility = visibility(options);
    let _ = writeln!(text, "#[derive(Debug, Clone, Copy, PartialEq)]");
    let _ = writeln!(text, "{visibility}struct {} {{", options.name);
    for (name, shape, documentation) in fields(mode_count, layout, options.scalar.constant_type_name()) {
        let _ = writeln!(text, "    /// {documentation}");
        let _ = writeln!(text, "    pub {name}: {shape},");
    }
    text.push_str("}\n");
    text
}

/// Name, type and documentation of each field.
pub(super) fn fields(m: usize, layout: &Layout, scalar: &str) -> Vec<(&'static str, String, String)> {
    let tensor = |structure: Structure| match structure {
        Structure::Diagonal => format!("[{scalar}; 3]"),
        _ => format!("[[{scalar}; 3]; 3]"),
    };
    let modal = |structure: Structure| match structure {
        Structure::Zero | Structure::Identity => None,
        Structure::Diagonal => Some(format!("[{scalar}; {m}]")),
        _ => Some(format!("[[{scalar}; {m}]; {m}]")),
    };
    let read = |structure: Structure| match structure {
        Structure::Diagonal => " Its diagonal.",
        Structure::Symmetric => " Symmetric: the upper triangle is read, the lower one must mirror it.",
        Structure::Antisymmetric => {
            " Antisymmetric: the upper triangle is read, the lower one must be its negative."
        }
        _ => "",
    };
    let mut fields = vec![("mass", scalar.to_owned(), "Mass m. Units: kg.".to_owned())];
    let mut add = |name: &'static str, shape: Option<String>, documentation: String| {
        fields.extend(shape.map(|shape| (name, shape, documentation)));
    };
    let open = |structure: Structure, shape: String| (structure != Structure::Zero).then_some(shape);
    add(
        "first_moment",
        open(layout.first_moment, format!("[{scalar}; 3]")),
        "First moment m a. Shape: 3. Units: kg m. Frame: body.".to_owned(),
    );
    add(
        "modal_first_moment",
        open(layout.modal_first_moment, format!("[[{scalar}; 3]; {m}]")),
        format!("Modal first moments m b_μ. Shape: {m} x 3. Frame: body."),
    );
    add(
        "second_moment",
        Some(tensor(layout.second_moment)),
        format!("Second moment (Euler tensor) T. Units: kg m². Frame: body.{}", read(layout.second_moment)),
    );
    let list = tensor(layout.position_mode_moment);
    add(
        "position_mode_moment",
        open(layout.position_mode_moment, format!("[{list}; {m}]")),
        format!("Position-mode moments T_μ. Frame: body.{}", read(layout.position_mode_moment)),
    );
    let list = tensor(layout.mode_mode_moment);
    add(
        "mode_mode_moment",
        open(layout.mode_mode_moment, format!("[[{list}; {m}]; {m}]")),
        format!(
            "Mode-mode moments T_μν, read where μ <= ν; T_νμ must be T_μνᵀ. Frame: body.{}",
            read(layout.mode_mode_moment)
        ),
    );
    if layout.has_own_modal_mass() {
        add("modal_mass", modal(layout.modal_mass), format!("Modal mass Θ_ff.{}", read(layout.modal_mass)));
    }
    add("stiffness", modal(layout.stiffness), format!("Modal stiffness K_ff.{}", read(layout.stiffness)));
    add("damping", modal(layout.damping), format!("Modal damping D_ff.{}", read(layout.damping)));
    fields
}
