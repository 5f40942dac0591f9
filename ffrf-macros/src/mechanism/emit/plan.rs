//! Where everything stands, as constants.

use ffrf_codegen::mechanism::{BlockPlace, MechanismPlan};
use proc_macro2::TokenStream;
use quote::quote;

/// The constants of a plan, and the plan made of them as an expression.
pub(super) fn plan(plan: &MechanismPlan) -> (TokenStream, TokenStream) {
    let block = |block: &BlockPlace| {
        let BlockPlace { start, columns, transposed } = block;
        quote! { places::Block { start: #start, columns: #columns, transposed: #transposed } }
    };
    let steps = plan.steps.iter().map(|step| {
        let (size, unknowns, diagonal) = (step.size, step.unknowns, step.diagonal);
        let (couplings, targets) = (step.couplings, step.targets);
        quote! {
            places::Step {
                size: #size, unknowns: #unknowns, diagonal: #diagonal,
                couplings: #couplings, targets: #targets,
            }
        }
    });
    let couplings = plan.couplings.iter().map(|coupling| {
        let (size, unknowns) = (coupling.size, coupling.unknowns);
        quote! { places::Coupling { size: #size, unknowns: #unknowns } }
    });
    let targets = &plan.targets;
    let bodies = plan.bodies.iter().map(|body| {
        let (unknowns, diagonal) = (body.unknowns, body.diagonal);
        quote! { places::BodyPlace { unknowns: #unknowns, diagonal: #diagonal } }
    });
    let joints = plan.joints.iter().map(|joint| {
        let (rows, unknowns, diagonal) = (joint.rows, joint.unknowns, joint.diagonal);
        let ends = joint.ends.iter().map(|end| match end {
            None => quote! { ::core::option::Option::None },
            Some(end) => {
                let (body, slot, block) = (end.body, end.slot, block(&end.block));
                quote! { ::core::option::Option::Some(places::EndPlace { body: #body, slot: #slot, block: #block }) }
            }
        });
        quote! {
            places::JointPlace { rows: #rows, unknowns: #unknowns, diagonal: #diagonal, ends: [#(#ends),*] }
        }
    });
    let shared = plan.shared.iter().map(|shared| {
        let (body, block) = (shared.body, block(&shared.block));
        let ((first, rows), (second, other_rows)) = (shared.first, shared.second);
        quote! {
            places::SharedPlace {
                body: #body, first: (#first, #rows), second: (#second, #other_rows), block: #block,
            }
        }
    });
    let (step_count, coupling_count, target_count) =
        (plan.steps.len(), plan.couplings.len(), plan.targets.len());
    let (body_count, joint_count, shared_count) = (plan.bodies.len(), plan.joints.len(), plan.shared.len());
    let constants = quote! {
        // by its path: a mechanism may have any of these names
        use ::ffrf::mechanism as places;
        static STEPS: [places::Step; #step_count] = [#(#steps),*];
        static COUPLINGS: [places::Coupling; #coupling_count] = [#(#couplings),*];
        static TARGETS: [usize; #target_count] = [#(#targets),*];
        static BODIES: [places::BodyPlace; #body_count] = [#(#bodies),*];
        static JOINTS: [places::JointPlace; #joint_count] = [#(#joints),*];
        static SHARED: [places::SharedPlace; #shared_count] = [#(#shared),*];
    };
    let expression = quote! {
        places::Plan {
            elimination: places::Elimination { steps: &STEPS, couplings: &COUPLINGS, targets: &TARGETS },
            bodies: &BODIES,
            joints: &JOINTS,
            shared: &SHARED,
        }
    };
    (constants, expression)
}
