//! How values get into the loops and out of them.

use crate::ScalarType;
use crate::formulate::{Shape, Signature};

/// The scalars of the loops, against those of the functions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// They are the same.
    Plain,
    /// Any number type is wrapped on its way in and unwrapped on its way out.
    Wrapped,
}

impl Form {
    pub(super) fn of(scalar: ScalarType) -> Self {
        if scalar == ScalarType::Generic { Self::Wrapped } else { Self::Plain }
    }

    /// The scalar type of the loops.
    pub(super) fn register_scalar(self, name: &str) -> String {
        match self {
            Self::Plain => name.to_owned(),
            Self::Wrapped => format!("support::lanes::Real<{name}>"),
        }
    }

    /// A reference to an array, as an argument of the loops.
    pub(super) fn input(self, reference: &str) -> String {
        match self {
            Self::Plain => reference.to_owned(),
            Self::Wrapped => format!("&support::lanes::reals({reference})"),
        }
    }

    /// What a reference to an array points to, as an argument of the loops.
    pub(super) fn value(self, reference: &str) -> String {
        match self {
            Self::Plain => format!("*{reference}"),
            Self::Wrapped => format!("support::lanes::reals({reference})"),
        }
    }

    pub(super) fn zero(self) -> &'static str {
        match self {
            Self::Plain => "0.0",
            Self::Wrapped => "support::constant(0.0)",
        }
    }

    /// The force less the elastic and damping forces that `internal` calls for.
    pub(super) fn net_force(self, internal: &str) -> String {
        format!("&support::lanes::net_force({}, {})", self.input("force"), self.input(internal))
    }

    /// The result of a kernel from that of the loops.
    pub(super) fn result(self, signature: &Signature, call: &str) -> String {
        let unwrapped = |shape: Shape, value: &str| match shape {
            Shape::Scalar => format!("{value}.0"),
            Shape::Vector(_) => format!("support::lanes::numbers({value})"),
            Shape::Symmetric(_) | Shape::Columns { .. } => format!("{value}.map(support::lanes::numbers)"),
        };
        match (self, signature.outputs) {
            (Self::Plain, _) => call.to_owned(),
            (Self::Wrapped, [output]) => unwrapped(output.shape, call),
            (Self::Wrapped, outputs) => {
                let names: Vec<&str> = outputs.iter().map(|output| output.name).collect();
                let values: Vec<String> = outputs
                    .iter()
                    .map(|output| format!("    {},\n", unwrapped(output.shape, output.name)))
                    .collect();
                format!("let ({}) = {call};\n(\n{})", names.join(", "), values.concat())
            }
        }
    }
}
