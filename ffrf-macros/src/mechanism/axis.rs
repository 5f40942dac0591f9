//! Axes of joints and force elements: `x`, `y`, `z`, `-x`, `[a, b, c]`, or a pair of them for both ends.

use proc_macro2::TokenStream;
use quote::quote;
use syn::spanned::Spanned;
use syn::{Expr, UnOp};

use super::call::Call;
use super::scalar::Scalar;

/// The axis in the frame of each end.
pub(super) struct Axes {
    first: Option<TokenStream>,
    second: Option<TokenStream>,
    /// Whether the second axis is at right angles to the first: by default along x of the first triad.
    crossed: bool,
}

impl Axes {
    /// The option `axis` of a call; z without it.
    pub(super) fn of(call: &Call, crossed: bool) -> syn::Result<Self> {
        let Some(option) = call.option("axis") else {
            return Ok(Self { first: None, second: None, crossed });
        };
        let expression = syn::parse2::<Expr>(option.value.clone()).map_err(|_| expected(&option.value))?;
        match &expression {
            Expr::Tuple(pair) => match pair.elems.iter().collect::<Vec<_>>().as_slice() {
                [first, second] => {
                    Ok(Self { first: Some(axis(first)?), second: Some(axis(second)?), crossed })
                }
                _ => Err(expected(&option.value)),
            },
            one => Ok(Self { first: Some(axis(one)?), second: None, crossed }),
        }
    }

    /// Whether there are triads to turn at all.
    fn orientation(axis: Option<&TokenStream>, scalar: &Scalar) -> TokenStream {
        let t = scalar.name();
        match axis {
            None => quote! { ::ffrf::nalgebra::UnitQuaternion::<#t>::identity() },
            Some(axis) => {
                let vector = scalar.vector(axis);
                quote! { ::ffrf::mechanism::along_axis::<#t>(&#vector) }
            }
        }
    }

    /// The orientations of both triads as expressions.
    pub(super) fn orientations(&self, scalar: &Scalar) -> [TokenStream; 2] {
        let first = Self::orientation(self.first.as_ref(), scalar);
        let second = match (&self.second, self.crossed) {
            (Some(second), _) => Self::orientation(Some(second), scalar),
            (None, false) => first.clone(),
            // z along what is x of the first triad
            (None, true) => quote! { ::ffrf::generated_support::mechanism::crossed(&#first) },
        };
        [first, second]
    }
}

fn axis(expression: &Expr) -> syn::Result<TokenStream> {
    let unit = |name: &Expr, size: f64| {
        let Expr::Path(path) = name else { return None };
        let place = ["x", "y", "z"].iter().position(|axis| path.path.is_ident(axis))?;
        let mut unit = [0.0; 3];
        unit[place] = size;
        let [x, y, z] = unit;
        Some(quote! { [#x, #y, #z] })
    };
    match expression {
        Expr::Array(array) if array.elems.len() == 3 => Ok(quote! { #array }),
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
            unit(&unary.expr, -1.0).ok_or_else(|| expected(&quote! { #expression }))
        }
        one => unit(one, 1.0).ok_or_else(|| expected(&quote! { #expression })),
    }
}

fn expected(found: &TokenStream) -> syn::Error {
    let message = format!(
        "`axis` must be x, y, z, -x, -y, -z, three components `[a, b, c]`, or a pair `(axis, axis)` for both ends, found `{found}`"
    );
    syn::Error::new(found.span(), message)
}
