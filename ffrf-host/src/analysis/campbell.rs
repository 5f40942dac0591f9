//! Eigenfrequencies against the speed of rotation.

use ffrf_runtime::{Observables as _, State};
use nalgebra::{Complex, Vector3};

use super::eigen::{Eigenmode, eigenmodes};
use super::equilibrium::search;
use super::spin::{Spin, SpinFrame, States};
use super::state_space::about_spin;
use super::whirl::{Shares, Whirl};
use super::{AnalysisError, Equilibrium};
use crate::mechanism::Drive;
use crate::scene::Scene;
use crate::{HostMechanism, HostModal};

/// What turns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SpinTarget {
    /// A revolute or cylindrical joint on the ground, by its name; its drive, if any, gets the speed.
    Joint(String),
    /// A body, by its name, about the axis of its angular velocity in the scene, through its centre of mass.
    Body(String),
}

impl SpinTarget {
    /// The joint of this name, or else the body.
    pub fn named(scene: &Scene, name: &str) -> Self {
        if scene.connection_names.iter().any(|known| known == name) {
            Self::Joint(name.to_owned())
        } else {
            Self::Body(name.to_owned())
        }
    }
}

/// One eigenmode at one speed, in the inertial frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CampbellPoint {
    /// Speed Ω. Units: rad/s.
    pub speed: f64,
    /// Its number at this speed, counted from one.
    pub mode: usize,
    /// λ, seen from the inertial frame. Units: 1/s.
    pub eigenvalue: Complex<f64>,
    /// Which way it goes round.
    pub whirl: Whirl,
}

impl CampbellPoint {
    /// Undamped natural frequency. Units: Hz.
    pub fn frequency_hz(&self) -> f64 {
        if self.eigenvalue.im > 0.0 { self.eigenvalue.norm() / std::f64::consts::TAU } else { 0.0 }
    }

    /// Damping ratio: negative where motion grows.
    pub fn damping_ratio(&self) -> f64 {
        let size = self.eigenvalue.norm();
        if size > 0.0 { -self.eigenvalue.re / size } else { 0.0 }
    }
}

/// Eigenfrequencies at each of several speeds.
#[derive(Debug, Clone, PartialEq)]
pub struct Campbell {
    /// All modes at all speeds, speed by speed.
    pub points: Vec<CampbellPoint>,
    /// The symmetry that was used at each speed.
    pub frames: Vec<SpinFrame>,
}

/// Deviation of eigenvalues after a turn of one radian, relative to the largest, from which on coefficients are not constant.
const CONSTANT: f64 = 1e-6;
/// Share of one direction in a mode of a rotating frame, below which it is not a circle.
const CIRCLE: f64 = 0.99;
/// Eigenvalues below this share of the largest are free motion.
const FREE: f64 = 1e-7;

/// Eigenfrequencies of a scene that turns steadily, at each speed (rad/s), seen from `frame` if one is asked for.
///
/// Errors: at some speed there is no steady rotation, or it has no constant coefficients: neither do round rigid bodies turn in
/// something that may be uneven, nor does everything turn as a whole in something that is round.
pub fn campbell(
    scene: &Scene,
    target: &SpinTarget,
    speeds: &[f64],
    frame: Option<SpinFrame>,
) -> Result<Campbell, AnalysisError> {
    let mut result = Campbell { points: Vec::new(), frames: Vec::new() };
    for &speed in speeds {
        if !(speed.is_finite() && speed >= 0.0) {
            let expected = "a speed that is not negative, in rad/s";
            return Err(AnalysisError::Value { what: "speed", expected, found: speed.to_string() });
        }
        let rotation = Rotation::new(scene, target, speed)?;
        let (frame, points) = rotation.modes(scene, speed, frame)?;
        result.frames.push(frame);
        result.points.extend(points);
    }
    Ok(result)
}

/// A scene set to turn.
struct Rotation {
    mechanism: HostMechanism,
    state: States,
    /// Body that turns, if only one was named.
    body: Option<usize>,
    /// Unit vector. Frame: inertial.
    axis: Vector3<f64>,
    /// A point of the axis. Frame: inertial. Units: m.
    point: Vector3<f64>,
}

impl Rotation {
    fn new(scene: &Scene, target: &SpinTarget, speed: f64) -> Result<Self, AnalysisError> {
        let (state, _) = scene.assembled()?;
        let mechanism = scene.mechanism.cast::<f64>();
        match target {
            SpinTarget::Joint(name) => {
                let joint = scene.connection_names.iter().position(|known| known == name);
                let connection = joint.and_then(|joint| scene.mechanism.connection(joint));
                let grounded = connection.and_then(|connection| {
                    let turns = matches!(
                        connection.kind,
                        ffrf_runtime::joints::JointKind::Revolute(_)
                            | ffrf_runtime::joints::JointKind::Cylindrical(_)
                    );
                    match (connection.first.body, connection.second.body) {
                        (None, Some(body)) if turns => Some((connection.first, body)),
                        (Some(body), None) if turns => Some((connection.second, body)),
                        _ => None,
                    }
                });
                let Some((ground, body)) = grounded else {
                    return Err(AnalysisError::Name {
                        found: name.clone(),
                        expected: "a revolute or cylindrical joint with one end on the ground",
                        known: scene.connection_names.join(", "),
                    });
                };
                let driven = format!("{name}.drive");
                let drive = scene.connection_names.iter().position(|known| *known == driven);
                let mechanism = match drive {
                    None => mechanism,
                    Some(drive) => {
                        let start = ffrf_runtime::mechanism::Assembly::drive(&mechanism, drive, 0.0)[0];
                        mechanism.with_drive(drive, Drive::Polynomial(vec![start, speed]))
                    }
                };
                let axis = ground.orientation * Vector3::z();
                Ok(Self { mechanism, state, body: Some(body), axis, point: ground.position })
            }
            SpinTarget::Body(name) => {
                let body = scene.body_names.iter().position(|known| known == name);
                let turning = body.and_then(|body| {
                    let start = scene.initial.get(body)?;
                    let axis = start.to_inertial(&start.angular_velocity).try_normalize(0.0)?;
                    Some((body, axis))
                });
                let Some((body, axis)) = turning else {
                    return Err(AnalysisError::Name {
                        found: name.clone(),
                        expected: "a body whose angular velocity in the scene gives the axis",
                        known: scene.body_names.join(", "),
                    });
                };
                let point = center_of_mass(&mechanism, &state, body);
                Ok(Self { mechanism, state, body: Some(body), axis, point })
            }
        }
    }

    /// The first symmetry that gives constant coefficients, and the modes.
    fn modes(
        &self,
        scene: &Scene,
        speed: f64,
        only: Option<SpinFrame>,
    ) -> Result<(SpinFrame, Vec<CampbellPoint>), AnalysisError> {
        let mut reasons = Vec::new();
        let both = [SpinFrame::Material, SpinFrame::Space];
        for frame in both.into_iter().filter(|frame| only.is_none_or(|only| only == *frame)) {
            match self.modes_in(scene, speed, frame) {
                Ok(points) => return Ok((frame, points)),
                Err(AnalysisError::Scene(error)) => return Err(error.into()),
                Err(error) => reasons.push(match frame {
                    SpinFrame::Material => format!("with round bodies turning in place: {error}"),
                    SpinFrame::Space => format!("with everything turning: {error}"),
                }),
            }
        }
        Err(AnalysisError::NotSteady { speed, reason: reasons.join("; ") })
    }

    fn modes_in(
        &self,
        scene: &Scene,
        speed: f64,
        frame: SpinFrame,
    ) -> Result<Vec<CampbellPoint>, AnalysisError> {
        let spin = match frame {
            SpinFrame::Space => Spin::Space([self.axis * speed, self.point]),
            SpinFrame::Material => self.material(speed)?,
        };
        let steady = search(scene, &self.mechanism, self.state.clone(), Some(spin.clone()))?;
        let (modes, basis) = self.eigenmodes_at(scene, &steady, steady.state.clone(), 0.0, &spin)?;
        let largest = modes.iter().map(|mode| mode.eigenvalue.norm()).fold(0.0, f64::max);
        if speed > 0.0 {
            let time = 1.0 / speed;
            let carried = spin.carried(&steady.state, time);
            let (later, _) = self.eigenmodes_at(scene, &steady, carried, time, &spin)?;
            let change = difference(&modes, &later);
            if change > CONSTANT * largest {
                return Err(AnalysisError::NotSteady {
                    speed,
                    reason: format!("eigenvalues change by {change:.2e} per second while it turns"),
                });
            }
        }
        let places = basis.view((0, 0), (basis.nrows() / 2, basis.ncols() / 2)).into_owned();
        let seen = modes.iter().enumerate().map(|(index, mode)| {
            let shares = Shares::new(&self.mechanism, &steady.state, &places, &mode.vector, &self.axis);
            let (eigenvalue, whirl) = match frame {
                SpinFrame::Material => (mode.eigenvalue, shares.whirl()),
                SpinFrame::Space => seen_from_space(mode, &shares, speed, FREE * largest),
            };
            CampbellPoint { speed, mode: index + 1, eigenvalue, whirl }
        });
        let mut points: Vec<CampbellPoint> = seen.collect();
        points.sort_by(|a, b| a.eigenvalue.im.total_cmp(&b.eigenvalue.im));
        for (index, point) in points.iter_mut().enumerate() {
            point.mode = index + 1;
        }
        Ok(points)
    }

    fn eigenmodes_at(
        &self,
        scene: &Scene,
        steady: &Equilibrium,
        state: States,
        time: f64,
        spin: &Spin,
    ) -> Result<(Vec<Eigenmode>, nalgebra::DMatrix<f64>), AnalysisError> {
        let system = about_spin(scene, &self.mechanism, steady.time + time, state, spin.clone())?;
        Ok((eigenmodes(&system.a)?, system.basis))
    }

    /// Bodies that turn about the axis, each with the axis in its own frame.
    fn material(&self, speed: f64) -> Result<Spin, AnalysisError> {
        let refused = |reason: &str| AnalysisError::NotSteady { speed, reason: reason.to_owned() };
        let turning: Vec<usize> = self.turning()?;
        let mut bodies = vec![None; self.state.len()];
        for body in turning {
            if self.mechanism.bodies().get(body).is_some_and(|body| body.mode_count() > 0) {
                return Err(refused("a flexible body turns"));
            }
            let (Some(state), Some(place)) = (self.state.get(body), bodies.get_mut(body)) else { continue };
            *place =
                Some([state.to_body(&(self.axis * speed)), state.to_body(&(self.point - state.position))]);
        }
        Ok(Spin::Material(bodies))
    }

    /// The named body, and all that turn with it when it turns at one radian per second.
    fn turning(&self) -> Result<Vec<usize>, AnalysisError> {
        let mut state = self.state.clone();
        for state in &mut state {
            state.velocity.fill(0.0);
            state.angular_velocity.fill(0.0);
            state.modal_rates.0.fill(0.0);
        }
        let driven = ffrf_runtime::mechanism::Constrained(&self.mechanism);
        let found = driven.project(0.0, state, None, 4, f64::MAX)?.0;
        let turns = |state: &State<HostModal>| state.angular_velocity.norm() > 0.0;
        let mut bodies: Vec<usize> =
            found.iter().enumerate().filter(|(_, state)| turns(state)).map(|(index, _)| index).collect();
        bodies.extend(self.body.filter(|body| !bodies.contains(body)));
        Ok(bodies)
    }
}

fn center_of_mass(mechanism: &HostMechanism, state: &States, body: usize) -> Vector3<f64> {
    let pair = mechanism.bodies().get(body).zip(state.get(body));
    pair.map_or_else(Vector3::zeros, |(body, state)| {
        state.position + state.to_inertial(&(body.first_mass_moment(&state.modal_coordinates) / body.mass()))
    })
}

/// The largest distance of an eigenvalue from the nearest of the others.
fn difference(modes: &[Eigenmode], others: &[Eigenmode]) -> f64 {
    let distance = |mode: &Eigenmode| {
        let distances = others.iter().map(|other| (other.eigenvalue - mode.eigenvalue).norm());
        distances.fold(f64::INFINITY, f64::min)
    };
    modes.iter().map(distance).fold(0.0, f64::max)
}

/// An eigenvalue of the rotating frame as the inertial frame sees it: a circle there turns with the frame besides.
fn seen_from_space(mode: &Eigenmode, shares: &Shares, speed: f64, free: f64) -> (Complex<f64>, Whirl) {
    let Complex { re, im } = mode.eigenvalue;
    let whirl = shares.whirl();
    if whirl == Whirl::Axial || mode.eigenvalue.norm() <= free || speed == 0.0 {
        return (mode.eigenvalue, whirl);
    }
    let across = shares.forward + shares.backward;
    if shares.forward.max(shares.backward) < CIRCLE * (across + shares.axial) {
        return (mode.eigenvalue, Whirl::Rotating);
    }
    if shares.forward > shares.backward {
        (Complex::new(re, im + speed), Whirl::Forward)
    } else if im > speed {
        (Complex::new(re, im - speed), Whirl::Backward)
    } else {
        (Complex::new(re, speed - im), Whirl::Forward)
    }
}
