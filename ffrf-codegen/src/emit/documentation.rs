//! The documentation of kernels, from their signatures.

use crate::expression::Extent;
use crate::formulate::{Shape, Signature};

/// What it is, shape, units, frame and source, one line each.
pub(super) fn of(signature: &Signature, mode_count: usize) -> Vec<String> {
    vec![
        signature.title.to_owned(),
        String::new(),
        format!("Shape: {}. Units: {}. Frame: body.", shape(signature, mode_count), signature.units),
        format!("Source: {}.", signature.source),
    ]
}

fn shape(signature: &Signature, mode_count: usize) -> String {
    let size = |extent: Extent| extent.size(mode_count);
    let short = |shape: Shape| match shape {
        Shape::Scalar => "scalar".to_owned(),
        Shape::Vector(extent) => size(extent).to_string(),
        Shape::Motion | Shape::Force => size(Extent::Velocities).to_string(),
        Shape::Symmetric(extent) => format!("{0} x {0}", size(extent)),
        Shape::Columns { rows, columns } => format!("{} x {}", size(columns), size(rows)),
    };
    let shapes: Vec<Shape> = signature.outputs.iter().map(|output| output.shape).collect();
    match shapes.as_slice() {
        [Shape::Motion | Shape::Force] => {
            format!("{}: translation 3, rotation 3, modes {mode_count}", size(Extent::Velocities))
        }
        [single @ Shape::Symmetric(_)] => format!("{}, symmetric, column by column", short(*single)),
        [value, derivatives @ ..] if let Some(Shape::Columns { rows, .. }) = derivatives.first() => {
            let columns = derivatives.iter().map(|shape| match shape {
                Shape::Columns { columns, .. } => size(*columns).to_string(),
                shape => short(*shape),
            });
            let columns: Vec<String> = columns.collect();
            format!("{}; columns of {}: {}", short(*value), size(*rows), columns.join(", "))
        }
        several => several.iter().map(|shape| short(*shape)).collect::<Vec<_>>().join(", "),
    }
}

/// A title on one line, without characters that a terminal obeys.
pub(super) fn plain(title: &str) -> String {
    let visible: String = title.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    visible.split_whitespace().collect::<Vec<_>>().join(" ")
}
