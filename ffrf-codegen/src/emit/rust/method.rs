//! One method of a trait: it calls the function on arrays and wraps what goes in and comes out.

use super::found_registers::on_registers;
use crate::emit::Subject;
use crate::emit::writer::{FunctionHead, Writer};
use crate::expression::{Extent, Input};
use crate::formulate::{Interface, Shape, Signature};

/// The types in the signatures of one body.
pub(super) struct Types {
    /// Scalar type of all values.
    pub(super) scalar: &'static str,
    modes: usize,
    /// Whether the functions take the body.
    pub(super) has_parameters: bool,
}

impl Types {
    pub(super) fn of(subject: &Subject<'_>) -> Self {
        Self {
            scalar: subject.options.scalar.type_name(),
            modes: subject.report.mode_count,
            has_parameters: subject.model.is_none(),
        }
    }

    fn size(&self) -> usize {
        Extent::Velocities.size(self.modes)
    }

    fn vector(&self, size: usize) -> String {
        match size {
            3 => format!("::ffrf::nalgebra::Vector3<{}>", self.scalar),
            _ => format!("::ffrf::nalgebra::SVector<{}, {size}>", self.scalar),
        }
    }

    fn matrix(&self, rows: usize, columns: usize) -> String {
        format!("::ffrf::nalgebra::SMatrix<{}, {rows}, {columns}>", self.scalar)
    }

    /// A vector over the modes.
    pub(super) fn modal(&self) -> String {
        format!("::ffrf::nalgebra::SVector<{}, {}>", self.scalar, self.modes)
    }

    /// A marker.
    pub(super) fn marker(&self) -> String {
        self.over_modes("Marker")
    }

    /// A type of the facade that holds modal vectors.
    fn over_modes(&self, name: &str) -> String {
        format!("::ffrf::{name}<{}, {}>", self.modal(), self.scalar)
    }

    /// A type of the facade that holds dense matrices.
    fn dense(&self, name: &str) -> String {
        format!("::ffrf::{name}<{}, {}, {}>", self.modes, self.size(), self.scalar)
    }

    /// The trait with its parameters.
    pub(super) fn trait_path(&self, interface: Interface) -> String {
        match interface {
            Interface::FlexibleBody => format!("::ffrf::FlexibleBody<{}>", self.scalar),
            Interface::Observables => format!("::ffrf::Observables<{}>", self.scalar),
            Interface::DenseForms => self.dense("DenseForms"),
            Interface::FlexibleBodyJacobians => self.dense("FlexibleBodyJacobians"),
        }
    }

    /// The type of an argument.
    pub(super) fn input(&self, interface: Interface, input: Input) -> String {
        match (interface, input) {
            (Interface::FlexibleBody, Input::FORCE) => self.over_modes("GeneralisedForce"),
            _ => self.vector(input.size(self.modes)),
        }
    }

    /// The type of a result that stands alone.
    pub(super) fn output(&self, interface: Interface, shape: Shape) -> String {
        match (interface, shape) {
            (Interface::FlexibleBody, Shape::Motion) => self.over_modes("Motion"),
            (Interface::FlexibleBody, Shape::Force) => self.over_modes("GeneralisedForce"),
            (Interface::FlexibleBody, Shape::Symmetric(Extent::Modes)) => self.over_modes("ModalMatrix"),
            (_, Shape::Scalar) => self.scalar.to_owned(),
            (_, Shape::Vector(_) | Shape::Motion | Shape::Force) => self.vector(shape.entries(self.modes)),
            (_, Shape::Symmetric(extent)) => self.matrix(extent.size(self.modes), extent.size(self.modes)),
            (_, Shape::Columns { rows, columns }) => {
                self.matrix(rows.size(self.modes), columns.size(self.modes))
            }
        }
    }

    /// The type of all results.
    pub(super) fn result(&self, interface: Interface, signature: &Signature) -> String {
        match (interface, signature.outputs) {
            (Interface::FlexibleBody, _) if is_modal_matrix(signature) => self.over_modes("ModalMatrix"),
            (_, [output]) => self.output(interface, output.shape),
            (Interface::FlexibleBody, _) => self.over_modes(signature.results),
            _ => self.dense(signature.results),
        }
    }
}

/// Whether the result is a matrix over the modes, whole or its diagonal: it follows from no input.
fn is_modal_matrix(signature: &Signature) -> bool {
    let shapes = [Shape::Symmetric(Extent::Modes), Shape::Vector(Extent::Modes)];
    signature.inputs.is_empty() && signature.outputs.iter().all(|output| shapes.contains(&output.shape))
}

/// Writes the method; the function `takes_registers` that are found when running, or not.
pub(super) fn method(
    writer: &mut Writer,
    types: &Types,
    interface: Interface,
    signature: &Signature,
    takes_registers: bool,
) {
    let mut inputs = vec!["&self".to_owned()];
    let mut values = Vec::new();
    if takes_registers {
        values.push("registers".to_owned());
    }
    if types.has_parameters {
        values.push("self".to_owned());
    }
    for &input in signature.inputs {
        inputs.push(format!("{}: &{}", input.name, types.input(interface, input)));
        values.push(match (interface, input) {
            (Interface::FlexibleBody, Input::FORCE) => {
                format!("support::array(&{}.to_vector::<{}>())", input.name, types.size())
            }
            _ => format!("support::array({})", input.name),
        });
    }
    let call = call(signature.name, &values);
    writer.line("#[inline]");
    let result = types.result(interface, signature);
    let head = FunctionHead { name: signature.name, inputs: &inputs, result: &result, may_be_short: false };
    let write = |writer: &mut Writer| match (interface, signature.outputs) {
        (Interface::FlexibleBody, [output]) if is_modal_matrix(signature) => {
            writer.line(match output.shape {
                Shape::Symmetric(_) => format!("::ffrf::ModalMatrix::Dense(support::matrix({call}))"),
                _ => format!("::ffrf::ModalMatrix::Diagonal(support::vector({call}))"),
            });
        }
        (_, [output]) => writer.line(wrapped(interface, output.shape, &call)),
        (_, outputs) => {
            let names: Vec<&str> = outputs.iter().map(|output| output.name).collect();
            writer.line(format!("let ({}) = {call};", names.join(", ")));
            writer.block(&format!("::ffrf::{} {{", signature.results), "}", |writer| {
                for output in outputs {
                    let value = wrapped(interface, output.shape, output.name);
                    let is_same = value == output.name;
                    writer.line(if is_same {
                        format!("{value},")
                    } else {
                        format!("{}: {value},", output.name)
                    });
                }
            });
        }
    };
    writer.function(&head, |writer| on_registers(writer, takes_registers, write));
}

/// A call, with an argument a line if there are several.
fn call(function: &str, arguments: &[String]) -> String {
    match arguments {
        [] | [_] => format!("{function}({})", arguments.concat()),
        several => format!("{function}(\n    {},\n)", several.join(",\n    ")),
    }
}

/// A result of the function on arrays as the trait has it.
fn wrapped(interface: Interface, shape: Shape, value: &str) -> String {
    match (interface, shape) {
        (Interface::FlexibleBody, Shape::Motion) => {
            format!("::ffrf::Motion::from_vector(&support::vector({value}))")
        }
        (Interface::FlexibleBody, Shape::Force) => {
            format!("::ffrf::GeneralisedForce::from_vector(&support::vector({value}))")
        }
        (Interface::FlexibleBody, Shape::Columns { .. }) => format!("{value}.map(support::vector)"),
        (_, Shape::Scalar) => value.to_owned(),
        (_, Shape::Vector(_) | Shape::Motion | Shape::Force) => format!("support::vector({value})"),
        (_, Shape::Symmetric(_) | Shape::Columns { .. }) => format!("support::matrix({value})"),
    }
}
