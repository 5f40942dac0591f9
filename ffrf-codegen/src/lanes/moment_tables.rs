//! The moments T_νμ in the order in which the loops read them.

use super::table::Table;
use crate::ScalarType;
use crate::expression::{Expression, Graph};

/// Largest table of all moments, in bytes, that is stored whole: with coordinates and results it stays in a
/// first-level cache of 32 KB. Larger ones are stored by half.
const LARGEST_WHOLE_TABLE: usize = 24 * 1024;

/// The moments T_νμ in eight components: yy, zz, xy + yx, xz + zx, yz + zy, then ϑ_νμ (3).
#[derive(Debug, Clone, PartialEq)]
pub enum MomentTables<V = f64> {
    /// No moment is left.
    None,
    /// All of them.
    Whole {
        /// Pairs of groups. Shape: pairs, modes ν, components, lanes μ (8).
        eights: Table<V>,
        /// The last group, if their number is odd. Shape: 0 or 1, modes ν, components, lanes μ (4).
        fours: Table<V>,
    },
    /// Half of them, in blocks; diagonal k of a block holds row r and column (r + k) mod width.
    Half {
        /// Blocks on the diagonal. Shape: rows of blocks, components, width, width.
        diagonal: Table<V>,
        /// Components of the blocks below it, in the order of use. Shape: tiles, width, width.
        below: Table<V>,
    },
}

impl<V> MomentTables<V> {
    /// The tables of `at(component, mu, nu)`, which is zero outside the modes.
    pub(super) fn new(
        modes: usize,
        scalar: ScalarType,
        is_empty: bool,
        at: impl Fn(usize, usize, usize) -> V,
    ) -> Self {
        let groups = modes.div_ceil(4);
        if is_empty {
            Self::None
        } else if 32 * groups * modes * scalar.bytes() <= LARGEST_WHOLE_TABLE {
            let (pairs, single) = (groups / 2, groups % 2);
            Self::Whole {
                eights: Table::new([pairs, modes, 8, 8], |[pair, nu, c, lane]| at(c, 8 * pair + lane, nu)),
                fours: Table::new([single, modes, 8, 4], |[_, nu, c, lane]| at(c, 8 * pairs + lane, nu)),
            }
        } else {
            // A register of 32 bytes is the widest that every current x86-64 processor works on at full rate.
            Self::by_half(modes, 32 / scalar.bytes(), at)
        }
    }

    fn by_half(modes: usize, width: usize, at: impl Fn(usize, usize, usize) -> V) -> Self {
        let rows = modes.div_ceil(width);
        let entry = |component, block_row: usize, block_column: usize, diagonal: usize, row: usize| {
            at(component, width * block_row + row, width * block_column + (row + diagonal) % width)
        };
        let mut tiles = Vec::with_capacity(4 * rows * rows.saturating_sub(1));
        for column in 0..rows {
            for components in [0..2, 2..4, 4..5, 5..6, 6..7, 7..8] {
                for block_row in column + 1..rows {
                    tiles.extend(components.clone().map(|component| (component, block_row, column)));
                }
            }
        }
        Self::Half {
            diagonal: Table::new([rows, 8, width, width], |[h, component, diagonal, row]| {
                entry(component, h, h, diagonal, row)
            }),
            below: Table::new([tiles.len(), width, width], |[tile, diagonal, row]| {
                let (component, block_row, block_column) = tiles[tile];
                entry(component, block_row, block_column, diagonal, row)
            }),
        }
    }

    /// Groups of four lanes for this many modes.
    pub(super) fn groups(&self, modes: usize) -> usize {
        match self {
            Self::Half { diagonal, .. } => match diagonal.shape() {
                [rows, _, width, _] => rows * width / 4,
                _ => 0,
            },
            _ => modes.div_ceil(4),
        }
    }

    /// Bytes of all numbers.
    pub(super) fn bytes(&self, scalar: ScalarType) -> usize {
        let numbers = match self {
            Self::None => 0,
            Self::Whole { eights: first, fours: second } | Self::Half { diagonal: first, below: second } => {
                first.entries().len() + second.entries().len()
            }
        };
        numbers * scalar.bytes()
    }

    /// In words, for the banner.
    pub(super) fn description(&self, scalar: ScalarType) -> String {
        let bytes = self.bytes(scalar);
        match self {
            Self::None => "no moments of pairs of modes".to_owned(),
            Self::Whole { .. } => format!("whole table of moments, {bytes} bytes"),
            Self::Half { below, .. } => {
                let width = below.shape().last().copied().unwrap_or(0);
                format!("table of moments by half in blocks of {width} x {width}, {bytes} bytes")
            }
        }
    }
}

impl MomentTables<Expression> {
    pub(super) fn numbers(&self, graph: &Graph) -> MomentTables {
        match self {
            Self::None => MomentTables::None,
            Self::Whole { eights, fours } => {
                MomentTables::Whole { eights: eights.numbers(graph), fours: fours.numbers(graph) }
            }
            Self::Half { diagonal, below } => {
                MomentTables::Half { diagonal: diagonal.numbers(graph), below: below.numbers(graph) }
            }
        }
    }
}
