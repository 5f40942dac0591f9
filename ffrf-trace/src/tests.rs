//! What is written down, and what is not.

use ffrf_codegen::expression::{Symbol, evaluate};
use nalgebra::{Cholesky, ComplexField, Matrix3, RealField, Vector3};

use crate::{Relation, Tape, Traced, record};

fn input(index: usize, value: f64) -> Traced {
    Traced::input(Symbol::Intermediate("x", index), value)
}

fn at(tape: &Tape, results: &[Traced], inputs: &[f64]) -> Vec<f64> {
    let results: Vec<_> = results.iter().map(|result| result.expression()).collect();
    evaluate(&tape.graph, &results, |symbol| match symbol {
        Symbol::Intermediate(_, index) => inputs[index],
        _ => f64::NAN,
    })
}

/// The solution of a system with a symmetric matrix, generic as the runtime is.
fn solve<T: RealField + Copy>([a, b, c, d]: [T; 4]) -> Vector3<T> {
    let two = T::one() + T::one();
    let matrix = Matrix3::new(a + two, b, c, b, a + two, d, c, d, a + two);
    match Cholesky::new(matrix) {
        Some(factors) => factors.solve(&Vector3::new(a, T::one(), d)),
        None => Vector3::zeros(),
    }
}

#[test]
fn a_factorisation_is_written_down_to_the_bit() {
    let (solution, tape) =
        record(|| solve([1.0, 0.5, 0.25, 0.125].map(|value| input((8.0 * value) as usize, value))));
    assert!(tape.missing.is_empty());
    let mut inputs = [f64::NAN; 9];
    let others = [0.75, -0.5, 0.3, 0.2];
    for (place, value) in [8, 4, 2, 1].into_iter().zip(others) {
        inputs[place] = value;
    }
    assert_eq!(at(&tape, solution.as_slice(), &inputs), solve(others).as_slice());
    // each pivot was asked whether it is positive
    assert!(
        tape.conditions.iter().filter(|condition| condition.relation == Relation::GreaterOrEqual).count()
            >= 3
    );
}

#[test]
fn what_is_known_leaves_nothing() {
    let (sum, tape) = record(|| {
        let (x, zero, one) = (input(0, 3.0), Traced::number(0.0), Traced::number(1.0));
        assert!(one > zero);
        x * zero + (one * x - zero) + one.sin() * zero
    });
    assert_eq!(sum.value(), 3.0);
    assert!(tape.conditions.is_empty());
    assert_eq!(at(&tape, &[sum], &[5.0]), [5.0]);
    assert_eq!(
        tape.graph.node(sum.expression()),
        ffrf_codegen::expression::Node::Symbol(Symbol::Intermediate("x", 0))
    );
}

#[test]
fn the_relation_that_came_out_is_the_condition() {
    let (_, tape) = record(|| {
        let (x, y) = (input(0, 1.0), input(1, 2.0));
        [x < y, x <= y, x > y, x >= y, x == y, x.max(y) == y]
    });
    let relations: Vec<Relation> = tape.conditions.iter().map(|condition| condition.relation).collect();
    // each once; what is compared with itself is none
    assert_eq!(relations, [Relation::Less, Relation::LessOrEqual, Relation::NotEqual]);
    assert!(relations.iter().all(|relation| relation.holds(1.0, 2.0)));
    assert!(relations.iter().all(|relation| !relation.holds(2.0, 2.0) || *relation == Relation::LessOrEqual));
}

#[test]
fn functions_without_a_node_are_named_once() {
    let (angle, tape) = record(|| {
        let x = input(0, 0.5);
        let number = Traced::number(0.5).cos();
        assert_eq!(number.value(), 0.5_f64.cos());
        x.sin() * x.exp() + x.exp()
    });
    assert_eq!(tape.missing, ["exp"]);
    assert_eq!(tape.calls.len(), 1, "the sine of an input is an input");
    assert!(angle.value().is_nan());
}

#[test]
fn an_input_is_no_plain_number() {
    let ((open, known), _) = record(|| {
        (
            nalgebra::try_convert::<Traced, f64>(input(0, 2.0)),
            nalgebra::try_convert::<Traced, f64>(Traced::number(2.0)),
        )
    });
    assert_eq!((open, known), (None, Some(2.0)));
}
