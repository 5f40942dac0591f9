//! Kernels over lanes: tables as static items, or made from fields, and functions that call the runtime's loops.

mod form;
mod kernels;
mod parameters;
mod state;
mod tables;

use self::form::Form;
use super::method::Types;
use crate::emit::writer::Writer;
use crate::lanes::Lanes;
use crate::{GenerateOptions, ScalarType};

/// Whether the functions of the loops compute in `registers`, their first argument.
pub(super) fn takes_registers(lanes: Option<&Lanes>, scalar: ScalarType) -> bool {
    lanes.is_some() && Form::of(scalar).finds_registers()
}

/// The items that the loops read and the functions that run them.
pub(super) fn functions(writer: &mut Writer, lanes: &Lanes, options: &GenerateOptions) {
    match lanes {
        Lanes::Tables(tables) => {
            tables::statics(writer, tables, options.scalar);
            writer.blank();
            state::function(writer, tables, options.scalar);
            kernels::functions(writer, &state::loops(tables, options.scalar));
        }
        Lanes::Parameters(fields) => {
            parameters::functions(writer, fields, options);
            kernels::functions(writer, &parameters::loops(fields, options));
        }
    }
}

/// The method of the trait that writes its results in place; a generic body has none, as its results are moved anyway.
pub(super) fn trait_method(writer: &mut Writer, types: &Types, lanes: &Lanes, scalar: ScalarType) {
    match lanes {
        Lanes::Tables(tables) if scalar != ScalarType::Generic => {
            writer.blank();
            state::trait_method(writer, types, tables);
        }
        _ => {}
    }
}
