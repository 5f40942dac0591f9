//! The number type of a mechanism.

use proc_macro2::TokenStream;
use quote::quote;

/// The number type of a mechanism.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Scalar {
    F64,
    F32,
    Generic,
}

impl Scalar {
    /// The type.
    pub(super) fn name(self) -> TokenStream {
        match self {
            Self::F64 => quote! { f64 },
            Self::F32 => quote! { f32 },
            Self::Generic => quote! { T },
        }
    }

    /// A type that can stand in constants: of a generic mechanism the number type of its constants.
    pub(super) fn of_constants(self) -> TokenStream {
        if self == Self::F32 {
            quote! { f32 }
        } else {
            quote! { f64 }
        }
    }

    /// Parameters where a type is declared.
    pub(super) fn declared(self) -> TokenStream {
        match self {
            Self::Generic => quote! { <T: ::ffrf::generated_support::Number = f64> },
            _ => TokenStream::new(),
        }
    }

    /// Parameters after `impl`.
    pub(super) fn bound(self) -> TokenStream {
        match self {
            Self::Generic => quote! { <T: ::ffrf::generated_support::Number> },
            _ => TokenStream::new(),
        }
    }

    /// Arguments where a type is used.
    pub(super) fn used(self) -> TokenStream {
        match self {
            Self::Generic => quote! { <T> },
            _ => TokenStream::new(),
        }
    }

    /// Arguments of the type in double precision, for sizes.
    pub(super) fn in_double(self) -> TokenStream {
        match self {
            Self::Generic => quote! { ::<f64> },
            _ => TokenStream::new(),
        }
    }

    /// An f64 in this type.
    pub(super) fn number(self, value: &TokenStream) -> TokenStream {
        let t = self.name();
        quote! { ::ffrf::generated_support::constant::<#t>(#value) }
    }

    /// Three f64 in this type.
    pub(super) fn vector(self, value: &TokenStream) -> TokenStream {
        let t = self.name();
        quote! { ::ffrf::generated_support::mechanism::vector3::<#t>(#value) }
    }
}
