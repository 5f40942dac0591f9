//! The constant numbers of a body, in lanes.

use super::{Compiled, Factors, ModalFactors};

/// A symmetric matrix over the modes, in groups of four; `C` is the type of the constants.
#[derive(Debug, Clone, Copy)]
pub enum ModalMatrix<'a, C, const M: usize, const G: usize> {
    /// Nothing: a dropped term.
    Zero,
    /// Ones.
    Identity,
    /// These entries.
    Diagonal(&'a [[C; 4]; G]),
    /// All entries: `[group][nu][lane]`, lanes over μ.
    Dense(&'a [[[C; 4]; M]; G]),
}

/// The invariants of a body with `M` modes in `G` groups of four lanes, padded with zero.
///
/// Frame: body. `C` is the type of the constants: that of the scalars which the kernels compute with, or the one
/// that these are made from ([`Scalar::Constant`](super::Scalar::Constant)). `P` is the table of the moments T_μν.
/// A layout without a term has `None` in its place.
#[derive(Debug, Clone, Copy)]
pub struct LaneBody<'a, C, const M: usize, const G: usize, P, R = Compiled> {
    /// What the loops compute in.
    pub registers: R,
    /// Mass m. Units: kg.
    pub mass: C,
    /// First moment m a. Shape: 3. Units: kg m.
    pub first_moment: Option<[C; 3]>,
    /// Modal first moments m b_μ. Shape: groups of 3 registers.
    pub modal_first_moment: Option<&'a [[[C; 4]; 3]; G]>,
    /// Inertia tensor Θ: xx, yy, zz, xy, xz, yz. Units: kg m².
    pub inertia: [C; 6],
    /// The mass that the modes leave for translation, m I - m B Θ_ff⁻¹ (m B)ᵀ. Units of the pivots: kg.
    pub translation_factors: Factors<C>,
    /// L⁻¹ (m B)ᵀ with the L of [`LaneBody::modal_factors`]. Shape: groups of 3 registers.
    pub eliminated_first_moment: Option<&'a [[[C; 4]; 3]; G]>,
    /// tr T_μ, then yy, zz, xy + yx, xz + zx, yz + zy of T_μ. Shape: groups of 6 registers.
    pub position_mode_even: Option<&'a [[[C; 4]; 6]; G]>,
    /// ϑ_μ. Shape: groups of 3 registers.
    pub position_mode_odd: Option<&'a [[[C; 4]; 3]; G]>,
    /// tr T_μν, which multiplies q in the trace of T_μ^d.
    pub trace: ModalMatrix<'a, C, M, G>,
    /// Θ_ff.
    pub modal_mass: ModalMatrix<'a, C, M, G>,
    /// Θ_ff in factors.
    pub modal_factors: ModalFactors<'a, C, M, G>,
    /// K_ff; zero if elastic forces are subtracted from `force` by the caller.
    pub stiffness: ModalMatrix<'a, C, M, G>,
    /// D_ff in the same way.
    pub damping: ModalMatrix<'a, C, M, G>,
    /// Moments T_μν, less the even part of the geometric stiffness Γ_μν.
    pub moments: P,
    /// -ϑ(Γ_μν): geometric stiffness of angular acceleration, `[group][nu][axis][lane]`, lanes over μ.
    pub second_order_odd: Option<&'a [[[[C; 4]; 3]; M]; G]>,
}

impl<'a, C: Copy, const M: usize, const G: usize, P, R> LaneBody<'a, C, M, G, P, R> {
    /// The same body in other registers.
    #[inline(always)]
    pub fn on<'b, S>(&'b self, registers: S) -> LaneBody<'b, C, M, G, &'b P, S>
    where
        'a: 'b,
    {
        LaneBody {
            registers,
            mass: self.mass,
            first_moment: self.first_moment,
            modal_first_moment: self.modal_first_moment,
            inertia: self.inertia,
            translation_factors: self.translation_factors,
            eliminated_first_moment: self.eliminated_first_moment,
            position_mode_even: self.position_mode_even,
            position_mode_odd: self.position_mode_odd,
            trace: self.trace,
            modal_mass: self.modal_mass,
            modal_factors: self.modal_factors,
            stiffness: self.stiffness,
            damping: self.damping,
            moments: &self.moments,
            second_order_odd: self.second_order_odd,
        }
    }
}
