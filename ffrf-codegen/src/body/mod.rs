//! The invariants of a body as expressions: constants where they are baked in, symbols where they come at run time.

mod baked;
mod raw;
mod significant;
mod symbolic;

pub use raw::{Matrix, RawInertia};
pub(crate) use raw::{matrix, trace};
pub use significant::significant;
pub use symbolic::{modal_matrix, raw_inertia};

use crate::expression::{Expression, Graph, Symmetric3, Vector, negate3};
use crate::fidelity::{EnergyTerm, Fidelity};
use crate::invariants::Structure;

/// A moment T^{ij} in the nine combinations that the equations use.
///
/// Θ = tr(T) I - Tᵀ and ϑ = ε_ijk T^{ij} e_k need T only through these; the first six are even under
/// T -> Tᵀ, the last three odd. With Θ_ff known, the trace of T_μν needs no operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MomentComponents {
    /// Trace, yy, zz, xy + yx, xz + zx, yz + zy.
    pub even: [Expression; 6],
    /// Axial vector ϑ: yz - zy, zx - xz, xy - yx.
    pub odd: Vector,
}

impl MomentComponents {
    /// The components of a matrix, with the trace given apart.
    pub fn of(graph: &mut Graph, matrix: &Matrix, trace: Expression) -> Self {
        let [[_, xy, xz], [yx, yy, yz], [zx, zy, zz]] = *matrix;
        let even = [trace, yy, zz, graph.add(xy, yx), graph.add(xz, zx), graph.add(yz, zy)];
        let odd = [graph.subtract(yz, zy), graph.subtract(zx, xz), graph.subtract(xy, yx)];
        Self { even, odd }
    }

    /// The components of the transpose.
    pub fn transpose(&self, graph: &mut Graph) -> Self {
        Self { even: self.even, odd: self.odd.map(|component| graph.negate(component)) }
    }
}

/// Every invariant of a body with M modes, in the form that the structured kernels use.
///
/// Frame: body. Source: (206)-(208), corrected. See [`ffrf_model::Inertia`] for shapes and units.
#[derive(Debug, Clone)]
pub struct BodyExpressions {
    /// Mass m.
    pub mass: Expression,
    /// First moment m a.
    pub first_moment: Vector,
    /// Modal first moments m b_μ. Shape: M x 3.
    pub modal_first_moment: Vec<Vector>,
    /// Inertia tensor Θ = tr(T) I - T.
    pub inertia: Symmetric3,
    /// Components of T_μ. Shape: M.
    pub position_mode: Vec<MomentComponents>,
    /// Components of T_μν, at `[mu][nu]`. Shape: M x M.
    pub mode_mode: Vec<Vec<MomentComponents>>,
    /// Modal mass Θ_ff = [tr T_μν]. Shape: M x M.
    pub modal_mass: Vec<Vec<Expression>>,
    /// Structure of the modal mass: identity, diagonal or symmetric.
    pub modal_mass_structure: Structure,
    /// Modal stiffness K_ff. Shape: M x M.
    pub stiffness: Vec<Vec<Expression>>,
    /// Modal damping D_ff. Shape: M x M.
    pub damping: Vec<Vec<Expression>>,
    /// Second-order first moments, -Γ_μν of uniform loads. Shape: M x M, symmetric.
    pub second_order_first_moment: Vec<Vec<Vector>>,
    /// Components of the second-order moments, -Γ_μν of linear loads. Shape: M x M, symmetric, odd components too.
    ///
    /// They stand to the displacements of second order in q, on which uniform and linear loads do the work that stress
    /// stiffness stores, as T_μ stands to those of first order.
    pub second_order: Vec<Vec<MomentComponents>>,
}

impl BodyExpressions {
    /// Number of modes M.
    pub fn mode_count(&self) -> usize {
        self.modal_first_moment.len()
    }

    /// From full matrices, all expressions of `graph`.
    pub fn from_raw(
        graph: &mut Graph,
        raw: &RawInertia,
        modal_mass_structure: Structure,
        stiffness: Vec<Vec<Expression>>,
        damping: Vec<Vec<Expression>>,
    ) -> Self {
        let modes = raw.mode_count();
        let position_mode = raw
            .position_mode_moment
            .iter()
            .map(|matrix| {
                let trace = trace(graph, matrix);
                MomentComponents::of(graph, matrix, trace)
            })
            .collect();
        let mut mode_mode = Vec::with_capacity(modes);
        for mu in 0..modes {
            let mut row = Vec::with_capacity(modes);
            for nu in 0..modes {
                let trace = raw.modal_mass[mu][nu];
                row.push(MomentComponents::of(graph, &raw.mode_mode_moment[mu][nu], trace));
            }
            mode_mode.push(row);
        }
        let second_order = raw::pairs(modes, |mu, nu| {
            let stiffness = &raw.linear_load_stiffness[mu][nu];
            let moment = matrix(|i, j| graph.negate(stiffness[i][j]));
            let trace = trace(graph, &moment);
            MomentComponents::of(graph, &moment, trace)
        });
        let second_order_first_moment =
            raw::pairs(modes, |mu, nu| negate3(graph, raw.uniform_load_stiffness[mu][nu]));
        Self {
            mass: raw.mass,
            first_moment: raw.first_moment,
            modal_first_moment: raw.modal_first_moment.clone(),
            inertia: inertia_tensor(graph, &raw.second_moment),
            position_mode,
            mode_mode,
            modal_mass: raw.modal_mass.clone(),
            modal_mass_structure,
            stiffness,
            damping,
            second_order_first_moment,
            second_order,
        }
    }

    /// The body with zero in the place of every invariant that only dropped terms of the energy use.
    ///
    /// The structured kernels are linear in the components, and each component enters the energy in one
    /// term: the even ones of T_μ in the first-order change of inertia, the odd ones in Ξ, and so on. Zeroing a
    /// component thus drops that term of the *energy* and all that follows from it, and nothing else.
    pub fn truncated(&self, graph: &mut Graph, fidelity: &Fidelity) -> Self {
        let zero = graph.zero();
        let mut body = self.clone();
        if !fidelity.keeps(EnergyTerm::FirstMoment) {
            body.first_moment = [zero; 3];
        }
        if !fidelity.keeps(EnergyTerm::ModalMomentum) {
            body.modal_first_moment.fill([zero; 3]);
        }
        for components in &mut body.position_mode {
            if !fidelity.keeps(EnergyTerm::RotationLinear) {
                components.even = [zero; 6];
            }
            if !fidelity.keeps(EnergyTerm::ModalRotation) {
                components.odd = [zero; 3];
            }
        }
        for components in body.mode_mode.iter_mut().flatten() {
            if !fidelity.keeps(EnergyTerm::RotationQuadratic) {
                components.even = [zero; 6];
            }
            if !fidelity.keeps(EnergyTerm::ModalRotationDeformed) {
                components.odd = [zero; 3];
            }
        }
        for components in body.second_order.iter_mut().flatten() {
            if !fidelity.keeps(EnergyTerm::CentrifugalStiffening) {
                components.even = [zero; 6];
            }
            if !fidelity.keeps(EnergyTerm::AngularAccelerationStiffening) {
                components.odd = [zero; 3];
            }
        }
        if !fidelity.keeps(EnergyTerm::LinearAccelerationStiffening) {
            body.second_order_first_moment.iter_mut().flatten().for_each(|moment| *moment = [zero; 3]);
        }
        body
    }
}

/// Θ = tr(T) I - T
fn inertia_tensor(graph: &mut Graph, second_moment: &Matrix) -> Symmetric3 {
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = *second_moment;
    Symmetric3 {
        diagonal: [graph.add(yy, zz), graph.add(xx, zz), graph.add(xx, yy)],
        off_diagonal: [graph.negate(yz), graph.negate(xz), graph.negate(xy)],
    }
}
