//! The invariants of a body in the layout of vector registers, padded with zero.

use super::table::number;
use super::{ModalFactors, ModalMatrix, MomentTables, Table};
use crate::ScalarType;
use crate::body::{BodyExpressions, MomentComponents};
use crate::expression::{Expression, Graph};
use crate::formulate::ConstantFactors;

/// The numbers of a body whose kernels are loops over lanes, as the generated `static` holds them.
///
/// `V` is f64 in a generated body; the proofs arrange [`Expression`]s in the same way. A lane is a mode; lanes stand in groups of four, padded
/// with zero. Frame: body. What is `None` the layout leaves out.
#[derive(Debug, Clone, PartialEq)]
pub struct LaneTables<V = f64> {
    /// Number of modes M.
    pub modes: usize,
    /// Number of groups of four lanes.
    pub groups: usize,
    /// Mass m. Units: kg.
    pub mass: V,
    /// First moment m a. Shape: 3. Units: kg m.
    pub first_moment: Option<[V; 3]>,
    /// m b_μ. Shape: groups, axes (3), lanes (4).
    pub modal_first_moment: Option<Table<V>>,
    /// Inertia tensor: xx, yy, zz, xy, xz, yz. Units: kg m².
    pub inertia: [V; 6],
    /// One over the pivots of the mass left for translation, m I - m B Θ_ff⁻¹ (m B)ᵀ. Shape: 3. Units: 1/kg.
    pub translation_inverse_pivots: [V; 3],
    /// Its factor below the diagonal of ones: yx, zx, zy.
    pub translation_lower: Option<[V; 3]>,
    /// L⁻¹ (m B)ᵀ with the L of Θ_ff. Shape: groups, axes (3), lanes (4).
    pub eliminated_first_moment: Option<Table<V>>,
    /// tr T_μ, then yy, zz, xy + yx, xz + zx, yz + zy of T_μ. Shape: groups, components (6), lanes (4).
    pub position_mode_even: Option<Table<V>>,
    /// ϑ_μ. Shape: groups, axes (3), lanes (4).
    pub position_mode_odd: Option<Table<V>>,
    /// tr T_μν.
    pub trace: ModalMatrix<V>,
    /// Θ_ff.
    pub modal_mass: ModalMatrix<V>,
    /// Θ_ff in factors.
    pub modal_factors: ModalFactors<V>,
    /// K_ff.
    pub stiffness: ModalMatrix<V>,
    /// D_ff.
    pub damping: ModalMatrix<V>,
    /// T_νμ, less the even part of the geometric stiffness Γ_νμ.
    pub moments: MomentTables<V>,
    /// -ϑ(Γ_μν), symmetric in the modes. Shape: groups, modes ν, axes (3), lanes (4) over μ.
    pub second_order_odd: Option<Table<V>>,
}

impl LaneTables<Expression> {
    /// The tables of a body, as expressions of `graph`.
    ///
    /// The scalar type decides how the moments are stored.
    pub fn arrange(
        graph: &mut Graph,
        body: &BodyExpressions,
        scalar: ScalarType,
        factors: &ConstantFactors,
    ) -> Self {
        let modes = body.mode_count();
        let even_parts: Vec<Vec<[Expression; 6]>> = body
            .mode_mode
            .iter()
            .zip(&body.second_order)
            .map(|(first, second)| {
                let pairs = first.iter().zip(second);
                pairs.map(|(first, second)| sum(graph, &first.even, &second.even)).collect()
            })
            .collect();
        let arrange = Arrangement { zero: graph.zero(), graph };

        let components = |mu: usize, nu: usize| {
            let [_, yy, zz, xy, xz, yz] = even_parts[nu][mu];
            let [x, y, z] = body.mode_mode[nu][mu].odd;
            [yy, zz, xy, xz, yz, x, y, z]
        };
        let is_empty = (0..modes).all(|mu| (0..modes).all(|nu| arrange.is_zero(&components(mu, nu))));
        let moments = MomentTables::new(modes, scalar, is_empty, |component, mu, nu| {
            if mu < modes && nu < modes { components(mu, nu)[component] } else { arrange.zero }
        });
        let groups = moments.groups(modes);
        let even: Vec<[Expression; 6]> = body.position_mode.iter().map(|moment| moment.even).collect();
        let odd: Vec<[Expression; 3]> = body.position_mode.iter().map(|moment| moment.odd).collect();
        let trace: Vec<Vec<Expression>> =
            even_parts.iter().map(|row| row.iter().map(|even| even[0]).collect()).collect();
        let [xx, yy, zz] = body.inertia.diagonal;
        let [yz, xz, xy] = body.inertia.off_diagonal;
        Self {
            modes,
            groups,
            mass: body.mass,
            first_moment: Some(body.first_moment).filter(|moment| !arrange.is_zero(moment)),
            modal_first_moment: arrange.in_lanes(groups, &body.modal_first_moment),
            inertia: [xx, yy, zz, xy, xz, yz],
            translation_inverse_pivots: factors.translation_inverse_pivots,
            translation_lower: Some(factors.translation_lower).filter(|lower| !arrange.is_zero(lower)),
            eliminated_first_moment: arrange.in_lanes(groups, &factors.first_moment),
            position_mode_even: arrange.in_lanes(groups, &even),
            position_mode_odd: arrange.in_lanes(groups, &odd),
            trace: arrange.matrix(groups, &trace),
            modal_mass: arrange.matrix(groups, &body.modal_mass),
            modal_factors: arrange.factors(groups, factors),
            stiffness: arrange.matrix(groups, &body.stiffness),
            damping: arrange.matrix(groups, &body.damping),
            moments,
            second_order_odd: arrange.pairs_in_lanes(groups, &body.second_order),
        }
    }

    /// The values of tables that hold constants only.
    pub(crate) fn numbers(&self, graph: &Graph) -> LaneTables {
        let table = |table: &Option<Table<Expression>>| table.as_ref().map(|table| table.numbers(graph));
        LaneTables {
            modes: self.modes,
            groups: self.groups,
            mass: number(graph, self.mass),
            first_moment: self.first_moment.map(|moment| moment.map(|entry| number(graph, entry))),
            modal_first_moment: table(&self.modal_first_moment),
            inertia: self.inertia.map(|entry| number(graph, entry)),
            translation_inverse_pivots: self.translation_inverse_pivots.map(|entry| number(graph, entry)),
            translation_lower: self.translation_lower.map(|lower| lower.map(|entry| number(graph, entry))),
            eliminated_first_moment: table(&self.eliminated_first_moment),
            position_mode_even: table(&self.position_mode_even),
            position_mode_odd: table(&self.position_mode_odd),
            trace: self.trace.numbers(graph),
            modal_mass: self.modal_mass.numbers(graph),
            modal_factors: self.modal_factors.numbers(graph),
            stiffness: self.stiffness.numbers(graph),
            damping: self.damping.numbers(graph),
            moments: self.moments.numbers(graph),
            second_order_odd: table(&self.second_order_odd),
        }
    }
}

impl LaneTables {
    /// The strategy in words, for the banner.
    pub fn description(&self, scalar: ScalarType) -> String {
        format!("lanes over modes, {} groups of 4; {}", self.groups, self.moments.description(scalar))
    }

    /// Bytes of all tables that the generated code holds in `static` items; equal ones stand there once.
    pub(crate) fn bytes(&self, scalar: ScalarType) -> usize {
        let numbers = |table: &Option<Table>| table.as_ref().map_or(0, |table| table.entries().len());
        let matrix = |matrix: &ModalMatrix| match matrix {
            ModalMatrix::Zero | ModalMatrix::Identity => 0,
            ModalMatrix::Diagonal(table) | ModalMatrix::Dense(table) => table.entries().len(),
        };
        let factors = match &self.modal_factors {
            ModalFactors::Identity => 0,
            ModalFactors::Diagonal(table) => table.entries().len(),
            ModalFactors::Triangular { inverse_pivots, lower } => {
                inverse_pivots.entries().len() + lower.entries().len()
            }
        };
        let eliminated = if self.eliminated_first_moment == self.modal_first_moment {
            0
        } else {
            numbers(&self.eliminated_first_moment)
        };
        let trace = if self.trace == self.modal_mass { 0 } else { matrix(&self.trace) };
        let all = numbers(&self.modal_first_moment)
            + eliminated
            + numbers(&self.position_mode_even)
            + numbers(&self.position_mode_odd)
            + trace
            + matrix(&self.modal_mass)
            + factors
            + matrix(&self.stiffness)
            + matrix(&self.damping);
        all * scalar.bytes() + self.moment_bytes(scalar)
    }

    /// Bytes of the table of moments.
    pub(crate) fn moment_bytes(&self, scalar: ScalarType) -> usize {
        self.moments.bytes(scalar)
    }
}

fn sum(graph: &mut Graph, left: &[Expression; 6], right: &[Expression; 6]) -> [Expression; 6] {
    std::array::from_fn(|component| graph.add(left[component], right[component]))
}

/// How expressions become tables.
struct Arrangement<'a> {
    graph: &'a Graph,
    zero: Expression,
}

impl Arrangement<'_> {
    fn is_zero(&self, entries: &[Expression]) -> bool {
        entries.iter().all(|entry| self.graph.is_zero(*entry))
    }

    /// One row per mode in lanes, `None` if all are zero. Shape: groups, K, lanes (4).
    fn in_lanes<const K: usize>(&self, groups: usize, rows: &[[Expression; K]]) -> Option<Table<Expression>> {
        let at = |[group, k, lane]: [usize; 3]| rows.get(4 * group + lane).map_or(self.zero, |row| row[k]);
        (!self.is_zero(rows.as_flattened())).then(|| Table::new([groups, K, 4], at))
    }

    /// The odd components of every pair of modes, `None` if all are zero. Shape: groups, modes ν, axes (3), lanes (4) over μ.
    fn pairs_in_lanes(&self, groups: usize, pairs: &[Vec<MomentComponents>]) -> Option<Table<Expression>> {
        let at = |[group, nu, axis, lane]: [usize; 4]| {
            pairs.get(4 * group + lane).map_or(self.zero, |row| row[nu].odd[axis])
        };
        let is_zero = pairs.iter().flatten().all(|moment| self.is_zero(&moment.odd));
        (!is_zero).then(|| Table::new([groups, pairs.len(), 3, 4], at))
    }

    fn matrix(&self, groups: usize, matrix: &[Vec<Expression>]) -> ModalMatrix<Expression> {
        let modes = matrix.len();
        let is_diagonal =
            (0..modes).all(|mu| (0..modes).all(|nu| mu == nu || self.graph.is_zero(matrix[mu][nu])));
        if !is_diagonal {
            let at =
                |[group, nu, lane]: [usize; 3]| matrix.get(4 * group + lane).map_or(self.zero, |row| row[nu]);
            return ModalMatrix::Dense(Table::new([groups, modes, 4], at));
        }
        let entries: Vec<Expression> = (0..modes).map(|mu| matrix[mu][mu]).collect();
        if self.is_zero(&entries) {
            ModalMatrix::Zero
        } else if entries.iter().all(|entry| self.graph.constant_value(*entry) == Some(1.0)) {
            ModalMatrix::Identity
        } else {
            ModalMatrix::Diagonal(self.list(groups, &entries))
        }
    }

    /// One entry per mode. Shape: groups, lanes (4).
    fn list(&self, groups: usize, entries: &[Expression]) -> Table<Expression> {
        let at = |[group, lane]: [usize; 2]| entries.get(4 * group + lane).copied().unwrap_or(self.zero);
        Table::new([groups, 4], at)
    }

    fn factors(&self, groups: usize, factors: &ConstantFactors) -> ModalFactors<Expression> {
        let (rows, inverse_pivots) = (&factors.modal.lower, &factors.modal.inverse_pivots);
        if rows.iter().any(|row| !self.is_zero(row)) {
            let at = |[group, nu, lane]: [usize; 3]| {
                let mu = 4 * group + lane;
                let row = rows.get(mu.max(nu));
                row.and_then(|row| row.get(mu.min(nu))).copied().unwrap_or(self.zero)
            };
            let lower = Table::new([groups, rows.len(), 4], at);
            ModalFactors::Triangular { inverse_pivots: self.list(groups, inverse_pivots), lower }
        } else if inverse_pivots.iter().all(|entry| self.graph.constant_value(*entry) == Some(1.0)) {
            ModalFactors::Identity
        } else {
            ModalFactors::Diagonal(self.list(groups, inverse_pivots))
        }
    }
}
