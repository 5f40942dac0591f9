//! Loads: everything that pushes a body, as generalised forces added without allocation.

use nalgebra::{RealField, SVector, Vector3};

use crate::{FlexibleBody, LeverArm, Marker, State};

/// Something that adds to the generalised force [f̄; τ; f] of a body of type `B`.
///
/// Closures with the arguments of [`add_to`](Self::add_to) are loads, and so are `()` (no load), references
/// and tuples of up to four loads (their sum). Write the argument types of a closure out:
///
/// ```
/// use ffrf_runtime::nalgebra::SVector;
/// use ffrf_runtime::{Load, State};
///
/// fn is_a_load<B>(load: impl Load<B, 2, 8, f64>) -> impl Load<B, 2, 8, f64> {
///     load
/// }
/// # struct Body;
/// // a moment about the body's z axis that grows with time
/// let _ = is_a_load(|_: &Body, time: f64, _: &State<2>, force: &mut SVector<f64, 8>| force[5] += 0.1 * time);
/// ```
pub trait Load<B, const M: usize, const N: usize, T: RealField + Copy = f64> {
    /// Adds the generalised force at `time` (s) in `state` to `force` (shape N, body-resolved).
    ///
    /// Called a few times per step, also at states that no step accepts. Must not panic.
    fn add_to(&self, body: &B, time: T, state: &State<M, T>, force: &mut SVector<T, N>);
}

impl<F, B, const M: usize, const N: usize, T: RealField + Copy> Load<B, M, N, T> for F
where
    F: Fn(&B, T, &State<M, T>, &mut SVector<T, N>),
{
    fn add_to(&self, body: &B, time: T, state: &State<M, T>, force: &mut SVector<T, N>) {
        self(body, time, state, force);
    }
}

/// No load at all.
impl<B, const M: usize, const N: usize, T: RealField + Copy> Load<B, M, N, T> for () {
    fn add_to(&self, _: &B, _: T, _: &State<M, T>, _: &mut SVector<T, N>) {}
}

macro_rules! sum_of_loads {
    ($($name:ident $index:tt),+) => {
        /// The sum of the loads.
        impl<B, $($name,)+ const M: usize, const N: usize, T> Load<B, M, N, T> for ($($name,)+)
        where
            $($name: Load<B, M, N, T>,)+
            T: RealField + Copy,
        {
            fn add_to(&self, body: &B, time: T, state: &State<M, T>, force: &mut SVector<T, N>) {
                $(self.$index.add_to(body, time, state, force);)+
            }
        }
    };
}
sum_of_loads!(L0 0, L1 1);
sum_of_loads!(L0 0, L1 1, L2 2);
sum_of_loads!(L0 0, L1 1, L2 2, L3 3);

/// Uniform gravity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gravity<T = f64> {
    /// Acceleration of free fall g. Shape: 3. Units: m/s². Frame: inertial.
    pub acceleration: Vector3<T>,
}

impl<B, const M: usize, const N: usize, T: RealField + Copy> Load<B, M, N, T> for Gravity<T>
where
    B: FlexibleBody<M, N, T>,
{
    fn add_to(&self, body: &B, _: T, state: &State<M, T>, force: &mut SVector<T, N>) {
        *force += body.gravity_force(&state.modal_coordinates, &state.to_body(&self.acceleration));
    }
}

/// The frame in which a force or moment keeps its components.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Frame {
    /// Constant direction in space.
    Inertial,
    /// Constant direction in the body frame: a follower force.
    Body,
}

/// A constant force and a constant moment at a marker.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarkerLoad<const M: usize, T = f64> {
    /// Where the load acts.
    pub marker: Marker<M, T>,
    /// Force. Shape: 3. Units: N. Frame: `frame`.
    pub force: Vector3<T>,
    /// Moment. Shape: 3. Units: N m. Frame: `frame`.
    pub moment: Vector3<T>,
    /// The frame of both.
    pub frame: Frame,
    /// Which position of the marker the force turns the body about.
    pub lever_arm: LeverArm,
}

impl<const M: usize, T: RealField + Copy> MarkerLoad<M, T> {
    /// A force at `marker`, in N.
    pub fn force(marker: Marker<M, T>, force: Vector3<T>, frame: Frame) -> Self {
        Self { marker, force, moment: Vector3::zeros(), frame, lever_arm: LeverArm::Deformed }
    }

    /// A moment at `marker`, in N m.
    pub fn moment(marker: Marker<M, T>, moment: Vector3<T>, frame: Frame) -> Self {
        Self { marker, force: Vector3::zeros(), moment, frame, lever_arm: LeverArm::Deformed }
    }

    /// The same load with another lever arm; [`LeverArm::Deformed`] if nothing is said.
    #[must_use]
    pub fn with_lever_arm(self, lever_arm: LeverArm) -> Self {
        Self { lever_arm, ..self }
    }
}

impl<B, const M: usize, const N: usize, T: RealField + Copy> Load<B, M, N, T> for MarkerLoad<M, T>
where
    B: FlexibleBody<M, N, T>,
{
    fn add_to(&self, body: &B, _: T, state: &State<M, T>, force: &mut SVector<T, N>) {
        let (marker_force, moment) = match self.frame {
            Frame::Inertial => (state.to_body(&self.force), state.to_body(&self.moment)),
            Frame::Body => (self.force, self.moment),
        };
        let q = &state.modal_coordinates;
        *force += match self.lever_arm {
            LeverArm::Deformed => body.marker_force(&self.marker, q, &marker_force),
            LeverArm::Undeformed => self.marker.force_about(q, &marker_force, LeverArm::Undeformed),
        };
        *force += body.marker_moment(&self.marker, &moment);
    }
}
