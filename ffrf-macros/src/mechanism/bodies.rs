//! The bodies of a mechanism and the markers that are used on them.

use proc_macro2::{Span, TokenStream};
use quote::quote;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Expr, Ident, LitInt, Token, Type, braced, bracketed};

use super::call::braces;
use super::scalar::Scalar;

/// The word for what does not move.
pub(super) const GROUND: &str = "ground";

/// One field of bodies: a body, or an array of equal ones.
pub(super) struct Body {
    pub(super) name: Ident,
    pub(super) nature: Nature,
    /// Number of equal bodies, if it is an array.
    pub(super) count: Option<usize>,
    /// Whether it may have no joint.
    pub(super) free: bool,
    /// Index of the first body of this field among all.
    pub(super) first: usize,
    /// The markers that something is attached to.
    pub(super) markers: Vec<UsedMarker>,
}

/// Where a body's numbers come from.
pub(super) enum Nature {
    /// A type that implements `FlexibleBody`, with modes.
    Flexible(Type),
    /// The same without modes.
    Rigid(Type),
    /// Numbers in the macro.
    Inline(Box<InlineBody>),
}

/// `rigid { mass: ..., ... }`
pub(super) struct InlineBody {
    mass: Expr,
    center_of_mass: Option<Expr>,
    inertia: Expr,
    markers: Vec<(Ident, Expr)>,
}

/// A marker that something is attached to.
#[derive(Clone)]
pub(super) enum UsedMarker {
    /// A constant of the body's type.
    Constant(Ident),
    /// A point on the rigid part of the body.
    Point(TokenStream),
}

impl UsedMarker {
    fn key(&self) -> String {
        match self {
            Self::Constant(name) => name.to_string(),
            Self::Point(position) => position.to_string(),
        }
    }
}

impl Body {
    /// Number of bodies in this field.
    pub(super) fn len(&self) -> usize {
        self.count.unwrap_or(1)
    }

    /// The name of each.
    pub(super) fn names(&self) -> Vec<String> {
        let name = &self.name;
        match self.count {
            None => vec![name.to_string()],
            Some(count) => (0..count).map(|index| format!("{name}[{index}]")).collect(),
        }
    }

    /// Whether joints on it are coupled through modes.
    pub(super) fn is_flexible(&self) -> bool {
        matches!(self.nature, Nature::Flexible(_))
    }

    /// The type of one body.
    pub(super) fn kind(&self, scalar: &Scalar) -> TokenStream {
        let t = scalar.name();
        match &self.nature {
            Nature::Flexible(kind) | Nature::Rigid(kind) => quote! { #kind },
            Nature::Inline(_) => quote! { ::ffrf::RigidBody<#t> },
        }
    }

    /// How many modes the type of one body has, as a constant expression.
    pub(super) fn mode_count(&self, scalar: Scalar) -> TokenStream {
        let (kind, t) = (self.kind(&scalar), scalar.of_constants());
        quote! {
            ::core::mem::size_of::<<#kind as ::ffrf::FlexibleBody<#t>>::Modal>() / ::core::mem::size_of::<#t>()
        }
    }

    /// The index of a marker among those used, which it joins.
    pub(super) fn use_marker(&mut self, marker: UsedMarker) -> usize {
        let key = marker.key();
        match self.markers.iter().position(|used| used.key() == key) {
            Some(index) => index,
            None => {
                self.markers.push(marker);
                self.markers.len() - 1
            }
        }
    }

    /// The marker of this name.
    pub(super) fn named(&self, name: &Ident) -> syn::Result<UsedMarker> {
        let Nature::Inline(inline) = &self.nature else { return Ok(UsedMarker::Constant(name.clone())) };
        match inline.markers.iter().find(|(known, _)| known == name) {
            Some((_, position)) => Ok(UsedMarker::Point(quote! { #position })),
            None => {
                let known: Vec<String> = inline.markers.iter().map(|(name, _)| name.to_string()).collect();
                let known = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
                let message = format!("body `{}` has no marker `{name}`; it has: {known}", self.name);
                Err(syn::Error::new(name.span(), message))
            }
        }
    }
}

impl InlineBody {
    /// The body as an expression.
    pub(super) fn expression(&self, scalar: &Scalar) -> TokenStream {
        let Self { mass, center_of_mass, inertia, .. } = self;
        let (mass, t) = (scalar.number(&quote! { #mass }), scalar.name());
        let center = match center_of_mass {
            Some(center) => scalar.vector(&quote! { #center }),
            None => quote! { ::ffrf::nalgebra::Vector3::<#t>::zeros() },
        };
        quote! {
            ::ffrf::RigidBody::<#t>::new(
                #mass,
                #center,
                ::ffrf::generated_support::mechanism::WrittenInertia::tensor::<#t>(#inertia),
            )
        }
    }
}

/// The bodies of `{ ... }`; each knows its index.
pub(super) fn bodies(tokens: TokenStream) -> syn::Result<Vec<Body>> {
    let mut bodies: Vec<Body> = braces(tokens, |input| {
        Ok(Punctuated::<Body, Token![,]>::parse_terminated(input)?.into_iter().collect())
    })?;
    let mut next = 0;
    for body in &mut bodies {
        body.first = next;
        next += body.len();
    }
    Ok(bodies)
}

impl Parse for Body {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let name: Ident = input.parse()?;
        input.parse::<Token![:]>()?;
        let free = word(input, "free")?;
        let (nature, count) = if input.peek(syn::token::Bracket) {
            let content;
            bracketed!(content in input);
            let nature = content.parse()?;
            content.parse::<Token![;]>()?;
            let count: LitInt = content.parse()?;
            if !content.is_empty() {
                return Err(content.error("expected `[Type; count]`"));
            }
            match count.base10_parse()? {
                0 => return Err(syn::Error::new(count.span(), "expected at least one body")),
                number => (nature, Some(number)),
            }
        } else {
            (input.parse()?, None)
        };
        Ok(Self { name, nature, count, free, first: 0, markers: Vec::new() })
    }
}

impl Parse for Nature {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        if !word(input, "rigid")? {
            return input.parse().map(Self::Flexible);
        }
        if !input.peek(syn::token::Brace) {
            return input.parse().map(Self::Rigid);
        }
        let content;
        let braces = braced!(content in input);
        inline(&content, braces.span.join()).map(|body| Self::Inline(Box::new(body)))
    }
}

fn inline(input: ParseStream<'_>, span: Span) -> syn::Result<InlineBody> {
    let (mut mass, mut center_of_mass, mut inertia, mut markers) = (None, None, None, None);
    while !input.is_empty() {
        let key: Ident = input.parse()?;
        input.parse::<Token![:]>()?;
        let twice = match key.to_string().as_str() {
            "mass" => mass.replace(input.parse()?).is_some(),
            "center_of_mass" => center_of_mass.replace(input.parse()?).is_some(),
            "inertia" => inertia.replace(input.parse()?).is_some(),
            "markers" => {
                let content;
                braced!(content in input);
                let all = Punctuated::<NamedPoint, Token![,]>::parse_terminated(&content)?;
                markers.replace(all.into_iter().map(|point| (point.name, point.position)).collect()).is_some()
            }
            _ => {
                let message =
                    format!("unknown key `{key}`, expected one of: mass, center_of_mass, inertia, markers");
                return Err(syn::Error::new(key.span(), message));
            }
        };
        if twice {
            return Err(syn::Error::new(key.span(), format!("`{key}` is given twice")));
        }
        if !input.is_empty() {
            input.parse::<Token![,]>()?;
        }
    }
    let missing = |what: &str| syn::Error::new(span, format!("a rigid body needs `{what}`"));
    Ok(InlineBody {
        mass: mass.ok_or_else(|| missing("mass"))?,
        center_of_mass,
        inertia: inertia.ok_or_else(|| missing("inertia"))?,
        markers: markers.unwrap_or_default(),
    })
}

struct NamedPoint {
    name: Ident,
    position: Expr,
}

impl Parse for NamedPoint {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let name = input.parse()?;
        input.parse::<Token![:]>()?;
        Ok(Self { name, position: input.parse()? })
    }
}

/// Takes `word` if it stands here and something of the same entry follows.
fn word(input: ParseStream<'_>, word: &str) -> syn::Result<bool> {
    let found = input.fork().parse::<Ident>().is_ok_and(|ident| ident == word)
        && !(input.peek2(Token![,]) || input.peek2(Token![::]) || input.peek2(Token![;]));
    if found {
        input.parse::<Ident>()?;
    }
    Ok(found)
}
