//! Sections 7.2 and 7.3: generalised velocities and accelerations, (89) to (106).

use faer::Mat;
use faer::linalg::solvers::SolveLstsq;
use ffrf_fe::formulations::constraints;
use ffrf_fe::formulations::null_space::{flexible_block, projection, projection_rate, rotation_block};
use ffrf_fe::formulations::rotation::{cross, skew};

use crate::bodies::{State, each_state};
use crate::check::{as_vector, block, column, different, equal, scaled, vanishes};

/// ω × d_i.
fn director_rates(state: &State) -> [[f64; 3]; 3] {
    state.d.map(|d| cross(as_vector(&state.omega), d))
}

/// w = [w_t; ω; q̇'].
fn velocities(state: &State) -> Mat<f64> {
    let mut w = vec![0.4, -1.1, 0.3];
    w.extend(as_vector(&state.omega));
    w.extend(&state.q_dot);
    column(&w)
}

/// Rates of [q_t; q_r; q_f] by the product rule: ḋ_i, and q̇' d_i + q' ḋ_i.
fn coordinate_rates(state: &State) -> Mat<f64> {
    let rates = director_rates(state);
    let mut q_dot = vec![0.4, -1.1, 0.3];
    q_dot.extend(rates.as_flattened());
    for mu in 0..state.q.len() {
        for i in 0..3 {
            q_dot.extend((0..3).map(|j| state.q_dot[mu] * state.d[i][j] + state.q[mu] * rates[i][j]));
        }
    }
    column(&q_dot)
}

fn flexible_part(matrix: &Mat<f64>) -> Mat<f64> {
    block(matrix, 12, 0, matrix.nrows() - 12, matrix.ncols())
}

#[test]
fn equation_089_velocities_from_the_projection() {
    each_state(|_, state| {
        equal(&(projection(&state.floating) * velocities(state)), &coordinate_rates(state))
    });
}

#[test]
fn equation_090_constraints_hold_on_the_floating_frame() {
    each_state(|_, state| {
        vanishes(&column(&constraints::rigid(&state.d)), 1.0);
        for mu in 0..state.q.len() {
            vanishes(&column(&constraints::flexible(&state.d, &state.mode_triad(mu))), state.q[mu].abs());
        }
    });
}

#[test]
fn equation_091_constraints_hold_at_velocity_level() {
    each_state(|_, state| {
        let triads: Vec<_> = (0..state.q.len()).map(|mu| state.mode_triad(mu)).collect();
        let jacobian = constraints::jacobian(&state.d, &triads);
        let rates = coordinate_rates(state);
        vanishes(&(jacobian * &rates), rates.norm_max());
    });
}

#[test]
fn equation_092_director_rates() {
    each_state(|_, state| {
        for (d, rate) in state.d.iter().zip(director_rates(state)) {
            equal(&(scaled(-1.0, &skew(*d)) * &state.omega), &column(&rate));
        }
    });
}

#[test]
fn equations_093_094_velocities_are_spin_and_modal_rates() {
    each_state(|_, state| {
        // The projection has full column rank, so its velocities follow from the coordinate rates alone.
        let found = projection(&state.floating).qr().solve_lstsq(coordinate_rates(state));
        equal(&found, &velocities(state));
    });
}

#[test]
fn equations_095_096_flexible_coordinates() {
    each_state(|body, state| {
        let p = projection(&state.floating);
        let p_ff = block(&p, 12, 6, 9 * body.mode_count(), body.mode_count());
        let stacked: Vec<f64> = (0..body.mode_count())
            .flat_map(|mu| state.mode_triad(mu).into_iter().flatten().collect::<Vec<_>>())
            .collect();
        equal(&(p_ff * column(&state.q)), &column(&stacked));
    });
}

#[test]
fn equations_097_098_rate_of_the_flexible_block() {
    each_state(|body, state| {
        let modes = body.mode_count();
        let rate = block(&projection_rate(&state.floating), 12, 6, 9 * modes, modes);
        let p_fr = block(&projection(&state.floating), 12, 3, 9 * modes, 3);
        equal(&(rate * column(&state.q)), &(p_fr * &state.omega));
    });
}

#[test]
fn equations_099_100_flexible_rates_two_ways() {
    each_state(|body, state| {
        let modes = body.mode_count();
        let (p, p_rate) = (projection(&state.floating), projection_rate(&state.floating));
        let (p_fr, p_ff) = (block(&p, 12, 3, 9 * modes, 3), block(&p, 12, 6, 9 * modes, modes));
        let p_ff_rate = block(&p_rate, 12, 6, 9 * modes, modes);
        let by_99 = p_fr * &state.omega + &p_ff * column(&state.q_dot);
        let by_100 = p_ff_rate * column(&state.q) + &p_ff * column(&state.q_dot);
        equal(&by_99, &by_100);
        equal(&by_99, &flexible_part(&coordinate_rates(state)));
    });
}

#[test]
fn equation_101_accelerations() {
    each_state(|_, state| {
        let w_dot = {
            let mut w = vec![0.2, 0.9, -0.6, 1.3, -0.4, 0.8];
            w.extend((0..state.q.len()).map(|mu| 0.5 - 0.3 * mu as f64));
            column(&w)
        };
        let found =
            projection(&state.floating) * &w_dot + projection_rate(&state.floating) * velocities(state);
        // By the product rule from d̈_i = ω̇ × d_i + ω × (ω × d_i).
        let (omega, alpha) = (as_vector(&state.omega), [1.3, -0.4, 0.8]);
        let first = director_rates(state);
        let second = [0, 1, 2].map(|i| {
            let (turn, centripetal) = (cross(alpha, state.d[i]), cross(omega, first[i]));
            [0, 1, 2].map(|j| turn[j] + centripetal[j])
        });
        let mut expected = vec![0.2, 0.9, -0.6];
        expected.extend(second.as_flattened());
        for mu in 0..state.q.len() {
            let (q, rate, acceleration) = (state.q[mu], state.q_dot[mu], w_dot[(6 + mu, 0)]);
            for i in 0..3 {
                expected.extend(
                    (0..3)
                        .map(|j| acceleration * state.d[i][j] + 2.0 * rate * first[i][j] + q * second[i][j]),
                );
            }
        }
        equal(&found, &column(&expected));
    });
}

#[test]
fn equation_102_rate_of_the_rotation_block() {
    each_state(|_, state| {
        let rates = director_rates(state).map(skew);
        let expected = Mat::from_fn(9, 3, |i, j| -rates[i / 3][(i % 3, j)]);
        equal(&block(&projection_rate(&state.floating), 3, 3, 9, 3), &expected);
    });
}

#[test]
fn equation_103_centripetal_terms() {
    each_state(|_, state| {
        let rate = block(&projection_rate(&state.floating), 3, 3, 9, 3);
        let omega = skew(as_vector(&state.omega));
        let expected = Mat::from_fn(9, 1, |i, _| (&omega * &omega * column(&state.d[i / 3]))[(i % 3, 0)]);
        equal(&(rate * &state.omega), &expected);
    });
}

#[test]
fn equation_104_rate_of_the_directors() {
    each_state(|_, state| {
        let omega = skew(as_vector(&state.omega));
        let rate = flexible_block((&omega * &state.a).as_ref());
        let by_directors =
            |d: [[f64; 3]; 3]| Mat::from_fn(9, 1, |i, _| (&omega * column(&d[i / 3]))[(i % 3, 0)]);
        equal(&rate, &by_directors(state.d));
        // Printed with ω̃ applied to the rates of the directors.
        different(&rate, &by_directors(director_rates(state)));
    });
}

#[test]
fn equation_105_flexible_block_moves_with_the_rotation() {
    each_state(|_, state| {
        let turning = skew(as_vector(&state.omega)) * &state.a;
        equal(&flexible_block(turning.as_ref()), &(&state.p_rr * &state.omega));
    });
}

#[test]
fn equation_106_rate_of_the_coupling_block() {
    each_state(|body, state| {
        let turning = skew(as_vector(&state.omega)) * &state.a;
        let p_rr_rate = rotation_block(turning.as_ref());
        let expected = Mat::from_fn(9 * body.mode_count(), 3, |i, j| {
            state.q_dot[i / 9] * state.p_rr[(i % 9, j)] + state.q[i / 9] * p_rr_rate[(i % 9, j)]
        });
        equal(&block(&projection_rate(&state.floating), 12, 3, 9 * body.mode_count(), 3), &expected);
    });
}
