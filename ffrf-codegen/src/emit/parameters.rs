//! How inputs are written: entries of the state by their names, invariants as fields of the body.

use crate::expression::Symbol;

/// The Rust expression of an input.
pub(super) fn place(symbol: Symbol) -> String {
    match symbol {
        Symbol::Mass => "body.mass".to_owned(),
        Symbol::FirstMoment(i) => format!("body.first_moment[{i}]"),
        Symbol::ModalFirstMoment(mu, i) => format!("body.modal_first_moment[{mu}][{i}]"),
        Symbol::SecondMoment(i, j) => format!("body.second_moment[{i}][{j}]"),
        Symbol::PositionModeMoment(mu, i, j) => {
            format!("body.position_mode_moment[{mu}][{i}][{j}]")
        }
        Symbol::ModeModeMoment(mu, nu, i, j) => {
            format!("body.mode_mode_moment[{mu}][{nu}][{i}][{j}]")
        }
        Symbol::ModalMass(mu, nu) => format!("body.modal_mass[{mu}][{nu}]"),
        Symbol::Stiffness(mu, nu) => format!("body.stiffness[{mu}][{nu}]"),
        Symbol::Damping(mu, nu) => format!("body.damping[{mu}][{nu}]"),
        state => state.to_string(),
    }
}
