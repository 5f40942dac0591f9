//! A mechanism as a linear system about a state.

use ffrf_runtime::State;
use nalgebra::{DMatrix, DVector};

use super::AnalysisError;
use super::evaluate::{Input, Point, slope, value};
use super::spin::{Spin, States};
use super::tangent::Tangent;
use crate::scene::Scene;
use crate::{HostMechanism, HostModal};

/// ẋ = A x + B u, y = C x + D u about a state, in minimal coordinates.
///
/// x holds f coordinates of places, then f of velocities. They are lengths in the metric of kinetic energy (√kg m and √kg m/s):
/// with M the mass matrix of all bodies, the reduced one is the identity. `basis` gives what they mean.
#[derive(Debug, Clone, PartialEq)]
pub struct StateSpace {
    /// Shape: 2f x 2f.
    pub a: DMatrix<f64>,
    /// Shape: 2f x inputs.
    pub b: DMatrix<f64>,
    /// Shape: outputs x 2f.
    pub c: DMatrix<f64>,
    /// Shape: outputs x inputs.
    pub d: DMatrix<f64>,
    /// Changes of `coordinates` with x. Shape: 2n x 2f.
    pub basis: DMatrix<f64>,
    /// x from changes of `coordinates`: a left inverse of the basis, orthogonal in the kinetic energy. Shape: 2f x 2n.
    pub projection: DMatrix<f64>,
    /// What is left of the accelerations (measured as x): zero in an equilibrium or steady rotation. Shape: f.
    pub accelerations: DVector<f64>,
    /// Names of all coordinates of all bodies: changes of places, then of velocities. Positions and velocities are inertial,
    /// rotations and angular velocities resolved in the body frame.
    pub coordinates: Vec<String>,
    /// Names of the inputs: forces and moments of the scene, in N and N m along their direction, and actuators, in their units.
    pub inputs: Vec<String>,
    /// Names of the sensors' columns.
    pub outputs: Vec<String>,
}

/// What drives do while a scene is linearised.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Drives {
    /// They stay where they are, as in a state of rest.
    Held,
    /// They go on as the scene says.
    Moving,
}

/// Linearises a scene in a state at a time (s), about rest or in motion. Inputs are its forces, moments and actuators, outputs its sensors.
///
/// Derivatives are exact, by dual numbers. Errors: no accelerations exist there.
pub fn linearise(
    scene: &Scene,
    time: f64,
    state: &[State<HostModal>],
    drives: Drives,
) -> Result<StateSpace, AnalysisError> {
    let held;
    let mechanism = match drives {
        Drives::Moving => &scene.mechanism,
        Drives::Held => {
            held = scene.mechanism.with_drives_held(time);
            &held
        }
    };
    let point = Point::new(scene, mechanism, time, state.to_vec());
    let tangent = Tangent::new(&point, &scene.body_names)?;
    let mut system = matrices(&point, &tangent)?;
    let elements = scene.mechanism.elements().iter().zip(&scene.element_names).enumerate();
    let forces = elements.filter(|(_, (element, _))| element.kind.grows());
    for (index, (_, name)) in forces {
        add_input(&mut system, &point, &tangent, Input::Element(index), name.clone())?;
    }
    for (index, name) in scene.actuator_names.iter().enumerate() {
        add_input(&mut system, &point, &tangent, Input::Actuator(index), name.clone())?;
    }
    for sensor in &scene.sensors {
        let endings = sensor.kind.columns().iter();
        system.outputs.extend(endings.map(|ending| format!("{}{ending}", sensor.name)));
    }
    system.coordinates = coordinates(scene);
    Ok(system)
}

/// A alone, about a steady rotation.
pub(super) fn about_spin(
    scene: &Scene,
    mechanism: &HostMechanism,
    time: f64,
    state: States,
    spin: Spin,
) -> Result<StateSpace, AnalysisError> {
    let mut point = Point::new(scene, mechanism, time, state);
    point.spin = Some(spin);
    let tangent = Tangent::new(&point, &scene.body_names)?;
    matrices(&point, &tangent)
}

fn matrices(point: &Point<'_>, tangent: &Tangent) -> Result<StateSpace, AnalysisError> {
    let (n, f) = (point.size(), tangent.freedom());
    let mut basis = DMatrix::zeros(2 * n, 2 * f);
    basis.view_mut((0, 0), (n, f)).copy_from(&tangent.places);
    basis.view_mut((n, 0), (n, f)).copy_from(&tangent.followed);
    basis.view_mut((n, f), (n, f)).copy_from(&tangent.places);
    let mut a = DMatrix::zeros(2 * f, 2 * f);
    let none = DVector::zeros(n);
    let here = point.evaluate(&none, &none)?;
    let mut c = DMatrix::zeros(here.outputs.len(), 2 * f);
    for column in 0..2 * f {
        let direction = basis.column(column);
        let moved = point.evaluate(&direction.rows(0, n).into_owned(), &direction.rows(n, n).into_owned())?;
        let parts = [&moved.place_rates, &moved.accelerations];
        for (half, part) in parts.into_iter().enumerate() {
            a.view_mut((half * f, column), (f, 1)).copy_from(&(&tangent.projection * slope(part)));
        }
        for (row, output) in moved.outputs.iter().enumerate() {
            c[(row, column)] = output.eps;
        }
    }
    let (b, d) = (DMatrix::zeros(2 * f, 0), DMatrix::zeros(c.nrows(), 0));
    let accelerations = &tangent.projection * value(&here.accelerations);
    let (coordinates, inputs, outputs) = (Vec::new(), Vec::new(), Vec::new());
    let mut projection = DMatrix::zeros(2 * f, 2 * n);
    projection.view_mut((0, 0), (f, n)).copy_from(&tangent.projection);
    projection.view_mut((f, n), (f, n)).copy_from(&tangent.projection);
    Ok(StateSpace { a, b, c, d, basis, projection, accelerations, coordinates, inputs, outputs })
}

fn add_input(
    system: &mut StateSpace,
    point: &Point<'_>,
    tangent: &Tangent,
    input: Input,
    name: String,
) -> Result<(), AnalysisError> {
    let (f, column) = (tangent.freedom(), system.inputs.len());
    let moved = point.evaluate_input(input)?;
    system.b = system.b.clone().insert_column(column, 0.0);
    system.d = system.d.clone().insert_column(column, 0.0);
    system.b.view_mut((f, column), (f, 1)).copy_from(&(&tangent.projection * slope(&moved.accelerations)));
    for (row, output) in moved.outputs.iter().enumerate() {
        system.d[(row, column)] = output.eps;
    }
    system.inputs.push(name);
    Ok(())
}

fn coordinates(scene: &Scene) -> Vec<String> {
    let mut names = Vec::new();
    for kinds in
        [["position", "rotation", "modal_coordinates"], ["velocity", "angular_velocity", "modal_rates"]]
    {
        for (body, shape) in scene.body_names.iter().zip(scene.mechanism.bodies()) {
            for kind in &kinds[..2] {
                names.extend(["x", "y", "z"].map(|axis| format!("{body}.{kind}.{axis}")));
            }
            names.extend((1..=shape.mode_count()).map(|mode| format!("{body}.{}.{mode}", kinds[2])));
        }
    }
    names
}
