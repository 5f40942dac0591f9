//! Random flexible bodies and states, and the bodies against their witness.

use ffrf_codegen::fidelity::Fidelity;
use ffrf_host::{HostBody, HostModal};
use ffrf_model::ReducedBody;
use ffrf_runtime::{DenseForms, FlexibleBody, Marker, Observables, State, rotation};
use ffrf_test_kit::naive_body::NaiveBody;
use ffrf_test_kit::random::Random;
use ffrf_test_kit::random_body::{Modes, random_body, stiffened};
use ffrf_test_kit::witness::invariants;
use nalgebra::{DVector, SMatrix, SVector, Vector3};

use super::dense::flat_force;

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

/// Kernels of polynomials: a few hundred operations on numbers of one size.
const POLYNOMIAL: f64 = 1e-13;
/// Size of the geometric stiffness of every third body, beside masses of modes of about one.
const STIFFENING: f64 = 0.1;

/// The host's body with its tables against the naive form: masses, forces, momenta and energies at random states.
#[test]
fn bodies_of_run_time_size_are_the_naive_ones() {
    for seed in 1..=10 {
        compare::<0, 6>(seed);
        compare::<1, 7>(seed);
        compare::<2, 8>(seed);
        compare::<3, 9>(seed);
        compare::<4, 10>(seed);
        compare::<5, 11>(seed);
    }
}

fn compare<const M: usize, const N: usize>(seed: u64) {
    let (model, mut random) = (model(seed, M), Random::new(seed + 50));
    let model = if seed.is_multiple_of(3) { stiffened(model, seed, STIFFENING) } else { model };
    let naive = NaiveBody::<M, N>::new(&invariants(&model)).stiffened(model.geometric_stiffness.as_ref());
    let host = HostBody::new(&model, &Fidelity::Full);
    let state = state(M, &mut random);
    let modal = |vector: &HostModal| SVector::<f64, M>::from_column_slice(vector.0.as_slice());
    let (q, q_dot) = (&state.modal_coordinates, &state.modal_rates);
    let (exact_q, exact_rates) = (modal(q), modal(q_dot));
    let (v, w) = (&state.velocity, &state.angular_velocity);
    let prepared = host.prepare(q, w, q_dot);
    let exact = naive.mass_matrix(&exact_q);
    let (rigid, coupling, modes) = (prepared.rigid_mass(), prepared.coupling(), host.modal_mass().dense());
    let mass = SMatrix::<f64, N, N>::from_fn(|i, j| match (i < 6, j < 6) {
        (true, true) => rigid[(i, j)],
        (true, false) => coupling[i].0[j - 6],
        (false, true) => coupling[j].0[i - 6],
        (false, false) => modes[(i - 6, j - 6)],
    });
    close("mass", mass.as_slice(), exact.as_slice());
    let quadratic = flat_force(&prepared.quadratic_velocity);
    close("quadratic", quadratic.as_slice(), naive.quadratic_velocity(&exact_q, w, &exact_rates).as_slice());
    let internal = naive.internal_force(&exact_q, &exact_rates);
    close("internal", prepared.internal_force.0.as_slice(), internal.as_slice());
    let weight = naive.gravity_force(&exact_q, v).to_vector::<N>();
    close("gravity", flat_force(&host.gravity_force(q, v)).as_slice(), weight.as_slice());
    let momenta = |body: [Vector3<f64>; 3]| body.map(<[f64; 3]>::from).concat();
    close(
        "momenta",
        &momenta([
            host.linear_momentum(q, v, w, q_dot),
            host.angular_momentum(q, v, w, q_dot),
            host.first_mass_moment(q),
        ]),
        &momenta([
            naive.linear_momentum(&exact_q, v, w, &exact_rates),
            naive.angular_momentum(&exact_q, v, w, &exact_rates),
            naive.first_mass_moment(&exact_q),
        ]),
    );
    close(
        "energies",
        &[host.kinetic_energy(q, v, w, q_dot), host.elastic_energy(q), host.mass()],
        &[naive.kinetic_energy(&exact_q, v, w, &exact_rates), naive.elastic_energy(&exact_q), naive.mass()],
    );
}

fn close(what: &str, found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let size = expected.iter().fold(1e-3_f64, |size, x| size.max(x.abs()));
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= POLYNOMIAL * size, "{what}: {found} and {expected}");
    }
}
