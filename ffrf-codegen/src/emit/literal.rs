//! Constants as Rust literals: the shortest text that reads back to the same bits.

use crate::ScalarType;

/// The literal of a finite number, with its sign.
pub(crate) fn literal(value: f64, scalar: ScalarType) -> String {
    match scalar {
        ScalarType::F64 | ScalarType::Generic => format!("{value:?}"),
        ScalarType::F32 => format!("{:?}", value as f32),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_read_back_to_the_same_bits() {
        for value in [0.1, -1.0 / 3.0, 1e-300, f64::MAX, 5e-324, 1e16, -2.5] {
            let text = literal(value, ScalarType::F64);
            assert_eq!(text.parse::<f64>().unwrap().to_bits(), value.to_bits(), "{text}");
            assert!(text.contains(['.', 'e']), "{text} would be an integer");
        }
        assert_eq!(literal(0.1, ScalarType::F32), "0.1");
        assert_eq!(literal(1.0 / 3.0, ScalarType::F32), "0.33333334");
    }
}
