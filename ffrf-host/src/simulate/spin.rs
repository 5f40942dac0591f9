//! Bodies that turn faster than their own stiffness allows.
//!
//! Centrifugal forces soften what they bend outwards: K - S(ω), where S is the part of the modes' kinetic energy that turns
//! with them, less the geometric stiffness of the stress that they leave, in a body that has it. Where that is no longer positive, small deformations grow without bound, in
//! the equations but not in the part: the formulation has left its validity. A beam that turns about an axis across it gets
//! there at its first bending frequency.

use std::fmt;

use ffrf_runtime::{FlexibleBody, State};
use nalgebra::{Cholesky, DMatrix, Vector3};

use crate::scene::Scene;
use crate::{HostBody, HostModal};

/// A flexible body that turned faster than its modes can stand.
#[derive(Debug, Clone, PartialEq)]
pub struct SpinWarning {
    /// Name of the body.
    pub body: String,
    /// The first sample where it was seen. Units: s.
    pub time: f64,
    /// Angular velocity there. Units: rad/s.
    pub speed: f64,
    /// The speed about the same axis at which the softened stiffness becomes singular. Units: rad/s.
    pub critical: f64,
    /// Whether the body has geometric stiffness.
    pub is_stiffened: bool,
}

impl fmt::Display for SpinWarning {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "body `{}` turns at {:.4} rad/s at t = {:.4} s, faster than the {:.4} rad/s at which centrifugal forces exceed the \
             stiffness of its modes: {}its deformation from there on means nothing",
            self.body,
            self.speed,
            self.time,
            self.critical,
            if self.is_stiffened { "" } else { "without geometric stiffening " }
        )
    }
}

/// Watches the spin of every flexible body.
#[derive(Debug)]
pub(super) struct SpinWatch {
    /// For each body that is still watched, its lowest natural frequency squared: no slower spin needs a closer look.
    screens: Vec<Option<f64>>,
    pub(super) warnings: Vec<SpinWarning>,
}

impl SpinWatch {
    pub(super) fn new(scene: &Scene) -> Self {
        let screens = scene.mechanism.bodies().iter().map(lowest_square).collect();
        Self { screens, warnings: Vec::new() }
    }

    /// Looks at the bodies of a sample; each is warned of once.
    pub(super) fn look(&mut self, scene: &Scene, time: f64, states: &[State<HostModal>]) {
        let bodies = scene.mechanism.bodies().iter().zip(&scene.body_names);
        for ((screen, state), (body, name)) in self.screens.iter_mut().zip(states).zip(bodies) {
            let omega = &state.angular_velocity;
            let Some(lowest) = *screen else { continue };
            // S(ω) is at most |ω|² Θ_ff; pressure can take more
            if omega.norm_squared() <= lowest && !body.is_stiffened() {
                continue;
            }
            let Some(critical) = critical_speed(body, omega).filter(|critical| omega.norm() > *critical)
            else {
                continue;
            };
            *screen = None;
            let (body, speed, is_stiffened) = (name.clone(), omega.norm(), body.is_stiffened());
            self.warnings.push(SpinWarning { body, time, speed, critical, is_stiffened });
        }
    }
}

/// The square of the lowest frequency of the modes about a frame at rest; none if some motion has no stiffness.
fn lowest_square(body: &HostBody) -> Option<f64> {
    let stiffness = body.stiffness().dense();
    if stiffness.nrows() == 0 {
        return None;
    }
    let lower = Cholesky::new(body.modal_mass().dense())?.l();
    let half = lower.solve_lower_triangular(&stiffness)?;
    let reduced = lower.solve_lower_triangular(&half.transpose())?;
    let lowest = reduced.symmetric_eigenvalues().min();
    (lowest > 0.0).then_some(lowest)
}

/// The speed about the axis of `omega` at which K - S is singular; none if S takes nothing from K, or K is singular itself.
///
/// Units: rad/s.
fn critical_speed(body: &HostBody, omega: &Vector3<f64>) -> Option<f64> {
    let stiffness = body.stiffness().dense();
    let softening: DMatrix<f64> = body.centrifugal_softening(omega);
    // far below: one factorisation tells
    if Cholesky::new(&stiffness - &softening).is_some() {
        return None;
    }
    let lower = Cholesky::new(stiffness)?.l();
    let half = lower.solve_lower_triangular(&softening)?;
    let share = lower.solve_lower_triangular(&half.transpose())?.symmetric_eigenvalues().max();
    (share > 0.0).then(|| omega.norm() / share.sqrt())
}
