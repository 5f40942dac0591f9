//! What is emitted after a mistake: the messages, and the struct, so that its uses are not mistakes as well.

use proc_macro2::TokenStream;
use quote::quote;

use crate::parse::Input;

/// The messages and a struct that implements nothing.
pub(crate) fn fallback(input: &Input, error: &syn::Error) -> TokenStream {
    let messages = error.to_compile_error();
    let Input { attributes, visibility, name, .. } = input;
    quote! {
        #messages
        #(#attributes)*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
        #visibility struct #name;
    }
}
