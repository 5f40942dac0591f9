//! How joints are kept: the key `constraints`.

use proc_macro2::TokenStream;
use quote::quote;
use syn::parse::{ParseStream, Parser};
use syn::{Ident, token};

use super::call::Call;
use super::scalar::Scalar;
use crate::parse::Field;

const EXPECTED: &str = "`constraints` must be projection, projection(iterations: .., tolerance: ..), \
                        baumgarte(alpha: .., beta: ..), ggl or index3";

/// The treatment as an expression.
pub(super) fn treatment(field: &Field, scalar: Scalar) -> syn::Result<TokenStream> {
    let parser = |input: ParseStream<'_>| {
        let fork = input.fork();
        let name: Ident = fork.parse()?;
        if fork.peek(token::Paren) {
            return input.parse();
        }
        input.parse::<Ident>()?;
        Ok(Call { kind: name, arguments: Vec::new(), options: Vec::new() })
    };
    let call: Call = parser
        .parse2(field.value.clone())
        .map_err(|_| syn::Error::new(field.span, format!("{EXPECTED}, found `{}`", field.value)))?;
    let treatment = quote! { ::ffrf::mechanism::Treatment };
    let name = call.kind.to_string();
    let options: &[&str] = match name.as_str() {
        "projection" => &["iterations", "tolerance"],
        "baumgarte" => &["alpha", "beta"],
        "ggl" | "index3" => &[],
        "minimal" => {
            let message = "joint coordinates are for scenes: `constraints = \"minimal\"` there; a compiled tree keeps its \
                           joints by projection";
            return Err(syn::Error::new(call.kind.span(), message));
        }
        other => return Err(syn::Error::new(call.kind.span(), format!("{EXPECTED}, found `{other}`"))),
    };
    let mut mistakes = crate::values::Mistakes::default();
    call.check_options(options).into_iter().for_each(|error| mistakes.push(error));
    mistakes.keep(call.arguments::<0>("no arguments without a name"));
    mistakes.verdict(())?;
    let needed = |key: &str| {
        let option = call
            .option(key)
            .ok_or_else(|| syn::Error::new(call.kind.span(), format!("`{name}` needs its `{key}` (1/s)")))?;
        Ok::<_, syn::Error>(scalar.number(&option.value))
    };
    Ok(match name.as_str() {
        "baumgarte" => {
            let (alpha, beta) = (needed("alpha")?, needed("beta")?);
            quote! { #treatment::Baumgarte { alpha: #alpha, beta: #beta } }
        }
        "ggl" => quote! { #treatment::StabilisedIndex2 },
        "index3" => quote! { #treatment::Index3 },
        _ => {
            let iterations = call.option("iterations").map(|option| &option.value);
            let tolerance = call.option("tolerance").map(|option| scalar.number(&option.value));
            if iterations.is_none() && tolerance.is_none() {
                return Ok(quote! { #treatment::projection() });
            }
            let set = [
                iterations.map(|value| quote! { *iterations = #value; }),
                tolerance.map(|value| quote! { *tolerance = #value; }),
            ];
            let set = set.into_iter().flatten();
            quote! {
                {
                    let mut treatment = #treatment::projection();
                    if let #treatment::Projection { iterations, tolerance } = &mut treatment {
                        #(#set)*
                    }
                    treatment
                }
            }
        }
    })
}
