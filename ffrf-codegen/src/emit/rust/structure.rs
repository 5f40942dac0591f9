//! The struct of a body and its constants.

use ffrf_model::ReducedBody;

use crate::emit::documentation::plain;
use crate::emit::literal::literal;
use crate::emit::writer::{Writer, bracketed};
use crate::report::Report;
use crate::{GenerateOptions, ScalarType};

/// The unit struct, with the user's attributes.
pub(super) fn unit_struct(
    writer: &mut Writer,
    body: &ReducedBody,
    report: &Report,
    options: &GenerateOptions,
) {
    for attribute in &options.attributes {
        writer.line(attribute);
    }
    if !options.attributes.iter().any(|attribute| is_documentation(attribute)) {
        let (title, modes) = (plain(&body.title), report.mode_count);
        writer.documentation([format!("Flexible body \"{title}\" with {modes} modes.")]);
    }
    writer.line("#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]");
    writer.line(format!("{}struct {};", visibility(options), options.name));
}

pub(super) fn is_documentation(attribute: &str) -> bool {
    attribute.trim_start().starts_with("///") || attribute.replace(' ', "").starts_with("#[doc=")
}

/// The visibility with a space after it, if there is one.
pub(super) fn visibility(options: &GenerateOptions) -> String {
    match options.visibility.as_str() {
        "" => String::new(),
        visibility => format!("{visibility} "),
    }
}

/// Names of the constants of bodies, which no marker can take.
pub(super) const RESERVED: [&str; 7] = [
    "MODE_COUNT",
    "MASS",
    "FREQUENCIES_HZ",
    "LARGEST_STABLE_STEP",
    "FLOPS",
    "TABLE_BYTES",
    "MODEL_FINGERPRINT",
];

/// A constant of a body, one of [`RESERVED`].
pub(super) struct Constant {
    /// Its name.
    pub(super) name: &'static str,
    documentation: &'static str,
    kind: String,
    value: String,
}

impl Constant {
    /// Writes documentation and item.
    pub(super) fn write(&self, writer: &mut Writer, options: &GenerateOptions) {
        let Self { name, documentation, kind, value } = self;
        writer.documentation(documentation.lines());
        writer.line(format!("{}const {name}: {kind} = {value};", visibility(options)));
    }
}

/// Constants that every baked body has.
pub(super) fn constants(body: &ReducedBody, report: &Report, options: &GenerateOptions) -> Vec<Constant> {
    let modes = report.mode_count;
    let frequencies: Vec<String> = body
        .modes
        .iter()
        .map(|mode| match mode.frequency_hz {
            Some(frequency) => {
                format!("::core::option::Option::Some({})", literal(frequency, ScalarType::F64))
            }
            None => "::core::option::Option::None".to_owned(),
        })
        .collect();
    let mut constants = vec![
        Constant {
            name: "MODE_COUNT",
            documentation: "Number of modes M.",
            kind: "usize".to_owned(),
            value: modes.to_string(),
        },
        Constant {
            name: "MASS",
            documentation: "Mass m. Units: kg.",
            kind: options.scalar.constant_type_name().to_owned(),
            value: literal(body.inertia.mass, options.scalar),
        },
        Constant {
            name: "FREQUENCIES_HZ",
            documentation: "Natural frequency of each mode that is an eigenmode. Units: Hz.",
            kind: format!("[::core::option::Option<f64>; {modes}]"),
            value: bracketed(&frequencies, 4),
        },
        Constant {
            name: "LARGEST_STABLE_STEP",
            documentation: "Largest step with which the classical Runge-Kutta method of order four is stable for small \
                            motions of the\nfree body, from its highest frequency and its damping; infinite without \
                            either. Units: s.",
            kind: "f64".to_owned(),
            value: stable_step(body),
        },
        Constant {
            name: "FLOPS",
            documentation: "Floating-point operations of one call of `forward_dynamics`; none where it is a loop over lanes, \
                            whose work\ndepends on the registers of the target.",
            kind: "::core::option::Option<usize>".to_owned(),
            value: match report.kernels.iter().find(|kernel| kernel.name == "forward_dynamics") {
                Some(kernel) => format!("::core::option::Option::Some({})", kernel.counts.total()),
                None => "::core::option::Option::None".to_owned(),
            },
        },
        Constant {
            name: "TABLE_BYTES",
            documentation: "Tables that loops over lanes read; zero where all numbers stand in statements. Units: bytes.",
            kind: "usize".to_owned(),
            value: report.table_bytes.to_string(),
        },
    ];
    if let Some(source) = &report.source {
        constants.push(Constant {
            name: "MODEL_FINGERPRINT",
            documentation: "Hash of the model's content, to tell versions apart.",
            kind: "u64".to_owned(),
            value: format!("0x{:016x}", source.fingerprint),
        });
    }
    constants
}

/// The literal of the largest stable step; a body without positive modal masses has none, and is refused before.
fn stable_step(body: &ReducedBody) -> String {
    match body.largest_stable_step() {
        Some(step) if step.is_finite() => literal(step, ScalarType::F64),
        Some(_) => "::core::primitive::f64::INFINITY".to_owned(),
        None => "0.0".to_owned(),
    }
}
