//! A body as the joints of a mechanism see it: markers, wrenches and six accelerations, whatever its number of modes.

use nalgebra::{RealField, Vector3};

use crate::body::{MarkerMotion, MarkerStep, Wrench};
use crate::integrators::StepError;

/// What a body in a step of the energy-momentum method shows of its markers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// The end of the step.
    End,
    /// Means over the step, and forces that do exactly the work of displacements.
    Mean,
}

/// One body in one state, prepared for joints. An object: joints, forces and sensors are compiled once for all bodies.
pub trait Port<T: RealField + Copy> {
    /// Place and motion of a marker.
    fn marker_motion(&self, marker: usize) -> MarkerMotion<T>;
    /// A marker over a step of the energy-momentum method; `None` outside of those.
    fn marker_step(&self, marker: usize) -> Option<MarkerStep<T>>;
    /// Adds a wrench (inertial) at a marker to the force on the body.
    fn push(&mut self, marker: usize, wrench: &Wrench<T>);
    /// Adds uniform gravity (m/s², inertial) to the force on the body.
    fn weigh(&mut self, gravity: &Vector3<T>);
    /// From now on this body is in a step of the energy-momentum method: its state was the beginning, and what a stage would
    /// subtract is the change of its velocities. Without effect on bodies that have been given none.
    fn conserve(&mut self, phase: Phase) {
        let _ = phase;
    }
    /// Prepares deformed quantities and factors; before this, wrenches can be pushed and markers read.
    ///
    /// Errors: the modal mass is not positive definite.
    fn factor(&mut self) -> Result<(), StepError>;
    /// Z, what the mass matrix leaves for rigid motion, row by row. Shape: 6 x 6.
    fn rigid_mass(&self) -> [[T; 6]; 6];
    /// Whether it has modes, through which rows are coupled.
    fn has_modes(&self) -> bool;
    /// Attaches constraint rows from `slot` on: their gradients at a marker. Gives the effect of each on the frame.
    fn attach(&mut self, slot: usize, marker: usize, gradients: &[Wrench<T>], effects: &mut [[T; 6]]);
    /// The compliance of the modes between two attached rows.
    fn compliance(&self, slot: usize, other: usize) -> T;
    /// Takes the forces as the right-hand side; returns the force on the frame with the modes eliminated. Shape: 6.
    fn reduced_force(&mut self) -> [T; 6];
    /// Adds a wrench (inertial) at a marker after factors and right-hand side were made, for the next
    /// [`reduced_force`](Self::reduced_force).
    fn push_net(&mut self, marker: usize, wrench: &Wrench<T>);
    /// Takes no force as the right-hand side: what follows is a correction of place or velocities.
    fn without_force(&mut self);
    /// What the modes' own acceleration adds to attached row `slot`.
    fn modal_acceleration(&self, slot: usize) -> T;
    /// The velocities [v; ω] (inertial) of a marker in what a linearly implicit stage subtracts; zero otherwise.
    fn subtracted_twist(&self, marker: usize) -> [Vector3<T>; 2];
    /// Sets the resulting motion: that of the frame, and of the modes on their own.
    fn finish(&mut self, rigid: &[T; 6]);
    /// Adds what the multiplier of attached row `slot` does to the modes.
    fn follow(&mut self, slot: usize, multiplier: T);
    /// The velocities [v; ω] (inertial) of a marker in the resulting motion: accelerations without bias.
    fn resulting_twist(&self, marker: usize) -> [Vector3<T>; 2];
}

/// The bodies of a mechanism in one state.
pub trait Ports<T: RealField + Copy> {
    /// Body `index`.
    fn port(&self, index: usize) -> Option<&dyn Port<T>>;
    /// Body `index`, to push or prepare.
    fn port_mut(&mut self, index: usize) -> Option<&mut dyn Port<T>>;
}
