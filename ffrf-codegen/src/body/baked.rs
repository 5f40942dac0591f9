//! A body whose invariants are constants.

use ffrf_model::{Matrix3, ReducedBody};

use super::raw::pairs;
use super::{BodyExpressions, MomentComponents};
use crate::expression::{Expression, Graph, Symmetric3};
use crate::invariants::{Invariant, Structure};
use crate::layout::{GramScales, found, negligible_first_moment};
use crate::options::ORTHOGONALITY_TOLERANCE;

impl BodyExpressions {
    /// The invariants of `body` as constants; entries below `tolerance` times their Gram scale are zero.
    ///
    /// The even and odd combinations of a moment have that test each, so that a symmetric T_μ (ϑ_μ = 0) is
    /// recognised. A Θ_ff found to be the identity is exactly that. `body` must have passed its shape check.
    pub fn baked(graph: &mut Graph, body: &ReducedBody, tolerance: f64) -> Self {
        let scales = GramScales::of(body);
        let structure = found(body, tolerance)[Invariant::ModalMass];
        let inertia = &body.inertia;
        let modes = || 0..body.mode_count();
        let mut number = Rounding { graph, tolerance };

        let modal_mass: Vec<Vec<Expression>> = modes()
            .map(|mu| {
                modes()
                    .map(|nu| match (structure, mu == nu) {
                        (Structure::Identity, true) => number.graph.one(),
                        (Structure::Identity | Structure::Diagonal, false) => number.graph.zero(),
                        _ => {
                            let value = mean_trace(&inertia.mode_mode_moment, mu, nu);
                            number.at(value, scales.modes[mu] * scales.modes[nu])
                        }
                    })
                    .collect()
            })
            .collect();
        let position_mode = modes()
            .map(|mu| {
                let moment = &inertia.position_mode_moment[mu];
                let scale = scales.position * scales.modes[mu];
                let trace = number.at(moment[0][0] + moment[1][1] + moment[2][2], scale);
                number.components(moment, trace, scale)
            })
            .collect();
        let mut mode_mode: Vec<Vec<MomentComponents>> = Vec::with_capacity(body.mode_count());
        for mu in modes() {
            let mut row = Vec::with_capacity(body.mode_count());
            for nu in modes() {
                // T_νμ = T_μνᵀ: what is stored below the diagonal is not read.
                row.push(if nu < mu {
                    mode_mode[nu][mu].transpose(number.graph)
                } else {
                    let mut moment = inertia.mode_mode_moment[mu][nu];
                    if mu == nu {
                        moment = symmetric_part(&moment);
                    }
                    let scale = scales.modes[mu] * scales.modes[nu];
                    number.components(&moment, modal_mass[mu][nu], scale)
                });
            }
            mode_mode.push(row);
        }
        // The even and odd combinations are negligible beside the largest entry of the pair of modes.
        let geometric = body.geometric_stiffness.as_ref();
        let second_order = pairs(body.mode_count(), |mu, nu| {
            let stiffness = geometric.map_or([[0.0; 3]; 3], |it| it.linear_load[mu][nu]);
            let moment = stiffness.map(|row| row.map(|entry| -entry));
            let scale = moment.as_flattened().iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
            let trace = number.at(moment[0][0] + moment[1][1] + moment[2][2], scale);
            number.components(&moment, trace, scale)
        });
        let second_order_first_moment = pairs(body.mode_count(), |mu, nu| {
            let stiffness = geometric.map_or([0.0; 3], |it| it.uniform_load[mu][nu]);
            let scale = stiffness.iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
            stiffness.map(|entry| number.at(-entry, scale))
        });
        let tensor = inertia.inertia_tensor();
        let scale = scales.position * scales.position;
        Self {
            mass: number.graph.constant(inertia.mass),
            first_moment: {
                let negligible = negligible_first_moment(body, &scales, tolerance);
                inertia
                    .first_moment
                    .map(|x| number.graph.constant(if x.abs() <= negligible { 0.0 } else { x }))
            },
            modal_first_moment: modes()
                .map(|mu| {
                    let scale = scales.translation * scales.modes[mu];
                    inertia.modal_first_moment[mu].map(|x| number.at(x, scale))
                })
                .collect(),
            inertia: Symmetric3 {
                diagonal: [0, 1, 2].map(|i| number.at(tensor[i][i], scale)),
                off_diagonal: [(1, 2), (0, 2), (0, 1)].map(|(i, j)| number.at(tensor[i][j], scale)),
            },
            position_mode,
            mode_mode,
            modal_mass,
            modal_mass_structure: structure,
            stiffness: number.symmetric(&body.stiffness, &scales.stiffness),
            damping: number.symmetric(&body.damping, &scales.damping),
            second_order_first_moment,
            second_order,
        }
    }
}

/// Turns numbers into constants, small ones into zero.
struct Rounding<'a> {
    graph: &'a mut Graph,
    tolerance: f64,
}

impl Rounding<'_> {
    fn at(&mut self, value: f64, scale: f64) -> Expression {
        let small = value.abs() <= self.tolerance * scale;
        self.graph.constant(if small { 0.0 } else { value })
    }

    fn components(&mut self, moment: &Matrix3, trace: Expression, scale: f64) -> MomentComponents {
        let [[_, xy, xz], [yx, yy, yz], [zx, zy, zz]] = *moment;
        let [yy, zz, a, b, c] = [yy, zz, xy + yx, xz + zx, yz + zy].map(|value| self.at(value, scale));
        let odd = [yz - zy, zx - xz, xy - yx].map(|value| self.at(value, scale));
        MomentComponents { even: [trace, yy, zz, a, b, c], odd }
    }

    fn symmetric(&mut self, matrix: &[Vec<f64>], scales: &[f64]) -> Vec<Vec<Expression>> {
        let modes = || 0..matrix.len();
        modes()
            .map(|mu| {
                modes()
                    .map(|nu| {
                        let value = 0.5 * matrix[mu][nu] + 0.5 * matrix[nu][mu];
                        let negligible =
                            self.tolerance.max(ORTHOGONALITY_TOLERANCE) * scales[mu] * scales[nu];
                        self.graph.constant(if value.abs() <= negligible { 0.0 } else { value })
                    })
                    .collect()
            })
            .collect()
    }
}

/// tr T_μν, with the round-off between T_μν and T_νμ shared evenly.
fn mean_trace(moments: &[Vec<Matrix3>], mu: usize, nu: usize) -> f64 {
    let trace = |matrix: &Matrix3| matrix[0][0] + matrix[1][1] + matrix[2][2];
    0.5 * trace(&moments[mu][nu]) + 0.5 * trace(&moments[nu][mu])
}

fn symmetric_part(matrix: &Matrix3) -> Matrix3 {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| 0.5 * matrix[i][j] + 0.5 * matrix[j][i]))
}
