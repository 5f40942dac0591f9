//! Block L D Lᵀ of the equations of a mechanism, in an order and with a pattern that are known beforehand.
//!
//! The unknowns are grouped in nodes: the six accelerations of each body's frame, the multipliers of each joint. The
//! matrix [Z Yᵀ; Y -E] is quasi-definite, so it has factors in every order in which a joint follows one of its bodies,
//! without pivoting; which order costs least is decided when the mechanism is composed
//! (R. J. Vanderbei, Symmetric quasidefinite matrices, SIAM J. Optim. 5 (1995) 100-113;
//! D. Baraff, Linear-time dynamics using Lagrange multipliers, SIGGRAPH 1996).

use nalgebra::RealField;

/// The largest node: six accelerations or six rows.
pub const LARGEST_NODE: usize = 6;

/// A node in the order of elimination.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    /// Number of unknowns.
    pub size: usize,
    /// Where its unknowns begin in a vector of all.
    pub unknowns: usize,
    /// Where its diagonal block begins among the values, row by row.
    pub diagonal: usize,
    /// First of its couplings.
    pub couplings: usize,
    /// First of its targets: one for each pair of couplings p >= q, in the order (0, 0), (1, 0), (1, 1), (2, 0), ...
    pub targets: usize,
}

/// A node that is eliminated later and coupled to a node that is eliminated now.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Coupling {
    /// Number of unknowns of the later node.
    pub size: usize,
    /// Where the unknowns of the later node begin in a vector of all.
    pub unknowns: usize,
    /// Where the block begins among the values: rows of the later node, columns of the one eliminated now, row by row.
    pub block: usize,
}

/// The order of elimination with all places, made once for a mechanism.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Elimination<'a> {
    /// The nodes in their order.
    pub steps: &'a [Step],
    /// The couplings of each node, in the order of elimination of the later nodes.
    pub couplings: &'a [Coupling],
    /// Where the blocks of each pair of couplings begin.
    pub targets: &'a [usize],
}

impl<'a> Elimination<'a> {
    fn couplings_of(&self, index: usize, step: &Step) -> &'a [Coupling] {
        let end = self.steps.get(index + 1).map_or(self.couplings.len(), |next| next.couplings);
        self.couplings.get(step.couplings..end).unwrap_or(&[])
    }

    /// Factors the matrix in place: its lower triangle becomes L, its diagonal D.
    ///
    /// Returns the smallest |pivot| over the largest of its block's diagonal before elimination, the digits lost there.
    /// `None` if a pivot is zero or not finite.
    pub fn factor<T: RealField + Copy>(&self, values: &mut [T]) -> Option<T> {
        let mut smallest = T::one();
        for (index, step) in self.steps.iter().enumerate() {
            let n = step.size;
            let mut block = [T::zero(); LARGEST_NODE * LARGEST_NODE];
            read(values, step.diagonal, &mut block, n * n);
            smallest = smallest.min(factor_block(&mut block, n)?);
            write(values, step.diagonal, &block, n * n);
            let couplings = self.couplings_of(index, step);
            // U = A L⁻ᵀ
            for coupling in couplings {
                let rows = values.get_mut(coupling.block..coupling.block + coupling.size * n)?;
                for row in rows.chunks_exact_mut(n) {
                    for j in 0..n {
                        let mut sum = *row.get(j)?;
                        for k in 0..j {
                            sum -= *row.get(k)? * *block.get(n * j + k)?;
                        }
                        *row.get_mut(j)? = sum;
                    }
                }
            }
            let mut target = step.targets;
            for (p, left) in couplings.iter().enumerate() {
                let mut upper = [T::zero(); LARGEST_NODE * LARGEST_NODE];
                read(values, left.block, &mut upper, left.size * n);
                // X = U D⁻¹, which is L
                for row in upper.chunks_exact_mut(n).take(left.size) {
                    for (j, entry) in row.iter_mut().enumerate() {
                        *entry /= *block.get((n + 1) * j)?;
                    }
                }
                for right in couplings.iter().take(p + 1) {
                    let mut other = [T::zero(); LARGEST_NODE * LARGEST_NODE];
                    read(values, right.block, &mut other, right.size * n);
                    let place = *self.targets.get(target)?;
                    target += 1;
                    let place = values.get_mut(place..place + left.size * right.size)?;
                    for (place, left) in place.chunks_exact_mut(right.size).zip(upper.chunks_exact(n)) {
                        for (entry, right) in place.iter_mut().zip(other.chunks_exact(n)) {
                            *entry -= product(left, right);
                        }
                    }
                }
            }
            for coupling in couplings {
                let rows = values.get_mut(coupling.block..coupling.block + coupling.size * n)?;
                for row in rows.chunks_exact_mut(n) {
                    for (j, entry) in row.iter_mut().enumerate() {
                        *entry /= *block.get((n + 1) * j)?;
                    }
                }
            }
        }
        Some(smallest)
    }

    /// Solves the factored system in place.
    pub fn solve<T: RealField + Copy>(&self, values: &[T], unknowns: &mut [T]) {
        for (index, step) in self.steps.iter().enumerate() {
            let n = step.size;
            let mut own = [T::zero(); LARGEST_NODE];
            read(unknowns, step.unknowns, &mut own, n);
            let lower = values.get(step.diagonal..).unwrap_or(&[]);
            for (i, row) in lower.chunks_exact(n).take(n).enumerate() {
                let known = product(row.get(..i).unwrap_or(&[]), &own);
                if let Some(entry) = own.get_mut(i) {
                    *entry -= known;
                }
            }
            write(unknowns, step.unknowns, &own, n);
            for coupling in self.couplings_of(index, step) {
                let rows = values.get(coupling.block..coupling.block + coupling.size * n).unwrap_or(&[]);
                let later = unknowns.get_mut(coupling.unknowns..).unwrap_or(&mut []);
                for (entry, row) in later.iter_mut().zip(rows.chunks_exact(n)) {
                    *entry -= product(row, &own);
                }
            }
        }
        for (index, step) in self.steps.iter().enumerate().rev() {
            let n = step.size;
            let mut own = [T::zero(); LARGEST_NODE];
            read(unknowns, step.unknowns, &mut own, n);
            let lower = values.get(step.diagonal..).unwrap_or(&[]);
            for (i, (row, entry)) in lower.chunks_exact(n).zip(own.iter_mut()).take(n).enumerate() {
                if let Some(pivot) = row.get(i) {
                    *entry /= *pivot;
                }
            }
            for coupling in self.couplings_of(index, step) {
                let rows = values.get(coupling.block..coupling.block + coupling.size * n).unwrap_or(&[]);
                let later = unknowns.get(coupling.unknowns..).unwrap_or(&[]);
                for (known, row) in later.iter().zip(rows.chunks_exact(n)) {
                    for (entry, factor) in own.iter_mut().zip(row) {
                        *entry -= *factor * *known;
                    }
                }
            }
            for (i, row) in lower.chunks_exact(n).take(n).enumerate().rev() {
                let known = own.get(i).copied().unwrap_or(T::zero());
                for (entry, factor) in own.iter_mut().zip(row).take(i) {
                    *entry -= *factor * known;
                }
            }
            write(unknowns, step.unknowns, &own, n);
        }
    }
}

impl Elimination<'_> {
    /// Subtracts the product of a matrix that is not factored with `unknowns` from `right`.
    pub fn subtract_product<T: RealField + Copy>(&self, matrix: &[T], unknowns: &[T], right: &mut [T]) {
        for (index, step) in self.steps.iter().enumerate() {
            let n = step.size;
            let mut own = [T::zero(); LARGEST_NODE];
            read(unknowns, step.unknowns, &mut own, n);
            let mut left = [T::zero(); LARGEST_NODE];
            read(right, step.unknowns, &mut left, n);
            let diagonal = matrix.get(step.diagonal..).unwrap_or(&[]);
            for (entry, row) in left.iter_mut().zip(diagonal.chunks_exact(n).take(n)) {
                *entry -= product(row, &own);
            }
            for coupling in self.couplings_of(index, step) {
                let rows = matrix.get(coupling.block..coupling.block + coupling.size * n).unwrap_or(&[]);
                let others = unknowns.get(coupling.unknowns..).unwrap_or(&[]);
                let later = right.get_mut(coupling.unknowns..).unwrap_or(&mut []);
                for ((row, other), entry) in rows.chunks_exact(n).zip(others).zip(later) {
                    *entry -= product(row, &own);
                    for (entry, factor) in left.iter_mut().zip(row) {
                        *entry -= *factor * *other;
                    }
                }
            }
            write(right, step.unknowns, &left, n);
        }
    }
}

/// L D Lᵀ of the leading n x n block, row by row; the smallest |pivot| relative to the diagonal entry it came from.
fn factor_block<T: RealField + Copy>(block: &mut [T], n: usize) -> Option<T> {
    let mut smallest = T::one();
    for j in 0..n {
        let diagonal = *block.get((n + 1) * j)?;
        let mut pivot = diagonal;
        for k in 0..j {
            let factor = *block.get(n * j + k)?;
            pivot -= factor * factor * *block.get((n + 1) * k)?;
        }
        if pivot == T::zero() || !pivot.is_finite() {
            return None;
        }
        smallest = smallest.min((pivot / diagonal).abs());
        *block.get_mut((n + 1) * j)? = pivot;
        for i in j + 1..n {
            let mut entry = *block.get(n * i + j)?;
            for k in 0..j {
                entry -= *block.get(n * i + k)? * *block.get(n * j + k)? * *block.get((n + 1) * k)?;
            }
            *block.get_mut(n * i + j)? = entry / pivot;
        }
    }
    Some(smallest)
}

fn product<T: RealField + Copy>(left: &[T], right: &[T]) -> T {
    left.iter().zip(right).fold(T::zero(), |sum, (left, right)| sum + *left * *right)
}

fn read<T: Copy>(from: &[T], start: usize, to: &mut [T], count: usize) {
    let from = from.get(start..).unwrap_or(&[]);
    for (place, value) in to.iter_mut().zip(from).take(count) {
        *place = *value;
    }
}

fn write<T: Copy>(to: &mut [T], start: usize, from: &[T], count: usize) {
    let to = to.get_mut(start..).unwrap_or(&mut []);
    for (place, value) in to.iter_mut().zip(from).take(count) {
        *place = *value;
    }
}
