//! A body as the joints of a mechanism see it: markers, wrenches and six accelerations, whatever its number of modes.

use nalgebra::{RealField, Vector3};

use super::{SupportPort, TreePort};
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
pub trait Port<T: RealField + Copy>: TreePort<T> + SupportPort<T> {
    /// Sets place and motion of a marker, where they stay.
    fn marker_motion(&self, marker: usize, to: &mut MarkerMotion<T>);
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
    /// The largest modal coordinate, if the mass matrix is not positive definite there; after [`factor`](Self::factor).
    fn indefinite(&self) -> Option<T>;
    /// Sets Z, what the mass matrix leaves for the motion of the frame, symmetric. Shape: 6 x 6.
    ///
    /// That motion is a [`RigidFrame`](super::RigidFrame)'s where there are no modes: Z is diagonal then.
    fn rigid_mass(&self, to: &mut [[T; 6]; 6]);
    /// Whether it has eliminated modes, through which rows are coupled.
    fn has_modes(&self) -> bool;
    /// Sets the entries of Θ_ff (with implicit terms) of the modes from `rows` on with those from `columns` on, of a body
    /// that keeps its modes as unknowns.
    fn modal_mass(&self, rows: usize, columns: usize, to: &mut [[T; 6]; 6]);
    /// Sets what couples kept modes from `first` on with the motion of the frame. Shape: modes x 6.
    fn modal_coupling(&self, first: usize, to: &mut [[T; 6]; 6]);
    /// Sets the gradients of the rows of attached joint `slot` to kept modes from `first` on. Shape: modes x rows.
    fn modal_rows(&self, slot: usize, first: usize, to: &mut [[T; 6]; 6]);
    /// The right-hand side of kept modes from `first` on.
    fn modal_force(&self, first: usize) -> [T; 6];
    /// Sets the resulting motion of kept modes from `first` on, after [`finish`](Self::finish).
    fn finish_modes(&mut self, first: usize, modal: &[T; 6]);
    /// Attaches so many rows of a joint as `slot`: the components of their gradients (force, moment; inertial) at a marker,
    /// side by side. Sets their effects on the components of the frame's motion, and adds what each row meets at the diagonal
    /// of Z about the frame origin to its compliance. Shape: 6 x rows, rows.
    fn attach(
        &mut self,
        slot: usize,
        marker: usize,
        rows: usize,
        gradients: &[[T; 6]; 6],
        effects: &mut [[T; 6]; 6],
        compliances: Option<&mut [T; 6]>,
    );
    /// Subtracts the compliance of the modes between the rows of two attached joints; of none that are kept.
    /// Shape: rows x rows of the other.
    fn subtract_compliance(&self, slot: usize, other: usize, from: &mut [[T; 6]; 6]);
    /// Takes the forces as the right-hand side; returns the force on the frame with the modes eliminated. Shape: 6.
    fn reduced_force(&mut self) -> [T; 6];
    /// Adds a wrench (inertial) at a marker after factors and right-hand side were made, for the next
    /// [`reduced_force`](Self::reduced_force).
    fn push_net(&mut self, marker: usize, wrench: &Wrench<T>);
    /// Takes no force as the right-hand side: what follows is a correction of place or velocities.
    fn without_force(&mut self);
    /// Subtracts what the modes' own acceleration adds to the rows of attached joint `slot`.
    fn subtract_modal_accelerations(&self, slot: usize, from: &mut [T; 6]);
    /// The velocities [v; ω] (inertial) of a marker in what a linearly implicit stage subtracts, if it does.
    fn subtracted_twist(&self, marker: usize) -> Option<[Vector3<T>; 2]>;
    /// As [`subtracted_twist`](Self::subtracted_twist), of what is subtracted from the rates of places: for soft rows.
    fn subtracted_displacement(&self, marker: usize) -> Option<[Vector3<T>; 2]>;
    /// Sets the resulting motion: that of the frame, and of the modes on their own.
    fn finish(&mut self, rigid: &[T; 6]);
    /// Subtracts what the *negative* multipliers of attached joint `slot` do to the modes.
    fn follow(&mut self, slot: usize, negative: &[T; 6]);
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
