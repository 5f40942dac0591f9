//! Sums of products with twice the digits of `f64`.

/// A running sum in two parts, after Ogita, Rump & Oishi (2005), algorithm Dot2.
///
/// The result is as accurate as if every product and sum were formed with 106 bits and rounded once.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    /// Adds `a b`.
    pub(crate) fn add_product(&mut self, a: f64, b: f64) {
        let product = a * b;
        let product_error = a.mul_add(b, -product);
        let sum = self.high + product;
        let added = sum - self.high;
        let sum_error = (self.high - (sum - added)) + (product - added);
        self.high = sum;
        self.low += sum_error + product_error;
    }

    /// The sum, rounded once.
    pub(crate) fn value(&self) -> f64 {
        self.high + self.low
    }
}

/// Σ a b.
pub(crate) fn dot(pairs: impl Iterator<Item = (f64, f64)>) -> f64 {
    let mut sum = Sum::default();
    for (a, b) in pairs {
        sum.add_product(a, b);
    }
    sum.value()
}

#[cfg(test)]
mod tests {
    use super::dot;

    #[test]
    fn cancellation_costs_nothing() {
        let tiny = 1.0 / 3.0;
        assert_eq!(dot([(1e16, 1.0), (tiny, 1.0), (-1e8, 1e8)].into_iter()), tiny);
        // (1 + ε)² - 1 - 2 ε = ε².
        let epsilon = f64::EPSILON;
        let square = 1.0 + epsilon;
        assert_eq!(dot([(square, square), (-1.0, 1.0), (-2.0, epsilon)].into_iter()), epsilon * epsilon);
    }
}
