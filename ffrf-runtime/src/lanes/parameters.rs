//! Bodies whose invariants come at run time: tables made from them, call by call, for the same loops.
//!
//! Only what grows with M is put in lanes; the moments T_μν, which grow with M², are read where they are.

use core::marker::PhantomData;

use super::moment_structure::{MomentComponents, MomentStructure};
use super::{
    Compiled, Factors, LaneBody, ModalFactors, ModalMatrix, MomentTable, Moments, Registers, Scalar,
};

/// A diagonal matrix over the modes that is known when compiling or when running.
#[derive(Debug, Clone, Copy)]
pub enum ParameterDiagonal<E> {
    /// Nothing.
    Zero,
    /// Ones.
    Identity,
    /// These entries: a list, or groups of four lanes.
    Entries(E),
}

impl<E> ParameterDiagonal<E> {
    #[inline(always)]
    fn map<F>(self, change: impl FnOnce(E) -> F) -> ParameterDiagonal<F> {
        match self {
            Self::Zero => ParameterDiagonal::Zero,
            Self::Identity => ParameterDiagonal::Identity,
            Self::Entries(entries) => ParameterDiagonal::Entries(change(entries)),
        }
    }
}

impl<C, const G: usize> ParameterDiagonal<[[C; 4]; G]> {
    #[inline(always)]
    fn borrow<const M: usize>(&self) -> ModalMatrix<'_, C, M, G> {
        match self {
            Self::Zero => ModalMatrix::Zero,
            Self::Identity => ModalMatrix::Identity,
            Self::Entries(entries) => ModalMatrix::Diagonal(entries),
        }
    }

    /// These entries as 1 / D.
    #[inline(always)]
    fn factors<const M: usize>(&self) -> ModalFactors<'_, C, M, G> {
        match self {
            Self::Zero | Self::Identity => ModalFactors::Identity,
            Self::Entries(entries) => ModalFactors::Diagonal(entries),
        }
    }
}

/// The invariants of a body with `M` modes. What the layout or the fidelity leaves out is `None`.
#[derive(Debug, Clone, Copy)]
pub struct Parameters<C, const M: usize> {
    /// Mass m. Units: kg.
    pub mass: C,
    /// First moment m a. Shape: 3.
    pub first_moment: Option<[C; 3]>,
    /// m b_μ. Shape: M x 3.
    pub modal_first_moment: Option<[[C; 3]; M]>,
    /// Components of the second moment T.
    pub second_moment: MomentComponents<C>,
    /// Components of T_μ of which the even ones are used. Shape: M.
    pub position_mode_even: Option<[MomentComponents<C>; M]>,
    /// Components of T_μ of which the odd ones are used. Shape: M.
    pub position_mode_odd: Option<[MomentComponents<C>; M]>,
    /// Θ_ff.
    pub modal_mass: ParameterDiagonal<[C; M]>,
    /// Whether the trace of T_μν, which is Θ_ff, changes the inertia.
    pub has_trace: bool,
    /// K_ff if it is diagonal.
    pub stiffness: ParameterDiagonal<[C; M]>,
    /// D_ff if it is diagonal.
    pub damping: ParameterDiagonal<[C; M]>,
}

/// [`Parameters`] in groups of four lanes.
pub struct ParameterTables<C, const M: usize, const G: usize> {
    mass: C,
    first_moment: Option<[C; 3]>,
    modal_first_moment: Option<[[[C; 4]; 3]; G]>,
    inertia: [C; 6],
    translation_factors: Factors<C>,
    position_mode_even: Option<[[[C; 4]; 6]; G]>,
    position_mode_odd: Option<[[[C; 4]; 3]; G]>,
    modal_mass: ParameterDiagonal<[[C; 4]; G]>,
    inverse_modal_mass: ParameterDiagonal<[[C; 4]; G]>,
    has_trace: bool,
    stiffness: ParameterDiagonal<[[C; 4]; G]>,
    damping: ParameterDiagonal<[[C; 4]; G]>,
}

/// Rows of `K` numbers, one row per mode, as `K` registers per group.
#[inline(always)]
fn in_lanes<C: Scalar, const K: usize, const M: usize, const G: usize>(
    rows: [[C; K]; M],
) -> [[[C; 4]; K]; G] {
    let mut groups = [[[C::zero(); 4]; K]; G];
    let (whole, rest) = rows.as_chunks::<4>();
    for (group, rows) in groups.iter_mut().zip(whole) {
        for (k, register) in group.iter_mut().enumerate() {
            *register = [rows[0][k], rows[1][k], rows[2][k], rows[3][k]];
        }
    }
    if let Some(group) = groups.get_mut(whole.len()) {
        for (k, register) in group.iter_mut().enumerate() {
            for (lane, row) in register.iter_mut().zip(rest) {
                *lane = row[k];
            }
        }
    }
    groups
}

#[inline(always)]
fn diagonal_in_lanes<C: Scalar, const M: usize, const G: usize>(
    diagonal: ParameterDiagonal<[C; M]>,
) -> ParameterDiagonal<[[C; 4]; G]> {
    diagonal.map(|entries| in_lanes::<C, 1, M, G>(entries.map(|entry| [entry])).map(|[group]| group))
}

impl<C: Scalar, const M: usize> Parameters<C, M> {
    /// The tables. Θ_ff and the mass left for translation are factorised here, once a call.
    #[inline(always)]
    pub fn tables<const G: usize>(self) -> ParameterTables<C, M, G> {
        const { assert!(4 * G >= M) };
        let inverse_modal_mass = self.modal_mass.map(|entries| entries.map(|mass| C::one() / mass));
        let [trace, yy, zz, xy, xz, yz] = self.second_moment.even;
        let half = C::half();
        ParameterTables {
            mass: self.mass,
            first_moment: self.first_moment,
            translation_factors: self.translation_factors(&inverse_modal_mass),
            modal_first_moment: self.modal_first_moment.map(in_lanes),
            // The even components hold both halves of a symmetric matrix.
            inertia: [yy + zz, trace - yy, trace - zz, -half * xy, -half * xz, -half * yz],
            position_mode_even: self
                .position_mode_even
                .map(|moments| in_lanes(moments.map(|moment| moment.even))),
            position_mode_odd: self
                .position_mode_odd
                .map(|moments| in_lanes(moments.map(|moment| moment.odd))),
            modal_mass: diagonal_in_lanes(self.modal_mass),
            inverse_modal_mass: diagonal_in_lanes(inverse_modal_mass),
            has_trace: self.has_trace,
            stiffness: diagonal_in_lanes(self.stiffness),
            damping: diagonal_in_lanes(self.damping),
        }
    }

    /// m I - m B Θ_ff⁻¹ (m B)ᵀ in factors.
    #[inline(always)]
    fn translation_factors(&self, inverse_modal_mass: &ParameterDiagonal<[C; M]>) -> Factors<C> {
        let scale = C::one() / self.mass;
        let Some(rows) = &self.modal_first_moment else {
            return Factors { inverse_pivots: [scale; 3], lower: None };
        };
        let zero = C::zero();
        let mut left = [self.mass, self.mass, self.mass, zero, zero, zero];
        for (mu, b) in rows.iter().enumerate() {
            let weighted = match inverse_modal_mass {
                ParameterDiagonal::Entries(entries) => b.map(|entry| entry * entries[mu]),
                _ => *b,
            };
            for (k, (i, j)) in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].into_iter().enumerate() {
                left[k] -= b[i] * weighted[j];
            }
        }
        Factors::new(Compiled, left, scale)
    }
}

impl<C: Copy, const M: usize, const G: usize> ParameterTables<C, M, G> {
    /// The body for the loops, with its moments.
    #[inline(always)]
    pub fn body<P>(&self, moments: P) -> LaneBody<'_, C, M, G, P> {
        LaneBody {
            registers: Compiled,
            mass: self.mass,
            first_moment: self.first_moment,
            modal_first_moment: self.modal_first_moment.as_ref(),
            inertia: self.inertia,
            translation_factors: self.translation_factors,
            eliminated_first_moment: self.modal_first_moment.as_ref(),
            position_mode_even: self.position_mode_even.as_ref(),
            position_mode_odd: self.position_mode_odd.as_ref(),
            trace: if self.has_trace { self.modal_mass.borrow() } else { ModalMatrix::Zero },
            modal_mass: self.modal_mass.borrow(),
            modal_factors: self.inverse_modal_mass.factors(),
            stiffness: self.stiffness.borrow(),
            damping: self.damping.borrow(),
            moments,
            second_order_odd: None,
        }
    }
}

/// tr T_μμ of every mode. Shape: M.
#[inline(always)]
pub fn traces<C: Scalar, S: MomentStructure<C>, const M: usize>(moments: &[[S::Entry; M]; M]) -> [C; M] {
    let mut traces = [C::zero(); M];
    for mu in 0..M {
        [traces[mu], ..] = S::components(&moments[mu][mu]).even;
    }
    traces
}

/// The moments T_μν of a body as they are given, read where μ <= ν. `EVEN` and `ODD` components count.
pub struct ParameterMoments<'a, C, S: MomentStructure<C>, const M: usize, const EVEN: bool, const ODD: bool> {
    moments: &'a [[S::Entry; M]; M],
    structure: PhantomData<S>,
}

impl<'a, C, S: MomentStructure<C>, const M: usize, const EVEN: bool, const ODD: bool>
    ParameterMoments<'a, C, S, M, EVEN, ODD>
{
    /// T_μν at `[mu][nu]`.
    #[inline(always)]
    pub fn new(moments: &'a [[S::Entry; M]; M]) -> Self {
        Self { moments, structure: PhantomData }
    }
}

impl<T, S, R, const M: usize, const G: usize, const EVEN: bool, const ODD: bool> MomentTable<T, M, G, R>
    for ParameterMoments<'_, T::Constant, S, M, EVEN, ODD>
where
    T: Scalar,
    R: Registers<T>,
    S: MomentStructure<T::Constant>,
{
    /// Each pair of modes once: T_νμ = T_μνᵀ has the same even components and odd ones of the other sign.
    #[inline(always)]
    fn multiply(
        &self,
        registers: R,
        q: &[T; M],
        q_dot: &[T; M],
        two_omega: [T; 3],
        moments: &mut Moments<T, G>,
    ) {
        let zero = T::zero();
        let mut even = [[zero; M]; 5];
        let mut odd = [[zero; M]; 3];
        let mut whirl = [zero; M];
        for mu in 0..M {
            for nu in mu..M {
                let MomentComponents { even: [_, components @ ..], odd: axes } =
                    S::components(&self.moments[mu][nu]);
                if EVEN {
                    for (sums, component) in even.iter_mut().zip(components) {
                        let component = T::constant(component);
                        sums[mu] = registers.multiply_add(component, q[nu], sums[mu]);
                        if nu > mu {
                            sums[nu] = registers.multiply_add(component, q[mu], sums[nu]);
                        }
                    }
                }
                if ODD && nu > mu {
                    let axes = axes.map(T::constant);
                    for (sums, axis) in odd.iter_mut().zip(axes) {
                        sums[mu] = registers.multiply_add(-axis, q[nu], sums[mu]);
                        sums[nu] = registers.multiply_add(axis, q[mu], sums[nu]);
                    }
                    let along = axes[0] * two_omega[0] + (axes[1] * two_omega[1] + axes[2] * two_omega[2]);
                    whirl[mu] = registers.multiply_add(-along, q_dot[nu], whirl[mu]);
                    whirl[nu] = registers.multiply_add(along, q_dot[mu], whirl[nu]);
                }
            }
        }
        let put = |groups: &mut [[T; 4]; G], numbers: [T; M]| {
            for (place, number) in groups.as_flattened_mut().iter_mut().zip(numbers) {
                *place = number;
            }
        };
        for (groups, numbers) in moments.even.iter_mut().zip(even) {
            put(groups, numbers);
        }
        for (groups, numbers) in moments.odd.iter_mut().zip(odd) {
            put(groups, numbers);
        }
        put(&mut moments.whirl, whirl);
    }
}
