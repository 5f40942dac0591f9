//! Reading the model, calling the generator, and giving its tokens the user's places.

use std::path::{Path, PathBuf};

use ffrf_codegen::{CodegenError, generate};
use ffrf_model::ReducedBody;
use proc_macro2::{Group, Ident, TokenStream, TokenTree};
use quote::quote;

use crate::fallback::fallback;
use crate::parse::Input;
use crate::validate::{Request, validate};

/// The whole macro.
pub(crate) fn flexible_body(input: TokenStream) -> TokenStream {
    let input: Input = match syn::parse2(input) {
        Ok(input) => input,
        Err(error) => return error.into_compile_error(),
    };
    match validate(&input).and_then(|request| body(&input, request)) {
        Ok(tokens) => tokens,
        Err(error) => fallback(&input, &error),
    }
}

fn body(input: &Input, mut request: Request) -> syn::Result<TokenStream> {
    let at_model = |message: String| syn::Error::new(request.model.span(), message);
    let relative = request.model.value();
    let folder = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default();
    let path = folder.join(&relative);
    if !path.is_file() {
        return Err(at_model(format!("there is no file `{relative}` in the folder of Cargo.toml")));
    }
    let text = std::fs::read_to_string(&path)
        .map_err(|error| at_model(format!("cannot read `{relative}`: {error}")))?;
    let model = ReducedBody::from_json(&text).map_err(|error| at_model(format!("`{relative}`: {error}")))?;
    request.options.source_name = file_name(&path);
    let code = generate(&model, &request.options).map_err(|error| match (&error, &request.modes) {
        (CodegenError::Model(ffrf_model::ModelError::TooFewModes { .. }), Some(modes)) => {
            syn::Error::new(modes.span, format!("`{relative}`: {error}"))
        }
        _ => at_model(format!("`{relative}`: {error}")),
    })?;
    let tokens = with_users_name(code.tokens, &input.name);
    let watch = rebuild_on_change(&relative, &request.model);
    Ok(quote! { #tokens #watch })
}

fn file_name(path: &Path) -> String {
    path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}

/// Makes the compiler read the file, so that a change of it rebuilds the crate. No machine path in the output.
fn rebuild_on_change(relative: &str, model: &syn::LitStr) -> TokenStream {
    if Path::new(relative).is_absolute() {
        return quote! { const _: &[u8] = ::core::include_bytes!(#model); };
    }
    let tail = syn::LitStr::new(&format!("/{relative}"), model.span());
    quote! {
        const _: &[u8] =
            ::core::include_bytes!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), #tail));
    }
}

/// Puts the user's own identifier in the place of each one with its name, so that tools find the definition.
fn with_users_name(tokens: TokenStream, name: &Ident) -> TokenStream {
    tokens
        .into_iter()
        .map(|token| match token {
            TokenTree::Group(group) => {
                let mut renamed = Group::new(group.delimiter(), with_users_name(group.stream(), name));
                renamed.set_span(group.span());
                TokenTree::Group(renamed)
            }
            TokenTree::Ident(ident) if ident == *name => TokenTree::Ident(name.clone()),
            other => other,
        })
        .collect()
}
