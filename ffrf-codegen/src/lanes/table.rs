//! Numbers in nested arrays.

/// Numbers in nested arrays of a fixed shape, the last index fastest: what a `static` of the generated code holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    shape: Vec<usize>,
    entries: Vec<f64>,
}

impl Table {
    /// The table with the entry `at(index)` for every index within `shape`.
    pub(crate) fn new<const D: usize>(shape: [usize; D], at: impl Fn([usize; D]) -> f64) -> Self {
        let count = shape.iter().product();
        let mut entries = Vec::with_capacity(count);
        let mut index = [0; D];
        for _ in 0..count {
            entries.push(at(index));
            for axis in (0..D).rev() {
                index[axis] += 1;
                if index[axis] < shape[axis] {
                    break;
                }
                index[axis] = 0;
            }
        }
        Self { shape: shape.to_vec(), entries }
    }

    /// The lengths of the arrays, the outermost first.
    pub fn shape(&self) -> &[usize] {
        &self.shape
    }

    /// All numbers, those of an innermost array side by side.
    pub fn entries(&self) -> &[f64] {
        &self.entries
    }
}

#[cfg(test)]
mod tests {
    use super::Table;

    #[test]
    fn the_last_index_is_fastest() {
        let table = Table::new([2, 1, 3], |[i, j, k]| (100 * i + 10 * j + k) as f64);
        assert_eq!(table.entries(), [0.0, 1.0, 2.0, 100.0, 101.0, 102.0]);
        assert_eq!(table.shape(), [2, 1, 3]);
        assert!(Table::new([0, 4], |_| 1.0).entries().is_empty());
    }
}
