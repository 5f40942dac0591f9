//! Deformed invariants and quadratic velocity vector.

use super::groups::{Register, four, groups, load, splat, stored, zero};
use super::rigid::{add, cross, times, traced};
use super::{Four, LaneBody, Lanes, MomentTable, Moments, Registers, Scalar};

/// Everything that follows from a state before forces are known.
#[derive(Clone, Copy)]
pub struct State<T: Scalar, const G: usize> {
    /// `odd`: Θ_rf(q), source (204). `whirl`: modal rows of the quadratic velocity vector. `even` is spent.
    pub(super) modal: Moments<T, G>,
    /// m r(q). Source: (204).
    pub(super) first_moment: [T; 3],
    /// Θ_rr(q). Source: (204), symmetrised.
    pub(super) inertia: [T; 6],
    /// Θ_rf q̇.
    pub(super) spin: [T; 3],
    /// m B q̇.
    pub(super) momentum: [T; 3],
    /// Quadratic velocity vector: ω × (ω × m r + 2 m B q̇).
    pub(super) translation: [T; 3],
    /// Quadratic velocity vector: ω × (Θ_rr ω + Θ_rf q̇) + Θ̇_rr ω.
    pub(super) rotation: [T; 3],
}

impl<T: Scalar, const G: usize> State<T, G> {
    /// All zero, to be written by [`LaneBody::write_state`].
    #[inline(always)]
    pub fn zero() -> Self {
        let zero = [T::zero(); 3];
        Self {
            modal: Moments::zero(),
            first_moment: zero,
            inertia: [T::zero(); 6],
            spin: zero,
            momentum: zero,
            translation: zero,
            rotation: zero,
        }
    }
}

/// `sum + left * right`; a zero sum of the first of few groups is left out, which the compiler may not do itself.
///
/// With more groups the sums are loops, and taking the first round out of them costs more than it saves.
#[inline(always)]
pub(super) fn accumulate<T: Scalar, R: Registers<T>, const G: usize>(
    group: usize,
    left: Register<T, R>,
    right: Register<T, R>,
    sum: Register<T, R>,
) -> Register<T, R> {
    if const { G <= 2 } && group == 0 { left * right } else { left.multiply_add(right, sum) }
}

/// Horizontal sums of many registers, four at a time.
#[inline(always)]
pub(super) fn sums<T: Scalar, R: Registers<T>, const K: usize>(
    registers: R,
    sums: [Register<T, R>; K],
) -> [T; K] {
    let mut result = [T::zero(); K];
    let (fours, rest) = sums.as_chunks::<4>();
    let (places, last) = result.as_chunks_mut::<4>();
    for (place, four) in places.iter_mut().zip(fours) {
        *place = Register::<T, R>::sums(*four);
    }
    if let [register] = rest {
        last.fill(register.sum());
    } else if !rest.is_empty() {
        let mut padded = [zero::<T, R>(registers); 4];
        for (place, register) in padded.iter_mut().zip(rest) {
            *place = *register;
        }
        for (place, sum) in last.iter_mut().zip(Register::<T, R>::sums(padded)) {
            *place = sum;
        }
    }
    result
}

impl<C: Copy, const M: usize, const G: usize, P, R> LaneBody<'_, C, M, G, P, R> {
    /// Deformed invariants and quadratic velocity vector of one state. What is not used costs nothing.
    #[inline(always)]
    pub fn state<T: Scalar<Constant = C>>(&self, q: &[T; M], omega: [T; 3], q_dot: &[T; M]) -> State<T, G>
    where
        R: Registers<T>,
        P: MomentTable<T, M, G, R>,
    {
        let mut state = State::zero();
        self.write_state(q, omega, q_dot, &mut state);
        state
    }

    /// [`LaneBody::state`] into a given place, which holds [`State::zero`]: a large state is not moved.
    #[inline(always)]
    pub fn write_state<T: Scalar<Constant = C>>(
        &self,
        q: &[T; M],
        omega: [T; 3],
        q_dot: &[T; M],
        state: &mut State<T, G>,
    ) where
        R: Registers<T>,
        P: MomentTable<T, M, G, R>,
    {
        let registers = self.registers;
        if let Some(moment) = self.first_moment {
            state.first_moment = moment.map(T::constant);
        }
        self.moments.multiply(registers, q, q_dot, omega.map(|x| T::two() * x), &mut state.modal);
        let shortening = self.second_order(q, q_dot, &mut state.modal.odd);
        let (q, q_dot) = (groups::<T, R, M, G>(registers, q), groups::<T, R, M, G>(registers, q_dot));
        let coordinates = stored::<T, R, G>(&q);
        let weights = spin_weights(omega).map(|number| splat::<T, R>(registers, number));
        let mut change = [zero::<T, R>(registers); 6];
        let mut rate = [zero::<T, R>(registers); 6];
        let mut spin = [zero::<T, R>(registers); 3];
        let mut shift = [zero::<T, R>(registers); 3];
        let mut momentum = [zero::<T, R>(registers); 3];
        for g in 0..G {
            let (q, q_dot) = (q[g], q_dot[g]);
            let base = match self.position_mode_even {
                Some(even) => even[g].map(|numbers| four::<T, R>(registers, &numbers)),
                None => [zero::<T, R>(registers); 6],
            };
            let [traced] = self.trace.products::<T, R, 1>(registers, g, [q], [&coordinates]);
            let trace = base[0] + traced;
            let [even_yy, even_zz, even_xy, even_xz, even_yz] = &state.modal.even;
            let [_, base_yy, base_zz, base_xy, base_xz, base_yz] = base;
            // One by one, not by `map`, for the reason of `scaled`.
            let yy = load::<T, R>(registers, &even_yy[g]) + base_yy;
            let zz = load::<T, R>(registers, &even_zz[g]) + base_zz;
            let xy = load::<T, R>(registers, &even_xy[g]) + base_xy;
            let xz = load::<T, R>(registers, &even_xz[g]) + base_xz;
            let yz = load::<T, R>(registers, &even_yz[g]) + base_yz;
            let deformed = [trace, yy, zz, xy, xz, yz];
            for component in 0..6 {
                let twice = base[component] + deformed[component];
                change[component] = accumulate::<T, R, G>(g, twice, q, change[component]);
                rate[component] = accumulate::<T, R, G>(g, deformed[component], q_dot, rate[component]);
            }
            let force = trace.multiply_add(weights[0], load::<T, R>(registers, &state.modal.whirl[g]))
                + yy.multiply_add(weights[1], zz * weights[2])
                + xy.multiply_add(weights[3], xz.multiply_add(weights[4], yz * weights[5]));
            state.modal.whirl[g] = force.store();
            for axis in 0..3 {
                let mut coupling = load::<T, R>(registers, &state.modal.odd[axis][g]);
                if let Some(base) = self.position_mode_odd {
                    coupling = coupling + four::<T, R>(registers, &base[g][axis]);
                    state.modal.odd[axis][g] = coupling.store();
                }
                spin[axis] = accumulate::<T, R, G>(g, coupling, q_dot, spin[axis]);
                if let Some(moment) = self.modal_first_moment {
                    let moment = four::<T, R>(registers, &moment[g][axis]);
                    shift[axis] = accumulate::<T, R, G>(g, moment, q, shift[axis]);
                    momentum[axis] = accumulate::<T, R, G>(g, moment, q_dot, momentum[axis]);
                }
            }
        }
        let [c0, c1, c2, c3, c4, c5] = change;
        let [r0, r1, r2, r3, r4, r5] = rate;
        let [s0, s1, s2] = spin;
        let [c0, c1, c2, c3, c4, c5, r0, r1, r2, r3, r4, r5, s0, s1, s2] =
            sums::<T, R, 15>(registers, [c0, c1, c2, c3, c4, c5, r0, r1, r2, r3, r4, r5, s0, s1, s2]);
        state.spin = [s0, s1, s2];
        state.inertia = add(self.inertia.map(T::constant), traced([c0, c1, c2, c3, c4, c5], T::half()));
        state.rotation = rotation(registers, omega, state, [r0, r1, r2, r3, r4, r5]);
        if self.second_order_odd.is_some() {
            state.rotation = add(state.rotation, shortening);
        }
        if self.modal_first_moment.is_some() {
            let [a, b, c] = shift;
            let [d, e, f] = momentum;
            let [a, b, c, d, e, f] = sums::<T, R, 6>(registers, [a, b, c, d, e, f]);
            state.first_moment = add(state.first_moment, [a, b, c]);
            state.momentum = [d, e, f];
        }
        if self.first_moment.is_some() || self.modal_first_moment.is_some() {
            let mut carried = cross(registers, omega, state.first_moment);
            if self.modal_first_moment.is_some() {
                carried = [0, 1, 2]
                    .map(|axis| registers.multiply_add(T::two(), state.momentum[axis], carried[axis]));
            }
            state.translation = cross(registers, omega, carried);
        }
    }

    /// Adds -ϑ(Γ_νμ) q_ν to Θ_rf, and returns -ϑ(Γ_μν) q̇_μ q̇_ν.
    #[inline(always)]
    fn second_order<T: Scalar<Constant = C>>(
        &self,
        q: &[T; M],
        q_dot: &[T; M],
        coupling: &mut [[[T; 4]; G]; 3],
    ) -> [T; 3]
    where
        R: Registers<T>,
    {
        let registers = self.registers;
        let Some(moments) = self.second_order_odd else { return [T::zero(); 3] };
        let rates = groups::<T, R, M, G>(registers, q_dot);
        let mut shortening = [zero::<T, R>(registers); 3];
        for g in 0..G {
            for axis in 0..3 {
                let mut turned = load::<T, R>(registers, &coupling[axis][g]);
                let mut rate = zero::<T, R>(registers);
                for ((moment, q), q_dot) in moments[g].iter().zip(q).zip(q_dot) {
                    let moment = four::<T, R>(registers, &moment[axis]);
                    turned = moment.multiply_add(splat::<T, R>(registers, *q), turned);
                    rate = moment.multiply_add(splat::<T, R>(registers, *q_dot), rate);
                }
                coupling[axis][g] = turned.store();
                shortening[axis] = accumulate::<T, R, G>(g, rate, rates[g], shortening[axis]);
            }
        }
        sums::<T, R, 3>(registers, shortening)
    }
}

/// ω × (Θ_rr ω + Θ_rf q̇) + Θ̇_rr ω
#[inline(always)]
fn rotation<T: Scalar, R: Registers<T>, const G: usize>(
    registers: R,
    omega: [T; 3],
    state: &State<T, G>,
    rate: [T; 6],
) -> [T; 3] {
    let growth = traced(rate, T::one());
    let growth =
        [T::two() * growth[0], T::two() * growth[1], T::two() * growth[2], growth[3], growth[4], growth[5]];
    let angular = add(times(registers, state.inertia, omega), state.spin);
    add(cross(registers, omega, angular), times(registers, growth, omega))
}

/// Factors of the even components in -ω · (tr(T) I - Tᵀ) ω.
#[inline(always)]
fn spin_weights<T: Scalar>([x, y, z]: [T; 3]) -> [T; 6] {
    let (xx, yy, zz) = (x * x, y * y, z * z);
    [-(yy + zz), yy - xx, zz - xx, x * y, x * z, y * z]
}
