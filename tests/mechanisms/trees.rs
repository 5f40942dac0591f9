//! Trees need no regularisation: accelerations and reactions against a dense solution of all equations; on a hub with many
//! joints too, whose modes are unknowns of their own.

use ffrf::mechanism::{Assembly, Connection, Constrained, Ports, Regularisation};
use ffrf::nalgebra::{DMatrix, DVector, SMatrix, SVector, Vector3};
use ffrf::{DenseForms, Increment, PlacedMarker, State, mechanism};

use crate::bodies::{BIG_END, Rod, SMALL_END, WholeRod};

mechanism! {
    /// A hub that branches: one rod on it, two on that.
    pub struct Tree {
        bodies: { arms: [Rod; 4] },
        gravity: [0.0, -9.81, 0.0],
        joints: {
            root: revolute(ground, arms[0].BIG_END, axis: z),
            branches: for i in 0..2 { spherical(arms[0].SMALL_END, arms[i + 1].BIG_END) },
            leaf: universal(arms[1].SMALL_END, arms[3].BIG_END, axis: z),
        },
    }
}

mechanism! {
    /// Five rods on the first of six, which keeps its modes.
    pub struct Hub {
        bodies: { arms: [Rod; 6] },
        gravity: [0.0, -9.81, 0.0],
        joints: {
            root: revolute(ground, arms[0].BIG_END, axis: z),
            branches: for i in 0..5 { spherical(arms[0].SMALL_END, arms[i + 1].BIG_END) },
        },
    }
}

mechanism! {
    /// More modes than rows: they are eliminated in the hub.
    pub struct FewRows {
        bodies: { hub: WholeRod, arms: [Rod; 3] },
        joints: {
            root: spherical(ground, hub.BIG_END),
            branches: for i in 0..3 { distance(hub.SMALL_END, arms[i].BIG_END, length: 0.1) },
        },
    }
}

const N: usize = 10;

/// Deforms arms that are so many rods away from the ground, and lets them move.
fn disturb(arms: &mut [State<SVector<f64, 4>>], places: &[f64]) {
    for (k, (arm, place)) in arms.iter_mut().zip(places).enumerate() {
        arm.position.x = place * (SMALL_END - BIG_END) - BIG_END;
        for mode in 0..4 {
            arm.modal_coordinates[mode] = 1e-5 * ((3 * k + mode) as f64).sin();
            arm.modal_rates[mode] = 1e-2 * ((5 * k + mode) as f64).cos();
        }
        arm.angular_velocity = Vector3::new(0.3, -0.2, 1.0 + k as f64);
    }
}

/// A state in which the joints are met, deformed and moving.
fn moving(model: &Tree) -> TreeState {
    let mut state = model.at_rest();
    disturb(&mut state.arms, &[0.0, 1.0, 1.0, 2.0]);
    let mut tree = model.in_motion(state);
    tree.assemble().unwrap();
    tree.state
}

/// Accelerations [α; ω̇; q̈] of each arm by LU of the whole saddle point matrix.
fn dense(
    connections: &[Connection],
    arms: &[State<SVector<f64, 4>>],
    ports: &dyn Ports<f64>,
    gravity: &Vector3<f64>,
) -> DVector<f64> {
    let rows: usize = connections.iter().map(|joint| joint.kind.row_count()).sum();
    let size = arms.len() * N + rows;
    let (mut matrix, mut right) = (DMatrix::<f64>::zeros(size, size), DVector::<f64>::zeros(size));
    for (k, arm) in arms.iter().enumerate() {
        let (q, omega, q_dot) = (&arm.modal_coordinates, &arm.angular_velocity, &arm.modal_rates);
        let mass: SMatrix<f64, N, N> = DenseForms::<4, N>::mass_matrix(&Rod, q);
        matrix.view_mut((N * k, N * k), (N, N)).copy_from(&mass);
        let gravity = ffrf::FlexibleBody::<f64>::gravity_force(&Rod, q, &arm.to_body(gravity));
        let prepared = ffrf::FlexibleBody::<f64>::prepare(&Rod, q, omega, q_dot);
        let net = prepared.net_force(&gravity);
        let parts = net.force.iter().chain(net.moment.iter()).chain(net.modal.iter());
        for (i, entry) in parts.enumerate() {
            right[N * k + i] = *entry;
        }
    }
    let mut row_index = arms.len() * N;
    for joint in connections {
        let ends = [joint.first.motion(ports), joint.second.motion(ports)];
        let rows = ffrf::joints::Joint::rows(&joint.kind, &ends[0], &ends[1], &[0.0; 3]);
        for row in rows.iter() {
            right[row_index] = -row.whole_bias(&ends[0], &ends[1]);
            for (attachment, wrench) in [(&joint.first, &row.first), (&joint.second, &row.second)] {
                let Some(body) = attachment.body else { continue };
                // by unit motions: what the marker's velocities are in each
                for i in 0..N {
                    let motion = unit(i);
                    let marker = MARKERS[attachment.marker];
                    let [linear, angular] = PlacedMarker::new(&marker, &arms[body]).twist(&motion);
                    let entry = wrench.power(&linear, &angular);
                    matrix[(row_index, N * body + i)] += entry;
                    matrix[(N * body + i, row_index)] += entry;
                }
            }
            row_index += 1;
        }
    }
    matrix.full_piv_lu().solve(&right).unwrap().rows(0, arms.len() * N).into_owned()
}

/// The markers in the order in which the mechanism uses them.
const MARKERS: [ffrf::Marker<SVector<f64, 4>>; 2] = [Rod::BIG_END, Rod::SMALL_END];

fn unit(index: usize) -> ffrf::Motion<SVector<f64, 4>> {
    let mut motion = ffrf::Motion::zeros(&SVector::<f64, 4>::zeros());
    match index {
        0..3 => motion.linear[index] = 1.0,
        3..6 => motion.angular[index - 3] = 1.0,
        _ => motion.modal[index - 6] = 1.0,
    }
    motion
}

/// [α; ω̇; q̈] of an arm from the rates of its state.
fn body_parts(state: &State<SVector<f64, 4>>, rate: &Increment<SVector<f64, 4>>) -> Vec<f64> {
    let linear = state.to_body(&rate.velocity);
    linear.iter().chain(rate.angular_velocity.iter()).chain(rate.modal_rates.iter()).copied().collect()
}

#[test]
fn a_tree_without_regularisation_is_solved_to_round_off() {
    let model = Tree::new([Rod; 4]);
    assert_eq!(model.regularisation, Regularisation::of_trees());
    let state = moving(&model);
    let mut rooms = model.rooms();
    let ports = model.ports(&mut rooms, state, None);
    let expected = dense(model.connections(), &state.arms, &ports, &model.gravity);
    let found = |model: &Tree| {
        let rates = Constrained(model);
        let rates = ffrf::System::rates(&rates, 0.0, &state, &model.no_change(&state)).unwrap();
        let parts = state.arms.iter().zip(&rates.arms).flat_map(|(state, rate)| body_parts(state, rate));
        DVector::from_vec(parts.collect())
    };
    let plain = (&found(&model) - &expected).amax() / expected.amax();
    let regularised = Tree { regularisation: Regularisation::of_loops(), ..model };
    let refined = (&found(&regularised) - &expected).amax() / expected.amax();
    println!("trees: plain {plain:.1e}, regularised and refined {refined:.1e} of {:.2e}", expected.amax());
    assert!(plain < 1e-12, "{plain:.2e}");
    assert!(plain < 10.0 * refined.max(1e-15), "{plain:.2e} {refined:.2e}");
}

#[test]
fn a_hub_that_keeps_its_modes_is_solved_to_round_off() {
    let model = Hub::new([Rod; 6]);
    assert_eq!(model.plan().modes.len(), 1);
    let mut state = model.at_rest();
    disturb(&mut state.arms, &[0.0, 1.0, 1.0, 1.0, 1.0, 1.0]);
    let mut hub = model.in_motion(state);
    hub.assemble().unwrap();
    let state = hub.state;
    let mut rooms = model.rooms();
    let ports = model.ports(&mut rooms, state, None);
    let expected = dense(model.connections(), &state.arms, &ports, &model.gravity);
    for regularisation in [Regularisation::of_trees(), Regularisation::of_loops()] {
        let model = Hub { regularisation, ..model };
        let rates = ffrf::System::rates(&Constrained(&model), 0.0, &state, &model.no_change(&state)).unwrap();
        let parts = state.arms.iter().zip(&rates.arms).flat_map(|(state, rate)| body_parts(state, rate));
        let error = (DVector::from_vec(parts.collect()) - &expected).amax() / expected.amax();
        println!("hub: {error:.1e} of {:.2e}", expected.amax());
        assert!(error < 1e-12, "{error:.2e}");
    }
}

#[test]
fn a_hub_with_more_modes_than_rows_eliminates_them() {
    let model = FewRows::new(WholeRod, [Rod; 3]);
    assert!(model.plan().modes.is_empty());
}
