//! Where everything stands, as constants.

use ffrf_codegen::mechanism::{BlockPlace, Hub, JointPlace, MechanismPlan};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::mechanism::spec::{Plans, Spec};

/// The layout of a mechanism, in code.
pub(super) struct Layout {
    /// The constants.
    pub(super) constants: TokenStream,
    /// The plan made of them, as an expression.
    pub(super) plan: TokenStream,
    /// Its number of blocks, as a constant expression.
    pub(super) blocks: TokenStream,
    /// Its number of nodes.
    pub(super) nodes: TokenStream,
}

/// How many modes the hubs have, and whether they keep them.
pub(super) fn hubs(spec: &Spec) -> TokenStream {
    if spec.hubs.is_empty() {
        return TokenStream::new();
    }
    let modes = spec.hubs.iter().filter_map(|hub| {
        let body =
            spec.bodies.iter().find(|body| (body.first..body.first + body.len()).contains(&hub.body))?;
        Some(body.mode_count(spec.scalar))
    });
    let count = spec.hubs.len();
    let keeps = if spec.hubs.iter().any(Hub::always_keeps) {
        quote! { true }
    } else {
        let rows = spec.hubs.iter().map(|hub| hub.rows);
        quote! { places::keeps_modes(&[#(#rows),*], &MODES_OF_HUBS) }
    };
    quote! {
        const MODES_OF_HUBS: [usize; #count] = [#(#modes),*];
        /// Whether the modes of these bodies are unknowns of their own.
        const KEEPS_MODES: bool = #keeps;
    }
}

/// The layout of one mechanism; `prefix`: what the names of its constants begin with.
pub(super) fn layout(plans: &Plans, prefix: &str) -> Layout {
    let eliminated = plans.eliminated.as_ref().map(|found| {
        let (blocks, nodes) = (found.block_count, found.node_count);
        let (constants, plan) = plan(found, prefix, &quote! { static });
        Layout { constants, plan, blocks: quote! { #blocks }, nodes: quote! { #nodes } }
    });
    let kept = plans.kept.as_ref().map(|found| expanded(found, &format!("{prefix}KEPT_")));
    match (eliminated, kept) {
        (Some(only), None) | (None, Some(only)) => only,
        (Some(eliminated), Some(kept)) => {
            let either = |kept: &TokenStream, eliminated: &TokenStream| {
                quote! { if KEEPS_MODES { #kept } else { #eliminated } }
            };
            let (blocks, nodes) =
                (either(&kept.blocks, &eliminated.blocks), either(&kept.nodes, &eliminated.nodes));
            Layout {
                plan: either(&kept.plan, &eliminated.plan),
                blocks: quote! { { #blocks } },
                nodes: quote! { { #nodes } },
                constants: eliminated.constants.into_iter().chain(kept.constants).collect(),
            }
        }
        // there is one of them
        (None, None) => Layout {
            constants: TokenStream::new(),
            plan: TokenStream::new(),
            blocks: quote! { 0 },
            nodes: quote! { 0 },
        },
    }
}

/// A layout with as many nodes as the kept modes need.
fn expanded(kept: &MechanismPlan, prefix: &str) -> Layout {
    let named = |name: &str| format_ident!("{prefix}{name}");
    let [unexpanded, sizes, expanded] = ["UNEXPANDED", "SIZES", "PLAN"].map(named);
    let (mut constants, plan) = plan(kept, prefix, &quote! { const });
    let (bodies, joints, shared) = (kept.bodies.len(), kept.joints.len(), kept.shared.len());
    constants.extend(quote! {
        #[allow(long_running_const_eval)]
        const #unexpanded: places::Unexpanded<'static> = places::Unexpanded { plan: #plan, modes: &MODES_OF_HUBS };
        #[allow(long_running_const_eval)]
        const #sizes: places::PlanSizes = #unexpanded.sizes();
        #[allow(long_running_const_eval)]
        static #expanded: places::FixedPlan<
            { #sizes.nodes },
            { #sizes.couplings },
            { #sizes.targets },
            #bodies,
            #joints,
            #shared,
            { #sizes.modes },
            { #sizes.modal_ends },
            { #sizes.modal_pairs },
        > = places::FixedPlan::expand(&#unexpanded);
    });
    Layout {
        constants,
        plan: quote! { #expanded.view() },
        blocks: quote! { { #sizes.blocks } },
        nodes: quote! { { #sizes.nodes } },
    }
}

/// The constants of a plan, and the plan made of them as an expression. `prefix`: what their names begin with.
fn plan(plan: &MechanismPlan, prefix: &str, keyword: &TokenStream) -> (TokenStream, TokenStream) {
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
        let (size, node, holds_point) = (coupling.size, coupling.node, coupling.holds_point);
        quote! { places::Coupling { size: #size, node: #node, holds_point: #holds_point } }
    });
    let targets = &plan.targets;
    let bodies = plan.bodies.iter().map(|body| {
        let (node, diagonal) = (body.node, body.diagonal);
        quote! { places::BodyPlace { node: #node, diagonal: #diagonal } }
    });
    let joints = plan.joints.iter().map(|joint| {
        let JointPlace { rows, node, diagonal, is_support, .. } = joint;
        let ends = joint.ends.iter().map(|end| match end {
            None => quote! { ::core::option::Option::None },
            Some(end) => {
                let (body, slot, block) = (end.body, end.slot, block(&end.block));
                quote! { ::core::option::Option::Some(places::EndPlace { body: #body, slot: #slot, block: #block }) }
            }
        });
        quote! {
            places::JointPlace {
                rows: #rows, node: #node, diagonal: #diagonal, is_support: #is_support, ends: [#(#ends),*],
            }
        }
    });
    let shared = plan.shared.iter().map(|shared| {
        let (body, block) = (shared.body, block(&shared.block));
        let (first, second) = (shared.first, shared.second);
        quote! { places::SharedPlace { body: #body, first: #first, second: #second, block: #block } }
    });
    let modes = plan.modes.iter().map(|modes| {
        let (body, node, diagonal, frame) = (modes.body, modes.node, modes.diagonal, block(&modes.frame));
        quote! {
            places::ModesPlace { body: #body, first: 0, node: #node, diagonal: #diagonal, frame: #frame }
        }
    });
    let modal_ends = plan.modal_ends.iter().map(|end| {
        let (body, slot, block) = (end.body, end.slot, block(&end.block));
        quote! { places::ModalEndPlace { body: #body, slot: #slot, first: 0, block: #block } }
    });
    // most mechanisms have none
    let (all_modes, all_modal_ends) = (quote! { [#(#modes),*] }, quote! { [#(#modal_ends),*] });
    let (step_count, coupling_count, target_count) =
        (plan.steps.len(), plan.couplings.len(), plan.targets.len());
    let leading = plan.leading;
    let (body_count, joint_count, shared_count) = (plan.bodies.len(), plan.joints.len(), plan.shared.len());
    let constants = quote! {
        #keyword #all_steps: [places::Step; #step_count] = [#(#steps),*];
        #keyword #all_couplings: [places::Coupling; #coupling_count] = [#(#couplings),*];
        #keyword #all_targets: [usize; #target_count] = [#(#targets),*];
        #keyword #all_bodies: [places::BodyPlace; #body_count] = [#(#bodies),*];
        #keyword #all_joints: [places::JointPlace; #joint_count] = [#(#joints),*];
        #keyword #all_shared: [places::SharedPlace; #shared_count] = [#(#shared),*];
    };
    let expression = quote! {
        places::Plan {
            elimination: places::Elimination {
                steps: &#all_steps, leading: #leading, couplings: &#all_couplings, targets: &#all_targets,
                of_instant: true,
            },
            bodies: &#all_bodies,
            joints: &#all_joints,
            shared: &#all_shared,
            modes: &#all_modes,
            modal_ends: &#all_modal_ends,
            modal_pairs: &[],
            branches: &[],
        }
    };
    (constants, expression)
}
