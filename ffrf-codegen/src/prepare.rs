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
    options.fidelity.check_held(body.second_order_terms)?;
    check_numbers(&body, options.scalar)?;
    check_digits(&body, options.scalar)?;
    Ok(body)
}

/// Least independence of modes in single precision. Accelerations of bodies down to some 4e-8 are measured to be as accurate as
/// those by Cholesky factors, which is what such modes allow (`tests/accuracy_of_accelerations`); a factor of five below, the
/// mass matrix cannot be told from a singular one.
const INDEPENDENCE_IN_SINGLE: f64 = f32::EPSILON as f64 / 16.0;

/// The modes are independent enough for the digits of the scalar type; for double precision the model's own check says so.
fn check_digits(body: &ReducedBody, scalar: ScalarType) -> Result<(), CodegenError> {
    let found = body.independence_of_modes().unwrap_or(0.0);
    if scalar == ScalarType::F32 && found < INDEPENDENCE_IN_SINGLE {
        let expected = INDEPENDENCE_IN_SINGLE;
        return Err(CodegenError::TooDependent { found, expected, scalar: scalar.name() });
    }
    Ok(())
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
