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
//! strictly triangular); of a vibration it is multiplied by at most 0.38 (s = 3) or 0.51 (s = 4) per sweep, whatever h ω, and
//! of what J does not hold by O(h): ten digits of a body that turns by a twentieth of a turn per step take twenty sweeps and
//! more. Sweeps begin with k = 0: from five (s = 3) or eight (s = 4) on the result is stable for every h ω also where the
//! iteration is not at its end.
//!
//! Sources: Hairer, Wanner, Solving Ordinary Differential Equations II, IV.5 and IV.8 (methods), VI.3 (stiff parts); van der
//! Houwen, de Swart, Triangularly implicit iteration methods for ODE-IVP solvers, SIAM J. Sci. Comput. 18 (1997) 41-55 (T).

use nalgebra::RealField;

use super::system::{begin, finish, refusal, stage};
use super::{ImplicitSystem, StepError, StepReport, Tolerances, VectorSpace};

/// A Radau IIA method with `S` stages, order 2 S - 1, and when its equations count as solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RadauIIA<const S: usize, T = f64> {
    /// Most sweeps of a step, each with `S` evaluations of the loads and `S` factorisations.
    pub iterations: usize,
    /// The change of the step's end that ends the sweeps, or what the next ones are expected to change.
    pub tolerances: Tolerances<T>,
    /// The numbers of the method.
    pub coefficients: &'static RadauCoefficients<S>,
}

/// The numbers of a Radau IIA method and of its iteration, rounded from fifty digits.
#[derive(Debug, PartialEq)]
pub struct RadauCoefficients<const S: usize> {
    /// c.
    nodes: [f64; S],
    /// A; its last row are the weights.
    stages: [[f64; S]; S],
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

    /// One step from `state`; nothing is remembered between steps.
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
        let none = system.no_change(state);
        let combined = |weights: &[f64], rates: &[S2::Increment]| {
            let mut sum = none.clone();
            for (weight, rates) in weights.iter().zip(rates) {
                sum.add_scaled(h * nalgebra::convert(*weight), rates);
            }
            sum
        };
        let RadauCoefficients { nodes, stages, triangular, error } = self.coefficients;
        let mut rates: [S2::Increment; S] = core::array::from_fn(|_| none.clone());
        let mut changes = rates.clone();
        let mut before = None;
        let mut residual = T::zero();
        let weights: &[f64] = stages.last().map_or(&[], |row| row);
        let lead =
            triangular.last().and_then(|row| row.last()).map_or(h, |lead| h * nalgebra::convert(*lead));
        for iteration in 1..=self.iterations {
            for (index, ((node, row), leads)) in nodes.iter().zip(stages).zip(triangular).enumerate() {
                let mut increment = combined(row, &rates);
                // earlier stages have changed in this sweep: T for A
                for ((weight, lead), change) in row.iter().zip(leads).zip(&changes).take(index) {
                    increment.add_scaled(h * nalgebra::convert(*lead - *weight), change);
                }
                let (Some(rate), Some(lead)) = (rates.get_mut(index), leads.get(index)) else { continue };
                let moment = time + h * nalgebra::convert(*node);
                let corrected = correct(system, state, moment, increment, rate, h * nalgebra::convert(*lead));
                let change = stage(system, time, state, true, corrected)?;
                if let Some(place) = changes.get_mut(index) {
                    *place = change;
                }
            }
            residual = system.weighted_error(state, &combined(weights, &changes), &self.tolerances);
            if !residual.is_finite() {
                return Err(refusal(system, time + h, state, true));
            }
            // what the sweeps to come would change, if each changes the same share of the one before
            let expected = before.map(|before| residual / before).filter(|ratio| *ratio < T::one());
            let left = expected.map_or(residual, |ratio| residual * ratio / (T::one() - ratio));
            if residual.min(left) <= T::one() {
                let whole = combined(weights, &rates);
                let difference = combined(error, &rates);
                let (state, report) = finish(system, time + h, state, &whole, &difference, Some(lead))?;
                return Ok((state, StepReport { iterations: iteration, ..report }));
            }
            before = Some(residual);
        }
        Err(StepError::not_converged(self.iterations, residual))
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
