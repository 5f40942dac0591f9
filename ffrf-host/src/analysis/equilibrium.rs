//! States of rest, and of steady rotation.

use ffrf_runtime::mechanism::Constrained;
use nalgebra::{DMatrix, DVector, Dyn, SymmetricEigen};
use num_dual::Dual64;

use super::AnalysisError;
use super::evaluate::{Point, cast_state, flatten, increment, slope, value};
use super::spin::{Spin, States};
use super::tangent::Tangent;
use crate::HostMechanism;
use crate::scene::Scene;
use crate::simulate::{Advance, SavedState};

/// A state in which a mechanism rests.
#[derive(Debug, Clone, PartialEq)]
pub struct Equilibrium {
    /// Time, at which drives are held. Units: s.
    pub time: f64,
    /// The states of the bodies.
    pub state: States,
    /// What is left of the accelerations, √(aᵀ M a).
    pub residual: f64,
    /// Iterations done.
    pub iterations: usize,
}

impl Equilibrium {
    /// The state as a file that a simulation can begin with.
    pub fn saved(&self, scene: &Scene) -> SavedState {
        let angles = vec![None; scene.sensors.len()];
        SavedState::new(
            scene,
            self.time,
            &Advance::new(&scene.settings, self.time, self.state.clone()),
            &angles,
            &self.state,
        )
    }
}

/// Most iterations.
const ITERATIONS: usize = 200;
/// Accelerations that are allowed to be left, relative to those of a free fall and of the first state.
const LEFT: f64 = 1e-11;
/// What stands for stiffness where motion is free, relative to the largest: round-off must not move it.
const FREE: f64 = 1e-9;
/// Largest rotation in one iteration. Units: rad.
const TURN: f64 = 0.3;
/// Rate of a residual at rest from which on a joint counts as driven. Units: m/s or rad/s.
const DRIVEN: f64 = 1e-9;

/// Where a scene comes to rest, from its initial state, with drives held as they are at time zero.
///
/// Pseudo-time steps become Newton's method as accelerations fall; where the potential bends down they stay so short that the
/// way leads to stable equilibria. Source: C. T. Kelley, D. E. Keyes, Convergence analysis of pseudo-transient continuation,
/// SIAM J. Numer. Anal. 35 (1998) 508-523.
///
/// Errors: no equilibrium is found.
pub fn equilibrium(scene: &Scene) -> Result<Equilibrium, AnalysisError> {
    let (state, _) = scene.assembled()?;
    search(scene, &scene.mechanism.with_drives_held(0.0), state, None)
}

/// The same from a state, for a mechanism that turns steadily with `spin`.
pub(super) fn search(
    scene: &Scene,
    mechanism: &HostMechanism,
    state: States,
    spin: Option<Spin>,
) -> Result<Equilibrium, AnalysisError> {
    let mut point = Point::new(scene, mechanism, 0.0, state);
    point.spin = spin;
    let mass: f64 = mechanism.bodies().iter().map(ffrf_runtime::Observables::mass).sum();
    let mut scale = mass.sqrt() * mechanism.gravity().norm();
    let mut largest = 0.0_f64;
    for iterations in 0..=ITERATIONS {
        set_velocities(&mut point);
        refuse_drives(scene, &point)?;
        let tangent = Tangent::new(&point, &scene.body_names)?;
        let none = DVector::zeros(point.size());
        let force = &tangent.projection * value(&point.evaluate(&none, &none)?.accelerations);
        let residual = force.norm();
        if iterations == 0 {
            scale += residual;
        }
        if residual <= LEFT * scale {
            return Ok(Equilibrium { time: 0.0, state: point.state, residual, iterations });
        }
        if iterations == ITERATIONS {
            let tolerance = LEFT * scale;
            return Err(AnalysisError::NoEquilibrium { iterations, residual, tolerance });
        }
        let bend = bending(&point, &tangent)?;
        // 1/h² of the pseudo-time step
        let size = bend.norm();
        largest = largest.max(residual);
        // at first as long as the bodies take to turn by a fraction of a radian, later without end
        let turning = largest_turn(&point, &(&tangent.places * &force));
        let damping = turning / TURN * residual / largest;
        let rising = largest_eigenvalue(&bend);
        let used = damping.max(if rising > 0.0 { 2.0 * rising } else { 0.0 });
        let freedom = tangent.freedom();
        let matrix = DMatrix::from_diagonal_element(freedom, freedom, used + FREE * size) - bend;
        let what = "the search for an equilibrium";
        let step = matrix.lu().solve(&force).ok_or(AnalysisError::NotConverged { what })?;
        let mut places = &tangent.places * step;
        let turn = largest_turn(&point, &places);
        if turn > TURN {
            places *= TURN / turn;
        }
        let change = increment(point.sizes(), &places, &none);
        let moved: States = point.state.iter().zip(&change.0).map(|(s, change)| s.retract(change)).collect();
        let system = Constrained(mechanism);
        let mut state = moved;
        for _ in 0..PASSES {
            state = system.project(point.time, state, None, 2, f64::MAX)?.0;
        }
        point.state = state;
    }
    // the loop returns at its last turn
    Err(AnalysisError::NoEquilibrium { iterations: ITERATIONS, residual: f64::NAN, tolerance: LEFT * scale })
}

/// Factorisations that meet the joints again after an iteration.
const PASSES: usize = 3;

/// Rest, or the velocities of the steady rotation.
fn set_velocities(point: &mut Point<'_>) {
    let velocities = point.spin.as_ref().map(|spin| spin.velocities(&point.state));
    for (index, state) in point.state.iter_mut().enumerate() {
        state.modal_rates.0.fill(0.0);
        let [velocity, omega] =
            velocities.as_ref().and_then(|all| all.get(index)).copied().unwrap_or_default();
        state.velocity = velocity;
        state.angular_velocity = omega;
    }
}

fn refuse_drives(scene: &Scene, point: &Point<'_>) -> Result<(), AnalysisError> {
    let none = DVector::zeros(point.size());
    let rates = point.evaluate(&none, &none)?.velocity_residuals;
    let names = point.mechanism.row_connections();
    let worst = rates.iter().zip(names).max_by(|a, b| a.0.re.abs().total_cmp(&b.0.re.abs()));
    match worst {
        Some((rate, connection)) if rate.re.abs() > DRIVEN * (1.0 + speed(point)) => {
            Err(AnalysisError::Driven {
                joint: scene.connection_names.get(connection).cloned().unwrap_or_default(),
                rate: rate.re.abs(),
            })
        }
        _ => Ok(()),
    }
}

fn speed(point: &Point<'_>) -> f64 {
    point.state.iter().map(|state| state.angular_velocity.norm()).fold(0.0, f64::max)
}

/// How accelerations change with places while velocities follow the steady rotation. Shape: f x f.
fn bending(point: &Point<'_>, tangent: &Tangent) -> Result<DMatrix<f64>, AnalysisError> {
    let freedom = tangent.freedom();
    let mut bend = DMatrix::zeros(freedom, freedom);
    for column in 0..freedom {
        let places = tangent.places.column(column).into_owned();
        let moved = point.evaluate(&places, &followed_velocities(point, &places))?;
        bend.set_column(column, &(&tangent.projection * slope(&moved.accelerations)));
    }
    Ok(bend)
}

/// The change of the velocities of the steady rotation with places.
fn followed_velocities(point: &Point<'_>, places: &DVector<f64>) -> DVector<f64> {
    let Some(spin) = &point.spin else { return DVector::zeros(places.len()) };
    let direction = places.map(|slope| Dual64::new(0.0, slope));
    let none = DVector::zeros(places.len());
    let mut change = increment(point.sizes(), &direction, &none);
    let moved: States<Dual64> =
        point.state.iter().zip(&change.0).map(|(state, change)| cast_state(state).retract(change)).collect();
    for (body, [velocity, omega]) in change.0.iter_mut().zip(spin.velocities(&moved)) {
        body.velocity = velocity;
        body.angular_velocity = omega;
    }
    slope(&flatten(&change).1)
}

fn largest_eigenvalue(matrix: &DMatrix<f64>) -> f64 {
    if matrix.is_empty() {
        return 0.0;
    }
    let symmetric = (matrix + matrix.transpose()) * 0.5;
    SymmetricEigen::<f64, Dyn>::new(symmetric).eigenvalues.max()
}

fn largest_turn(point: &Point<'_>, places: &DVector<f64>) -> f64 {
    let bodies = increment(point.sizes(), places, &DVector::zeros(places.len())).0;
    bodies.iter().map(|body| body.rotation.norm()).fold(0.0, f64::max)
}
