//! Indices of bodies: sums, differences, products and quotients of numbers and the variable of a range.

use syn::{BinOp, Expr, Ident, Lit, UnOp};

/// The value of an index where `variable` has a value.
pub(super) fn evaluate(expression: &Expr, variable: Option<(&Ident, i64)>) -> syn::Result<i64> {
    let refuse = |message: &str| Err(syn::Error::new_spanned(expression, message));
    match expression {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(number) => number.base10_parse(),
            _ => refuse("an index is a whole number"),
        },
        Expr::Paren(inner) => evaluate(&inner.expr, variable),
        Expr::Group(inner) => evaluate(&inner.expr, variable),
        Expr::Path(path) => match variable {
            Some((name, value)) if path.path.is_ident(name) => Ok(value),
            Some((name, _)) => refuse(&format!("the one variable here is `{name}`")),
            None => refuse("an index is a number; variables come from `for i in 0..8 { ... }`"),
        },
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => Ok(-evaluate(&unary.expr, variable)?),
        Expr::Binary(binary) => {
            let (left, right) = (evaluate(&binary.left, variable)?, evaluate(&binary.right, variable)?);
            let value = match binary.op {
                BinOp::Add(_) => left.checked_add(right),
                BinOp::Sub(_) => left.checked_sub(right),
                BinOp::Mul(_) => left.checked_mul(right),
                BinOp::Div(_) => left.checked_div(right),
                BinOp::Rem(_) => left.checked_rem(right),
                _ => return refuse("an index is made of `+`, `-`, `*`, `/` and `%`"),
            };
            value.map_or_else(|| refuse("this index has no value"), Ok)
        }
        _ => refuse("an index is made of whole numbers, `+`, `-`, `*`, `/`, `%` and the variable of `for`"),
    }
}
