//! The loops run on expressions: what every kernel over lanes computes, written down.

use ffrf::generated_support::lanes::{
    Dense, LaneBody, MomentStructure, MomentTable, ParameterDiagonal, ParameterMoments, Parameters,
    Symmetric, traces,
};
use ffrf_codegen::ScalarType;
use ffrf_codegen::body::{BodyExpressions, raw_inertia};
use ffrf_codegen::expression::{Expression, Graph};
use ffrf_codegen::formulate::{ConstantFactors, State};
use ffrf_codegen::invariants::{Invariant, Structure};
use ffrf_codegen::lanes::LaneTables;
use ffrf_codegen::layout::Layout;
use ffrf_host::kernels::Bodies;

use crate::symbolic::{Symbolic, record};

/// What the kernels over lanes compute.
pub struct Loops {
    /// Columns. Shape: N x N.
    pub mass_matrix: Vec<Vec<Expression>>,
    /// Shape: N.
    pub quadratic_velocity: Vec<Expression>,
    /// Shape: N. Rational functions, not polynomials.
    pub acceleration: Vec<Expression>,
    pub kinetic_energy: Expression,
    /// Shape: 3.
    pub angular_momentum: Vec<Expression>,
}

/// How a number of modes is compiled: which constants of the loops belong to it.
pub type Compiled = fn(&mut Graph, &BodyExpressions) -> Loops;

/// All moments stored: `G` = 2 `PAIRS` + `SINGLE` groups.
pub fn whole<const M: usize, const N: usize, const G: usize, const PAIRS: usize, const SINGLE: usize>(
    graph: &mut Graph,
    body: &BodyExpressions,
) -> Loops {
    let tables = tables(graph, body, ScalarType::F64);
    let bodies = Bodies { zero: Symbolic(graph.zero()), constant: Symbolic };
    let moments = bodies.whole::<Expression, M, PAIRS, SINGLE>(&tables);
    run::<M, N, G, _>(graph, &bodies.body(&tables, moments))
}

/// Half of the moments stored: `H` rows of blocks of `W` modes.
pub fn half<
    const M: usize,
    const N: usize,
    const G: usize,
    const W: usize,
    const H: usize,
    const TILES: usize,
>(
    graph: &mut Graph,
    body: &BodyExpressions,
) -> Loops
where
    Symbolic: ffrf::generated_support::lanes::HasLanes<W>,
{
    let scalar = if W == 4 { ScalarType::F64 } else { ScalarType::F32 };
    let tables = tables(graph, body, scalar);
    let bodies = Bodies { zero: Symbolic(graph.zero()), constant: Symbolic };
    let moments = bodies.half::<Expression, W, H, TILES>(&tables);
    run::<M, N, G, _>(graph, &bodies.body(&tables, moments))
}

/// The tables as the generator arranges them.
fn tables(graph: &mut Graph, body: &BodyExpressions, scalar: ScalarType) -> LaneTables<Expression> {
    let factors = ConstantFactors::new(graph, body).unwrap();
    LaneTables::arrange(graph, body, scalar, &factors)
}

/// Invariants read from fields at run time: the general layout with Θ_ff identity or diagonal, full fidelity.
pub fn fields<const M: usize, const N: usize, const G: usize>(graph: &mut Graph, layout: &Layout) -> Loops {
    let raw = raw_inertia(graph, M, layout);
    let matrix = |matrix: &[[Expression; 3]; 3]| matrix.map(|row| row.map(Symbolic));
    let list = |rows: &[[Expression; 3]]| std::array::from_fn(|mu| rows[mu].map(Symbolic));
    let position: [_; M] = std::array::from_fn(|mu| matrix(&raw.position_mode_moment[mu]));
    let moments: [[_; M]; M] =
        std::array::from_fn(|mu| std::array::from_fn(|nu| matrix(&raw.mode_mode_moment[mu][nu])));
    let tables = record(graph, || {
        let components = position.map(|moment| Dense::components(&moment));
        let parameters = Parameters {
            mass: Symbolic(raw.mass),
            first_moment: Some(raw.first_moment.map(Symbolic)),
            modal_first_moment: Some(list(&raw.modal_first_moment)),
            second_moment: Symmetric::components(&matrix(&raw.second_moment)),
            position_mode_even: Some(components),
            position_mode_odd: Some(components),
            modal_mass: match layout[Invariant::ModalMass] {
                Structure::Identity => ParameterDiagonal::Identity,
                _ => ParameterDiagonal::Entries(traces::<_, Dense, M>(&moments)),
            },
            has_trace: true,
            stiffness: ParameterDiagonal::Zero,
            damping: ParameterDiagonal::Zero,
        };
        parameters.tables::<G>()
    });
    let moments = ParameterMoments::<'_, Symbolic, Dense, M, true, true>::new(&moments);
    run::<M, N, G, _>(graph, &tables.body(moments))
}

fn run<const M: usize, const N: usize, const G: usize, P: MomentTable<Symbolic, M, G>>(
    graph: &mut Graph,
    body: &LaneBody<'_, Symbolic, M, G, P>,
) -> Loops {
    let inputs = State::symbolic(graph, M);
    let list =
        |expressions: &[Expression]| -> Vec<Symbolic> { expressions.iter().copied().map(Symbolic).collect() };
    let modal = |expressions: &[Expression]| -> [Symbolic; M] {
        list(expressions).try_into().unwrap_or_else(|_| panic!("{M} modes are expected"))
    };
    let (q, q_dot) = (modal(&inputs.q), modal(&inputs.q_dot));
    let (omega, velocity) = (inputs.omega.map(Symbolic), inputs.velocity.map(Symbolic));
    let force: [Symbolic; N] =
        list(&inputs.force).try_into().unwrap_or_else(|_| panic!("{N} forces are expected"));
    record(graph, || {
        let state = body.state(&q, omega, &q_dot);
        let plain = |list: &[Symbolic]| -> Vec<Expression> { list.iter().map(|entry| entry.0).collect() };
        let columns: [[Symbolic; N]; N] = body.mass_matrix(&state);
        let quadratic: [Symbolic; N] = body.quadratic_velocity(&state);
        prepared_parts_are_those_of(&columns, &quadratic, body.prepare(&state));
        Loops {
            mass_matrix: columns.iter().map(|column| plain(column)).collect(),
            quadratic_velocity: plain(&quadratic),
            acceleration: plain(&body.forward_dynamics(&state, &q, &q_dot, &force)),
            kinetic_energy: body.kinetic_energy(&state, &velocity, &omega, &q_dot).0,
            angular_momentum: plain(&body.angular_momentum(&state, &velocity, &omega)),
        }
    })
}

/// What the loops prepare: mass, first moment, inertia, rows of m B, rows of Θ_rf, quadratic velocity vector.
type Parts<const M: usize, const N: usize> =
    (Symbolic, [Symbolic; 3], [[Symbolic; 3]; 3], [[Symbolic; M]; 3], [[Symbolic; M]; 3], [Symbolic; N]);

/// The prepared state is made of the expressions of the dense forms, so that what is proven of these holds for it.
fn prepared_parts_are_those_of<const M: usize, const N: usize>(
    columns: &[[Symbolic; N]; N],
    quadratic: &[Symbolic; N],
    (mass, first_moment, inertia, momentum, coupling, prepared): Parts<M, N>,
) {
    for axis in 0..3 {
        assert_eq!(columns[axis][axis].0, mass.0);
        // m r~ in the columns of the rotation: x, y, z where they have no sign.
        let (column, row) = [(5, 1), (3, 2), (4, 0)][axis];
        assert_eq!(columns[column][row].0, first_moment[axis].0);
        for other in 0..3 {
            assert_eq!(columns[3 + axis][3 + other].0, inertia[axis][other].0);
        }
        for mu in 0..M {
            assert_eq!(columns[6 + mu][axis].0, momentum[axis][mu].0);
            assert_eq!(columns[6 + mu][3 + axis].0, coupling[axis][mu].0);
        }
    }
    assert!(quadratic.iter().zip(&prepared).all(|(one, other)| one.0 == other.0));
}
