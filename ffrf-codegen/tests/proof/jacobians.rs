//! Analytic Jacobians against dual numbers, and that of the residual against the mass matrix.

use ffrf_codegen::body::BodyExpressions;
use ffrf_codegen::expression::{Expression, Graph, Input, Symbol, evaluate};
use ffrf_codegen::formulate::{Draft, Jacobian, Variable};
use ffrf_codegen::invariants::Invariant;
use ffrf_codegen::layout::{Layout, Structure};

use crate::tolerances::SOLVED;
use ffrf_test_kit::proof::dual::Dual;
use ffrf_test_kit::proof::sample::value;

/// Largest difference between the columns of a Jacobian and dual numbers, relative to the largest entry.
fn error(graph: &Graph, jacobian: &Jacobian, mode_count: usize, seed: u64) -> f64 {
    let mut worst: f64 = 0.0;
    for variable in Variable::ALL {
        let columns = jacobian.columns(variable);
        let symbols = variable.symbols(mode_count);
        assert_eq!(columns.len(), symbols.len());
        for (column, direction) in columns.iter().zip(symbols) {
            let found = evaluate(graph, column, |symbol| value(symbol, seed));
            let duals = evaluate(graph, &jacobian.value, |symbol| Dual {
                value: value(symbol, seed),
                slope: if symbol == direction { 1.0 } else { 0.0 },
            });
            let scale = duals.iter().map(|dual| dual.slope.abs()).fold(1e-3, f64::max);
            for (found, dual) in found.iter().zip(&duals) {
                assert!(found.is_finite());
                worst = worst.max((found - dual.slope).abs() / scale);
            }
        }
    }
    worst
}

fn layouts() -> [Layout; 5] {
    [
        Layout::GENERAL,
        Layout::GENERAL.with(Invariant::ModalMass, Structure::Identity),
        Layout::GENERAL.with(Invariant::ModalMass, Structure::Diagonal),
        Layout::FREE_FREE,
        Layout::GENERAL.stiffened(),
    ]
}

#[test]
fn jacobians_of_the_accelerations_agree_with_dual_numbers() {
    for mode_count in 0..6 {
        for layout in layouts() {
            let mut graph = Draft::default();
            let body = BodyExpressions::symbolic(&mut graph, mode_count, &layout);
            let jacobian = Jacobian::of_accelerations(&mut graph, &body).unwrap();
            for seed in 0..3 {
                let error = error(&graph, &jacobian, mode_count, seed);
                assert!(error < SOLVED, "M = {mode_count}, {layout}: {error:e}");
            }
        }
    }
}

#[test]
fn jacobians_of_the_residual_agree_with_dual_numbers() {
    for mode_count in 0..6 {
        for layout in layouts() {
            let mut graph = Draft::default();
            let body = BodyExpressions::symbolic(&mut graph, mode_count, &layout);
            let jacobian = Jacobian::of_residual(&mut graph, &body);
            for seed in 0..3 {
                let error = error(&graph, &jacobian, mode_count, seed);
                assert!(error < SOLVED, "M = {mode_count}, {layout}: {error:e}");
            }
        }
    }
}

#[test]
fn nothing_depends_on_the_velocity_of_the_origin() {
    let mut graph = Draft::default();
    let body = BodyExpressions::symbolic(&mut graph, 3, &Layout::GENERAL.stiffened());
    let jacobian = Jacobian::of_accelerations(&mut graph, &body).unwrap();
    let zero = graph.zero();
    assert!(jacobian.velocity.concat().iter().all(|entry| *entry == zero));
}

/// Operations of the Jacobians, against those of the accelerations alone.
#[test]
fn the_implicit_function_theorem_keeps_the_cost_near_that_of_the_columns() {
    for mode_count in [1, 2, 4, 8, 16] {
        let layout = Layout::GENERAL.with(Invariant::ModalMass, Structure::Identity);
        let mut graph = Draft::default();
        let body = BodyExpressions::symbolic(&mut graph, mode_count, &layout);
        let jacobian = Jacobian::of_accelerations(&mut graph, &body).unwrap();
        let without_force: Vec<Expression> = [
            jacobian.value.clone(),
            jacobian.coordinates.concat(),
            jacobian.rates.concat(),
            jacobian.angular_velocity.concat(),
        ]
        .concat();
        let (alone, all) = (operations(&graph, &jacobian.value), operations(&graph, &without_force));
        let direct: Vec<Expression> = [Variable::Coordinates, Variable::Rates, Variable::AngularVelocity]
            .into_iter()
            .flat_map(|variable| variable.symbols(mode_count))
            .flat_map(|symbol| ffrf_codegen::expression::differentiate(&mut graph, &jacobian.value, symbol))
            .collect();
        let direct = operations(&graph, &direct);
        eprintln!(
            "M = {mode_count}: accelerations {alone}, with Jacobians {all}, by direct differentiation {direct}"
        );
        assert!(all < direct, "M = {mode_count}");
    }
}

fn operations(graph: &Graph, outputs: &[Expression]) -> usize {
    let needed = graph.reachable(outputs);
    graph
        .nodes()
        .take(needed.len())
        .filter(|(handle, node)| needed[handle.index()] && node.is_operation())
        .count()
}

/// The residual is linear in w with the mass matrix as its slope, and in the force with minus one.
#[test]
fn the_residual_is_what_its_name_says() {
    let mode_count = 2;
    let mut graph = Draft::default();
    let body = BodyExpressions::symbolic(&mut graph, mode_count, &Layout::GENERAL);
    let jacobian = Jacobian::of_residual(&mut graph, &body);
    let accelerations = Jacobian::of_accelerations(&mut graph, &body).unwrap();
    let w = evaluate(&graph, &accelerations.value, |symbol| value(symbol, 7));
    let rest = evaluate(&graph, &jacobian.value, |symbol| match symbol {
        Symbol::Input(Input::ACCELERATION, row) => w[row],
        other => value(other, 7),
    });
    assert!(rest.iter().all(|entry| entry.abs() < SOLVED), "{rest:?}");
    for (index, column) in jacobian.force.iter().enumerate() {
        for (row, entry) in column.iter().enumerate() {
            let expected = if row == index { -1.0 } else { 0.0 };
            assert_eq!(graph.constant_value(*entry), Some(expected));
        }
    }
}
