//! The time step of a mechanism in C.

use crate::emit;
use crate::generate::prepare_c;
use crate::mechanism::{
    AttachmentModel, BodyKind, FlexibleModel, JointTopology, MechanismModel, MechanismPlan, RelationModel,
    Topology,
};
use crate::prepare::check_name;
use crate::{CodegenError, GenerateOptions, ScalarType, Strategy};

/// The time step of a mechanism in C.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GeneratedMechanismC {
    /// The header.
    pub header: String,
    /// The source; it includes the header as `PREFIX.h`.
    pub source: String,
    /// Header and source in one text.
    pub single: String,
    /// What every name that other files see begins with, in lower case: the name of the options in snake case.
    pub prefix: String,
}

/// Generates the time step of a mechanism as C99: the kernels of its flexible bodies, tables of its places, and the solver.
///
/// Of the options, name, scalar type and layout tolerance are used; bodies have the modes and terms of the mechanism. The
/// same mechanism gives the same text, to the byte. Errors: see [`CodegenError`]. Panics: never.
pub fn generate_mechanism_c(
    mechanism: &MechanismModel,
    options: &GenerateOptions,
) -> Result<GeneratedMechanismC, CodegenError> {
    if options.scalar == ScalarType::Generic {
        return Err(CodegenError::NotInC { option: "scalar", found: "generic", expected: "f64 or f32" });
    }
    check_name(&options.name)?;
    let names = emit::CNames::of(&options.name, mechanism)?;
    let (kernels, kernel_of) = kernels(mechanism, &names, options)?;
    let joints = joints(mechanism);
    let soft = soft_links(mechanism);
    let plan = MechanismPlan::new(&joints.with_soft_links(soft.iter().map(|(_, link)| *link)))?;
    let soft: Vec<usize> = soft.into_iter().map(|(element, _)| element).collect();
    // redundant rows need loops, which a drive beside its joint does not close
    let undriven = mechanism.joints.iter().zip(&joints.joints).filter(|(joint, _)| joint.drive.is_none());
    let undriven =
        Topology { flexible: joints.flexible.clone(), joints: undriven.map(|(_, shape)| *shape).collect() };
    let [header, source, single] = emit::c_mechanism(&emit::CMechanism {
        model: mechanism,
        options,
        names: &names,
        plan: &plan,
        soft: &soft,
        has_loops: undriven.has_loops(),
        kernels: &kernels,
        kernel_of: &kernel_of,
    })?;
    Ok(GeneratedMechanismC { header, source, single, prefix: names.prefix })
}

/// The kernels of the flexible bodies, one for equal bodies, and what stands before the name of each body's.
fn kernels(
    mechanism: &MechanismModel,
    names: &emit::CNames,
    options: &GenerateOptions,
) -> Result<(String, Vec<String>), CodegenError> {
    let mut printed: Vec<(&FlexibleModel, String)> = Vec::new();
    let (mut text, mut kernel_of) = (String::new(), Vec::with_capacity(mechanism.bodies.len()));
    for (body, name) in mechanism.bodies.iter().zip(&names.bodies) {
        let BodyKind::Flexible(flexible) = &body.kind else {
            kernel_of.push(String::new());
            continue;
        };
        let same =
            |known: &FlexibleModel| known.model == flexible.model && known.fidelity == flexible.fidelity;
        if let Some((_, prefix)) = printed.iter().find(|(known, _)| same(known)) {
            kernel_of.push(prefix.clone());
            continue;
        }
        let prefix = format!("body_{name}");
        let options = GenerateOptions {
            name: prefix.clone(),
            modes: None,
            fidelity: flexible.fidelity.clone(),
            strategy: Strategy::StraightLine,
            ..options.clone()
        };
        text.push_str(&prepare_c(&flexible.model, &options)?);
        printed.push((flexible, prefix.clone()));
        kernel_of.push(prefix);
    }
    Ok((text, kernel_of))
}

fn body(mechanism: &MechanismModel, end: &AttachmentModel) -> Option<usize> {
    end.marker.and_then(|marker| mechanism.markers.get(marker)).map(|marker| marker.body)
}

/// Bodies with joints and drives. The solver in C has whole blocks: what holds a point has no zeros there.
fn joints(mechanism: &MechanismModel) -> Topology {
    let joints = mechanism.joints.iter().map(|joint| JointTopology {
        rows: joint.relations.iter().map(RelationModel::rows).sum(),
        holds_point: false,
        ends: joint.ends.each_ref().map(|end| body(mechanism, end)),
    });
    Topology {
        flexible: mechanism.bodies.iter().map(|body| body.kind.mode_count() > 0).collect(),
        joints: joints.collect(),
    }
}

/// The elements between two things that move relative to each other, which implicit steps take into their matrix.
fn soft_links(mechanism: &MechanismModel) -> Vec<(usize, JointTopology)> {
    let elements = mechanism.elements.iter().enumerate().filter(|_| mechanism.method.is_implicit());
    let soft = elements.filter_map(|(index, element)| {
        let ends = element.ends.each_ref().map(|end| body(mechanism, end));
        let rows = element.kind.soft_rows()?;
        (ends[0] != ends[1]).then_some((index, JointTopology { rows, holds_point: false, ends }))
    });
    soft.collect()
}
