//! Where everything stands in the equations, and what joints hold.

use std::fmt::Write as _;

use super::Numbers;
use super::numbers::{attachment, integers, table};
use crate::emit::c::mechanism::MechanismSubject;
use crate::emit::c::text::{braced, harmless};
use crate::mechanism::{AttachmentModel, EndPlace, JointModel, RelationModel};

fn axes(held: [bool; 3]) -> usize {
    held.iter().enumerate().map(|(axis, held)| usize::from(*held) << axis).sum()
}

/// The order of elimination, the links and what couples them.
pub(super) fn places(subject: &MechanismSubject<'_>, numbers: &Numbers) -> String {
    let (model, plan) = (subject.model, subject.plan);
    let ends = plan.couplings.len();
    let next = plan.steps.iter().skip(1).map(|step| step.couplings).chain([ends]);
    let steps: Vec<String> = plan
        .steps
        .iter()
        .zip(next)
        .map(|(step, end)| {
            let list =
                [step.size, step.node, step.diagonal, step.couplings, end - step.couplings, step.targets];
            braced(&integers(&list))
        })
        .collect();
    let couplings: Vec<String> =
        plan.couplings.iter().map(|coupling| braced(&integers(&[coupling.size, coupling.node]))).collect();
    let or_none = |list: Vec<String>, none: &str| if list.is_empty() { vec![none.to_owned()] } else { list };
    let mut text = table("step_place", "steps", &steps);
    text.push_str(&table("coupling_place", "couplings", &or_none(couplings, "{0, 0}")));
    let targets = or_none(integers(&plan.targets), "0");
    let _ = writeln!(text, "static const int targets[{}] = {};\n", targets.len(), braced(&targets));
    let diagonals: Vec<usize> = plan.bodies.iter().map(|body| body.diagonal).collect();
    let _ = writeln!(text, "static const int body_diagonals[BODIES] = {};\n", braced(&integers(&diagonals)));
    // ends of all bodies one after the other
    let mut offsets = vec![0; plan.attached_ends.len()];
    for body in 1..offsets.len() {
        offsets[body] = offsets[body - 1] + plan.attached_ends[body - 1];
    }
    let number = |body: usize, slot: usize| offsets.get(body).map_or(0, |offset| offset + slot);
    let (mut relations, mut coefficients, mut links) = (vec![], vec![], vec![]);
    for (index, place) in plan.joints.iter().enumerate() {
        let joint = model.joints.get(index);
        let held: &[RelationModel] = joint.map_or(&[], |joint| &joint.relations);
        let drive: &[f64] = joint.and_then(|joint| joint.drive.as_deref()).unwrap_or(&[]);
        let ends = place.ends.map(|end| match end {
            Some(EndPlace { body, slot, block }) => {
                format!("{{{}, {}, {}}}", number(body, slot), block.index, u8::from(block.transposed))
            }
            None => "{-1, 0, 0}".to_owned(),
        });
        let at = ends_of(subject, index);
        links.push(format!(
            "/* {} */\n{{{}, {}, {}, {{{}, {}}},\n {{{},\n  {}}},\n {}, {}, {}, {}}}",
            harmless(joint.map_or("a soft link", |joint| joint.name.as_str())),
            place.rows,
            place.node,
            place.diagonal,
            ends[0],
            ends[1],
            attachment(&at[0], numbers),
            attachment(&at[1], numbers),
            relations.len(),
            held.len(),
            coefficients.len(),
            drive.len()
        ));
        relations.extend(held.iter().map(|relation| {
            let (kind, held, length) = match relation {
                RelationModel::Coincident => ("COINCIDENT", 7, 0.0),
                RelationModel::InPlane(held) => ("IN_PLANE", axes(*held), 0.0),
                RelationModel::Perpendicular(held) => ("PERPENDICULAR", axes(*held), 0.0),
                RelationModel::Aligned(held) => ("ALIGNED", axes(*held), 0.0),
                RelationModel::Distance(length) => ("DISTANCE", 0, *length),
                RelationModel::Angle => ("ANGLE", 0, 0.0),
            };
            format!("{{{kind}, {held}, {}}}", numbers.one(length))
        }));
        coefficients.extend_from_slice(drive);
    }
    let nowhere = format!(
        "{{0, 0, 0, {{{{-1, 0, 0}}, {{-1, 0, 0}}}}, {{{n}, {n}}}, 0, 0, 0, 0}}",
        n = "{-1, {0}, {0}}"
    );
    text.push_str(&table("relation", "relations", &or_none(relations, "{0, 0, 0}")));
    if !coefficients.is_empty() {
        let _ = writeln!(
            text,
            "static const real coefficients[{}] = {};\n",
            coefficients.len(),
            numbers.list(&coefficients)
        );
    }
    text.push_str(&table("link_place", "links", &or_none(links, &nowhere)));
    let mut end_modes = Vec::new();
    for (body, count) in model.bodies.iter().zip(&plan.attached_ends) {
        end_modes.extend(std::iter::repeat_n(body.kind.mode_count(), *count));
    }
    if subject.modes() > 0 {
        let list = or_none(integers(&end_modes), "0");
        let _ = writeln!(text, "static const int end_modes[ENDS] = {};\n", braced(&list));
    }
    let rows_at = |body: usize, slot: usize| {
        let is_there = |end: &EndPlace| end.body == body && end.slot == slot;
        let joint = plan.joints.iter().find(|joint| joint.ends.iter().flatten().any(is_there));
        joint.map_or(0, |joint| joint.rows)
    };
    let shared: Vec<String> = plan
        .shared
        .iter()
        .map(|place| {
            let (rows, columns) = match place.block.transposed {
                true => (place.first, place.second),
                false => (place.second, place.first),
            };
            braced(&integers(&[
                number(place.body, rows),
                rows_at(place.body, rows),
                number(place.body, columns),
                rows_at(place.body, columns),
                place.block.index,
            ]))
        })
        .collect();
    text.push_str(&table("shared_place", "shared", &shared));
    text
}

/// What a link connects: a joint, or behind those a soft element.
fn ends_of(subject: &MechanismSubject<'_>, link: usize) -> [AttachmentModel; 2] {
    let (joints, elements) = (&subject.model.joints, &subject.model.elements);
    match joints.get(link) {
        Some(JointModel { ends, .. }) => *ends,
        None => {
            let soft = link.checked_sub(joints.len()).and_then(|soft| subject.soft.get(soft));
            soft.and_then(|element| elements.get(*element))
                .map_or([AttachmentModel::GROUND; 2], |element| element.ends)
        }
    }
}
