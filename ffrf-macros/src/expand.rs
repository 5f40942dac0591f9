//! Reading the model, calling the generator, and giving its tokens the user's places.

use std::path::{Path, PathBuf};

use ffrf_codegen::{CodegenError, GenerateOptions, GeneratedCode, generate, generate_with_layout};
use ffrf_model::{ModelError, ReducedBody};
use proc_macro2::{Group, Ident, Span, TokenStream, TokenTree};
use quote::quote;
use syn::LitStr;

use crate::fallback::fallback;
use crate::family::family;
use crate::parse::Input;
use crate::validate::{Request, Source, validate};

/// The whole macro.
pub(crate) fn flexible_body(input: TokenStream) -> TokenStream {
    let input: Input = match syn::parse2(input) {
        Ok(input) => input,
        Err(error) => return error.into_compile_error(),
    };
    if input.is_family {
        let one = |input: &Input| validate(input).and_then(|request| body(input, request));
        return family(&input, one).unwrap_or_else(|error| crate::family::fallback(&input, &error));
    }
    match validate(&input).and_then(|request| body(&input, request)) {
        Ok(tokens) => tokens,
        Err(error) => fallback(&input, &error),
    }
}

fn body(input: &Input, request: Request) -> syn::Result<TokenStream> {
    let Request { source, mut options } = request;
    let (code, watch) = match &source {
        Source::Model { path, modes } => (from_model(path, *modes, &mut options)?, rebuild_on_change(path)),
        Source::Layout { mode_count, layout, span } => {
            let code = generate_with_layout(*mode_count, layout, &options)
                .map_err(|error| syn::Error::new(*span, error.to_string()))?;
            (code, TokenStream::new())
        }
    };
    let tokens = with_users_name(code.tokens, &input.name);
    Ok(quote! { #tokens #watch })
}

fn from_model(
    path: &LitStr,
    modes: Option<Span>,
    options: &mut GenerateOptions,
) -> syn::Result<GeneratedCode> {
    let relative = path.value();
    let at_model = |message: String| syn::Error::new(path.span(), message);
    let folder = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default();
    let file = folder.join(&relative);
    if !file.is_file() {
        return Err(at_model(format!("there is no file `{relative}` in the folder of Cargo.toml")));
    }
    let text = std::fs::read_to_string(&file)
        .map_err(|error| at_model(format!("cannot read `{relative}`: {error}")))?;
    let model = ReducedBody::from_json(&text).map_err(|error| at_model(format!("`{relative}`: {error}")))?;
    options.source_name = file_name(&file);
    generate(&model, options).map_err(|error| {
        let span = modes.filter(|_| blames_selection(&error)).unwrap_or_else(|| path.span());
        syn::Error::new(span, format!("`{relative}`: {error}"))
    })
}

/// Whether the modes were asked for that the model does not have.
fn blames_selection(error: &CodegenError) -> bool {
    matches!(
        error,
        CodegenError::Model(
            ModelError::TooFewModes { .. } | ModelError::NoSuchMode { .. } | ModelError::RepeatedMode { .. }
        )
    )
}

fn file_name(path: &Path) -> String {
    path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}

/// Makes the compiler read the file, so that a change of it rebuilds the crate. No machine path in the output.
fn rebuild_on_change(model: &LitStr) -> TokenStream {
    let relative = model.value();
    if Path::new(&relative).is_absolute() {
        return quote! { const _: &[u8] = ::core::include_bytes!(#model); };
    }
    let tail = LitStr::new(&format!("/{relative}"), model.span());
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

#[cfg(test)]
mod tests {
    use ffrf_codegen::GenerateOptions;
    use ffrf_test_kit::doors;

    use super::*;

    /// The model of the macro's tests, from this crate's folder.
    const MODEL: &str = "../tests/models/random_m4.ffrf.json";

    #[test]
    fn the_macro_makes_the_code_that_the_generator_prints() {
        let tokens = flexible_body(quote! {
            /// A body.
            pub struct Part { model: #MODEL, modes: ..3 }
        });
        let model = ReducedBody::read(Path::new(env!("CARGO_MANIFEST_DIR")).join(MODEL)).unwrap();
        let options = GenerateOptions {
            name: "Part".to_owned(),
            attributes: vec!["/// A body.".to_owned()],
            source_name: "random_m4.ffrf.json".to_owned(),
            modes: Some(3.into()),
            ..GenerateOptions::default()
        };
        let printed: TokenStream = generate(&model, &options).unwrap().text.parse().unwrap();
        let watch = rebuild_on_change(&LitStr::new(MODEL, Span::call_site()));
        assert_eq!(tokens.to_string(), quote! { #printed #watch }.to_string());
    }

    /// The same table is held against the command line in `ffrf-cli/tests/commands/doors.rs`.
    #[test]
    fn every_option_means_the_same_at_every_door() {
        let path = format!("../models/{}", doors::MODEL);
        let model = ReducedBody::read(Path::new(env!("CARGO_MANIFEST_DIR")).join(&path)).unwrap();
        let watch = rebuild_on_change(&LitStr::new(&path, Span::call_site()));
        for door in doors::with_model() {
            let fields: TokenStream = door.fields.parse().unwrap();
            let expanded = flexible_body(quote! { pub struct Part { model: #path, #fields } });
            let tokens = generate(&model, &door.options).unwrap().tokens;
            assert_eq!(expanded.to_string(), quote! { #tokens #watch }.to_string(), "{}", door.fields);
        }
        for (modes, layout, door) in doors::with_layout() {
            let fields: TokenStream = door.fields.parse().unwrap();
            let expanded = flexible_body(quote! { pub struct Part { #fields } });
            let tokens = generate_with_layout(modes, &layout, &door.options).unwrap().tokens;
            assert_eq!(expanded.to_string(), tokens.to_string(), "{}", door.fields);
        }
    }

    #[test]
    fn a_member_of_a_family_is_the_body_that_stands_alone() {
        let family = flexible_body(quote! {
            pub family parts { model: #MODEL, modes: [2, 3], fidelity: [linear], scalar: [f64, f32], fma: off }
        })
        .to_string();
        for (name, modes, scalar) in [("M2LinearF64", 2_usize, quote!(f64)), ("M3LinearF32", 3, quote!(f32))]
        {
            let modes = proc_macro2::Literal::usize_unsuffixed(modes);
            let (ident, text) =
                (Ident::new(name, Span::call_site()), format!(" {modes} modes, `linear`, `{scalar}`."));
            let alone = flexible_body(quote! {
                #[doc = #text]
                pub struct #ident { model: #MODEL, fma: off, modes: ..#modes, fidelity: linear, scalar: #scalar }
            });
            assert!(family.contains(&alone.to_string()), "{name}");
        }
    }

    #[test]
    fn what_is_wrong_with_the_model_of_a_family_is_said_once() {
        let tokens = flexible_body(quote! {
            pub family parts { model: "Cargo.toml", modes: [1, 2], scalar: [f64, f32] }
        })
        .to_string();
        assert_eq!(tokens.matches("compile_error").count(), 1, "{tokens}");
        assert!(tokens.contains("pub mod parts"), "{tokens}");
    }

    #[test]
    fn no_machine_path_is_in_the_output() {
        let tokens = flexible_body(quote! { pub struct Part { model: #MODEL } }).to_string();
        assert!(!tokens.contains(env!("CARGO_MANIFEST_DIR")));
        assert!(tokens.contains("include_bytes"));
    }

    #[test]
    fn too_many_modes_and_damaged_models_are_reported() {
        let message = |tokens: TokenStream| flexible_body(tokens).to_string();
        let few = message(quote! { pub struct Part { model: #MODEL, modes: ..9 } });
        assert!(few.contains("compile_error") && few.contains("9 modes"), "{few}");
        let manifest = message(quote! { pub struct Part { model: "Cargo.toml" } });
        assert!(manifest.contains("compile_error") && manifest.contains("`Cargo.toml`: "), "{manifest}");
        // The struct is still there, so that its uses are no mistakes.
        assert!(manifest.contains("pub struct Part ;"), "{manifest}");
    }
}
