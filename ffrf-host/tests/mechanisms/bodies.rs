//! Random flexible bodies and states.

use ffrf_codegen::fidelity::Fidelity;
use ffrf_host::{HostBody, HostModal};
use ffrf_model::ReducedBody;
use ffrf_runtime::{Marker, State, rotation};
use ffrf_test_kit::random::Random;
use ffrf_test_kit::random_body::{Modes, random_body};
use nalgebra::{DVector, Vector3};

/// A random body with `modes` modes; dense Θ_ff for odd seeds, identity for even ones.
pub fn model(seed: u64, modes: usize) -> ReducedBody {
    let kind = if seed.is_multiple_of(2) { Modes::Normalised } else { Modes::Random };
    random_body(seed, modes, kind)
}

/// The body of a model with its markers: tip, root, and one on the rigid part.
pub fn body(model: &ReducedBody, random: &mut Random) -> (HostBody, Vec<Marker<HostModal, f64>>) {
    let body = HostBody::new(model, &Fidelity::Full);
    let mut markers = HostBody::markers(model);
    markers.push(Marker::rigid(Vector3::from(random.vector()), &HostModal::zeros(model.mode_count())));
    (body, markers)
}

/// Number of markers of [`body`].
pub const MARKERS: usize = 3;

/// A random state: anywhere, turned by anything, moving.
pub fn state(modes: usize, random: &mut Random) -> State<HostModal> {
    let mut parameters = [random.number(), random.number(), random.number(), random.number()];
    parameters[0] += 0.01;
    State {
        position: random.vector().into(),
        orientation: rotation::from_euler_parameters(parameters).unwrap(),
        modal_coordinates: HostModal(DVector::from_fn(modes, |_, _| 0.2 * random.number())),
        velocity: random.vector().into(),
        angular_velocity: Vector3::from(random.vector()) * 2.0,
        modal_rates: HostModal(DVector::from_fn(modes, |_, _| random.number())),
    }
}
