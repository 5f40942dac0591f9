//! What stands before everything that is made of a model: its modes are chosen, model and options are checked.

use ffrf_model::ReducedBody;

use crate::{CodegenError, GenerateOptions, ScalarType};

/// The body with the modes that the options want; checks both.
pub(crate) fn prepare(body: &ReducedBody, options: &GenerateOptions) -> Result<ReducedBody, CodegenError> {
    let tolerance = options.layout_tolerance;
    if !(0.0..1.0).contains(&tolerance) {
        return Err(CodegenError::LayoutTolerance { found: tolerance });
    }
    check_name(&options.name)?;
    let body = match &options.modes {
        Some(selection) => body.with_selected_modes(selection)?,
        None => body.clone(),
    };
    // What was read from a file has been checked; what was built by hand, and what a selection leaves, has not.
    body.check()?.verdict()?;
    check_numbers(&body, options.scalar)?;
    Ok(body)
}

/// Every number of the body is finite in the scalar type of its constants.
fn check_numbers(body: &ReducedBody, scalar: ScalarType) -> Result<(), CodegenError> {
    match body.find_number(|number| !scalar.is_finite(number)) {
        Some((field, found)) => Err(CodegenError::TooLarge { field, found, scalar: scalar.name() }),
        None => Ok(()),
    }
}

/// Whether the name can be that of a type.
///
/// Errors: [`CodegenError::Name`].
pub(crate) fn check_name(name: &str) -> Result<(), CodegenError> {
    let mut characters = name.chars();
    let starts = characters.next().is_some_and(|c| c.is_alphabetic() || c == '_');
    if starts && name != "_" && characters.all(|c| c.is_alphanumeric() || c == '_') {
        return Ok(());
    }
    Err(CodegenError::Name { found: name.to_owned() })
}
