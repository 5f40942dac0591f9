//! Where everything stands, as constants.

use ffrf_codegen::mechanism::{BlockPlace, MechanismPlan};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The constants of a plan, and the plan made of them as an expression. `prefix`: what their names begin with.
pub(super) fn plan(plan: &MechanismPlan, prefix: &str) -> (TokenStream, TokenStream) {
    let named = |name: &str| format_ident!("{prefix}{name}");
    let [all_steps, all_couplings, all_targets] = ["STEPS", "COUPLINGS", "TARGETS"].map(named);
    let [all_bodies, all_joints, all_shared] = ["BODIES", "JOINTS", "SHARED"].map(named);
    let block = |block: &BlockPlace| {
        let BlockPlace { index, transposed } = block;
        quote! { places::Block { index: #index, transposed: #transposed } }
    };
    let steps = plan.steps.iter().map(|step| {
        let (size, node, diagonal) = (step.size, step.node, step.diagonal);
        let (is_diagonal, couplings, targets) = (step.is_diagonal, step.couplings, step.targets);
        quote! {
            places::Step {
                size: #size, node: #node, diagonal: #diagonal, is_diagonal: #is_diagonal,
                couplings: #couplings, targets: #targets,
            }
        }
    });
    let couplings = plan.couplings.iter().map(|coupling| {
        let (size, node) = (coupling.size, coupling.node);
        quote! { places::Coupling { size: #size, node: #node } }
    });
    let targets = &plan.targets;
    let bodies = plan.bodies.iter().map(|body| {
        let (node, diagonal) = (body.node, body.diagonal);
        quote! { places::BodyPlace { node: #node, diagonal: #diagonal } }
    });
    let joints = plan.joints.iter().map(|joint| {
        let (rows, node, diagonal) = (joint.rows, joint.node, joint.diagonal);
        let ends = joint.ends.iter().map(|end| match end {
            None => quote! { ::core::option::Option::None },
            Some(end) => {
                let (body, slot, block) = (end.body, end.slot, block(&end.block));
                quote! { ::core::option::Option::Some(places::EndPlace { body: #body, slot: #slot, block: #block }) }
            }
        });
        quote! {
            places::JointPlace { rows: #rows, node: #node, diagonal: #diagonal, ends: [#(#ends),*] }
        }
    });
    let shared = plan.shared.iter().map(|shared| {
        let (body, block) = (shared.body, block(&shared.block));
        let (first, second) = (shared.first, shared.second);
        quote! { places::SharedPlace { body: #body, first: #first, second: #second, block: #block } }
    });
    let (step_count, coupling_count, target_count) =
        (plan.steps.len(), plan.couplings.len(), plan.targets.len());
    let leading = plan.leading;
    let (body_count, joint_count, shared_count) = (plan.bodies.len(), plan.joints.len(), plan.shared.len());
    let constants = quote! {
        static #all_steps: [places::Step; #step_count] = [#(#steps),*];
        static #all_couplings: [places::Coupling; #coupling_count] = [#(#couplings),*];
        static #all_targets: [usize; #target_count] = [#(#targets),*];
        static #all_bodies: [places::BodyPlace; #body_count] = [#(#bodies),*];
        static #all_joints: [places::JointPlace; #joint_count] = [#(#joints),*];
        static #all_shared: [places::SharedPlace; #shared_count] = [#(#shared),*];
    };
    let expression = quote! {
        places::Plan {
            elimination: places::Elimination {
                steps: &#all_steps, leading: #leading, couplings: &#all_couplings, targets: &#all_targets,
            },
            bodies: &#all_bodies,
            joints: &#all_joints,
            shared: &#all_shared,
        }
    };
    (constants, expression)
}
