//! The passes between formulation and emission keep every kernel the same polynomial.

use ffrf_codegen::FusedMultiplyAdd;
use ffrf_codegen::body::BodyExpressions;
use ffrf_codegen::expression::Graph;
use ffrf_codegen::formulate::{Kernel, KernelKind};
use ffrf_codegen::layout::Layout;
use ffrf_codegen::passes;
use ffrf_codegen::polynomial::polynomials_of;

/// Every kernel without a division.
const POLYNOMIAL: [KernelKind; 8] = [
    KernelKind::MassMatrix,
    KernelKind::QuadraticVelocity,
    KernelKind::KineticEnergy,
    KernelKind::ElasticEnergy,
    KernelKind::LinearMomentum,
    KernelKind::AngularMomentum,
    KernelKind::InternalForce,
    KernelKind::GravityForce,
];

#[test]
fn passes_keep_the_polynomials() {
    let mut changed = 0;
    for mode_count in 0..5 {
        for layout in [Layout::GENERAL, Layout::FREE_FREE] {
            for kind in POLYNOMIAL {
                let mut graph = Graph::new();
                let body = BodyExpressions::symbolic(&mut graph, mode_count, &layout);
                let kernel = Kernel::formulate(kind, graph, &body).unwrap();
                let before = polynomials_of(&kernel.graph, &kernel.outputs).unwrap();
                for fused in [FusedMultiplyAdd::Off, FusedMultiplyAdd::On] {
                    let result = passes::run(kernel.clone(), fused);
                    let after = polynomials_of(&result.graph, &result.outputs).unwrap();
                    assert_eq!(before, after, "M = {mode_count}, {}, {layout}, {fused:?}", kind.name());
                    changed += usize::from(result.graph.len() != kernel.graph.len());
                }
            }
        }
    }
    assert!(changed > 0, "no pass did anything");
}
