//! How values get into the loops and out of them.

use crate::ScalarType;
use crate::emit::writer::Writer;
use crate::formulate::{Output, Shape};

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

    /// Whether the processor may have registers for these scalars that the code is not compiled for.
    pub(super) fn finds_registers(self) -> bool {
        self == Self::Plain
    }

    /// The generic parameters of a function over lanes.
    pub(super) fn generics(self, scalar: ScalarType) -> String {
        match self {
            Self::Plain => format!("<R: support::lanes::Registers<{}>>", scalar.type_name()),
            Self::Wrapped => scalar.generics().to_owned(),
        }
    }

    /// The argument that says in which registers a function computes, if it can be asked to.
    pub(super) fn registers(self) -> impl Iterator<Item = String> {
        self.finds_registers().then(|| "registers: R".to_owned()).into_iter()
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

    /// Writes the result of a kernel from that of the loops; `rest` is the last of several results if the loops leave it
    /// out.
    pub(super) fn result(self, writer: &mut Writer, outputs: &[Output], call: &str, rest: Option<&str>) {
        match (self, outputs, rest) {
            (Self::Plain, _, None) => writer.line(call),
            (_, [output], _) => writer.line(self.unwrapped(output.shape, call)),
            (_, outputs, rest) => {
                let known = &outputs[..outputs.len() - rest.iter().count()];
                let names: Vec<&str> = known.iter().map(|output| output.name).collect();
                writer.line(format!("let ({}) = {call};", names.join(", ")));
                writer.block("(", ")", |writer| {
                    for output in known {
                        writer.line(format!("{},", self.unwrapped(output.shape, output.name)));
                    }
                    if let Some(rest) = rest {
                        writer.line(format!("{rest},"));
                    }
                });
            }
        }
    }

    fn unwrapped(self, shape: Shape, value: &str) -> String {
        match (self, shape) {
            (Self::Plain, _) => value.to_owned(),
            (Self::Wrapped, Shape::Scalar) => format!("{value}.0"),
            (Self::Wrapped, Shape::Vector(_) | Shape::Motion | Shape::Force) => {
                format!("support::lanes::numbers({value})")
            }
            (Self::Wrapped, Shape::Symmetric(_) | Shape::Columns { .. }) => {
                format!("{value}.map(support::lanes::numbers)")
            }
        }
    }
}
