//! A tumbling rod under gravity, by the classical Runge-Kutta method and by a linearly implicit one.

use ffrf::nalgebra::{self, SVector, Vector3};
use ffrf::{FlexibleBody, FreeBody, Gravity, Observables};

use crate::bodies::{Eight32, Eight64, Four32, Four64, Rigid32, Rigid64};
use crate::motion::follow;
use crate::{Bits, Hash, Motion, Sink};

/// One millisecond, a usual tick of a controller. Units: s.
const TICK: f64 = 1e-3;
/// Part of the largest stable step that the explicit method takes.
const PART: f64 = 0.5;

/// A rod in flight.
pub struct Flight<B: FlexibleBody<T>, T: Bits> {
    rod: FreeBody<B, T>,
    gravity: Gravity<T>,
    step: T,
    implicit: bool,
}

impl<B, T, const M: usize> Flight<B, T>
where
    T: Bits,
    B: Observables<T> + FlexibleBody<T, Modal = SVector<T, M>>,
{
    /// Thrown with a spin about its middle axis, which is not stable, and a first deformation.
    pub fn thrown(body: B, implicit: bool) -> Self {
        let vector = |x: f64, y: f64, z: f64| Vector3::new(x, y, z).map(nalgebra::convert::<f64, T>);
        let explicit = body.largest_stable_step().filter(|step| step.is_finite());
        let tick: T = nalgebra::convert(TICK);
        let step = explicit.map_or(tick, |step| step * nalgebra::convert(PART));
        let deformation = SVector::repeat(nalgebra::convert(1e-5));
        Self {
            rod: FreeBody::new(body)
                .with_velocity(vector(1.0, 0.5, 3.0))
                .with_spin(vector(0.3, 60.0, 0.1))
                .with_deformation(deformation, SVector::zeros()),
            gravity: Gravity { acceleration: vector(0.0, 0.0, -9.81) },
            step: if implicit { tick } else { step },
            implicit,
        }
    }
}

impl<B, T, const M: usize> Motion for Flight<B, T>
where
    T: Bits,
    B: Observables<T> + FlexibleBody<T, Modal = SVector<T, M>>,
{
    fn step(&mut self) -> bool {
        if self.implicit {
            self.rod.step_linearly_implicit(self.step, &self.gravity).is_ok()
        } else {
            self.rod.step_rk4(self.step, &self.gravity).is_ok()
        }
    }

    fn hash(&self, hash: &mut Hash) {
        let state = &self.rod.state;
        hash.numbers(state.position.as_slice());
        hash.numbers(state.orientation.coords.as_slice());
        hash.numbers(state.modal_coordinates.as_slice());
        hash.numbers(state.velocity.as_slice());
        hash.numbers(state.angular_velocity.as_slice());
        hash.numbers(state.modal_rates.as_slice());
    }
}

macro_rules! cases {
    ($($name:ident: $body:ident $scalar:ident $implicit:literal;)*) => {$(
        pub fn $name(steps: u32, sink: Sink<'_>) {
            follow(Flight::<$body, $scalar>::thrown($body, $implicit), steps, sink);
        }
    )*};
}

cases! {
    rigid_f32: Rigid32 f32 false;
    four_f32: Four32 f32 false;
    eight_f32: Eight32 f32 false;
    rigid_f64: Rigid64 f64 false;
    four_f64: Four64 f64 false;
    eight_f64: Eight64 f64 false;
    four_f32_implicit: Four32 f32 true;
    four_f64_implicit: Four64 f64 true;
}
