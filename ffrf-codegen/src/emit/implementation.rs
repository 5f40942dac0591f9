//! The implementation of the trait: nalgebra outside, arrays inside.

use crate::formulate::{Argument, KernelKind, OutputShape};
use crate::{FusedMultiplyAdd, GenerateOptions, ScalarType};

/// What functions may call, with the line that brings it into scope.
pub(super) fn imports(options: &GenerateOptions) -> [(String, String); 2] {
    let suffix = match options.scalar {
        ScalarType::F64 => "",
        ScalarType::F32 => "_f32",
        ScalarType::Generic => "_of",
    };
    let fused = match options.fused_multiply_add {
        FusedMultiplyAdd::On => "always_fused_multiply_add",
        FusedMultiplyAdd::Auto | FusedMultiplyAdd::Off => "fused_multiply_add",
    };
    let alias = |name: &str, short: &str| match name == short {
        true => format!("use ::ffrf::generated_support::{name};"),
        false => format!("use ::ffrf::generated_support::{name} as {short};"),
    };
    [
        ("fma(".to_owned(), alias(&format!("{fused}{suffix}"), "fma")),
        ("square_root(".to_owned(), alias(&format!("square_root{suffix}"), "square_root")),
    ]
}

/// `impl FlexibleBody<M, N, scalar> for NAME`; for every scalar if the body is generic.
pub(super) fn implementation(
    options: &GenerateOptions,
    mode_count: usize,
    has_parameters: bool,
    extra_methods: &str,
) -> String {
    let size = 6 + mode_count;
    let (scalar, generics) = (options.scalar.type_name(), options.scalar.generics());
    let methods = |kinds: &[KernelKind]| {
        let method = |kind: &KernelKind| method(*kind, mode_count, scalar, has_parameters);
        kinds.iter().map(method).collect::<Vec<String>>().join("\n")
    };
    let mut text = format!(
        "    #[automatically_derived]
    impl{generics} ::ffrf::FlexibleBody<{mode_count}, {size}, {scalar}> for {} {{
{}{extra_methods}    }}
",
        options.name,
        methods(&KernelKind::ALL)
    );
    if options.jacobians {
        text.push_str(&format!(
            "
    #[automatically_derived]
    impl{generics} ::ffrf::FlexibleBodyJacobians<{mode_count}, {size}, {scalar}> for {} {{
{}    }}
",
            options.name,
            methods(&KernelKind::JACOBIANS)
        ));
    }
    text
}

/// The struct of several results, and its fields in the order of the results.
fn result_struct(kind: KernelKind) -> (&'static str, &'static [&'static str]) {
    match kind {
        KernelKind::AccelerationJacobian => {
            ("AccelerationJacobian", &["acceleration", "coordinates", "rates", "angular_velocity", "force"])
        }
        KernelKind::ResidualJacobian => {
            ("ResidualJacobian", &["residual", "coordinates", "rates", "angular_velocity", "acceleration"])
        }
        _ => ("EquationsOfMotion", &["mass_matrix", "quadratic_velocity", "acceleration"]),
    }
}

fn method(kind: KernelKind, mode_count: usize, scalar: &str, has_parameters: bool) -> String {
    let vector = |size: usize| match size {
        3 => format!("::ffrf::nalgebra::Vector3<{scalar}>"),
        _ => format!("::ffrf::nalgebra::SVector<{scalar}, {size}>"),
    };
    let mut inputs = vec!["&self".to_owned()];
    let mut values = Vec::new();
    if has_parameters {
        values.push("self".to_owned());
    }
    for argument in kind.arguments() {
        let name = match argument {
            Argument::Coordinates => "q",
            Argument::Velocity => "velocity",
            Argument::AngularVelocity => "omega",
            Argument::Rates => "q_dot",
            Argument::Force => "force",
            Argument::Gravity => "gravity",
            Argument::Acceleration => "acceleration",
        };
        inputs.push(format!("{name}: &{}", vector(argument.size(mode_count))));
        values.push(format!("support::array({name})"));
    }
    let wrap = |shape: OutputShape, value: &str| match shape {
        OutputShape::Scalar => value.to_owned(),
        OutputShape::Vector(_) => format!("support::vector({value})"),
        OutputShape::Matrix(_) | OutputShape::Columns { .. } => format!("support::matrix({value})"),
    };
    let name = kind.name();
    let size = 6 + mode_count;
    let call = format!("{name}({})", values.join(", "));
    let outputs = kind.outputs(mode_count);
    let (result, body) = match outputs.as_slice() {
        [shape] => {
            let result = match shape {
                OutputShape::Scalar => scalar.to_owned(),
                OutputShape::Vector(size) => vector(*size),
                OutputShape::Matrix(size) => format!("::ffrf::nalgebra::SMatrix<{scalar}, {size}, {size}>"),
                OutputShape::Columns { rows, columns } => {
                    format!("::ffrf::nalgebra::SMatrix<{scalar}, {rows}, {columns}>")
                }
            };
            (result, wrap(*shape, &call))
        }
        shapes => {
            let (structure, fields) = result_struct(kind);
            let values: Vec<String> = shapes
                .iter()
                .zip(fields)
                .map(|(shape, field)| format!("                {field}: {},\n", wrap(*shape, field)))
                .collect();
            let body = format!(
                "let ({}) = {call};
            ::ffrf::{structure} {{
{}            }}",
                fields.join(", "),
                values.concat()
            );
            (format!("::ffrf::{structure}<{mode_count}, {size}, {scalar}>"), body)
        }
    };
    format!(
        "        #[inline]
        fn {name}(
            {},
        ) -> {result} {{
            {body}
        }}
",
        inputs.join(",\n            ")
    )
}
