//! The implementation of the traits: nalgebra outside, arrays inside.

use super::lanes;
use super::markers;
use super::writer::{FunctionHead, Writer};
use crate::emit::Subject;
use crate::formulate::{Definition, JACOBIANS, KERNELS, Shape, Signature};

/// `impl FlexibleBody<M, N, scalar> for NAME`; for every scalar if the body is generic.
pub(super) fn implementation(writer: &mut Writer, subject: &Subject<'_>) {
    let Subject { model, lanes, options, .. } = subject;
    block(writer, subject, "FlexibleBody", &KERNELS, |writer| {
        if let Some(lanes) = lanes {
            lanes::trait_method(writer, lanes, options.scalar);
        }
        if let Some(model) = model {
            markers::trait_methods(writer, model, options);
        }
    });
    if options.jacobians {
        writer.blank();
        block(writer, subject, "FlexibleBodyJacobians", &JACOBIANS, |_| {});
    }
}

fn block(
    writer: &mut Writer,
    subject: &Subject<'_>,
    name: &str,
    kernels: &[&Definition],
    extra: impl FnOnce(&mut Writer),
) {
    let Subject { report, options, .. } = subject;
    let (modes, size) = (report.mode_count, 6 + report.mode_count);
    let (scalar, generics) = (options.scalar.type_name(), options.scalar.generics());
    writer.line("#[automatically_derived]");
    let head = format!("impl{generics} ::ffrf::{name}<{modes}, {size}, {scalar}> for {} {{", options.name);
    writer.block(&head, "}", |writer| {
        for (position, definition) in kernels.iter().enumerate() {
            if position > 0 {
                writer.blank();
            }
            method(writer, subject, &definition.signature);
        }
        extra(writer);
    });
}

fn method(writer: &mut Writer, subject: &Subject<'_>, signature: &Signature) {
    let (modes, scalar) = (subject.report.mode_count, subject.options.scalar.type_name());
    let vector = |size: usize| match size {
        3 => format!("::ffrf::nalgebra::Vector3<{scalar}>"),
        _ => format!("::ffrf::nalgebra::SVector<{scalar}, {size}>"),
    };
    let matrix =
        |rows: usize, columns: usize| format!("::ffrf::nalgebra::SMatrix<{scalar}, {rows}, {columns}>");
    let mut inputs = vec!["&self".to_owned()];
    let mut values = Vec::new();
    if subject.model.is_none() {
        values.push("self".to_owned());
    }
    for input in signature.inputs {
        inputs.push(format!("{}: &{}", input.name, vector(input.size(modes))));
        values.push(format!("support::array({})", input.name));
    }
    let wrapped = |shape: Shape, value: &str| match shape {
        Shape::Scalar => value.to_owned(),
        Shape::Vector(_) => format!("support::vector({value})"),
        Shape::Symmetric(_) | Shape::Columns { .. } => format!("support::matrix({value})"),
    };
    let call = format!("{}({})", signature.name, values.join(", "));
    let result = match signature.outputs {
        [output] => match output.shape {
            Shape::Scalar => scalar.to_owned(),
            Shape::Vector(extent) => vector(extent.size(modes)),
            Shape::Symmetric(extent) => matrix(extent.size(modes), extent.size(modes)),
            Shape::Columns { rows, columns } => matrix(rows.size(modes), columns.size(modes)),
        },
        _ => format!("::ffrf::{}<{modes}, {}, {scalar}>", signature.results, 6 + modes),
    };
    writer.line("#[inline]");
    let head = FunctionHead { name: signature.name, inputs: &inputs, result: &result, may_be_short: false };
    writer.function(&head, |writer| match signature.outputs {
        [output] => writer.line(wrapped(output.shape, &call)),
        outputs => {
            let names: Vec<&str> = outputs.iter().map(|output| output.name).collect();
            writer.line(format!("let ({}) = {call};", names.join(", ")));
            writer.block(&format!("::ffrf::{} {{", signature.results), "}", |writer| {
                for output in outputs {
                    writer.line(format!("{}: {},", output.name, wrapped(output.shape, output.name)));
                }
            });
        }
    });
}
