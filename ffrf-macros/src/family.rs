//! A family: one call, a body for each combination of modes, fidelity and number type, in a module of their own.

use ffrf_codegen::{Fidelity, ScalarType};
use proc_macro2::{Span, TokenStream};
use quote::{format_ident, quote};
use syn::Ident;

use crate::parse::{Field, Input};
use crate::values::{self, Mistakes};

/// A member: what is written in the place of the lists, and what it is called.
struct Member {
    input: Input,
    modes: usize,
    fidelity: String,
    scalar: &'static str,
}

/// The keys that hold lists in a family.
const LISTS: [&str; 3] = ["modes", "fidelity", "scalar"];

/// The whole module. `body`: expands one body.
pub(crate) fn family(
    input: &Input,
    body: impl Fn(&Input) -> syn::Result<TokenStream>,
) -> syn::Result<TokenStream> {
    let members = members(input)?;
    let (mut mistakes, mut told) = (Mistakes::default(), Vec::new());
    let mut bodies = Vec::with_capacity(members.len());
    for member in &members {
        match body(&member.input) {
            Ok(tokens) => bodies.push(tokens),
            // what is wrong with the model or a common key is wrong with every member
            Err(error) => {
                for one in
                    error.into_iter().filter(|one| !told.contains(&one.to_string())).collect::<Vec<_>>()
                {
                    told.push(one.to_string());
                    mistakes.push(one);
                }
            }
        }
    }
    mistakes.verdict(())?;
    Ok(module(input, &members, &bodies))
}

/// After a mistake: a module, so that its name is no mistake as well.
pub(crate) fn fallback(input: &Input, error: &syn::Error) -> TokenStream {
    let messages = error.to_compile_error();
    let Input { attributes, visibility, name, .. } = input;
    quote! { #messages #(#attributes)* #visibility mod #name {} }
}

fn module(input: &Input, members: &[Member], bodies: &[TokenStream]) -> TokenStream {
    let Input { attributes, visibility, name, .. } = input;
    let count = members.len();
    let names: Vec<&Ident> = members.iter().map(|member| &member.input.name).collect();
    let texts = names.iter().map(|name| name.to_string());
    let modes: Vec<usize> = members.iter().map(|member| member.modes).collect();
    let fidelities: Vec<&String> = members.iter().map(|member| &member.fidelity).collect();
    let scalars: Vec<&str> = members.iter().map(|member| member.scalar).collect();
    let types: Vec<Ident> = scalars.iter().map(|scalar| Ident::new(scalar, Span::call_site())).collect();
    let places = 0..count;
    let list = format_ident!("__members_of_{}", name);
    let call = quote!($call);
    quote! {
        #(#attributes)*
        #visibility mod #name {
            #(#bodies)*

            /// The members, in the order of `for_each` and `members!`.
            pub const MEMBERS: [::ffrf::FamilyMember; #count] = [
                #(::ffrf::FamilyMember {
                    name: #texts, modes: #modes, fidelity: #fidelities, scalar: #scalars,
                }),*
            ];

            /// Visits every member once.
            pub fn for_each(visitor: &mut impl ::ffrf::FamilyVisitor) {
                #(::ffrf::FamilyVisitor::visit::<#types, _>(visitor, MEMBERS[#places], self::#names);)*
            }

            #[doc(hidden)]
            #[allow(unused_macros)]
            macro_rules! #list {
                (#call:ident) => { #(#call! { #names, #modes, #fidelities, #types })* };
            }
            #[allow(unused_imports)]
            pub(crate) use #list as members;
        }
    }
}

/// Every combination, the lists in their order; without modes the first fidelity stands for all: they are the same body.
fn members(input: &Input) -> syn::Result<Vec<Member>> {
    let find = |key: &str| input.fields.iter().find(|field| field.key == key);
    let mut mistakes = Mistakes::default();
    if let Some(field) = find("layout") {
        mistakes.add(field.key.span(), "a family is made of a model: `layout` has one body".to_owned());
    }
    if find("model").is_none() {
        mistakes
            .add(input.name.span(), format!("`{}` needs `model: \"path/to/file.ffrf.json\"`", input.name));
    }
    let modes = match find("modes") {
        Some(field) => mistakes.keep(values::mode_counts(field)),
        None => {
            let message = format!("`{}` needs `modes: [..]`, a list of numbers of modes", input.name);
            mistakes.add(input.name.span(), message);
            None
        }
    };
    let fidelities = find("fidelity").map(values::fidelities);
    let fidelities = fidelities.map_or(Some(vec![None]), |found| {
        mistakes.keep(found).map(|list| list.into_iter().map(Some).collect())
    });
    let scalars = find("scalar").map(values::scalars);
    let scalars = scalars.map_or(Some(vec![(ScalarType::F64, None)]), |found| {
        mistakes
            .keep(found)
            .map(|list| list.into_iter().map(|(scalar, field)| (scalar, Some(field))).collect())
    });
    mistakes.verdict(())?;
    let (Some(modes), Some(fidelities), Some(scalars)) = (modes, fidelities, scalars) else {
        return Err(syn::Error::new(input.name.span(), "no members"));
    };
    let mut members = Vec::new();
    for (count, place) in &modes {
        let kept = if *count == 0 { &fidelities[..1] } else { &fidelities[..] };
        let mut lists = 0;
        for fidelity in kept {
            let level = fidelity.as_ref().map_or(Fidelity::Full, |(level, _)| level.clone());
            let word = if let Fidelity::Terms(_) = level {
                lists += 1;
                format!("Terms{lists}")
            } else {
                capitalised(level.name())
            };
            for (scalar, written) in &scalars {
                let name =
                    Ident::new(&format!("M{count}{word}{}", scalar.name().to_uppercase()), input.name.span());
                let mut fields: Vec<Field> = input
                    .fields
                    .iter()
                    .filter(|field| !LISTS.iter().any(|list| field.key == list))
                    .cloned()
                    .collect();
                fields.push(Field {
                    key: Ident::new("modes", *place),
                    value: {
                        let count = proc_macro2::Literal::usize_unsuffixed(*count);
                        quote!(..#count)
                    },
                    span: *place,
                });
                fields.extend(fidelity.iter().map(|(_, field)| field.clone()));
                fields.extend(written.iter().cloned());
                let text = format!(" {count} modes, `{level}`, `{}`.", scalar.name());
                members.push(Member {
                    modes: *count,
                    fidelity: level.to_string(),
                    scalar: scalar.name(),
                    input: Input {
                        attributes: vec![syn::parse_quote!(#[doc = #text])],
                        visibility: syn::parse_quote!(pub),
                        is_family: false,
                        name,
                        fields,
                    },
                });
            }
        }
    }
    Ok(members)
}

fn capitalised(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}
