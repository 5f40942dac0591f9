//! What sections are written in: `name: kind(end, end, option: value)`, or such a call for each index of a range.

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::quote;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::spanned::Spanned as _;
use syn::{Ident, LitInt, Token, braced, parenthesized};

/// One entry of a section.
pub(super) struct Entry {
    pub(super) name: Ident,
    /// Variable and bounds of `for i in 0..8 { ... }`.
    pub(super) range: Option<Range>,
    pub(super) call: Call,
}

/// `for i in start..end`
pub(super) struct Range {
    pub(super) variable: Ident,
    pub(super) start: usize,
    pub(super) end: usize,
    pub(super) span: Span,
}

impl Range {
    /// Number of indices.
    pub(super) fn len(&self) -> usize {
        self.end - self.start
    }

    /// Gives the variable its value for the `number`-th index.
    pub(super) fn bind(&self) -> TokenStream {
        let (variable, start) = (&self.variable, self.start);
        quote! { let #variable = #start + number; }
    }

    /// An array with what `one` says for each index.
    pub(super) fn array(&self, one: &TokenStream) -> TokenStream {
        let bind = self.bind();
        quote! { ::core::array::from_fn(|number| { #bind #one }) }
    }

    /// The name of each entry of this range.
    pub(super) fn names(&self, name: &Ident) -> Vec<String> {
        (self.start..self.end).map(|k| format!("{name}[{k}]")).collect()
    }
}

/// An array over the indices of a range, or one value.
pub(super) fn each(range: Option<&Range>, one: TokenStream) -> TokenStream {
    range.map_or_else(|| one.clone(), |range| range.array(&one))
}

/// The type of [`each`].
pub(super) fn each_type(range: Option<&Range>, one: TokenStream) -> TokenStream {
    match range {
        Some(range) => {
            let count = range.len();
            quote! { [#one; #count] }
        }
        None => one,
    }
}

/// The kind of force whose one argument is a function, commas and colons included.
pub(super) const USER: &str = "user";

/// `kind(argument, ..., option: value, ...)`
pub(super) struct Call {
    pub(super) kind: Ident,
    pub(super) arguments: Vec<Argument>,
    pub(super) options: Vec<CallOption>,
}

/// An argument without a name.
pub(super) struct Argument {
    pub(super) tokens: TokenStream,
    pub(super) span: Span,
}

/// `key: value`
pub(super) struct CallOption {
    pub(super) key: Ident,
    pub(super) value: TokenStream,
}

impl Call {
    /// The value of an option.
    pub(super) fn option(&self, key: &str) -> Option<&CallOption> {
        self.options.iter().find(|option| option.key == key)
    }

    /// Mistakes in the options: unknown ones, and those given twice.
    pub(super) fn check_options(&self, known: &[&str]) -> Vec<syn::Error> {
        let mut errors = Vec::new();
        for (position, option) in self.options.iter().enumerate() {
            if !known.iter().any(|key| option.key == key) {
                let expected = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
                let message = format!("`{}` has no option `{}`, expected: {expected}", self.kind, option.key);
                errors.push(syn::Error::new(option.key.span(), message));
            } else if self.options[..position].iter().any(|earlier| earlier.key == option.key) {
                errors.push(syn::Error::new(option.key.span(), format!("`{}` is given twice", option.key)));
            }
        }
        errors
    }

    /// The arguments, if there are as many as expected.
    pub(super) fn arguments<const N: usize>(&self, expected: &str) -> syn::Result<[&Argument; N]> {
        let all: Vec<&Argument> = self.arguments.iter().collect();
        let found = all.len();
        all.try_into().map_err(|_| {
            let message = format!("`{}` takes {expected}, found {found} in all", self.kind);
            syn::Error::new(self.kind.span(), message)
        })
    }
}

/// The entries of `{ ... }`.
pub(super) fn entries(tokens: TokenStream) -> syn::Result<Vec<Entry>> {
    braces(tokens, |input| Ok(Punctuated::<Entry, Token![,]>::parse_terminated(input)?.into_iter().collect()))
}

/// What stands in `{ ... }`.
pub(super) fn braces<T>(
    tokens: TokenStream,
    parse: impl FnOnce(ParseStream<'_>) -> syn::Result<T>,
) -> syn::Result<T> {
    let parser = |input: ParseStream<'_>| {
        let content;
        braced!(content in input);
        parse(&content)
    };
    syn::parse::Parser::parse2(parser, tokens)
}

impl Parse for Entry {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let name = input.parse()?;
        input.parse::<Token![:]>()?;
        if !input.peek(Token![for]) {
            return Ok(Self { name, range: None, call: input.parse()? });
        }
        let span = input.parse::<Token![for]>()?.span();
        let variable = input.parse()?;
        input.parse::<Token![in]>()?;
        let start = input.parse::<LitInt>()?.base10_parse()?;
        input.parse::<Token![..]>()?;
        let end = input.parse::<LitInt>()?.base10_parse()?;
        if end <= start {
            return Err(syn::Error::new(span, format!("the range {start}..{end} is empty")));
        }
        let content;
        braced!(content in input);
        let call = content.parse()?;
        if !content.is_empty() {
            return Err(content.error("expected one entry for each index"));
        }
        Ok(Self { name, range: Some(Range { variable, start, end, span }), call })
    }
}

impl Parse for Call {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let kind: Ident = input.parse()?;
        let content;
        parenthesized!(content in input);
        let (mut arguments, mut options) = (Vec::new(), Vec::new());
        if kind == USER && !content.is_empty() {
            let function: syn::Expr = content.parse()?;
            let span = function.span();
            arguments.push(Argument { tokens: quote! { #function }, span });
            if !content.is_empty() {
                content.parse::<Token![,]>()?;
            }
        }
        while !content.is_empty() {
            if content.peek(Ident) && content.peek2(Token![:]) && !content.peek2(Token![::]) {
                let key: Ident = content.parse()?;
                content.parse::<Token![:]>()?;
                let value = until_comma(&content)?;
                if value.is_empty() {
                    return Err(syn::Error::new(key.span(), format!("`{key}` has no value")));
                }
                options.push(CallOption { key, value });
            } else {
                let tokens = until_comma(&content)?;
                let span = tokens.clone().into_iter().next().map_or(kind.span(), |token| token.span());
                arguments.push(Argument { tokens, span });
            }
            if !content.is_empty() {
                content.parse::<Token![,]>()?;
            }
        }
        Ok(Self { kind, arguments, options })
    }
}

fn until_comma(input: ParseStream<'_>) -> syn::Result<TokenStream> {
    let mut tokens = TokenStream::new();
    while !input.is_empty() && !input.peek(Token![,]) {
        tokens.extend([input.parse::<TokenTree>()?]);
    }
    Ok(tokens)
}
