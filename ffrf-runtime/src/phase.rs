//! The state as a vector space: the stages of the integrators are sums of these.

use nalgebra::{Quaternion, RealField, SVector, Vector3};

use crate::rotation::{normalised, quaternion_rate};
use crate::step::{LocalError, StepReport};
use crate::{FlexibleBody, Load, State, StepError};

/// A state with a quaternion of any norm, or the rate of one.
#[derive(Clone, Copy)]
pub(crate) struct Phase<const M: usize, T: RealField + Copy> {
    pub position: Vector3<T>,
    pub quaternion: Quaternion<T>,
    pub modal_coordinates: SVector<T, M>,
    pub velocity: Vector3<T>,
    pub angular_velocity: Vector3<T>,
    pub modal_rates: SVector<T, M>,
}

impl<const M: usize, T: RealField + Copy> Phase<M, T> {
    pub fn of(state: &State<M, T>) -> Self {
        Self {
            position: state.position,
            quaternion: *state.orientation.quaternion(),
            modal_coordinates: state.modal_coordinates,
            velocity: state.velocity,
            angular_velocity: state.angular_velocity,
            modal_rates: state.modal_rates,
        }
    }

    /// self + factor * other.
    pub fn plus(&self, factor: T, other: &Self) -> Self {
        Self {
            position: self.position + other.position * factor,
            quaternion: self.quaternion + other.quaternion * factor,
            modal_coordinates: self.modal_coordinates + other.modal_coordinates * factor,
            velocity: self.velocity + other.velocity * factor,
            angular_velocity: self.angular_velocity + other.angular_velocity * factor,
            modal_rates: self.modal_rates + other.modal_rates * factor,
        }
    }

    /// factor * self.
    pub fn scaled(&self, factor: T) -> Self {
        Self {
            position: self.position * factor,
            quaternion: self.quaternion * factor,
            modal_coordinates: self.modal_coordinates * factor,
            velocity: self.velocity * factor,
            angular_velocity: self.angular_velocity * factor,
            modal_rates: self.modal_rates * factor,
        }
    }

    /// The state with the quaternion scaled to unit norm, and the norm it had.
    pub fn state(&self) -> Result<(State<M, T>, T), StepError> {
        let (orientation, norm) = normalised(self.quaternion).ok_or(StepError::NonFiniteResult)?;
        let state = State {
            position: self.position,
            orientation,
            modal_coordinates: self.modal_coordinates,
            velocity: self.velocity,
            angular_velocity: self.angular_velocity,
            modal_rates: self.modal_rates,
        };
        Ok((state, norm))
    }

    /// The state at the end of a step with its report; `error` is the difference to the embedded method.
    pub fn accept(&self, error: &Self) -> Result<(State<M, T>, StepReport<T>), StepError> {
        let (state, norm) = self.state()?;
        if !state.is_finite() {
            return Err(StepError::NonFiniteResult);
        }
        let two: T = nalgebra::convert(2.0);
        let local_error = LocalError {
            position: error.position.amax(),
            orientation: error.quaternion.coords.amax() * two,
            // zero for a rigid body
            modal_coordinates: error.modal_coordinates.iter().fold(T::zero(), |most, x| most.max(x.abs())),
        };
        Ok((state, StepReport { local_error, quaternion_norm_drift: norm - T::one() }))
    }
}

/// The rates of `phase` under `load`: the field that all integrators follow.
///
/// θ̇ is linear in the quaternion as it stands, everything else sees the quaternion scaled to unit norm. This
/// extends the equations smoothly off the unit sphere, so that the order of a Runge-Kutta method is kept.
pub(crate) fn rates<B, L, const M: usize, const N: usize, T>(
    body: &B,
    load: &L,
    time: T,
    phase: &Phase<M, T>,
) -> Result<Phase<M, T>, StepError>
where
    B: FlexibleBody<M, N, T>,
    L: Load<B, M, N, T>,
    T: RealField + Copy,
{
    let (state, _) = phase.state()?;
    let mut force = SVector::zeros();
    load.add_to(body, time, &state, &mut force);
    let acceleration =
        body.forward_dynamics(&state.modal_coordinates, &state.angular_velocity, &state.modal_rates, &force);
    Ok(from_acceleration(phase, &state, &acceleration))
}

/// The `K` entries of a vector from `start` on; zero beyond its end.
///
/// In plain loops: an iterator over a view can panic for all that the optimiser sees of it.
#[inline(always)]
pub(crate) fn part<const K: usize, const N: usize, T: RealField + Copy>(
    vector: &SVector<T, N>,
    start: usize,
) -> SVector<T, K> {
    let mut part = [T::zero(); K];
    for (place, entry) in part.iter_mut().zip(vector.as_slice().iter().skip(start)) {
        *place = *entry;
    }
    crate::generated_support::vector(part)
}

/// The rates of `phase` when its accelerations [α; ω̇; q̈] are known.
pub(crate) fn from_acceleration<const M: usize, const N: usize, T: RealField + Copy>(
    phase: &Phase<M, T>,
    state: &State<M, T>,
    acceleration: &SVector<T, N>,
) -> Phase<M, T> {
    const { assert!(N == 6 + M, "a body with M modes has N = 6 + M velocities") };
    Phase {
        position: phase.velocity,
        quaternion: quaternion_rate(&phase.quaternion, &phase.angular_velocity),
        modal_coordinates: phase.modal_rates,
        velocity: state.to_inertial(&part(acceleration, 0)),
        angular_velocity: part(acceleration, 3),
        modal_rates: part(acceleration, 6),
    }
}
