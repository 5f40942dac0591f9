//! The same loops over all moments and over half of them: what the symmetry T_νμ = T_μνᵀ gives.

use std::hint::black_box;

use ffrf::nalgebra::SVector;
use ffrf_runtime::lanes::{
    Compiled, Factors, FullTable, HalfTable, LaneBody, ModalFactors, ModalMatrix, MomentTable,
};

use crate::columns::States;
use crate::timing::Column;

/// A body without symmetry and with Θ_ff = I. Its numbers are no body's: time does not depend on them.
fn body<const M: usize, const G: usize, P>(moments: P) -> LaneBody<'static, f64, M, G, P> {
    LaneBody {
        registers: Compiled,
        mass: 3.0,
        first_moment: Some([0.1, 0.2, 0.3]),
        modal_first_moment: Some(Box::leak(Box::new([[[0.01; 4]; 3]; G]))),
        inertia: [50.0, 60.0, 70.0, 1.0, 2.0, 3.0],
        translation_factors: Factors { inverse_pivots: [0.3; 3], lower: Some([0.01, 0.02, 0.03]) },
        eliminated_first_moment: Some(Box::leak(Box::new([[[0.01; 4]; 3]; G]))),
        position_mode_even: Some(Box::leak(Box::new([[[0.02; 4]; 6]; G]))),
        position_mode_odd: Some(Box::leak(Box::new([[[0.03; 4]; 3]; G]))),
        trace: ModalMatrix::Identity,
        modal_mass: ModalMatrix::Identity,
        modal_factors: ModalFactors::Identity,
        stiffness: ModalMatrix::Diagonal(Box::leak(Box::new([[40.0; 4]; G]))),
        damping: ModalMatrix::Zero,
        moments,
        second_order_odd: None,
    }
}

/// Accelerations by loops over this table.
fn column<'a, const M: usize, const N: usize, const G: usize, P: MomentTable<f64, M, G> + 'static>(
    name: &str,
    moments: P,
    states: &'a States<M, N, f64>,
) -> Column<'a> {
    let body = Box::new(body::<M, G, P>(moments));
    Column {
        name: name.to_owned(),
        call: Box::new(move |k| {
            let (q, q_dot): (&[f64; M], &[f64; M]) = (&states.q[k].data.0[0], &states.q_dot[k].data.0[0]);
            let state = body.state(q, states.omega[k].into(), q_dot);
            let force: &[f64; N] = &states.force[k].data.0[0];
            black_box(SVector::<f64, N>::from(body.forward_dynamics(&state, q, q_dot, force)));
        }),
    }
}

/// All moments, in `PAIRS` pairs of groups, and half of them, in `G` rows of blocks.
pub fn columns<'a, const M: usize, const N: usize, const G: usize, const PAIRS: usize, const TILES: usize>(
    states: &'a States<M, N, f64>,
) -> [Column<'a>; 2] {
    let whole: FullTable<f64, M, PAIRS, 0> = FullTable { eights: [[[[0.01; 8]; 8]; M]; PAIRS], fours: [] };
    let half: HalfTable<f64, 4, G, TILES> =
        HalfTable { diagonal: [[[[0.01; 4]; 4]; 8]; G], below: [[[0.01; 4]; 4]; TILES] };
    [column::<M, N, G, _>("whole", whole, states), column::<M, N, G, _>("half", half, states)]
}
