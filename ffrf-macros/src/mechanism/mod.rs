//! `mechanism!`: bodies, joints, drives, forces and sensors composed into one type of static size.

mod accelerations;
mod axis;
mod bodies;
mod call;
mod controls;
mod drives;
mod emit;
mod ends;
mod forces;
mod index;
mod joints;
mod named_joint;
mod scalar;
mod sensors;
mod spec;
#[cfg(test)]
mod tests;
mod treatment;

use proc_macro2::TokenStream;

use crate::fallback::fallback;
use crate::parse::Input;

/// The whole macro.
pub(crate) fn mechanism(input: TokenStream) -> TokenStream {
    let input: Input = match syn::parse2(input) {
        Ok(input) => input,
        Err(error) => return error.into_compile_error(),
    };
    match spec::spec(&input) {
        Ok(spec) => emit::mechanism(&input, &spec),
        Err(error) => fallback(&input, &error),
    }
}
