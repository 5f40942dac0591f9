//! The invariants of a body in the layout of vector registers, padded with zero.

use super::table::number;
use super::{Diagonal, MomentTables, Table};
use crate::ScalarType;
use crate::body::BodyExpressions;
use crate::expression::{Expression, Graph};

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
    /// Inverse of the mass left for translation: xx, yy, zz, xy, xz, yz. Units: 1/kg.
    pub translation_compliance: [V; 6],
    /// tr T_μ, then yy, zz, xy + yx, xz + zx, yz + zy of T_μ. Shape: groups, components (6), lanes (4).
    pub position_mode_even: Option<Table<V>>,
    /// ϑ_μ. Shape: groups, axes (3), lanes (4).
    pub position_mode_odd: Option<Table<V>>,
    /// tr T_μμ.
    pub trace: Diagonal<V>,
    /// Θ_ff.
    pub modal_mass: Diagonal<V>,
    /// Θ_ff⁻¹.
    pub modal_compliance: Diagonal<V>,
    /// K_ff and D_ff if both are diagonal.
    pub internal: Option<[Diagonal<V>; 2]>,
    /// T_νμ.
    pub moments: MomentTables<V>,
}

impl LaneTables<Expression> {
    /// The tables of a body whose Θ_ff is diagonal, as expressions of `graph`.
    ///
    /// The scalar type decides how the moments are stored. `translation_compliance` is the inverse of the mass left for
    /// translation, m I - m B Θ_ff⁻¹ (m B)ᵀ, as xx, yy, zz, xy, xz, yz.
    pub fn arrange(
        graph: &mut Graph,
        body: &BodyExpressions,
        scalar: ScalarType,
        translation_compliance: [Expression; 6],
    ) -> Self {
        let modes = body.mode_count();
        let modal_mass: Vec<Expression> = (0..modes).map(|mu| body.modal_mass[mu][mu]).collect();
        let one = graph.one();
        let modal_compliance = modal_mass.iter().map(|mass| graph.divide(one, *mass)).collect();
        let arrange = Arrangement { zero: graph.zero(), graph };

        let components = |mu: usize, nu: usize| {
            let moment = &body.mode_mode[nu][mu];
            let [_, yy, zz, xy, xz, yz] = moment.even;
            let [x, y, z] = moment.odd;
            [yy, zz, xy, xz, yz, x, y, z]
        };
        let is_empty = (0..modes).all(|mu| (0..modes).all(|nu| arrange.is_zero(&components(mu, nu))));
        let moments = MomentTables::new(modes, scalar, is_empty, |component, mu, nu| {
            if mu < modes && nu < modes { components(mu, nu)[component] } else { arrange.zero }
        });
        let groups = moments.groups(modes);
        let even: Vec<[Expression; 6]> = body.position_mode.iter().map(|moment| moment.even).collect();
        let odd: Vec<[Expression; 3]> = body.position_mode.iter().map(|moment| moment.odd).collect();
        let trace = (0..modes).map(|mu| body.mode_mode[mu][mu].even[0]).collect();
        let internal = arrange.diagonal_of(&body.stiffness).zip(arrange.diagonal_of(&body.damping));
        let [xx, yy, zz] = body.inertia.diagonal;
        let [yz, xz, xy] = body.inertia.off_diagonal;
        Self {
            modes,
            groups,
            mass: body.mass,
            first_moment: Some(body.first_moment).filter(|moment| !arrange.is_zero(moment)),
            modal_first_moment: arrange.in_lanes(groups, &body.modal_first_moment),
            inertia: [xx, yy, zz, xy, xz, yz],
            translation_compliance,
            position_mode_even: arrange.in_lanes(groups, &even),
            position_mode_odd: arrange.in_lanes(groups, &odd),
            trace: arrange.diagonal(groups, trace),
            modal_mass: arrange.diagonal(groups, modal_mass),
            modal_compliance: arrange.diagonal(groups, modal_compliance),
            internal: internal.map(|(stiffness, damping)| {
                [arrange.diagonal(groups, stiffness), arrange.diagonal(groups, damping)]
            }),
            moments,
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
            translation_compliance: self.translation_compliance.map(|entry| number(graph, entry)),
            position_mode_even: table(&self.position_mode_even),
            position_mode_odd: table(&self.position_mode_odd),
            trace: self.trace.numbers(graph),
            modal_mass: self.modal_mass.numbers(graph),
            modal_compliance: self.modal_compliance.numbers(graph),
            internal: self.internal.as_ref().map(|[k, d]| [k.numbers(graph), d.numbers(graph)]),
            moments: self.moments.numbers(graph),
        }
    }
}

impl LaneTables {
    /// The strategy in words, for the banner.
    pub fn description(&self, scalar: ScalarType) -> String {
        format!("lanes over modes, {} groups of 4; {}", self.groups, self.moments.description(scalar))
    }

    /// Bytes of the table of moments.
    pub(crate) fn moment_bytes(&self, scalar: ScalarType) -> usize {
        self.moments.bytes(scalar)
    }
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

    fn diagonal(&self, groups: usize, entries: Vec<Expression>) -> Diagonal<Expression> {
        if self.is_zero(&entries) {
            Diagonal::Zero
        } else if entries.iter().all(|entry| self.graph.constant_value(*entry) == Some(1.0)) {
            Diagonal::Identity
        } else {
            let at = |[group, lane]: [usize; 2]| entries.get(4 * group + lane).copied().unwrap_or(self.zero);
            Diagonal::Entries(Table::new([groups, 4], at))
        }
    }

    /// The diagonal of a matrix that has nothing else.
    fn diagonal_of(&self, matrix: &[Vec<Expression>]) -> Option<Vec<Expression>> {
        let beside = |mu: usize| (0..matrix.len()).filter(move |nu| *nu != mu);
        let is_diagonal = (0..matrix.len()).all(|mu| beside(mu).all(|nu| self.graph.is_zero(matrix[mu][nu])));
        is_diagonal.then(|| (0..matrix.len()).map(|mu| matrix[mu][mu]).collect())
    }
}
