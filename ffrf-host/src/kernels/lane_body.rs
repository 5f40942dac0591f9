//! Tables as the loops of the runtime want them.

use ffrf_codegen::lanes::{LaneTables, ModalFactors, ModalMatrix, MomentTables, Table};
use ffrf_runtime::lanes::{self, Factors, FullTable, HalfTable, LaneBody};

/// From entries `V` of tables to constants `C` of the loops.
///
/// The loops hold their tables for the rest of the program, as generated code does in its `static`s: one body is
/// read per run, and its memory is never given back.
pub struct Bodies<C, F> {
    /// What padding holds.
    pub zero: C,
    /// The constant of an entry.
    pub constant: F,
}

impl<C: Copy + 'static, F> Bodies<C, F> {
    fn fill<V: Copy>(&self, places: &mut [C], entries: &[V])
    where
        F: Fn(V) -> C,
    {
        for (place, entry) in places.iter_mut().zip(entries) {
            *place = (self.constant)(*entry);
        }
    }

    /// All moments, for tables of up to `M` modes; zero for other kinds of tables.
    pub fn whole<V: Copy, const M: usize, const PAIRS: usize, const SINGLE: usize>(
        &self,
        tables: &LaneTables<V>,
    ) -> FullTable<C, M, PAIRS, SINGLE>
    where
        F: Fn(V) -> C,
    {
        let mut moments = FullTable {
            eights: [[[[self.zero; 8]; 8]; M]; PAIRS],
            fours: [[[[self.zero; 4]; 8]; M]; SINGLE],
        };
        if let MomentTables::Whole { eights, fours } = &tables.moments {
            // The rows of a group end with the last mode, not with the padding.
            for (group, entries) in moments.eights.iter_mut().zip(eights.entries().chunks(64 * tables.modes))
            {
                self.fill(group.as_flattened_mut().as_flattened_mut(), entries);
            }
            for (group, entries) in moments.fours.iter_mut().zip(fours.entries().chunks(32 * tables.modes)) {
                self.fill(group.as_flattened_mut().as_flattened_mut(), entries);
            }
        }
        moments
    }

    /// Half of the moments, in blocks of `W` x `W`; zero for other kinds of tables.
    pub fn half<V: Copy, const W: usize, const H: usize, const TILES: usize>(
        &self,
        tables: &LaneTables<V>,
    ) -> HalfTable<C, W, H, TILES>
    where
        F: Fn(V) -> C,
    {
        let mut moments =
            HalfTable { diagonal: [[[[self.zero; W]; W]; 8]; H], below: [[[self.zero; W]; W]; TILES] };
        if let MomentTables::Half { diagonal, below } = &tables.moments {
            self.fill(
                moments.diagonal.as_flattened_mut().as_flattened_mut().as_flattened_mut(),
                diagonal.entries(),
            );
            self.fill(moments.below.as_flattened_mut().as_flattened_mut(), below.entries());
        }
        moments
    }

    /// The body in lanes, with its moments in the form `P`.
    pub fn body<V: Copy, const M: usize, const G: usize, P: 'static>(
        &self,
        tables: &LaneTables<V>,
        moments: P,
    ) -> LaneBody<'static, C, M, G, P>
    where
        F: Fn(V) -> C,
    {
        LaneBody {
            registers: lanes::Compiled,
            mass: (self.constant)(tables.mass),
            first_moment: tables.first_moment.map(|moment| moment.map(&self.constant)),
            modal_first_moment: tables.modal_first_moment.as_ref().map(|table| self.rows(table)),
            inertia: tables.inertia.map(&self.constant),
            translation_factors: Factors {
                inverse_pivots: tables.translation_inverse_pivots.map(&self.constant),
                lower: tables.translation_lower.map(|lower| lower.map(&self.constant)),
            },
            eliminated_first_moment: tables.eliminated_first_moment.as_ref().map(|table| self.rows(table)),
            position_mode_even: tables.position_mode_even.as_ref().map(|table| self.rows(table)),
            position_mode_odd: tables.position_mode_odd.as_ref().map(|table| self.rows(table)),
            trace: self.matrix(&tables.trace),
            modal_mass: self.matrix(&tables.modal_mass),
            modal_factors: self.factors(&tables.modal_factors),
            stiffness: self.matrix(&tables.stiffness),
            damping: self.matrix(&tables.damping),
            moments,
            second_order_odd: tables.second_order_odd.as_ref().map(|table| self.pairs(table)),
        }
    }

    fn rows<V: Copy, const K: usize, const G: usize>(&self, table: &Table<V>) -> &'static [[[C; 4]; K]; G]
    where
        F: Fn(V) -> C,
    {
        let mut rows = Box::new([[[self.zero; 4]; K]; G]);
        self.fill(rows.as_flattened_mut().as_flattened_mut(), table.entries());
        Box::leak(rows)
    }

    fn pairs<V: Copy, const M: usize, const G: usize>(
        &self,
        table: &Table<V>,
    ) -> &'static [[[[C; 4]; 3]; M]; G]
    where
        F: Fn(V) -> C,
    {
        let mut groups = Box::new([[[[self.zero; 4]; 3]; M]; G]);
        // The columns of a group end with the last mode, not with the padding.
        for (group, entries) in groups.iter_mut().zip(table.entries().chunks(12 * table.shape()[1])) {
            self.fill(group.as_flattened_mut().as_flattened_mut(), entries);
        }
        Box::leak(groups)
    }

    fn matrix<V: Copy, const M: usize, const G: usize>(
        &self,
        matrix: &ModalMatrix<V>,
    ) -> lanes::ModalMatrix<'static, C, M, G>
    where
        F: Fn(V) -> C,
    {
        match matrix {
            ModalMatrix::Zero => lanes::ModalMatrix::Zero,
            ModalMatrix::Identity => lanes::ModalMatrix::Identity,
            ModalMatrix::Diagonal(table) => lanes::ModalMatrix::Diagonal(self.list(table)),
            ModalMatrix::Dense(table) => lanes::ModalMatrix::Dense(self.columns(table)),
        }
    }

    fn factors<V: Copy, const M: usize, const G: usize>(
        &self,
        factors: &ModalFactors<V>,
    ) -> lanes::ModalFactors<'static, C, M, G>
    where
        F: Fn(V) -> C,
    {
        match factors {
            ModalFactors::Identity => lanes::ModalFactors::Identity,
            ModalFactors::Diagonal(table) => lanes::ModalFactors::Diagonal(self.list(table)),
            ModalFactors::Triangular { inverse_pivots, lower } => lanes::ModalFactors::Triangular {
                inverse_pivots: self.list(inverse_pivots),
                lower: self.columns(lower),
            },
        }
    }

    fn list<V: Copy, const G: usize>(&self, table: &Table<V>) -> &'static [[C; 4]; G]
    where
        F: Fn(V) -> C,
    {
        let mut entries = Box::new([[self.zero; 4]; G]);
        self.fill(entries.as_flattened_mut(), table.entries());
        Box::leak(entries)
    }

    fn columns<V: Copy, const M: usize, const G: usize>(&self, table: &Table<V>) -> &'static [[[C; 4]; M]; G]
    where
        F: Fn(V) -> C,
    {
        let mut groups = Box::new([[[self.zero; 4]; M]; G]);
        // The columns of a group end with the last mode, not with the padding.
        for (group, entries) in groups.iter_mut().zip(table.entries().chunks(4 * table.shape()[1])) {
            self.fill(group.as_flattened_mut(), entries);
        }
        Box::leak(groups)
    }
}
