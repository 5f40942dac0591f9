//! From an array function to text.

use crate::array_function::{ArrayFunction, ArrayInput, Call, InputForm, Relation};
use crate::counts::OperationCounts;
use crate::expression::Extent;
use crate::formulate::{Draft, Kernel, Output, Shape, Signature};
use crate::prepare::check_name;
use crate::validate::ValidKernel;
use crate::{CodegenError, FusedMultiplyAdd, GenerateOptions, ScalarType, emit, passes};

/// A function on arrays as text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GeneratedArrayFunction {
    /// The function.
    pub text: String,
    /// Operations of one call.
    pub counts: OperationCounts,
}

/// All results and both sides of all conditions as one column.
const COLUMN: Signature = Signature {
    name: "array function",
    inputs: &[],
    outputs: &[Output { name: "column", shape: Shape::Vector(Extent::Modes) }],
    results: "",
    title: "",
    units: "",
    source: "",
};

/// Generates a function on arrays in Rust.
///
/// Of the options, scalar type and fused multiply-add are used. With [`FusedMultiplyAdd::Off`] every operation is rounded as
/// the graph has it: the same bits as the computation that it was written down from, in f64. Else products are contracted
/// with sums, common factors are taken out, and quotients by one number become products with its inverse.
///
/// The same function gives the same text, to the byte. Errors: see [`CodegenError`]. Panics: never.
pub fn generate_array_function(
    function: &ArrayFunction,
    options: &GenerateOptions,
) -> Result<GeneratedArrayFunction, CodegenError> {
    check_name(&function.name)?;
    if options.scalar == ScalarType::Generic {
        return Err(CodegenError::NotInArrays { found: "generic", expected: "f64 or f32" });
    }
    let sides = function.conditions.iter().flat_map(|condition| match condition.relation {
        Relation::Finite => [condition.left, condition.left],
        _ => [condition.left, condition.right],
    });
    let outputs: Vec<_> = function.results.iter().copied().chain(sides).collect();
    let kernel = Kernel {
        signature: COLUMN,
        mode_count: outputs.len(),
        graph: Draft::new(function.graph.clone()),
        outputs,
    };
    let kernel = match options.fused_multiply_add {
        FusedMultiplyAdd::Off => passes::run_exactly(kernel),
        fused => passes::run_with_inverses(kernel, fused),
    };
    let counts = OperationCounts::of(&kernel);
    let values = ArrayInput {
        name: Call::ENTRY,
        entry: Call::ENTRY,
        count: function.calls.len(),
        form: InputForm::Flat,
    };
    let inputs: Vec<ArrayInput> = function.inputs.iter().copied().chain([values]).collect();
    let kernel = ValidKernel::of_arrays(kernel, options.scalar, &inputs)?;
    Ok(GeneratedArrayFunction { text: emit::rust_array_function(function, &kernel, options), counts })
}
