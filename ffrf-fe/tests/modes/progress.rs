//! Progress reports of a sparse solve come in order.

use ffrf_fe::elements::{Material, brick};
use ffrf_fe::modes::{Method, ModeRequest, Stage, compute_modes};

#[test]
fn progress_passes_all_stages_in_order_and_ends_with_the_count() {
    let model = brick([0.8, 0.2, 0.1], [12, 4, 3], &Material::STEEL).unwrap();
    let request = ModeRequest { method: Method::Sparse, ..ModeRequest::free_free(4) };
    let mut stages = Vec::new();
    compute_modes(&model, &request, &mut |progress| {
        assert!(progress.done <= progress.total, "{progress:?}");
        if stages.last() != Some(&progress.stage) {
            stages.push(progress.stage);
        }
    })
    .unwrap();
    assert_eq!(stages, [Stage::Ordering, Stage::Factorising, Stage::Iterating, Stage::Counting]);
}
