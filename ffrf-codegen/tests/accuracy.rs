//! Accelerations of badly proportioned bodies: the 3 x 3 inverses must not lose more than the body asks for.

use ffrf_codegen::formulate::kernels::ELASTIC_ENERGY;
use ffrf_codegen::{GenerateOptions, KernelInput, Kernels, Strategy, generate};
use ffrf_test_kit::random::Random;
use ffrf_test_kit::random_body::{Modes, random_body};

/// Of M w + Q + K q + D q̇ - f relative to the terms of its row: some dozens of roundings, of which 7e-16 is found. The
/// frames are along the bodies and forces of any kind; for others see `tests/accuracy_of_accelerations/slender_bodies` of the facade.
const RESIDUAL: f64 = 1e-14;

/// The residual of the equations of motion at a random state, relative to the size of what is summed.
fn residual(kernels: &Kernels, seed: u64) -> f64 {
    let mut random = Random::new(seed);
    let (modes, size) = (kernels.mode_count(), 6 + kernels.mode_count());
    let q: Vec<f64> = random.numbers(modes).iter().map(|x| 0.1 * x).collect();
    let (q_dot, omega, force) = (random.numbers(modes), random.numbers(3), random.numbers(size));
    let acceleration = kernels.forward_dynamics(&q, &omega, &q_dot, &force);
    let mass = kernels.mass_matrix(&q);
    let quadratic = kernels.quadratic_velocity(&q, &omega, &q_dot);
    let internal = kernels.internal_force(&q, &q_dot);
    let mut worst = 0.0_f64;
    for row in 0..size {
        let modal = if row < 6 { 0.0 } else { internal[row - 6] };
        let products: Vec<f64> = (0..size).map(|column| mass[row][column] * acceleration[column]).collect();
        let scale =
            products.iter().chain([&quadratic[row], &modal, &force[row]]).map(|x| x.abs()).sum::<f64>();
        let sum = products.iter().sum::<f64>() + quadratic[row] + modal - force[row];
        worst = worst.max(sum.abs() / scale);
    }
    worst
}

#[test]
fn slender_bodies_far_from_their_frame() {
    for (thickness, offset) in [(1.0, 0.0), (1e-2, 0.0), (1e-2, 10.0), (1e-3, 0.0)] {
        let mut body = random_body(21, 3, Modes::Random);
        // Stretching the fields of a Gram matrix: the body gets thin in y and z and moves along x.
        let scale = [1.0, thickness, thickness];
        let inertia = &mut body.inertia;
        let (mass, first) = (inertia.mass, inertia.first_moment);
        let moments = inertia.position_mode_moment.clone();
        for i in 0..3 {
            inertia.first_moment[i] = scale[i] * first[i] + if i == 0 { offset * mass } else { 0.0 };
            for j in 0..3 {
                inertia.second_moment[i][j] *= scale[i] * scale[j];
            }
        }
        let shifted = |i: usize| scale[i] * first[i] * offset;
        inertia.second_moment[0][0] += 2.0 * shifted(0) + offset * offset * mass;
        for i in 1..3 {
            inertia.second_moment[0][i] += shifted(i);
            inertia.second_moment[i][0] += shifted(i);
        }
        for (mu, moment) in moments.iter().enumerate() {
            for j in 0..3 {
                for i in 0..3 {
                    inertia.position_mode_moment[mu][i][j] = scale[i] * moment[i][j];
                }
                inertia.position_mode_moment[mu][0][j] += offset * inertia.modal_first_moment[mu][j];
            }
        }
        let kernels = Kernels::formulate(&body, &GenerateOptions::default()).unwrap();
        for seed in 1..20 {
            let found = residual(&kernels, seed);
            assert!(found < RESIDUAL, "thickness {thickness}, offset {offset}, seed {seed}: {found:e}");
        }
    }
}

#[test]
fn modes_that_contain_rigid_motion_are_refused() {
    let mut body = random_body(22, 1, Modes::Random);
    // One mode that is the translation along x.
    let inertia = &mut body.inertia;
    inertia.modal_first_moment[0] = [inertia.mass, 0.0, 0.0];
    inertia.mode_mode_moment[0][0] = [[inertia.mass, 0.0, 0.0], [0.0; 3], [0.0; 3]];
    let first = inertia.first_moment;
    inertia.position_mode_moment[0] = [0, 1, 2].map(|i| [first[i], 0.0, 0.0]);
    let error = Kernels::formulate(&body, &GenerateOptions::default()).unwrap_err().to_string();
    assert!(error.contains("(counted from 1, mode 1 is a rigid motion)"), "{error}");
}

#[test]
fn modes_that_repeat_each_other_are_refused() {
    let mut body = random_body(24, 8, Modes::Random);
    // The fourth mode is the second one again.
    let inertia = &mut body.inertia;
    inertia.modal_first_moment[3] = inertia.modal_first_moment[1];
    inertia.position_mode_moment[3] = inertia.position_mode_moment[1];
    for row in &mut inertia.mode_mode_moment {
        row[3] = row[1];
    }
    inertia.mode_mode_moment[3] = inertia.mode_mode_moment[1].clone();
    for strategy in [Strategy::Lanes, Strategy::StraightLine] {
        let options = GenerateOptions { strategy, ..GenerateOptions::default() };
        let error = generate(&body, &options).map(|code| code.report).unwrap_err().to_string();
        assert!(error.contains("(counted from 1, mode 4 repeats mode 2)"), "{strategy:?}: {error}");
    }
}

#[test]
fn missing_input_shows_as_not_a_number() {
    let kernels =
        Kernels::formulate(&random_body(23, 2, Modes::Random), &GenerateOptions::default()).unwrap();
    let energy = kernels.evaluate(&ELASTIC_ENERGY, &KernelInput::<f64>::default());
    assert!(energy[0].is_nan());
}
