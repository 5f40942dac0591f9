//! Formulas in t: read once, evaluated with exact derivatives.

use num_dual::{Dual2_64, DualNum};
use thiserror::Error;

/// A formula in t.
#[derive(Debug, Clone, PartialEq)]
pub struct Formula(Term);

/// Why a formula cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("formula `{text}`: at character {at}: expected {expected}, found {found}")]
pub struct FormulaError {
    text: String,
    at: usize,
    expected: &'static str,
    found: String,
}

#[derive(Debug, Clone, PartialEq)]
enum Term {
    Number(f64),
    Time,
    Sum(Box<Term>, Box<Term>),
    Difference(Box<Term>, Box<Term>),
    Product(Box<Term>, Box<Term>),
    Quotient(Box<Term>, Box<Term>),
    Power(Box<Term>, Box<Term>),
    Negative(Box<Term>),
    Call(Function, Box<Term>),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Function {
    Sin,
    Cos,
    Tan,
    Exp,
    Ln,
    Sqrt,
    Tanh,
}

impl Function {
    const ALL: [(&'static str, Self); 7] = [
        ("sin", Self::Sin),
        ("cos", Self::Cos),
        ("tan", Self::Tan),
        ("exp", Self::Exp),
        ("ln", Self::Ln),
        ("sqrt", Self::Sqrt),
        ("tanh", Self::Tanh),
    ];
}

impl Formula {
    /// Reads a formula: numbers, `t`, `pi`, `+ - * / ^`, parentheses, sin, cos, tan, exp, ln, sqrt, tanh.
    pub fn parse(text: &str) -> Result<Self, FormulaError> {
        let mut reader = Reader { text, rest: text, depth: 0 };
        let term = reader.sum()?;
        reader.skip();
        if reader.rest.is_empty() { Ok(Self(term)) } else { Err(reader.error("an operator or the end")) }
    }

    /// Value, first and second derivative at `time`.
    pub fn at(&self, time: f64) -> [f64; 3] {
        let result = value(&self.0, Dual2_64::from_re(time).derivative());
        [result.re, result.v1, result.v2]
    }
}

fn value(term: &Term, t: Dual2_64) -> Dual2_64 {
    match term {
        Term::Number(number) => Dual2_64::from_re(*number),
        Term::Time => t,
        Term::Sum(a, b) => value(a, t) + value(b, t),
        Term::Difference(a, b) => value(a, t) - value(b, t),
        Term::Product(a, b) => value(a, t) * value(b, t),
        Term::Quotient(a, b) => value(a, t) / value(b, t),
        Term::Negative(a) => -value(a, t),
        Term::Power(a, b) => match **b {
            Term::Number(exponent) if exponent.fract() == 0.0 && exponent.abs() <= 64.0 => {
                value(a, t).powi(exponent as i32)
            }
            _ => (value(a, t).ln() * value(b, t)).exp(),
        },
        Term::Call(function, a) => {
            let a = value(a, t);
            match function {
                Function::Sin => a.sin(),
                Function::Cos => a.cos(),
                Function::Tan => a.tan(),
                Function::Exp => a.exp(),
                Function::Ln => a.ln(),
                Function::Sqrt => a.sqrt(),
                Function::Tanh => a.tanh(),
            }
        }
    }
}

/// Parentheses nested deeper than this are refused.
const DEEPEST: usize = 100;

struct Reader<'a> {
    text: &'a str,
    rest: &'a str,
    depth: usize,
}

impl Reader<'_> {
    fn skip(&mut self) {
        self.rest = self.rest.trim_start();
    }

    fn take(&mut self, symbol: char) -> bool {
        self.skip();
        match self.rest.strip_prefix(symbol) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn error(&self, expected: &'static str) -> FormulaError {
        let found =
            self.rest.chars().next().map_or("the end".to_owned(), |c| format!("`{}`", c.escape_default()));
        FormulaError {
            text: self.text.escape_debug().to_string(),
            at: self.text.len() - self.rest.len() + 1,
            expected,
            found,
        }
    }

    fn sum(&mut self) -> Result<Term, FormulaError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.error("fewer nested parentheses and signs"));
        }
        let mut left = self.product()?;
        loop {
            if self.take('+') {
                left = Term::Sum(Box::new(left), Box::new(self.product()?));
            } else if self.take('-') {
                left = Term::Difference(Box::new(left), Box::new(self.product()?));
            } else {
                self.depth -= 1;
                return Ok(left);
            }
        }
    }

    fn product(&mut self) -> Result<Term, FormulaError> {
        let mut left = self.sign()?;
        loop {
            if self.take('*') {
                left = Term::Product(Box::new(left), Box::new(self.sign()?));
            } else if self.take('/') {
                left = Term::Quotient(Box::new(left), Box::new(self.sign()?));
            } else {
                return Ok(left);
            }
        }
    }

    fn sign(&mut self) -> Result<Term, FormulaError> {
        if self.take('-') {
            self.depth += 1;
            if self.depth > DEEPEST {
                return Err(self.error("fewer nested parentheses and signs"));
            }
            let term = Term::Negative(Box::new(self.sign()?));
            self.depth -= 1;
            return Ok(term);
        }
        let base = self.atom()?;
        if self.take('^') {
            return Ok(Term::Power(Box::new(base), Box::new(self.sign()?)));
        }
        Ok(base)
    }

    fn atom(&mut self) -> Result<Term, FormulaError> {
        self.skip();
        if self.take('(') {
            let inner = self.sum()?;
            return if self.take(')') { Ok(inner) } else { Err(self.error("`)`")) };
        }
        let word: usize = self.rest.chars().take_while(|c| c.is_ascii_alphabetic()).map(char::len_utf8).sum();
        if word > 0 {
            let (name, rest) = self.rest.split_at(word);
            return self.named(name, rest);
        }
        let length = number_length(self.rest);
        let (number, rest) = self.rest.split_at(length);
        match number.parse::<f64>() {
            Ok(number) if number.is_finite() => {
                self.rest = rest;
                Ok(Term::Number(number))
            }
            _ => Err(self.error("a number, `t`, a function or `(`")),
        }
    }

    fn named(&mut self, name: &str, rest: &str) -> Result<Term, FormulaError> {
        let before = self.rest;
        // the text outlives the reader, and `rest` is a part of it
        let at = self.text.len() - rest.len();
        self.rest = self.text.get(at..).unwrap_or("");
        match name {
            "t" => return Ok(Term::Time),
            "pi" => return Ok(Term::Number(std::f64::consts::PI)),
            _ => {}
        }
        let Some((_, function)) = Function::ALL.iter().find(|(known, _)| *known == name) else {
            let at = self.text.len() - before.len();
            self.rest = self.text.get(at..).unwrap_or("");
            return Err(self.error("`t`, `pi` or one of sin, cos, tan, exp, ln, sqrt, tanh"));
        };
        if !self.take('(') {
            return Err(self.error("`(`"));
        }
        let argument = self.sum()?;
        if self.take(')') { Ok(Term::Call(*function, Box::new(argument))) } else { Err(self.error("`)`")) }
    }
}

/// Length of the number at the start: digits, a point, an exponent.
fn number_length(text: &str) -> usize {
    let mut previous = ' ';
    let digits = |c: char, previous: char| {
        c.is_ascii_digit()
            || c == '.'
            || matches!(c, 'e' | 'E')
            || (matches!(c, '+' | '-') && matches!(previous, 'e' | 'E'))
    };
    text.chars()
        .take_while(|c| {
            let part = digits(*c, previous);
            previous = *c;
            part
        })
        .map(char::len_utf8)
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_exact() {
        let formula = Formula::parse("0.4*(t - 1.6*sin(0.6*t)) + 2^t/(1e0 + t)^2 - -3").unwrap();
        let f = |t: f64| 0.4 * (t - 1.6 * (0.6 * t).sin()) + 2.0_f64.powf(t) / ((1.0 + t) * (1.0 + t)) + 3.0;
        let (t, h) = (0.7, 1e-4);
        let [value, rate, acceleration] = formula.at(t);
        assert!((value - f(t)).abs() < 1e-14);
        // centred differences: h² and ε / h, ε / h²
        assert!((rate - (f(t + h) - f(t - h)) / (2.0 * h)).abs() < 1e-7);
        assert!((acceleration - (f(t + h) - 2.0 * f(t) + f(t - h)) / (h * h)).abs() < 1e-6);
    }

    #[test]
    fn what_is_no_formula_is_refused_with_its_place() {
        for (text, at) in
            [("1 +", 4), ("sin t", 5), ("2*(t", 5), ("foo(t)", 1), ("1 2", 3), ("", 1), ("3..1", 1)]
        {
            let error = Formula::parse(text).unwrap_err();
            assert_eq!(error.at, at, "{error}");
        }
        assert!(Formula::parse(&"(".repeat(100_000)).is_err());
        assert!(Formula::parse(&"-".repeat(100_000)).is_err());
    }
}
