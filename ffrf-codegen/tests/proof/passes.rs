//! The passes between formulation and emission keep every kernel the same polynomial.

use ffrf_codegen::FusedMultiplyAdd;
use ffrf_codegen::body::BodyExpressions;
use ffrf_codegen::expression::Graph;
use ffrf_codegen::formulate::kernels::{
    ANGULAR_MOMENTUM, ELASTIC_ENERGY, GRAVITY_FORCE, INTERNAL_FORCE, KINETIC_ENERGY, LINEAR_MOMENTUM,
    MASS_MATRIX, QUADRATIC_VELOCITY,
};
use ffrf_codegen::formulate::{Definition, Kernel};
use ffrf_codegen::layout::Layout;
use ffrf_codegen::passes;
use ffrf_codegen::polynomial::polynomials_of;

/// Every kernel without a division.
static POLYNOMIAL: [&Definition; 8] = [
    &MASS_MATRIX,
    &QUADRATIC_VELOCITY,
    &KINETIC_ENERGY,
    &ELASTIC_ENERGY,
    &LINEAR_MOMENTUM,
    &ANGULAR_MOMENTUM,
    &INTERNAL_FORCE,
    &GRAVITY_FORCE,
];

#[test]
fn passes_keep_the_polynomials() {
    let mut changed = 0;
    for mode_count in 0..5 {
        for layout in [Layout::GENERAL, Layout::FREE_FREE, Layout::GENERAL.stiffened()] {
            for definition in POLYNOMIAL {
                let mut graph = Graph::new();
                let body = BodyExpressions::symbolic(&mut graph, mode_count, &layout);
                let kernel = Kernel::formulate(definition, graph, &body).unwrap();
                let before = polynomials_of(&kernel.graph, &kernel.outputs).unwrap();
                for fused in [FusedMultiplyAdd::Off, FusedMultiplyAdd::On] {
                    let result = passes::run(kernel.clone(), fused);
                    let after = polynomials_of(&result.graph, &result.outputs).unwrap();
                    assert_eq!(
                        before, after,
                        "M = {mode_count}, {}, {layout}, {fused:?}",
                        kernel.signature.name
                    );
                    changed += usize::from(result.graph.len() != kernel.graph.len());
                }
            }
        }
    }
    assert!(changed > 0, "no pass did anything");
}
