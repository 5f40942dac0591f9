//! Deformed invariants and quadratic velocity vector.

use super::rigid::{add, cross, times, traced};
use super::scalar::{Register, groups};
use super::{Diagonal, Four, LaneBody, Lanes, MomentTable, Moments, Scalar};

/// Everything that follows from a state before forces are known.
pub type State<T, const G: usize> = (Deformed<T, G>, Quadratic<T, G>);

/// What depends on the deformation.
#[derive(Clone, Copy)]
pub struct Deformed<T: Scalar, const G: usize> {
    /// m r(q). Source: (204).
    pub(super) first_moment: [T; 3],
    /// Θ_rr(q). Source: (204), symmetrised.
    pub(super) inertia: [T; 6],
    /// Θ_rf(q), rows in lanes. Source: (204).
    pub(super) coupling: [[Register<T>; G]; 3],
    /// Θ_rf q̇.
    pub(super) spin: [T; 3],
    /// m B q̇.
    pub(super) momentum: [T; 3],
}

/// Quadratic velocity vector by its parts.
#[derive(Clone, Copy)]
pub struct Quadratic<T: Scalar, const G: usize> {
    pub(super) translation: [T; 3],
    pub(super) rotation: [T; 3],
    pub(super) modal: [Register<T>; G],
}

impl<T: Scalar, const G: usize> Diagonal<T, G> {
    /// The entries of a group times `lanes`.
    #[inline(always)]
    pub(super) fn times(&self, group: usize, lanes: Register<T>) -> Register<T> {
        match self {
            Self::Zero => Register::<T>::ZERO,
            Self::Identity => lanes,
            Self::Entries(entries) => Register::<T>::load(&entries[group]) * lanes,
        }
    }
}

/// Horizontal sums of many registers, four at a time.
#[inline(always)]
pub(super) fn sums<T: Scalar, const K: usize>(registers: [Register<T>; K]) -> [T; K] {
    let mut result = [T::ZERO; K];
    let (fours, rest) = registers.as_chunks::<4>();
    let (places, last) = result.as_chunks_mut::<4>();
    for (place, four) in places.iter_mut().zip(fours) {
        *place = Register::<T>::sums(*four);
    }
    for (place, register) in last.iter_mut().zip(rest) {
        *place = register.sum();
    }
    result
}

impl<T: Scalar, const M: usize, const G: usize, P: MomentTable<T, M, G>> LaneBody<T, M, G, P> {
    /// Deformed invariants and quadratic velocity vector of one state. What is not used costs nothing.
    #[inline(always)]
    pub fn state(&self, q: &[T; M], omega: [T; 3], q_dot: &[T; M]) -> (Deformed<T, G>, Quadratic<T, G>) {
        let Moments { mut even, odd, whirl } = self.moments.times(q, q_dot, omega.map(|x| T::TWO * x));
        let mut coupling = odd;
        let (q, q_dot) = (groups::<T, M, G>(q), groups::<T, M, G>(q_dot));
        let weights = spin_weights(omega).map(Register::<T>::splat);
        let mut change = [Register::<T>::ZERO; 6];
        let mut rate = [Register::<T>::ZERO; 6];
        let mut spin = [Register::<T>::ZERO; 3];
        let mut shift = [Register::<T>::ZERO; 3];
        let mut momentum = [Register::<T>::ZERO; 3];
        let mut modal = whirl;
        for g in 0..G {
            let (q, q_dot) = (q[g], q_dot[g]);
            let base = match self.position_mode_even {
                Some(even) => even[g].map(|numbers| Register::<T>::load(&numbers)),
                None => [Register::<T>::ZERO; 6],
            };
            let trace = base[0] + self.trace.times(g, q);
            for component in 0..5 {
                even[component][g] = even[component][g] + base[component + 1];
            }
            let [yy, zz, xy, xz, yz] = [0, 1, 2, 3, 4].map(|component| even[component][g]);
            let deformed = [trace, yy, zz, xy, xz, yz];
            for component in 0..6 {
                change[component] =
                    (base[component] + deformed[component]).multiply_add(q, change[component]);
                rate[component] = deformed[component].multiply_add(q_dot, rate[component]);
            }
            modal[g] = trace.multiply_add(weights[0], modal[g])
                + yy.multiply_add(weights[1], zz * weights[2])
                + xy.multiply_add(weights[3], xz.multiply_add(weights[4], yz * weights[5]));
            for axis in 0..3 {
                if let Some(base) = self.position_mode_odd {
                    coupling[axis][g] = coupling[axis][g] + Register::<T>::load(&base[g][axis]);
                }
                spin[axis] = coupling[axis][g].multiply_add(q_dot, spin[axis]);
                if let Some(moment) = self.modal_first_moment {
                    let moment = Register::<T>::load(&moment[g][axis]);
                    shift[axis] = moment.multiply_add(q, shift[axis]);
                    momentum[axis] = moment.multiply_add(q_dot, momentum[axis]);
                }
            }
        }
        let [c0, c1, c2, c3, c4, c5] = change;
        let [r0, r1, r2, r3, r4, r5] = rate;
        let [s0, s1, s2] = spin;
        let [c0, c1, c2, c3, c4, c5, r0, r1, r2, r3, r4, r5, s0, s1, s2] =
            sums::<T, 15>([c0, c1, c2, c3, c4, c5, r0, r1, r2, r3, r4, r5, s0, s1, s2]);
        let (change, rate, spin) = ([c0, c1, c2, c3, c4, c5], [r0, r1, r2, r3, r4, r5], [s0, s1, s2]);
        let mut first_moment = self.first_moment.unwrap_or([T::ZERO; 3]);
        let mut linear = [T::ZERO; 3];
        if self.modal_first_moment.is_some() {
            let [a, b, c] = shift;
            let [d, e, f] = momentum;
            let [a, b, c, d, e, f] = sums::<T, 6>([a, b, c, d, e, f]);
            first_moment = add(first_moment, [a, b, c]);
            linear = [d, e, f];
        }
        let inertia = add(self.inertia, traced(change, T::HALF));
        let deformed = Deformed { first_moment, inertia, coupling, spin, momentum: linear };
        let quadratic = Quadratic {
            translation: self.translation(omega, &deformed),
            rotation: rotation(omega, &deformed, rate),
            modal,
        };
        (deformed, quadratic)
    }

    /// ω × (ω × m r + 2 m B q̇)
    #[inline(always)]
    fn translation(&self, omega: [T; 3], deformed: &Deformed<T, G>) -> [T; 3] {
        if self.first_moment.is_none() && self.modal_first_moment.is_none() {
            return [T::ZERO; 3];
        }
        let mut carried = cross(omega, deformed.first_moment);
        if self.modal_first_moment.is_some() {
            for axis in 0..3 {
                carried[axis] = T::TWO.multiply_add(deformed.momentum[axis], carried[axis]);
            }
        }
        cross(omega, carried)
    }
}

/// ω × (Θ_rr ω + Θ_rf q̇) + Θ̇_rr ω
#[inline(always)]
fn rotation<T: Scalar, const G: usize>(omega: [T; 3], deformed: &Deformed<T, G>, rate: [T; 6]) -> [T; 3] {
    let growth = traced(rate, T::ONE);
    let growth =
        [T::TWO * growth[0], T::TWO * growth[1], T::TWO * growth[2], growth[3], growth[4], growth[5]];
    let angular = add(times(deformed.inertia, omega), deformed.spin);
    add(cross(omega, angular), times(growth, omega))
}

/// Factors of the even components in -ω · (tr(T) I - Tᵀ) ω.
#[inline(always)]
fn spin_weights<T: Scalar>([x, y, z]: [T; 3]) -> [T; 6] {
    let (xx, yy, zz) = (x * x, y * y, z * z);
    [-(yy + zz), yy - xx, zz - xx, x * y, x * z, y * z]
}
