//! The structures that an invariant can have.

/// What is known about the entries of an invariant.
///
/// For a list of 3 x 3 matrices (T_μ, T_μν) the structure is that of every matrix of the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Structure {
    /// Every entry is zero.
    Zero,
    /// One on the diagonal, zero elsewhere.
    Identity,
    /// Zero off the diagonal.
    Diagonal,
    /// Equal to its transpose.
    Symmetric,
    /// Minus its transpose.
    Antisymmetric,
    /// Nothing is known.
    Dense,
}

impl Structure {
    /// Every structure, from the most special to the most general.
    pub const ALL: [Self; 6] =
        [Self::Zero, Self::Identity, Self::Diagonal, Self::Symmetric, Self::Antisymmetric, Self::Dense];

    /// The name by which the macro and the command line know the structure.
    pub fn name(self) -> &'static str {
        match self {
            Self::Zero => "zero",
            Self::Identity => "identity",
            Self::Diagonal => "diagonal",
            Self::Symmetric => "symmetric",
            Self::Antisymmetric => "antisymmetric",
            Self::Dense => "dense",
        }
    }

    /// The structure of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|structure| structure.name() == name)
    }

    /// The most special structure that holds for all entries of a square matrix.
    ///
    /// `is_zero(i, j, value)` says whether a value counts as zero in that place.
    pub fn of_matrix(
        size: usize,
        entry: impl Fn(usize, usize) -> f64,
        is_zero: impl Fn(usize, usize, f64) -> bool,
    ) -> Self {
        let pairs = || (0..size).flat_map(move |i| (0..size).map(move |j| (i, j)));
        let off = || pairs().filter(|(i, j)| i != j);
        if pairs().all(|(i, j)| is_zero(i, j, entry(i, j))) {
            return Self::Zero;
        }
        if off().all(|(i, j)| is_zero(i, j, entry(i, j))) {
            let unit = (0..size).all(|i| is_zero(i, i, entry(i, i) - 1.0));
            return if unit { Self::Identity } else { Self::Diagonal };
        }
        if off().all(|(i, j)| is_zero(i, j, entry(i, j) - entry(j, i))) {
            return Self::Symmetric;
        }
        if pairs().all(|(i, j)| is_zero(i, j, entry(i, j) + entry(j, i))) {
            return Self::Antisymmetric;
        }
        Self::Dense
    }

    /// The most special structure that both have.
    pub fn join(self, other: Self) -> Self {
        use Structure as S;
        match (self, other) {
            (a, b) if a == b => a,
            (S::Zero, b) if b != S::Identity => b,
            (a, S::Zero) if a != S::Identity => a,
            (S::Antisymmetric | S::Dense, _) | (_, S::Antisymmetric | S::Dense) => S::Dense,
            (S::Symmetric, _) | (_, S::Symmetric) => S::Symmetric,
            _ => S::Diagonal,
        }
    }
}

impl core::fmt::Display for Structure {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::Structure as S;

    fn of(rows: [[f64; 3]; 3]) -> S {
        S::of_matrix(3, |i, j| rows[i][j], |_, _, value| value == 0.0)
    }

    #[test]
    fn the_most_special_structure_is_found() {
        assert_eq!(of([[0.0; 3]; 3]), S::Zero);
        assert_eq!(of([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]), S::Identity);
        assert_eq!(of([[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 0.0]]), S::Diagonal);
        assert_eq!(of([[1.0, 5.0, 0.0], [5.0, 2.0, 0.0], [0.0, 0.0, 0.0]]), S::Symmetric);
        assert_eq!(of([[0.0, 5.0, 0.0], [-5.0, 0.0, 1.0], [0.0, -1.0, 0.0]]), S::Antisymmetric);
        assert_eq!(of([[1.0, 5.0, 0.0], [-5.0, 0.0, 1.0], [0.0, -1.0, 0.0]]), S::Dense);
    }

    #[test]
    fn join_is_symmetric_and_covers_both() {
        for a in S::ALL {
            assert_eq!(a.join(a), a);
            assert_eq!(a.join(S::Dense), S::Dense);
            for b in S::ALL {
                assert_eq!(a.join(b), b.join(a), "{a} and {b}");
            }
        }
        assert_eq!(S::Zero.join(S::Antisymmetric), S::Antisymmetric);
        assert_eq!(S::Zero.join(S::Identity), S::Diagonal);
        assert_eq!(S::Diagonal.join(S::Symmetric), S::Symmetric);
    }

    #[test]
    fn names_round_trip() {
        for structure in S::ALL {
            assert_eq!(S::from_name(structure.name()), Some(structure));
        }
    }
}
