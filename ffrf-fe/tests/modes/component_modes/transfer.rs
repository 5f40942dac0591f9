//! Interface transfer functions against the full model.

use ffrf_fe::component_modes::{
    ComponentBasis, ComponentRequest, reduce_component_modes, transfer_functions,
};
use ffrf_fe::reduction::ReductionOptions;

use super::dense::{Dense, deviation};
use super::free_body::receptance;
use super::parts::{bar, compute, mixed_ends, rigid_ends};
use super::tolerances::RESPONSE;

#[test]
fn craig_bampton_with_all_modes_is_the_full_model() {
    let model = bar();
    for interfaces in [rigid_ends(&model), mixed_ends(&model)] {
        let dense = Dense::new(&model, &interfaces);
        let all = dense.size() - 12;
        let modes = compute(&model, &ComponentRequest::craig_bampton(interfaces, all));
        assert_eq!(modes.basis.modes.len(), dense.size() - 6);
        for hertz in [100.0, 2500.0, 20_000.0] {
            let body = modes.elastic_receptance(hertz);
            let full = dense.receptance(hertz);
            let rigid = rigid_receptance(&model, &modes.interfaces, hertz);
            let error = deviation(&full, &(body + rigid));
            assert!(error < RESPONSE, "{hertz} Hz: {error:e}");
        }
    }
}

/// -1/ω² B R (RᵀMR)⁻¹ RᵀBᵀ by the mass properties of a body without modes of interest.
fn rigid_receptance(
    model: &ffrf_fe::FeModel,
    interfaces: &[ffrf_fe::component_modes::Interface],
    hertz: f64,
) -> faer::Mat<f64> {
    let modes = compute(model, &ComponentRequest::craig_bampton(interfaces.to_vec(), 0));
    let body = reduce_component_modes(model, &modes, &ReductionOptions::default()).unwrap();
    receptance(&body, 2, hertz) - modes.elastic_receptance(hertz)
}

#[test]
fn the_sparse_response_of_the_full_model_is_that_of_dense_algebra() {
    let model = bar();
    let interfaces = mixed_ends(&model);
    let dense = Dense::new(&model, &interfaces);
    let modes = compute(&model, &ComponentRequest::craig_bampton(interfaces, dense.size() - 12));
    // With all modes the reduced model is the full one: the error is that of the sparse solution.
    for point in transfer_functions(&model, &modes, &[100.0, 2500.0, 20_000.0]).unwrap() {
        println!("{point:?}");
        assert!(point.error < RESPONSE, "{point:?}");
    }
}

#[test]
fn every_basis_converges_and_static_bases_are_exact_at_rest() {
    let model = bar();
    let frequencies = [1.0, 800.0, 3000.0];
    for basis in [
        ComponentBasis::CraigBampton,
        ComponentBasis::Attachment,
        ComponentBasis::Rubin,
        ComponentBasis::Herting,
    ] {
        let mut before = f64::INFINITY;
        for count in [2, 6, 20] {
            let request =
                ComponentRequest { basis, ..ComponentRequest::craig_bampton(mixed_ends(&model), count) };
            let modes = compute(&model, &request);
            let points = transfer_functions(&model, &modes, &frequencies).unwrap();
            println!("{basis}, {count}: {points:?}");
            let error = points[2].error;
            assert!(error < before, "{basis}: {error:e} with {count} modes, {before:e} with fewer");
            before = error;
            if matches!(basis, ComponentBasis::Attachment | ComponentBasis::Rubin) {
                assert!(points[0].error < 1e-5, "{basis} at rest: {:e}", points[0].error);
                assert!((modes.report.compliance_kept - 1.0).abs() < 1e-6);
            }
        }
        assert!(before < 0.02, "{basis}: {before:e} with 20 modes");
    }
}
