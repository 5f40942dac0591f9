//! Something that moves in steps and can be looked at.

use ffrf::nalgebra::{RealField, SVector, UnitQuaternion, Vector3, convert, try_convert};
use ffrf::{FlexibleBody, FreeBody, Observables};

/// What the page chose.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Choice {
    /// Number of modes.
    pub modes: usize,
    /// Terms of the kinetic energy to first order in the modal coordinates, or all.
    pub linear: bool,
    /// f32, or f64.
    pub single: bool,
}

/// A system in motion.
pub trait Motion {
    /// Advances by one step. Errors: why that was not possible.
    fn step(&mut self) -> Result<(), String>;
    /// Length of a step. Units: s.
    fn step_size(&self) -> f64;
    /// Kinetic, elastic and potential energy together. Units: J.
    fn energy(&self) -> f64;
    /// Adds for each body position, orientation (x, y, z, w) and modal coordinates.
    fn look(&self, numbers: &mut Vec<f64>);
}

/// A number of any scalar as one that the page knows.
pub fn plain<T: RealField + Copy>(number: T) -> f64 {
    try_convert(number).unwrap_or(f64::NAN)
}

/// Adds the numbers of one body.
pub fn place<T: RealField + Copy>(
    numbers: &mut Vec<f64>,
    position: &Vector3<T>,
    orientation: &UnitQuaternion<T>,
    modal_coordinates: &[T],
) {
    let all = position.iter().chain(orientation.coords.iter()).chain(modal_coordinates);
    numbers.extend(all.map(|number| plain(*number)));
}

/// A body in flight, by the classical Runge-Kutta method.
pub struct Flight<B: FlexibleBody<T>, T: RealField + Copy> {
    body: FreeBody<B, T>,
    step: T,
}

/// Step of bodies whose modes do not ask for a shorter one. Units: s.
const STEP: f64 = 1e-4;
/// Part of the largest stable step that is taken: the method damps a mode of ω h = 0.28 by 7e-6 in a step of its energy.
const PART: f64 = 0.1;

impl<B, T, const M: usize> Flight<B, T>
where
    T: RealField + Copy,
    B: Observables<T> + FlexibleBody<T, Modal = SVector<T, M>>,
{
    /// A body that tumbles, with a first deformation. `stable`: the largest stable step, if modes limit it.
    pub fn tumbling(body: B, spin: [f64; 3], deformation: f64, stable: Option<f64>) -> Self {
        let step = stable.map_or(STEP, |stable| (PART * stable).min(STEP));
        let mut bent = SVector::<T, M>::zeros();
        if let Some(first) = bent.iter_mut().next() {
            *first = convert(deformation);
        }
        Self {
            body: FreeBody::new(body)
                .with_spin(Vector3::from(spin).map(convert))
                .with_deformation(bent, SVector::zeros()),
            step: convert(step),
        }
    }
}

impl<B, T, const M: usize> Motion for Flight<B, T>
where
    T: RealField + Copy,
    B: Observables<T> + FlexibleBody<T, Modal = SVector<T, M>>,
{
    fn step(&mut self) -> Result<(), String> {
        self.body.step_rk4(self.step, &()).map(|_| ()).map_err(|error| error.to_string())
    }

    fn step_size(&self) -> f64 {
        plain(self.step)
    }

    fn energy(&self) -> f64 {
        plain(self.body.kinetic_energy()) + plain(self.body.elastic_energy())
    }

    fn look(&self, numbers: &mut Vec<f64>) {
        let state = &self.body.state;
        place(numbers, &state.position, &state.orientation, state.modal_coordinates.as_slice());
    }
}
