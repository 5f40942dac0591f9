//! One mode on its own: the exact answer of q̈ + d q̇ + ω² q to a start and to forces.

use nalgebra::RealField;

use super::{FlexibleBody, Increment, ModalMatrix, ModalVector, State};
use crate::integrators::Forcing;

/// Terms of the power series at an argument of at most one half: 2⁻²⁰ / 20! is far below round-off.
const TERMS: usize = 20;
/// Most doublings; more radians in one step have no phase left.
const MOST_DOUBLINGS: usize = 60;

/// What a mode with ω² and d (over the modal mass) does within a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Oscillator<T> {
    stiffness: T,
    damping: T,
    /// k: answer to a unit impulse.
    impulse: T,
    /// ∫ k: answer to a unit force.
    constant: T,
    /// ∫∫ k: answer to a force that grows from zero at unit rate.
    ramp: T,
    time: T,
}

impl<T: RealField + Copy> Oscillator<T> {
    /// By the power series of a fraction of `time`, doubled: no trigonometry, no case distinction between damped and
    /// overdamped, the same bits on every target. Units: 1/s², 1/s, s.
    pub(crate) fn new(stiffness: T, damping: T, time: T) -> Self {
        let (half, two): (T, T) = (nalgebra::convert(0.5), nalgebra::convert(2.0));
        let rate = stiffness.abs().sqrt().max(damping.abs());
        let (mut short, mut doublings) = (time, 0);
        while short * rate > half && doublings < MOST_DOUBLINGS {
            short *= half;
            doublings += 1;
        }
        // c_n t^n with (n + 2)(n + 1) c_{n+2} + d (n + 1) c_{n+1} + ω² c_n = 0
        let (mut before, mut term) = (T::zero(), short);
        let mut oscillator = Self {
            stiffness,
            damping,
            impulse: T::zero(),
            constant: T::zero(),
            ramp: T::zero(),
            time: short,
        };
        let mut n = T::one();
        for _ in 0..TERMS {
            oscillator.impulse += term;
            oscillator.constant += term * short / (n + T::one());
            oscillator.ramp += term * short * short / ((n + T::one()) * (n + two));
            let next =
                -(damping * n * term * short + stiffness * before * short * short) / (n * (n + T::one()));
            (before, term) = (term, next);
            n += T::one();
        }
        for _ in 0..doublings {
            let Self { impulse, constant, ramp, time, .. } = oscillator;
            let [from_place, from_rate] =
                [T::one() - stiffness * constant, T::one() - damping * impulse - stiffness * constant];
            oscillator.impulse = impulse + from_rate * impulse - stiffness * impulse * constant;
            oscillator.constant = constant + from_place * constant + impulse * impulse;
            oscillator.ramp = ramp + from_place * ramp + impulse * constant + time * constant;
            oscillator.time = time * two;
        }
        oscillator
    }

    /// Changes of place and rate in free vibration.
    fn free(&self, place: T, rate: T) -> [T; 2] {
        let held = self.stiffness * self.constant;
        [
            rate * self.impulse - place * held,
            -place * self.stiffness * self.impulse - rate * (self.damping * self.impulse + held),
        ]
    }
}

/// The modes of a body, each on its own, with their answers within one step size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oscillators<V, T = f64> {
    stiffness: V,
    damping: V,
    impulse: V,
    constant: V,
    ramp: V,
    step: T,
}

impl<V: ModalVector<T>, T: RealField + Copy> Oscillators<V, T> {
    /// The answers within `step` (s).
    ///
    /// `None` if modal mass, stiffness or damping are not diagonal, or the modal mass is not positive.
    pub fn new<B: FlexibleBody<T, Modal = V>>(body: &B, step: T) -> Option<Self> {
        let (ModalMatrix::Diagonal(mass), ModalMatrix::Diagonal(stiffness), ModalMatrix::Diagonal(damping)) =
            (body.modal_mass(), body.stiffness(), body.damping())
        else {
            return None;
        };
        let mut inverse = mass;
        for entry in inverse.as_mut_slice() {
            let positive = *entry > T::zero();
            if !positive {
                return None;
            }
            *entry = T::one() / *entry;
        }
        let (stiffness, damping) = (stiffness.times(&inverse), damping.times(&inverse));
        let [mut impulse, mut constant, mut ramp] = [(); 3].map(|()| inverse.clone());
        let answers = impulse.as_mut_slice().iter_mut().zip(constant.as_mut_slice()).zip(ramp.as_mut_slice());
        for ((stiffness, damping), ((impulse, constant), ramp)) in
            stiffness.as_slice().iter().zip(damping.as_slice()).zip(answers)
        {
            let oscillator = Oscillator::new(*stiffness, *damping, step);
            (*impulse, *constant, *ramp) = (oscillator.impulse, oscillator.constant, oscillator.ramp);
        }
        Some(Self { stiffness, damping, impulse, constant, ramp, step })
    }

    fn each(&self) -> impl Iterator<Item = Oscillator<T>> + '_ {
        let answers = self.impulse.as_slice().iter().zip(self.constant.as_slice()).zip(self.ramp.as_slice());
        let pairs = self.stiffness.as_slice().iter().zip(self.damping.as_slice());
        pairs.zip(answers).map(|((stiffness, damping), ((impulse, constant), ramp))| Oscillator {
            stiffness: *stiffness,
            damping: *damping,
            impulse: *impulse,
            constant: *constant,
            ramp: *ramp,
            time: self.step,
        })
    }

    /// The rates of free vibration in `state`; all else is at rest.
    pub fn rates(&self, state: &State<V, T>) -> Increment<V, T> {
        let mut rates = Increment::zeros(&state.modal_coordinates);
        rates.modal_coordinates = state.modal_rates.clone();
        rates.modal_rates.add_scaled(-T::one(), &self.stiffness.times(&state.modal_coordinates));
        rates.modal_rates.add_scaled(-T::one(), &self.damping.times(&state.modal_rates));
        rates
    }

    /// The change in free vibration from `state`; all else is at rest.
    pub fn free(&self, state: &State<V, T>) -> Increment<V, T> {
        let mut change = Increment::zeros(&state.modal_coordinates);
        let starts = state.modal_coordinates.as_slice().iter().zip(state.modal_rates.as_slice());
        let places =
            change.modal_coordinates.as_mut_slice().iter_mut().zip(change.modal_rates.as_mut_slice());
        for ((oscillator, (place, rate)), (place_change, rate_change)) in self.each().zip(starts).zip(places)
        {
            [*place_change, *rate_change] = oscillator.free(*place, *rate);
        }
        change
    }

    /// The change that rates cause within the step: of the modes by their vibration, of all else by their integral.
    pub fn forced(&self, rates: &Increment<V, T>, forcing: Forcing) -> Increment<V, T> {
        let (mut change, step) = (rates.clone(), self.step);
        change.scale(match forcing {
            Forcing::Constant => step,
            Forcing::Ramp => step * nalgebra::convert(0.5),
        });
        let places =
            change.modal_coordinates.as_mut_slice().iter_mut().zip(change.modal_rates.as_mut_slice());
        for ((oscillator, force), (place, rate)) in self.each().zip(rates.modal_rates.as_slice()).zip(places)
        {
            [*place, *rate] = match forcing {
                Forcing::Constant => [*force * oscillator.constant, *force * oscillator.impulse],
                Forcing::Ramp => [*force * oscillator.ramp / step, *force * oscillator.constant / step],
            };
        }
        change
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Round-off of some hundred radians.
    const EXACT: f64 = 1e-13;

    #[test]
    fn free_vibration_is_the_exact_one() {
        for (omega, damping, time) in
            [(3.0_f64, 0.0_f64, 0.1), (200.0, 0.0, 0.7), (40.0, 5.0, 0.3), (1e-3, 0.0, 1.0)]
        {
            let oscillator = Oscillator::new(omega * omega, damping, time);
            let nu = (omega * omega - 0.25 * damping * damping).sqrt();
            let (decay, [sine, cosine]) =
                ((-0.5 * damping * time).exp(), [(nu * time).sin(), (nu * time).cos()]);
            let impulse = decay * sine / nu;
            let place = decay * (cosine + 0.5 * damping * sine / nu);
            let [change, rate] = oscillator.free(1.0, 0.0);
            assert!((1.0 + change - place).abs() < EXACT, "{omega} {damping}: {change}");
            assert!(
                (rate + omega * omega * impulse).abs() < EXACT * omega.max(1.0),
                "{omega} {damping}: {rate}"
            );
            let [change, rate] = oscillator.free(0.0, 1.0);
            assert!((change - impulse).abs() < EXACT * time, "{omega} {damping}: {change}");
            assert!((1.0 + rate - (place - damping * impulse)).abs() < EXACT, "{omega} {damping}: {rate}");
        }
    }

    #[test]
    fn overdamped_and_free_modes_answer_forces() {
        // d >> ω: q̇ settles at 1/d; ω = 0: the answer to a force is known in closed form
        let (damping, time) = (50.0_f64, 0.4_f64);
        let oscillator = Oscillator::new(0.0, damping, time);
        let impulse = (1.0 - (-damping * time).exp()) / damping;
        let constant = (time - impulse) / damping;
        let ramp = (0.5 * time * time - constant) / damping;
        for (found, expected) in
            [(oscillator.impulse, impulse), (oscillator.constant, constant), (oscillator.ramp, ramp)]
        {
            assert!((found - expected).abs() < EXACT * expected, "{found} {expected}");
        }
        // without stiffness and damping: t, t²/2, t³/6
        let free = Oscillator::new(0.0, 0.0, 2.0);
        assert_eq!([free.impulse, free.constant], [2.0, 2.0]);
        assert!((free.ramp - 8.0_f64 / 6.0).abs() < EXACT);
    }
}
