//! Plans against sweeps: what is planned keeps its budget, and nothing that a sweep finds is much cheaper.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use ffrf_codegen::{Fidelity, ScalarType};
use ffrf_host::scene::file::SceneFile;
use ffrf_host::scene::{Integrator, Scene};
use ffrf_host::simulate::simulate;
use ffrf_host::tradeoff::{
    Axes, Configuration, Finding, Measured, Modes, Operations, Outcome, PlanOptions, Quantity, Reference,
    ReferenceOptions, SceneModes, StepBudget, Study, TradeoffError, Variant, plan, plan_within, run, sweep,
};
use ffrf_runtime::FlexibleBody;

/// What a plan may exceed its budget by.
const OVER_BUDGET: f64 = 2.0;
/// What a plan may cost over the best of a sweep that is as exact.
const OVER_BEST: f64 = 3.0;

fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes")
}

/// A scene of `models/scenes`, shortened to `duration` (s) and sampled `samples` times.
fn study(name: &str, duration: f64, samples: f64) -> Study {
    let mut file = SceneFile::read(&scenes().join(name)).unwrap();
    file.simulation.duration = duration;
    file.simulation.output_step = Some(duration / samples);
    Study::new(file, scenes()).unwrap()
}

/// Plans, measures what was planned, sweeps, and compares.
#[track_caller]
fn compare(
    name: &str,
    study: &Study,
    error: f64,
    quantities: &[Quantity],
    modes: Vec<usize>,
    steps: Vec<f64>,
) {
    let integrators = vec![Integrator::Rk4, Integrator::LinearlyImplicit, Integrator::GeneralizedAlpha];
    let scalars = vec![ScalarType::F64];
    let options = PlanOptions {
        error,
        quantities: quantities.to_vec(),
        integrators: integrators.clone(),
        scalars: scalars.clone(),
    };
    let found = plan(study, &options).unwrap();
    let tolerance = 0.1 * found.reference.tolerance;
    let reference = Reference::compute(study, quantities, ReferenceOptions { tolerance }).unwrap();
    let one = &found.configuration;
    let variant = study.variant(&one.modes, &one.fidelity).unwrap();
    let Finding::Finished(planned) = run(study, &variant, &reference, one).finding else {
        panic!("{name}: {one:?} fails");
    };
    let axes = Axes {
        modes: modes.into_iter().map(SceneModes::first).collect(),
        fidelities: vec![Fidelity::Constant, Fidelity::Linear, Fidelity::Full],
        scalars,
        integrators,
        steps,
    };
    let all =
        sweep(study, &reference, &axes.configurations(), &BTreeMap::new(), 2, &mut |_, _| Ok(())).unwrap();
    let best = cheapest(&all, error.max(planned.error()));
    let (measured, cost) = (planned.error(), planned.operations_per_second());
    eprintln!(
        "{name}, {error:e}: {} measured {measured:.2e}, predicted {:.2e}, ratio {:.2}; cost {cost:.3e}, best of {} {:.3e} ({}), ratio {:.2}",
        one.key(),
        found.predicted_error,
        measured / found.predicted_error,
        all.len(),
        best.1.operations_per_second(),
        best.0.key(),
        cost / best.1.operations_per_second()
    );
    assert!(
        reference.own_error() < 0.1 * error,
        "{name}: the reference itself is off by {}",
        reference.own_error()
    );
    assert!(measured <= OVER_BUDGET * error, "{name}: {measured} of {error}");
    assert!(cost <= OVER_BEST * best.1.operations_per_second(), "{name}: {cost}");
}

fn cheapest(all: &[Outcome], error: f64) -> (&Configuration, &Measured) {
    let kept = all.iter().filter_map(|outcome| match &outcome.finding {
        Finding::Finished(measured) if measured.error() <= error => Some((&outcome.configuration, measured)),
        _ => None,
    });
    kept.min_by(|a, b| a.1.operations_per_second().total_cmp(&b.1.operations_per_second())).unwrap()
}

/// From `first` (s) down by factors of two.
fn steps(first: f64, count: i32) -> Vec<f64> {
    (0..count).map(|k| first / 2.0_f64.powi(k)).collect()
}

#[test]
fn a_plan_of_the_tumbling_rod_keeps_its_budget_and_is_cheap() {
    let study = study("tumbling_rod.toml", 4.0, 20.0);
    for error in [3e-2, 1e-3] {
        compare("tumbling rod", &study, error, &[], vec![0, 1, 2, 3, 4], steps(0.1, 7));
    }
}

#[test]
fn a_plan_of_the_rotor_keeps_its_budget_and_is_cheap() {
    let study = study("rotor_run_up.toml", 0.3, 60.0);
    for error in [3e-2, 1e-3] {
        compare("rotor", &study, error, &[], vec![0], steps(1e-3, 7));
    }
}

#[test]
fn a_plan_of_the_slider_crank_keeps_its_budget_and_is_cheap() {
    let study = study("slider_crank.toml", 4e-3, 20.0);
    let reaction = [Quantity::Sensor("bearing".to_owned()), Quantity::Sensor("stroke".to_owned())];
    // the sixth mode, along the rod, makes the force on the crank: fewer are off by a third
    compare("slider-crank", &study, 3e-2, &reaction, vec![0, 4, 6, 8], steps(4e-5, 5));
}

/// The cheapest step is a rigid one; with more time the force in the bearing gets better, and no step takes longer than it may.
#[test]
fn a_plan_for_a_time_per_step_takes_no_more_and_uses_what_it_has() {
    let study = study("slider_crank.toml", 2e-3, 20.0);
    let budget = |operations: f64| StepBudget {
        step: 1e-5,
        operations: Operations { double: operations, single: operations },
        divisions: vec![1],
        quantities: vec![Quantity::Sensor("bearing".to_owned())],
        integrators: vec![Integrator::Rk4, Integrator::LinearlyImplicit],
        scalars: vec![ScalarType::F64],
    };
    let mut before = f64::INFINITY;
    for operations in [1.4e4, 3e4, 1e5] {
        let found = plan_within(&study, &budget(operations)).unwrap();
        let one = &found.best;
        eprintln!("{operations:e}: {}", one.describe());
        assert!(one.operations <= operations, "{}", one.describe());
        assert!(found.error <= before, "{} after {before:e}", one.describe());
        assert!(found.tried.iter().all(|other| other.configuration.step == 1e-5));
        before = found.error;
    }
    // all eight modes in RK4: the least error that there is with this step
    assert!(before < 0.1, "{before:e}");
    let refused = plan_within(&study, &budget(1e3)).unwrap_err();
    assert!(matches!(refused, TradeoffError::StepBudget { .. }), "{refused}");
    assert!(refused.to_string().contains("1.000e3 operations"), "{refused}");
}

/// The runs of a study are those of the simulation itself.
#[test]
fn a_run_of_a_study_is_the_simulation() {
    let path = scenes().join("double_pendulum.toml");
    let mut file = SceneFile::read(&path).unwrap();
    (file.simulation.tolerance, file.simulation.step, file.simulation.integrator) = (None, Some(1e-3), None);
    (file.simulation.duration, file.simulation.output_step) = (0.2, Some(0.01));
    let study = Study::new(file.clone(), scenes()).unwrap();
    let reference = Reference::compute(&study, &[], ReferenceOptions { tolerance: 1e-9 }).unwrap();
    let scene = Scene::compose(&file, &scenes()).unwrap();
    let mut shown = Vec::new();
    simulate(
        &scene,
        None,
        |sample| {
            shown.push(sample.time);
            Ok(())
        },
        |_| {},
    )
    .unwrap();
    assert_eq!(reference.times.len(), shown.len());
    for (own, shown) in reference.times.iter().zip(&shown) {
        assert!((own - shown).abs() < 1e-12);
    }
    let variant = study.variant(&SceneModes::first(0), &Fidelity::Full).unwrap();
    let configuration = |scalar, step| Configuration {
        modes: SceneModes::first(0),
        fidelity: Fidelity::Full,
        scalar,
        integrator: Integrator::Rk4,
        step,
    };
    let measured =
        |scalar, step| match run(&study, &variant, &reference, &configuration(scalar, step)).finding {
            Finding::Finished(measured) => measured,
            Finding::Failed(reason) => panic!("{reason}"),
        };
    let (coarse, fine) = (measured(ScalarType::F64, 1e-2), measured(ScalarType::F64, 5e-3));
    assert_eq!((coarse.steps, fine.steps), (20, 40));
    // order 4: a factor of 16, less what is not asymptotic
    assert!(coarse.error() > 10.0 * fine.error(), "{} {}", coarse.error(), fine.error());
    assert!((coarse.operations_per_second() / fine.operations_per_second() - 0.5).abs() < 1e-12);
    // single precision has seven digits
    let single = measured(ScalarType::F32, 1e-3);
    assert!((1e-9..1e-3).contains(&single.error()), "{}", single.error());
}

#[test]
fn the_calls_of_the_macros_name_what_was_chosen() {
    let study = study("slider_crank.toml", 4e-3, 20.0);
    let fidelity = Fidelity::Linear;
    let (scalar, integrator) = (ScalarType::F32, Integrator::LinearlyImplicit);
    let text = study.macro_calls(
        "slider_crank",
        &Configuration { modes: SceneModes::first(2), fidelity, scalar, integrator, step: 1e-5 },
    );
    for part in [
        "pub struct Rod {",
        "modes: ..2,",
        "fidelity: linear,",
        "pub struct SliderCrank {",
        "rod: Rod,",
        "gravity: [0.0, 0.0, -9.81],",
        "small_end: spherical(rod.SMALL_END, piston),",
        "main_drive: angle(main, polynomial: [0.0, 100.0]),",
        "bearing: reaction_force(main),",
        "scalar: f32,",
        "linearly_implicit, steps of 1e-5 s",
    ] {
        assert!(text.contains(part), "`{part}` is not in\n{text}");
    }
}

/// Where the samples are closer together than the tolerance asks for, runs of any tolerance would take the same steps and differ by
/// nothing: the own error must be what the reference is off by all the same.
#[test]
fn a_reference_knows_its_error_where_samples_cut_its_steps() {
    let study = study("bricard.toml", 2.0, 40.0);
    let with = |tolerance| Reference::compute(&study, &[], ReferenceOptions { tolerance }).unwrap();
    let (rough, exact) = (with(1e-3), with(1e-11));
    let error = exact.errors(&rough.history).into_iter().fold(0.0, f64::max);
    eprintln!("{} steps, off by {error:.2e}, own error {:.2e}", rough.steps, rough.own_error());
    assert!(exact.own_error() < 1e-2 * error && error <= rough.own_error());
}

/// A scene with a list of modes: the body, its initial values and the calls of the macros are those of the list.
#[test]
fn modes_may_be_a_list() {
    let tiny = |mode: i32| 1e-12 * f64::from(mode);
    let mut file = SceneFile::read(&scenes().join("slider_crank.toml")).unwrap();
    file.bodies[1].1.modes = None;
    file.bodies[1].1.modal_coordinates = Some((0..8).map(tiny).collect());
    let study = Study::new(file, scenes()).unwrap();
    let all = study.variant(&study.all_modes(), &Fidelity::Full).unwrap();
    let some = SceneModes::from(Modes::listed(vec![5, 1]));
    let listed = study.variant(&some, &Fidelity::Full).unwrap();
    let stiffness = |variant: &Variant| variant.scene.mechanism.bodies()[1].stiffness().dense();
    let (few, many) = (stiffness(&listed), stiffness(&all));
    assert_eq!((few[(0, 0)], few[(1, 1)]), (many[(1, 1)], many[(5, 5)]));
    assert_eq!(few.nrows(), 2);
    let values = study.file_with(&some, &Fidelity::Full).bodies[1].1.modal_coordinates.clone();
    assert_eq!(values, Some(vec![tiny(1), tiny(5)]));
    assert!(listed.cost.operations < all.cost.operations);
    // a scene that has such a list itself
    let mut file = study.file_with(&some, &Fidelity::Full);
    file.bodies[1].1.fidelity = None;
    let own = Study::new(file, scenes()).unwrap();
    assert_eq!(own.most_modes(), 8);
    let widened = own.file_with(&SceneModes::first(6), &Fidelity::Full).bodies[1].1.modal_coordinates.clone();
    assert_eq!(widened, Some(vec![0.0, tiny(1), 0.0, 0.0, 0.0, tiny(5)]));
    let (fidelity, scalar, integrator) = (Fidelity::Full, ScalarType::F64, Integrator::Rk4);
    let one = Configuration { modes: some, fidelity, scalar, integrator, step: 1e-5 };
    let text = study.macro_calls("slider_crank", &one);
    assert!(text.contains("modes: [1, 5],"), "{text}");
}

/// Five modes of bending and torsion stand before the one along the rod, where the load of its bearing goes: the plan takes those
/// that take part, and is as exact as with more of the first ones.
#[test]
fn a_plan_takes_the_modes_that_take_part() {
    let study = study("slider_crank.toml", 4e-3, 20.0);
    let quantities = vec![Quantity::Sensor("bearing".to_owned())];
    let options = PlanOptions {
        quantities: quantities.clone(),
        integrators: vec![Integrator::Rk4],
        scalars: vec![ScalarType::F64],
        ..PlanOptions::usual(3e-2)
    };
    let found = plan(&study, &options).unwrap();
    let modes = &found.configuration.modes;
    eprintln!("{modes}: {:?}", found.models);
    assert!(modes.has("rod", 5) && modes.most() < 6, "{modes}");
    let tolerance = 0.1 * found.reference.tolerance;
    let reference = Reference::compute(&study, &quantities, ReferenceOptions { tolerance }).unwrap();
    let variant = study.variant(modes, &found.configuration.fidelity).unwrap();
    let outcome = run(&study, &variant, &reference, &found.configuration);
    let error = outcome.measured().unwrap().error();
    assert!(error <= OVER_BUDGET * options.error, "{error}");
    // the first so many are no better
    let first = study.variant(&SceneModes::first(modes.most()), &Fidelity::Full).unwrap();
    let one = Configuration {
        modes: SceneModes::first(modes.most()),
        fidelity: Fidelity::Full,
        ..found.configuration.clone()
    };
    let without = run(&study, &first, &reference, &one).measured().unwrap().error();
    assert!(without > options.error, "{without}");
}
