//! What displacements of second order, ½ q_μ q_ν g_μν(n), add to the motion of the nodes.
//!
//! They are small beside those of first order: node n moves with J⁰ + J¹, where J⁰ = [I, -x̃_n, 0] is the rigid motion of the
//! undeformed body and J¹ = [0, -s̃_n, g_μν(n) q_ν] with s_n = ½ q_μ q_ν g_μν(n). Of their products those with one factor J¹ count:
//! the terms of second order in q and q̇.

use super::{Field, Oracle, OracleState, OracleValues, add, cross, inner, total};

impl Oracle<'_> {
    /// Adds the terms of second order to values that lack them.
    pub(super) fn add_second_order(&self, state: &OracleState, values: &mut OracleValues) {
        let OracleState { q, velocity, omega, q_dot } = state;
        let nothing: Field = vec![[0.0; 3]; self.model.nodes.len()];
        let positions = &self.model.nodes.positions;
        let half: Vec<f64> = q.iter().map(|q| 0.5 * q).collect();
        let shift = self.second(&half, q);
        let axis = |i: usize| -> [f64; 3] { std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }) };
        let turned =
            |i: usize, field: &Field| -> Field { field.iter().map(|x| cross(axis(i), *x)).collect() };
        let modes = 0..self.mode_count();
        let unit = |mu: usize| -> Vec<f64> {
            (0..self.mode_count()).map(|nu| if mu == nu { 1.0 } else { 0.0 }).collect()
        };
        let base: Vec<Field> = (0..3)
            .map(|i| vec![axis(i); positions.len()])
            .chain((0..3).map(|i| turned(i, positions)))
            .chain(modes.clone().map(|_| nothing.clone()))
            .collect();
        let extra: Vec<Field> = (0..3)
            .map(|_| nothing.clone())
            .chain((0..3).map(|i| turned(i, &shift)))
            .chain(modes.map(|mu| self.second(&unit(mu), q)))
            .collect();
        let weighted: Vec<Field> = extra.iter().map(|column| self.apply_mass(column)).collect();
        for (i, row) in values.mass_matrix.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry += inner(&base[i], &weighted[j]) + inner(&base[j], &weighted[i]);
            }
        }

        // Accelerations without those of the unknowns: ω × (ω × x), and ω × (ω × s) + 2 ω × ṡ + g_μν q̇_μ q̇_ν.
        let rate = self.second(q, q_dot);
        let steady = self.second(q_dot, q_dot);
        let centripetal = |x: &[f64; 3]| cross(*omega, cross(*omega, *x));
        let plain: Field = positions.iter().map(centripetal).collect();
        let added: Field = shift
            .iter()
            .zip(rate.iter().zip(&steady))
            .map(|(s, (rate, steady))| {
                let coriolis = cross(*omega, *rate).map(|entry| 2.0 * entry);
                add(add(centripetal(s), coriolis), *steady)
            })
            .collect();
        let weighted_added = self.apply_mass(&added);
        for (i, entry) in values.quadratic_velocity.iter_mut().enumerate() {
            *entry += inner(&base[i], &weighted_added) + inner(&plain, &weighted[i]);
        }

        let rigid: Field = positions.iter().map(|x| add(*velocity, cross(*omega, *x))).collect();
        let moving: Field = shift.iter().zip(&rate).map(|(s, rate)| add(cross(*omega, *s), *rate)).collect();
        let (momenta, added) = (self.apply_mass(&rigid), self.apply_mass(&moving));
        values.kinetic_energy += inner(&rigid, &added);
        values.linear_momentum = add(values.linear_momentum, total(&added));
        let moments: Field = positions
            .iter()
            .zip(&added)
            .zip(shift.iter().zip(&momenta))
            .map(|((x, added), (s, momentum))| add(cross(*x, *added), cross(*s, *momentum)))
            .collect();
        values.angular_momentum = add(values.angular_momentum, total(&moments));
    }

    /// g_μν a_μ b_ν, node by node.
    fn second(&self, a: &[f64], b: &[f64]) -> Field {
        let mut field: Field = vec![[0.0; 3]; self.model.nodes.len()];
        let Some(fields) = self.second_order else { return field };
        let mut pair = 0;
        for mu in 0..self.mode_count() {
            for nu in mu..self.mode_count() {
                let factor = if mu == nu { a[mu] * b[mu] } else { a[mu] * b[nu] + a[nu] * b[mu] };
                for (node, displacement) in field.iter_mut().enumerate() {
                    for (i, entry) in displacement.iter_mut().enumerate() {
                        *entry += factor * fields[(3 * node + i, pair)];
                    }
                }
                pair += 1;
            }
        }
        field
    }
}
