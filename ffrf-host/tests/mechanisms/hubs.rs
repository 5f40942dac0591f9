//! Flexible bodies with many joints, whose modes are unknowns of their own: the same solution, at a cost that is linear in
//! the joints.

use std::path::Path;

use ffrf_host::scene::Scene;
use ffrf_host::simulate::simulate;
use ffrf_runtime::joints::{Distance, InPlane, JointKind, Revolute, Spherical};
use ffrf_runtime::mechanism::{Assembly, Connection, Constrained};
use ffrf_runtime::{System, VectorSpace};
use ffrf_test_kit::random::Random;

use super::accelerations::Tally;
use super::bodies::model;
use super::dense::evaluate;
use super::graphs::{Case, attachment, case};
use super::redundant::check;

const REVOLUTE: JointKind = JointKind::Revolute(Revolute);
const SPHERICAL: JointKind = JointKind::Spherical(Spherical);

/// Joints of these kinds between these bodies, at random triads.
fn joined(edges: &[(JointKind, [Option<usize>; 2])], modes: &[usize], seed: u64) -> Case {
    let mut random = Random::new(seed);
    let joints = edges.iter().map(|(kind, ends)| {
        let [first, second] = ends.map(|body| attachment(body, &mut random));
        (Connection { kind: *kind, first, second }, None)
    });
    let joints = joints.collect();
    case(format!("{} joints on {modes:?} modes, seed {seed}", edges.len()), modes, joints, seed, &mut random)
}

/// So many arms on body 0, which turns on the ground.
fn star(arms: usize, hub: usize, arm: usize, seed: u64) -> Case {
    let mut edges = vec![(REVOLUTE, [None, Some(0)])];
    edges.extend((1..=arms).map(|arm| {
        let kind = if arm % 3 == 0 { SPHERICAL } else { REVOLUTE };
        // either end may be the hub's
        (kind, if arm % 2 == 0 { [Some(arm), Some(0)] } else { [Some(0), Some(arm)] })
    }));
    let mut modes = vec![arm; arms + 1];
    modes[0] = hub;
    joined(&edges, &modes, seed)
}

/// Two hubs with arms, joined to each other, and closed loops between arms.
fn two_hubs(hubs: [usize; 2], seed: u64) -> Case {
    let distance = JointKind::Distance(Distance { length: 0.7 });
    let mut edges = vec![(REVOLUTE, [None, Some(0)]), (SPHERICAL, [Some(0), Some(1)])];
    for arm in 0..4 {
        edges.push((REVOLUTE, [Some(0), Some(2 + arm)]));
        edges.push((SPHERICAL, [Some(6 + arm), Some(1)]));
    }
    edges.push((distance, [Some(2), Some(6)]));
    edges.push((JointKind::InPlane(InPlane), [Some(3), Some(1)]));
    let modes = [hubs[0], hubs[1], 0, 3, 0, 2, 1, 0, 4, 0];
    joined(&edges, &modes, seed)
}

fn every_case(mut check: impl FnMut(&Case)) {
    for seed in 1..=6 {
        for (arms, hub) in [(3, 1), (5, 5), (6, 9), (8, 13)] {
            check(&star(arms, hub, seed as usize % 3, seed));
        }
        for hubs in [[5, 5], [9, 2], [13, 9], [3, 13]] {
            check(&two_hubs(hubs, seed));
        }
    }
}

#[test]
fn kept_modes_accelerate_as_a_dense_solve_says() {
    let mut tally = Tally::new();
    every_case(|case| {
        assert!(!case.mechanism.plan().modes.is_empty(), "{}: modes are kept", case.name);
        tally.add(case, &evaluate(case, &case.states, 0.0, None), None);
    });
    tally.tell("hubs");
}

#[test]
fn kept_modes_are_right_in_stages_of_linearly_implicit_steps() {
    let mut tally = Tally::new();
    let mut number = 0;
    every_case(|case| {
        number += 1;
        let gamma_h = [1e-3, 0.1, 100.0][number % 3];
        let system = Constrained(&case.mechanism);
        let mut subtracted = system.rates(0.0, &case.states, &system.no_change(&case.states)).unwrap();
        subtracted.scale(0.3);
        let stage = Some((gamma_h, &subtracted));
        tally.add(case, &evaluate(case, &case.states, 0.0, stage), stage);
    });
    tally.tell("hubs in implicit stages");
}

/// Reactions of least norm are measured as on bodies whose modes are eliminated.
#[test]
fn redundant_rows_on_a_hub_share_reactions_as_on_other_bodies() {
    for (hub, seed) in [(4, 1), (5, 2), (9, 3), (2, 4)] {
        let mut random = Random::new(seed);
        let arms = 4;
        let mut joints = vec![(
            Connection {
                kind: SPHERICAL,
                first: attachment(None, &mut random),
                second: attachment(Some(0), &mut random),
            },
            None,
        )];
        for arm in 1..=arms {
            let [first, second] = [Some(0), Some(arm)].map(|body| attachment(body, &mut random));
            let connection = Connection { kind: REVOLUTE, first, second };
            // the first arm is held twice
            joints.extend(std::iter::repeat_n((connection, None), if arm == 1 { 2 } else { 1 }));
        }
        let modes = [hub, 0, 2, 0, 1];
        let case = case(format!("hub with {hub} modes, seed {seed}"), &modes, joints, seed, &mut random);
        assert!(!case.mechanism.plan().modes.is_empty(), "{}: modes are kept", case.name);
        check(&case, 5);
    }
}

/// Slope of cost in the double logarithm that still counts as linear.
const LINEAR: f64 = 1.1;

/// Multiply-adds of one factorisation of stars on a flexible hub; the numbers are a snapshot.
#[test]
fn the_cost_of_a_star_on_a_flexible_hub_is_linear_in_its_arms() {
    let expected = [
        [2851.0, 5102.0, 9307.0, 18015.0, 35134.0],
        [5038.0, 8669.0, 15465.0, 29522.0, 57171.0],
        [7473.0, 12533.0, 22012.0, 41610.0, 80167.0],
    ];
    let found = [4, 9, 13].map(|hub| {
        let costs = [4, 8, 16, 32, 64].map(|arms| star(arms, hub, 0, 1).mechanism.solve_cost().0);
        for (fewer, more) in costs.iter().zip(&costs[1..]) {
            let slope = (more / fewer).log2();
            assert!(slope <= LINEAR, "{hub} modes: {costs:?}, slope {slope}");
        }
        costs.map(f64::round)
    });
    assert_eq!(found, expected);
}

/// Few joints on many modes: eliminating the modes first is cheaper, and is what is done.
#[test]
fn a_body_keeps_its_modes_only_where_that_is_cheaper() {
    for (arms, modes, kept) in [(2, 1, false), (3, 4, true), (3, 13, false), (5, 13, true)] {
        let mechanism = star(arms, modes, 0, 1).mechanism;
        assert_eq!(!mechanism.plan().modes.is_empty(), kept, "{arms} arms on {modes} modes");
    }
}

/// Relative difference of states after some steps: reactions are shared by redundant rows, whose shift is 1e-9.
const ALIKE: f64 = 1e-9;

/// A swinging body with an arm and a spring, each attached once or twice with half the strength: positions, velocities and
/// modal coordinates at the end.
fn swung(folder: &Path, integrator: &str, times: usize) -> Vec<f64> {
    let mut text = format!(
        "[simulation]\nduration = 0.02\nstep = 1e-3\nintegrator = \"{integrator}\"\ngravity = [0.5, -1.0, -9.0]\n\
         output_step = 0.02\n\
         [bodies.hub]\nmodel = \"hub.json\"\nangular_velocity = [0.3, 1.2, -0.5]\nmodal_rates = [0.2, -0.1, 0.4, 0.1]\n\
         [bodies.arm]\nmass = 0.7\ninertia = [[0.2, 0.0, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.4]]\nposition = [0.3, 0.2, 0.1]\n"
    );
    for k in 0..times {
        let stiffness = 40.0 / times as f64;
        text.push_str(&format!(
            "[joints.pin{k}]\nkind = \"spherical\"\nfirst = \"ground\"\nsecond = \"hub.root\"\n\
             [joints.elbow{k}]\nkind = \"revolute\"\nfirst = \"hub.tip\"\nsecond = \"arm\"\naxis = [1.0, -0.4, 0.2]\n\
             [forces.spring{k}]\nkind = \"spring\"\nfirst = \"ground\"\nfirst_position = [0.4, 0.9, 0.1]\n\
             second = \"hub.tip\"\nstiffness = {stiffness:?}\nrest = 0.1\n"
        ));
    }
    let path = folder.join("scene.toml");
    std::fs::write(&path, text).unwrap();
    let scene = Scene::read(&path).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(
        scene.mechanism.plan().modes.is_empty(),
        times == 1,
        "modes are kept by the hub that has six ends"
    );
    let summary = simulate(&scene, None, |_| Ok(()), |_| ()).unwrap_or_else(|error| panic!("{error}"));
    let bodies = ["hub", "arm"].map(|name| &summary.end.bodies[name]);
    let numbers = bodies.iter().flat_map(|body| {
        let rigid = body.position.iter().chain(&body.velocity).chain(&body.angular_velocity);
        rigid.chain(&body.modal_coordinates).copied().collect::<Vec<_>>()
    });
    numbers.collect()
}

/// Soft rows, implicit stages and steps of the energy-momentum method, with the modes kept and with the modes eliminated.
#[test]
fn everything_attached_twice_with_half_the_strength_moves_as_once() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("hub.json"), serde_json::to_string(&model(3, 4)).unwrap()).unwrap();
    for integrator in ["rk4", "linearly_implicit", "energy_momentum", "generalized_alpha"] {
        let [once, twice] = [1, 2].map(|times| swung(folder.path(), integrator, times));
        let size = once.iter().fold(0.0_f64, |size, number| size.max(number.abs()));
        let apart = once.iter().zip(&twice).fold(0.0_f64, |apart, (a, b)| apart.max((a - b).abs()));
        println!("{integrator}: {:.1e}", apart / size);
        assert!(apart < ALIKE * size, "{integrator}: {once:?} and {twice:?}");
    }
}
