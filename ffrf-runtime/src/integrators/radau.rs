//! Radau IIA methods of order five and seven, for systems that are stiff and smooth.
//!
//! The s stages of a step are at the nodes c of Radau, of which the last is the end of the step:
//!
//! ```text
//! k_i = f(t + c_i h, y ∘ h Σ_j a_ij k_j),        y_new = y ∘ h Σ_j a_sj k_j
//! ```
//!
//! in the chart about the state at the beginning. The order is 2 s - 1, that of each stage s. The last stage is the end: a part of
//! the motion that stiff springs and dampers tie to the rest has the error of the rest there, and one of the order h^s that is
//! as small as their time constants are. The methods are L-stable: what a step does not resolve is gone at once.
//!
//! All stages depend on each other. They are solved by sweeps over them, each with one quasi-Newton correction per stage in the
//! metric of a linearly implicit one ([`ImplicitSystem::correction`]), of γ h = t_ii h, where A = T U with the diagonal
//! of U one:
//!
//! ```text
//! Y_i = y ∘ h (Σ_j a_ij k_j + Σ_{j<i} t_ij Δk_j),        (I - t_ii h J) Δk_i = f(Y_i) - k_i
//! ```
//!
//! In a sweep that is the Newton iteration with T for A. The error that it leaves of a stiff part is gone after s sweeps (I - U is
//! strictly triangular); of a decay it is multiplied by at most 0.15 (s = 3) or 0.18 (s = 4) per sweep, of a vibration by at most
//! 0.38 or 0.51, whatever h ω, and of what J does not hold, as of the turning of frames, by O(h).
//!
//! Sweeps begin with k_1 = 0, and with k_i = k_(i-1) once that is corrected. Between two sweeps the stages are mixed: let g be what
//! a sweep has led to and Δ the change of the step's end by it, g' and Δ' those of the sweep before. Then the next one begins at
//!
//! ```text
//! g - σ (g - g'),        σ in [-1, 1] with the least ‖Δ - σ (Δ - Δ')‖
//! ```
//!
//! in the norm of the tolerances: Anderson's acceleration of depth one. The error of the end after a sweep is taken as
//! ‖Δ‖ ‖g - g'‖ / ‖Δ - Δ'‖, with g and g' seen at the end as well: as if a sweep did to it what it did to the difference of the two
//! before. Sweeps end when that is within tolerance, or ‖Δ‖ is. Computed for one oscillator: from five (s = 3) or six sweeps
//! (s = 4) on the result does not grow for any h ω, also where the iteration is not at its end.
//!
//! Sources: Hairer, Wanner, Solving Ordinary Differential Equations II, IV.5 and IV.8 (methods), VI.3 (stiff parts); van der
//! Houwen, de Swart, Triangularly implicit iteration methods for ODE-IVP solvers, SIAM J. Sci. Comput. 18 (1997) 41-55 (T);
//! Walker, Ni, Anderson acceleration for fixed-point iterations, SIAM J. Numer. Anal. 49 (2011) 1715-1735.

use nalgebra::RealField;

use super::mixing::Sweep;
use super::system::{begin, finish, refusal, stage};
use super::{ImplicitSystem, StepError, StepReport, Tolerances, VectorSpace};

/// A Radau IIA method with `S` stages, order 2 S - 1, and when its equations count as solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RadauIIA<const S: usize, T = f64> {
    /// Most sweeps of a step, each with `S` evaluations of the loads and `S` factorisations.
    pub iterations: usize,
    /// The change of the step's end that ends the sweeps, or the error of the end that is estimated to be left.
    pub tolerances: Tolerances<T>,
    /// The numbers of the method.
    pub coefficients: &'static RadauCoefficients<S>,
}

/// The numbers of a Radau IIA method and of its iteration, rounded from fifty digits.
#[derive(Debug, PartialEq)]
pub struct RadauCoefficients<const S: usize> {
    /// c.
    pub(super) nodes: [f64; S],
    /// A; its last row are the weights.
    pub(super) stages: [[f64; S]; S],
    /// T: on and below its diagonal.
    triangular: [[f64; S]; S],
    /// Weights less those of the quadrature with all nodes but the first.
    error: [f64; S],
}

#[rustfmt::skip]
static ORDER_FIVE: RadauCoefficients<3> = RadauCoefficients {
    nodes: [0.1550510257216822, 0.6449489742783178, 1.0],
    stages: [
        [0.1968154772236604, -0.06553542585019839, 0.02377097434822015],
        [0.3944243147390873, 0.2920734116652285, -0.04154875212599793],
        [0.37640306270046725, 0.5124858261884216, 0.1111111111111111],
    ],
    triangular: [
        [0.1968154772236604, 0.0, 0.0],
        [0.3944243147390873, 0.42340843570261305, 0.0],
        [0.37640306270046725, 0.6378201512799474, 0.2],
    ],
    error: [0.37640306270046725, -0.8957624642754414, 0.5193594015749742],
};

#[rustfmt::skip]
static ORDER_SEVEN: RadauCoefficients<4> = RadauCoefficients {
    nodes: [0.08858795951270394, 0.4094668644407347, 0.787659461760847, 1.0],
    stages: [
        [0.11299947932315618, -0.04030922072352221, 0.025802377420336392, -0.009904676507266424],
        [0.23438399574740026, 0.2068925739353589, -0.04785712804854072, 0.016047422806516273],
        [0.21668178462325033, 0.4061232638673733, 0.18903651817005634, -0.02418210489983294],
        [0.22046221117676837, 0.3881934688431719, 0.32884431998005975, 0.0625],
    ],
    triangular: [
        [0.11299947932315618, 0.0, 0.0, 0.0],
        [0.23438399574740026, 0.2905021292645839, 0.0, 0.0],
        [0.21668178462325033, 0.48341807916618545, 0.3082576600150099, 0.0],
        [0.22046221117676837, 0.466836839456465, 0.441415881458443, 0.11764705882352941],
    ],
    error: [0.22046221117676837, -0.6289458035993799, 0.8028680023661605, -0.39438440994354895],
};

impl<T: RealField + Copy> RadauIIA<3, T> {
    /// Order five with three stages: at most 40 sweeps, to ten digits or what the number type has.
    pub fn order_five() -> Self {
        Self::with(&ORDER_FIVE)
    }
}

impl<T: RealField + Copy> RadauIIA<4, T> {
    /// Order seven with four stages: at most 40 sweeps, to ten digits or what the number type has.
    pub fn order_seven() -> Self {
        Self::with(&ORDER_SEVEN)
    }
}

impl<const S: usize, T: RealField + Copy> RadauIIA<S, T> {
    fn with(coefficients: &'static RadauCoefficients<S>) -> Self {
        let relative = nalgebra::convert::<f64, T>(1e-10).max(T::default_epsilon() * nalgebra::convert(64.0));
        let tolerances = Tolerances { relative, absolute: relative * nalgebra::convert(0.01) };
        Self { iterations: 40, tolerances, coefficients }
    }

    /// One step from `state`; nothing is remembered between steps, see [`step_from`](Self::step_from).
    ///
    /// At most [`iterations`](Self::iterations) times `S` evaluations and factorisations; no allocation, bounded work. The error
    /// estimate is the difference to the quadrature of order S - 1 with all stages but the first.
    ///
    /// Units: `time`, `step` s. Errors: see [`StepError`]; [`StepError::NotConverged`] with the last change if the step is too large
    /// for what is neither stiffness nor damping.
    pub fn step<S2: ImplicitSystem<T>>(
        &self,
        system: &S2,
        state: &S2::State,
        time: T,
        step: T,
    ) -> Result<(S2::State, StepReport<T>), StepError> {
        let h = begin(system, state, step)?;
        let solving = Solving { system, state, time, h, coefficients: self.coefficients };
        let size = |change: &S2::Increment| system.weighted_error(state, change, &self.tolerances);
        let mut rates = solving.at_rest();
        let mut changes = rates.clone();
        let mut before: Option<Sweep<S2::Increment, T, S>> = None;
        let mut residual = T::zero();
        for iteration in 1..=self.iterations {
            solving.sweep(&mut rates, &mut changes, iteration == 1)?;
            let change = solving.at_end(&changes);
            residual = size(&change);
            if !residual.is_finite() {
                return Err(refusal(system, time + h, state, true));
            }
            let sweep = Sweep { end: solving.at_end(&rates), rates: rates.clone(), change, residual };
            let outlook = before.as_ref().map(|before| (before, sweep.after(before, size)));
            let left = outlook.as_ref().map_or(residual, |(_, outlook)| outlook.left);
            if residual.min(left) <= T::one() {
                let (state, report) = solving.finish(&rates, &sweep.end)?;
                return Ok((state, StepReport { iterations: iteration, ..report }));
            }
            if let Some((before, outlook)) = outlook {
                rates = sweep.mixed(before, outlook.share);
            }
            before = Some(sweep);
        }
        Err(StepError::not_converged(self.iterations, residual))
    }
}

/// A step whose stages are to be found.
pub(super) struct Solving<'a, S2: ImplicitSystem<T>, const S: usize, T: RealField + Copy> {
    pub system: &'a S2,
    /// At its beginning.
    pub state: &'a S2::State,
    /// At its beginning. Units: s.
    pub time: T,
    /// Its size. Units: s.
    pub h: T,
    pub coefficients: &'static RadauCoefficients<S>,
}

impl<S2: ImplicitSystem<T>, const S: usize, T: RealField + Copy> Solving<'_, S2, S, T> {
    /// No rates.
    pub fn at_rest(&self) -> [S2::Increment; S] {
        core::array::from_fn(|_| self.system.no_change(self.state))
    }

    /// The change of the state by `rates` with these weights.
    pub fn combined(&self, weights: &[f64], rates: &[S2::Increment]) -> S2::Increment {
        let mut sum = self.system.no_change(self.state);
        for (weight, rates) in weights.iter().zip(rates) {
            sum.add_scaled(self.h * nalgebra::convert(*weight), rates);
        }
        sum
    }

    /// The change of the state over the step.
    pub fn at_end(&self, rates: &[S2::Increment]) -> S2::Increment {
        self.combined(self.coefficients.stages.last().map_or(&[], |row| row), rates)
    }

    /// Corrects `rates` stage by stage; `changes` is what it has changed. `follow`: each stage begins where the one before it has come to.
    pub fn sweep(
        &self,
        rates: &mut [S2::Increment; S],
        changes: &mut [S2::Increment; S],
        follow: bool,
    ) -> Result<(), StepError> {
        let Self { system, state, time, h, coefficients } = *self;
        let RadauCoefficients { nodes, stages, triangular, .. } = coefficients;
        for (index, ((node, row), leads)) in nodes.iter().zip(stages).zip(triangular).enumerate() {
            let mut increment = self.combined(row, rates);
            // earlier stages have changed in this sweep: T for A
            for ((weight, lead), change) in row.iter().zip(leads).zip(&*changes).take(index) {
                increment.add_scaled(h * nalgebra::convert(*lead - *weight), change);
            }
            let (Some(rate), Some(lead)) = (rates.get_mut(index), leads.get(index)) else { continue };
            let moment = time + h * nalgebra::convert(*node);
            let corrected = correct(system, state, moment, increment, rate, h * nalgebra::convert(*lead));
            let change = stage(system, time, state, true, corrected)?;
            if let Some(place) = changes.get_mut(index) {
                *place = change;
            }
            if follow {
                // where the next stage begins
                let found = rate.clone();
                if let Some(next) = rates.get_mut(index + 1) {
                    *next = found;
                }
            }
        }
        Ok(())
    }

    /// The end of the step that `rates` lead to by the change `end`.
    pub fn finish(
        &self,
        rates: &[S2::Increment; S],
        end: &S2::Increment,
    ) -> Result<(S2::State, StepReport<T>), StepError> {
        let RadauCoefficients { triangular, error, .. } = self.coefficients;
        let lead = triangular.last().and_then(|row| row.last());
        let lead = lead.map_or(self.h, |lead| self.h * nalgebra::convert(*lead));
        let difference = self.combined(error, rates);
        finish(self.system, self.time + self.h, self.state, end, &difference, Some(lead))
    }
}

/// One correction of the rates of a stage whose other stages give `increment`; the change, and `rates` changed by it.
fn correct<S: ImplicitSystem<T>, T: RealField + Copy>(
    system: &S,
    state: &S::State,
    time: T,
    mut increment: S::Increment,
    rates: &mut S::Increment,
    gamma_h: T,
) -> Result<S::Increment, StepError> {
    let before = rates.clone();
    let accelerations = system.velocities_only(rates);
    // the places follow from the velocities: their residual is taken away first
    let mut missing = system.place_rates(state, &increment);
    missing.add_scaled(T::one(), &accelerations);
    missing.add_scaled(-T::one(), &before);
    increment.add_scaled(gamma_h, &missing);
    let corrected = system.correction(time, state, &increment, &accelerations, gamma_h)?.accelerations;
    increment.add_scaled(gamma_h, &corrected);
    *rates = system.place_rates(state, &increment);
    rates.add_scaled(T::one(), &accelerations);
    rates.add_scaled(T::one(), &corrected);
    let mut change = rates.clone();
    change.add_scaled(-T::one(), &before);
    Ok(change)
}
