//! One reference case: every state, every quantity.

use ffrf::nalgebra::{SMatrix, SVector};
use ffrf::{DenseForms, GeneralisedForce, NamedMarkers, Observables};
use serde_json::Value;

use crate::Run;
use crate::compare::{deviation, numbers, rotation, vector, vector_deviation, vector3};

/// Mass matrix, quadratic velocity, energies and momenta: round-off of the format's own suggestion.
const EXACT: f64 = 1e-12;

/// Largest deviations over the states of one case.
#[derive(Default)]
struct Worst {
    mass: f64,
    quadratic: f64,
    energy: f64,
    momentum: f64,
    markers: f64,
    acceleration_over_tolerance: f64,
    one_pass: f64,
}

/// Compares `body` with the case `name`.
pub fn check<B, const M: usize, const N: usize>(run: &mut Run, name: &str, body: &B)
where
    B: DenseForms<M, N> + Observables + NamedMarkers,
{
    let case = run.read(&format!("{name}.json"));
    let scale = case["invariants"]["m"].as_f64().expect("m") * case["size"].as_f64().expect("size");
    let mut worst = Worst::default();
    let states = case["states"].as_array().expect("states");
    assert!(!states.is_empty());
    for state in states {
        check_state(body, state, scale, &mut worst);
    }
    run.check(&format!("{name}: mass matrix"), worst.mass, EXACT);
    run.check(&format!("{name}: quadratic velocity"), worst.quadratic, EXACT);
    run.check(&format!("{name}: energies"), worst.energy, EXACT);
    run.check(&format!("{name}: momenta, gravity"), worst.momentum, EXACT);
    run.check(&format!("{name}: markers"), worst.markers, EXACT);
    run.check(&format!("{name}: acceleration over its tolerance"), worst.acceleration_over_tolerance, 1.0);
    run.check(&format!("{name}: one pass against single kernels"), worst.one_pass, EXACT);
}

fn check_state<B, const M: usize, const N: usize>(body: &B, state: &Value, scale: f64, worst: &mut Worst)
where
    B: DenseForms<M, N> + Observables + NamedMarkers,
{
    let a = rotation(&state["theta"]);
    let q: SVector<f64, M> = vector(&state["q"]);
    let q_dot: SVector<f64, M> = vector(&state["q_dot"]);
    let omega = a.transpose() * vector3(&state["omega"]);
    let velocity = a.transpose() * vector3(&state["v_t"]);
    let force = to_body(&a, &vector::<N>(&state["Q_ext"]));

    let mass = body.mass_matrix(&q);
    worst.mass = worst.mass.max(matrix_deviation(&mass, &state["mass_b"], scale));
    let quadratic = body.quadratic_velocity(&q, &omega, &q_dot);
    worst.quadratic = worst.quadratic.max(vector_deviation(quadratic.as_slice(), &numbers(&state["qw_b"])));

    let tolerance = (100.0 * state["acc_uncertainty_rel"].as_f64().expect("uncertainty")).max(1e-10);
    let resultant = GeneralisedForce::from_vector(&force);
    let acceleration = body.forward_dynamics(&q, &omega, &q_dot, &resultant).to_vector::<N>();
    let off = vector_deviation(acceleration.as_slice(), &numbers(&state["acc_b"]));
    worst.acceleration_over_tolerance = worst.acceleration_over_tolerance.max(off / tolerance);

    let all = body.equations_of_motion(&q, &omega, &q_dot, &force);
    let one_pass = vector_deviation(all.acceleration.as_slice(), acceleration.as_slice())
        .max(vector_deviation(all.quadratic_velocity.as_slice(), quadratic.as_slice()))
        .max((all.mass_matrix - mass).amax() / mass.amax());
    worst.one_pass = worst.one_pass.max(one_pass);

    let kinetic = body.kinetic_energy(&q, &velocity, &omega, &q_dot);
    let elastic = body.elastic_energy(&q);
    let expected = [state["kinetic"].as_f64().expect("kinetic"), state["elastic"].as_f64().expect("elastic")];
    worst.energy = worst.energy.max(deviation(&[kinetic], &expected[..1], 1.0)).max(deviation(&[elastic], &expected[1..], 1.0));

    let linear = a * body.linear_momentum(&q, &velocity, &omega, &q_dot);
    let angular = a * body.angular_momentum(&q, &velocity, &omega, &q_dot) + vector3(&state["q_t"]).cross(&linear);
    worst.momentum = worst
        .momentum
        .max(deviation(linear.as_slice(), &numbers(&state["P"]), scale))
        .max(deviation(angular.as_slice(), &numbers(&state["L_origin"]), scale));
    let gravity = body.gravity_force(&q, &(a.transpose() * vector3(&state["gravity"]["g"]))).to_vector::<N>();
    let expected = to_body(&a, &vector::<N>(&state["gravity"]["Q"]));
    worst.momentum = worst.momentum.max(vector_deviation(gravity.as_slice(), expected.as_slice()));

    check_markers::<B, M, N>(body, state, &q, &q_dot, worst);
}

fn check_markers<B, const M: usize, const N: usize>(
    body: &B,
    state: &Value,
    q: &SVector<f64, M>,
    q_dot: &SVector<f64, M>,
    worst: &mut Worst,
) where
    B: NamedMarkers<Modal = SVector<f64, M>>,
{
    let a = rotation(&state["theta"]);
    let omega = a.transpose() * vector3(&state["omega"]);
    let velocity = a.transpose() * vector3(&state["v_t"]);
    let find = |node: &Value| {
        let wanted = format!("NODE_{node}");
        body.marker(&wanted).expect("a marker for every node that the case names")
    };
    let marker = find(&state["nodal_force"]["node"]);
    let found = marker.force(q, &(a.transpose() * vector3(&state["nodal_force"]["f"]))).to_vector::<N>();
    let expected = to_body(&a, &vector::<N>(&state["nodal_force"]["Q"]));
    worst.markers = worst.markers.max(vector_deviation(found.as_slice(), expected.as_slice()));

    let marker = find(&state["probe"]["node"]);
    let position = vector3(&state["q_t"]) + a * marker.position(q);
    let rate = a * marker.velocity(q, &velocity, &omega, q_dot);
    worst.markers = worst
        .markers
        .max(deviation(position.as_slice(), &numbers(&state["probe"]["r"]), 1.0))
        .max(deviation(rate.as_slice(), &numbers(&state["probe"]["v"]), 1.0));
}

/// diag(Aᵀ, Aᵀ, I) times an inertial generalised force.
fn to_body<const N: usize>(a: &ffrf::nalgebra::Matrix3<f64>, force: &SVector<f64, N>) -> SVector<f64, N> {
    let mut turned = *force;
    for start in [0, 3] {
        let part = a.transpose() * force.fixed_rows::<3>(start);
        turned.fixed_rows_mut::<3>(start).copy_from(&part);
    }
    turned
}

/// Largest deviation over the blocks tt, tr, tf, rr, rf, ff and their mirror images.
fn matrix_deviation<const N: usize>(found: &SMatrix<f64, N, N>, expected: &Value, scale: f64) -> f64 {
    let expected = SMatrix::<f64, N, N>::from_row_slice(&numbers(expected));
    let blocks = [0..3, 3..6, 6..N];
    let mut worst: f64 = 0.0;
    for rows in &blocks {
        for columns in &blocks {
            let pick = |matrix: &SMatrix<f64, N, N>| -> Vec<f64> {
                rows.clone().flat_map(|i| columns.clone().map(move |j| (i, j))).map(|ij| matrix[ij]).collect()
            };
            worst = worst.max(deviation(&pick(found), &pick(&expected), scale));
        }
    }
    worst
}
