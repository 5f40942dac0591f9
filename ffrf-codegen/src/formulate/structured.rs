//! The structured kernels: mass matrix and quadratic velocity vector from one product.
//!
//! Everything that depends on the deformation follows from T_μ^d = T_μ + q_ν T_νμ (205), in the nine
//! components of [`MomentComponents`], with the geometric stiffness -Γ_νμ added to T_νμ where a model has it. For mass matrix and quadratic velocity vector together that is
//! 11 M² + O(M) fused multiply-adds if Θ_ff is diagonal: eight components of q_ν T_νμ, and three of q̇_ν ϑ_νμ.

use super::{Draft, State};
use crate::body::{BodyExpressions, MomentComponents};
use crate::expression::{AXES, Expression, Graph, Symmetric3, Vector, cross, negate3, sum3, symmetric_times};

/// Names of the even components in generated code.
const EVEN_NAMES: [&str; 6] = ["trace", "yy", "zz", "xy", "xz", "yz"];

/// What depends on the deformation q.
#[derive(Debug, Clone)]
pub struct DeformedBody {
    /// Components of T_μ^d(q) = T_μ + q_ν (T_νμ - Γ_νμ). Shape: M. Source: (205), index order corrected.
    pub moments: Vec<MomentComponents>,
    /// Modal first moments m b_μ - Γ_μν q_ν. Shape: M x 3.
    pub modal_first_moment: Vec<Vector>,
    /// First moment m r(q). Units: kg m. Source: (204), r = a + q_μ b_μ; less ½ Γ_μν q_μ q_ν.
    pub first_moment: Vector,
    /// Inertia tensor Θ_rr(q). Units: kg m². Source: (204), symmetrised.
    pub inertia: Symmetric3,
}

impl DeformedBody {
    /// Writes the deformed invariants into the graph. Nothing that is not used later costs anything.
    pub fn new(graph: &mut Draft, body: &BodyExpressions, state: &State) -> Self {
        graph.section("Deformed moments T_μ + q_ν T_νμ");
        let moments = deformed_moments(graph, body, &state.q);
        graph.section("Deformed first moment m r = m a + m b_μ q_μ");
        let modal_first_moment = deformed_first_moments(graph, body, &state.q);
        let mean: Vec<Vector> = body
            .modal_first_moment
            .iter()
            .zip(&modal_first_moment)
            .map(|(own, deformed)| [0, 1, 2].map(|i| mean(graph, own[i], deformed[i])))
            .collect();
        let first_moment = moment_sum(graph, &mean, body.first_moment, &state.q);
        label3(graph, first_moment, "first_moment");
        graph.section("Deformed inertia tensor Θ_rr");
        let inertia = deformed_inertia(graph, body, &moments, &state.q);
        Self { moments, modal_first_moment, first_moment, inertia }
    }

    /// Θ_rf c for modal coefficients c. Shape: 3.
    pub fn coupling_times(&self, graph: &mut Graph, coefficients: &[Expression]) -> Vector {
        let zero = graph.zero();
        [0, 1, 2].map(|i| {
            let terms = self.moments.iter().zip(coefficients).map(|(moment, &c)| (moment.odd[i], c));
            graph.sum_of_products(zero, terms)
        })
    }
}

/// m b_μ - Γ_μν q_ν
fn deformed_first_moments(graph: &mut Draft, body: &BodyExpressions, q: &[Expression]) -> Vec<Vector> {
    let mut moments = body.modal_first_moment.clone();
    for (moment, row) in moments.iter_mut().zip(&body.second_order_first_moment) {
        for (i, component) in moment.iter_mut().enumerate() {
            let terms = row.iter().zip(q).map(|(second, &q)| (second[i], q));
            *component = graph.sum_of_products(*component, terms);
        }
    }
    for (mu, moment) in moments.iter().enumerate() {
        label3(graph, *moment, &format!("modal_first_moment{mu}"));
    }
    moments
}

/// ½ (a + b), and a itself where both are the same.
fn mean(graph: &mut Graph, a: Expression, b: Expression) -> Expression {
    if a == b {
        return a;
    }
    let sum = graph.add(a, b);
    graph.scale(0.5, sum)
}

/// start + moment_μ c_μ
pub(super) fn moment_sum(
    graph: &mut Graph,
    moments: &[Vector],
    start: Vector,
    coefficients: &[Expression],
) -> Vector {
    [0, 1, 2].map(|i| {
        let terms = moments.iter().zip(coefficients).map(|(moment, &c)| (moment[i], c));
        graph.sum_of_products(start[i], terms)
    })
}

fn deformed_moments(graph: &mut Draft, body: &BodyExpressions, q: &[Expression]) -> Vec<MomentComponents> {
    let mut moments = body.position_mode.clone();
    for (mu, moment) in moments.iter_mut().enumerate() {
        for component in 0..6 {
            let terms = pair_terms(graph, body, q, mu, |moment| moment.even[component]);
            moment.even[component] = graph.sum_of_products(moment.even[component], terms);
            graph.label(moment.even[component], format!("moment_{}{mu}", EVEN_NAMES[component]));
        }
        for component in 0..3 {
            let terms = pair_terms(graph, body, q, mu, |moment| moment.odd[component]);
            moment.odd[component] = graph.sum_of_products(moment.odd[component], terms);
            graph.label(moment.odd[component], format!("coupling_{}{mu}", AXES[component]));
        }
    }
    moments
}

/// A component of T_νμ - Γ_νμ and q_ν, for every ν.
fn pair_terms(
    graph: &mut Graph,
    body: &BodyExpressions,
    q: &[Expression],
    mu: usize,
    component: impl Fn(&MomentComponents) -> Expression,
) -> Vec<(Expression, Expression)> {
    let mut terms = Vec::with_capacity(q.len());
    for (nu, &q) in q.iter().enumerate() {
        let (first, second) = (component(&body.mode_mode[nu][mu]), component(&body.second_order[nu][mu]));
        terms.push((graph.add(first, second), q));
    }
    terms
}

/// Θ_rr = Θ + q_μ (Θ_μ + Θ_μᵀ) + q_μ q_ν Θ_μν, from Σ q_μ (T_μ + T_μ^d).
fn deformed_inertia(
    graph: &mut Draft,
    body: &BodyExpressions,
    moments: &[MomentComponents],
    q: &[Expression],
) -> Symmetric3 {
    let zero = graph.zero();
    let sums = [0, 1, 2, 3, 4, 5].map(|component| {
        let mut terms = Vec::with_capacity(q.len());
        for (mu, &q) in q.iter().enumerate() {
            let both = graph.add(body.position_mode[mu].even[component], moments[mu].even[component]);
            terms.push((both, q));
        }
        let sum = graph.sum_of_products(zero, terms);
        graph.label(sum, format!("change_{}", EVEN_NAMES[component]))
    });
    let inertia = traced(graph, sums, 0.5);
    let total = Symmetric3 {
        diagonal: sum3(graph, body.inertia.diagonal, inertia.diagonal),
        off_diagonal: sum3(graph, body.inertia.off_diagonal, inertia.off_diagonal),
    };
    for i in 0..3 {
        graph.label(total.diagonal[i], format!("inertia_{0}{0}", AXES[i]));
        let (j, k) = [(1, 2), (0, 2), (0, 1)][i];
        graph.label(total.off_diagonal[i], format!("inertia_{}{}", AXES[j], AXES[k]));
    }
    total
}

/// tr(S) I - S for the even components of T, where S has the off-diagonal entries `share` times T^{ij} + T^{ji}.
fn traced(graph: &mut Graph, even: [Expression; 6], share: f64) -> Symmetric3 {
    let [trace, yy, zz, xy, xz, yz] = even;
    Symmetric3 {
        diagonal: [graph.add(yy, zz), graph.subtract(trace, yy), graph.subtract(trace, zz)],
        off_diagonal: [yz, xz, xy].map(|sum| graph.scale(-share, sum)),
    }
}

/// Mass matrix M(q), columns of N = 6 + M entries.
///
/// Source: (203), body-resolved; signs of r̃ and order of indices corrected.
pub fn mass_matrix(
    graph: &mut Graph,
    body: &BodyExpressions,
    deformed: &DeformedBody,
) -> Vec<Vec<Expression>> {
    let modes = body.mode_count();
    let zero = graph.zero();
    let [x, y, z] = deformed.first_moment;
    let [minus_x, minus_y, minus_z] = negate3(graph, deformed.first_moment);
    let mut columns = vec![vec![zero; 6 + modes]; 6 + modes];
    for i in 0..3 {
        columns[i][i] = body.mass;
        for j in 0..3 {
            columns[3 + i][3 + j] = deformed.inertia.at(i, j);
        }
    }
    // -m r̃ in rows 0..3, columns 3..6, and its transpose.
    for (row, column, entry) in
        [(0, 1, z), (0, 2, minus_y), (1, 0, minus_z), (1, 2, x), (2, 0, y), (2, 1, minus_x)]
    {
        columns[3 + column][row] = entry;
        columns[row][3 + column] = entry;
    }
    for mu in 0..modes {
        for i in 0..3 {
            columns[6 + mu][i] = deformed.modal_first_moment[mu][i];
            columns[i][6 + mu] = deformed.modal_first_moment[mu][i];
            columns[6 + mu][3 + i] = deformed.moments[mu].odd[i];
            columns[3 + i][6 + mu] = deformed.moments[mu].odd[i];
        }
        for nu in 0..modes {
            columns[6 + mu][6 + nu] = body.modal_mass[mu][nu];
        }
    }
    columns
}

/// Quadratic velocity vector Q(q, ω, q̇) on the left-hand side, N = 6 + M entries.
///
/// Source: (209), signs and index order corrected; see `docs/theory/errata.md`.
pub fn quadratic_velocity(
    graph: &mut Draft,
    body: &BodyExpressions,
    state: &State,
    deformed: &DeformedBody,
) -> Vec<Expression> {
    let (omega, q_dot) = (state.omega, &state.q_dot);
    let mut result = Vec::with_capacity(6 + body.mode_count());

    graph.section("Translation: ω × (ω × m r + 2 m B q̇)");
    let zero = graph.zero();
    let momentum = moment_sum(graph, &deformed.modal_first_moment, [zero; 3], q_dot);
    let twice = momentum.map(|component| graph.scale(2.0, component));
    let carried = cross(graph, omega, deformed.first_moment);
    let sum = sum3(graph, carried, twice);
    let centripetal = cross(graph, omega, sum);
    let shortening = quadratic_rate(graph, q_dot, |mu, nu| body.second_order_first_moment[mu][nu]);
    result.extend(sum3(graph, centripetal, shortening));

    // Σ q̇_μ Θ_μ^d has an even part, half of the rate of Θ_rr, and an odd part with the axial vector -½ Θ_rf q̇.
    graph.section("Rotation: ω × (Θ_rr ω + Θ_rf q̇) + Θ̇_rr ω");
    let rates = [0, 1, 2, 3, 4, 5].map(|component| {
        let terms = deformed.moments.iter().zip(q_dot).map(|(moment, &rate)| (moment.even[component], rate));
        let sum = graph.sum_of_products(zero, terms);
        graph.label(sum, format!("rate_{}", EVEN_NAMES[component]))
    });
    let spin = deformed.coupling_times(graph, q_dot);
    label3(graph, spin, "modal_spin");
    let angular = symmetric_times(graph, &deformed.inertia, omega);
    let angular = sum3(graph, angular, spin);
    label3(graph, angular, "angular_momentum");
    let gyroscopic = cross(graph, omega, angular);
    let rate = traced(graph, rates, 1.0);
    let twice_omega = omega.map(|component| graph.scale(2.0, component));
    let growth = [0, 1, 2].map(|i| {
        let terms = [0, 1, 2].map(|j| (rate.at(i, j), if i == j { twice_omega[i] } else { omega[j] }));
        graph.sum_of_products(zero, terms)
    });
    let turning = sum3(graph, gyroscopic, growth);
    let shortening = quadratic_rate(graph, q_dot, |mu, nu| body.second_order[mu][nu].odd);
    result.extend(sum3(graph, turning, shortening));

    graph.section("Modes: -ω · Θ_μ^d ω + 2 ω · ϑ_νμ q̇_ν");
    let weights = spin_weights(graph, omega);
    for mu in 0..body.mode_count() {
        let even = deformed.moments[mu].even;
        let mut force = graph.sum_of_products(zero, (0..6).map(|k| (weights[k], even[k])));
        for i in 0..3 {
            let terms = q_dot.iter().enumerate().map(|(nu, &rate)| (body.mode_mode[nu][mu].odd[i], rate));
            let whirl = graph.sum_of_products(zero, terms);
            graph.label(whirl, format!("whirl_{}{mu}", AXES[i]));
            force = graph.sum_of_products(force, [(twice_omega[i], whirl)]);
        }
        graph.label(force, format!("modal_quadratic{mu}"));
        result.push(force);
    }
    result
}

/// moment_μν q̇_μ q̇_ν: the acceleration of second order that steady rates leave.
fn quadratic_rate(
    graph: &mut Graph,
    q_dot: &[Expression],
    moment: impl Fn(usize, usize) -> Vector,
) -> Vector {
    let zero = graph.zero();
    [0, 1, 2].map(|i| {
        let mut terms = Vec::with_capacity(q_dot.len());
        for (mu, &rate) in q_dot.iter().enumerate() {
            let row = q_dot.iter().enumerate().map(|(nu, &other)| (moment(mu, nu)[i], other));
            terms.push((graph.sum_of_products(zero, row), rate));
        }
        graph.sum_of_products(zero, terms)
    })
}

/// Factors of the even components in -ω · (tr(T) I - Tᵀ) ω.
fn spin_weights(graph: &mut Graph, [x, y, z]: Vector) -> [Expression; 6] {
    let [xx, yy, zz] = [x, y, z].map(|component| graph.multiply(component, component));
    let sum = graph.add(yy, zz);
    [
        graph.negate(sum),
        graph.subtract(yy, xx),
        graph.subtract(zz, xx),
        graph.multiply(x, y),
        graph.multiply(x, z),
        graph.multiply(y, z),
    ]
}

pub(super) fn label3(graph: &mut Draft, vector: Vector, name: &str) {
    for (component, axis) in vector.into_iter().zip(AXES) {
        graph.label(component, format!("{name}_{axis}"));
    }
}
