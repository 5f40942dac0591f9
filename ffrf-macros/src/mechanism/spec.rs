//! From what the user wrote to a mechanism that can be emitted; every mistake is reported.

use ffrf_codegen::mechanism::{BranchPlace, Hub, MechanismPlan, Topology, TopologyError};
use proc_macro2::TokenStream;
use quote::quote;
use syn::{Ident, Path};

use super::accelerations::{accelerations, check_known};
use super::bodies::{Body, GROUND, bodies};
use super::call::{Entry, entries};
use super::controls::{Control, controls};
use super::drives::{Drive, drive};
use super::forces::{Force, force};
use super::joints::{Joint, joint};
use super::scalar::Scalar;
use super::sensors::{Sensor, sensor};
use super::treatment::treatment;
use crate::parse::{Field, Input};
use crate::values::Mistakes;

/// A mechanism that can be emitted.
pub(super) struct Spec {
    pub(super) scalar: Scalar,
    pub(super) bodies: Vec<Body>,
    pub(super) gravity: TokenStream,
    pub(super) controls: Vec<Control>,
    /// How joints are kept, as an expression.
    pub(super) treatment: TokenStream,
    pub(super) joints: Vec<Joint>,
    pub(super) drives: Vec<Drive>,
    pub(super) forces: Vec<Force>,
    pub(super) sensors: Vec<Sensor>,
    /// A function that was printed for this mechanism and gives its accelerations, if there is one.
    pub(super) accelerations: Option<Path>,
    /// The same for linearly implicit stages.
    pub(super) implicit_accelerations: Option<Path>,
    /// One that projects it onto its joints.
    pub(super) projection: Option<Path>,
    /// The same after linearly implicit steps.
    pub(super) implicit_projection: Option<Path>,
    /// Rows of all joints and drives.
    pub(super) rows: usize,
    /// Number of joints, with drives.
    pub(super) connections: usize,
    /// Flexible bodies with many joints and soft links.
    pub(super) hubs: Vec<Hub>,
    pub(super) plan: Plans,
    /// The plans with soft rows and their number of links, if there are any.
    pub(super) soft: Option<(Plans, usize)>,
    pub(super) has_loops: bool,
    /// The bodies in the order of a sweep, if joints close no loop; else empty.
    pub(super) branches: Vec<BranchPlace>,
}

/// The layouts of one mechanism: how many modes its bodies have, which decides between them, the macro does not know.
pub(super) struct Plans {
    /// Every body eliminates its modes; not where a hub keeps them however many there are.
    pub(super) eliminated: Option<MechanismPlan>,
    /// The hubs keep their modes, if there are hubs.
    pub(super) kept: Option<MechanismPlan>,
}

impl Plans {
    fn new(topology: &Topology, hubs: &[Hub]) -> Result<Self, TopologyError> {
        let keeping: Vec<usize> = hubs.iter().map(|hub| hub.body).collect();
        let always = hubs.iter().any(Hub::always_keeps);
        let eliminated = if always { None } else { Some(MechanismPlan::new(topology)?) };
        let kept =
            if hubs.is_empty() { None } else { Some(MechanismPlan::keeping_modes(topology, &keeping)?) };
        Ok(Self { eliminated, kept })
    }

    /// Ends of joints on a body, the same in all layouts.
    pub(super) fn attached_ends(&self, body: usize) -> usize {
        let plan = self.eliminated.as_ref().or(self.kept.as_ref());
        plan.and_then(|plan| plan.attached_ends.get(body)).copied().unwrap_or(0)
    }
}

const KEYS: [&str; 13] = [
    "bodies",
    "gravity",
    "joints",
    "constraints",
    "controls",
    "drives",
    "forces",
    "sensors",
    "accelerations",
    "implicit_accelerations",
    "projection",
    "implicit_projection",
    "scalar",
];

/// Names of fields and methods that every mechanism has.
const TAKEN: [&str; 9] = [
    "gravity",
    "treatment",
    "regularisation",
    "connections",
    "new",
    "at_rest",
    "met_in",
    "state_from_array",
    "in_motion",
];

/// Checks everything; all mistakes are in the error.
pub(super) fn spec(input: &Input) -> syn::Result<Spec> {
    let mut mistakes = Mistakes::default();
    for (position, field) in input.fields.iter().enumerate() {
        if !KEYS.iter().any(|key| field.key == key) {
            let message = format!("unknown key `{}`, expected one of: {}", field.key, KEYS.join(", "));
            mistakes.add(field.key.span(), message);
        } else if input.fields[..position].iter().any(|earlier| earlier.key == field.key) {
            mistakes.add(field.key.span(), format!("`{}` is given twice", field.key));
        }
    }
    let find = |key: &str| input.fields.iter().find(|field| field.key == key);
    let scalar = find("scalar").and_then(|field| mistakes.keep(scalar(field))).unwrap_or(Scalar::F64);
    let gravity = find("gravity").map_or(quote! { [0.0, 0.0, 0.0] }, |field| field.value.clone());
    let Some(field) = find("bodies") else {
        let message = format!("`{}` needs bodies: write `bodies: {{ name: Type, ... }}`", input.name);
        mistakes.add(input.name.span(), message);
        return mistakes.verdict(()).and_then(|()| Err(syn::Error::new(input.name.span(), "no bodies")));
    };
    let mut bodies = mistakes.keep(bodies(field.value.clone())).unwrap_or_default();
    if bodies.is_empty() && mistakes.0.is_none() {
        mistakes.add(field.key.span(), "a mechanism has at least one body".to_owned());
    }
    let controls =
        find("controls").and_then(|field| mistakes.keep(controls(field, scalar))).unwrap_or_default();
    let treatment = find("constraints").and_then(|field| mistakes.keep(treatment(field, scalar)));
    let treatment = treatment.unwrap_or_else(|| quote! { ::ffrf::mechanism::Treatment::projection() });
    let section = |key: &str, mistakes: &mut Mistakes| -> Vec<Entry> {
        find(key).and_then(|field| mistakes.keep(entries(field.value.clone()))).unwrap_or_default()
    };
    let joint_entries = section("joints", &mut mistakes);
    let drive_entries = section("drives", &mut mistakes);
    let force_entries = section("forces", &mut mistakes);
    let sensor_entries = section("sensors", &mut mistakes);
    let names = |entries: &[Entry]| entries.iter().map(|entry| entry.name.clone()).collect::<Vec<_>>();
    let of_bodies: Vec<Ident> = bodies.iter().map(|body| body.name.clone()).collect();
    check_names(
        [
            ("body", of_bodies),
            ("joint", names(&joint_entries)),
            ("control", controls.iter().map(|control| control.name.clone()).collect()),
            ("drive", names(&drive_entries)),
            ("force", names(&force_entries)),
            ("sensor", names(&sensor_entries)),
        ],
        &mut mistakes,
    );
    let mut joints: Vec<Joint> = joint_entries
        .into_iter()
        .filter_map(|entry| joint(entry, &mut bodies, &scalar, &mut mistakes))
        .collect();
    let mut drives: Vec<Drive> = Vec::new();
    for entry in drive_entries {
        drives.extend(drive(entry, &joints, &drives, &scalar, &mut mistakes));
    }
    let connections = number(&mut joints, &mut drives);
    let forces: Vec<Force> = force_entries
        .into_iter()
        .filter_map(|entry| force(entry, &mut bodies, &joints, &scalar, &mut mistakes))
        .collect();
    let sensors: Vec<Sensor> = sensor_entries
        .into_iter()
        .filter_map(|entry| sensor(entry, &mut bodies, &joints, &drives, &scalar, &mut mistakes))
        .collect();
    let printed = ["accelerations", "implicit_accelerations", "projection", "implicit_projection"].map(find);
    let [explicit, implicit, projection, implicit_projection] =
        printed.map(|field| field.and_then(|field| accelerations(field, scalar, &mut mistakes)));
    // once is enough: what one of them cannot know of the other cannot either
    if let Some(field) = printed.into_iter().flatten().next() {
        check_known(&field.key, find("constraints"), &controls, &forces, &mut mistakes);
    }
    if mistakes.0.is_none() {
        check_held(&bodies, &joints, &mut mistakes);
    }
    mistakes.verdict(())?;
    let (topology, has_loops) = topology(&bodies, &joints, &drives, connections);
    let refused = |error: TopologyError| syn::Error::new(input.name.span(), error.to_string());
    let links: Vec<_> = forces.iter().flat_map(Force::soft_links).collect();
    let count = links.len();
    let whole = topology.with_soft_links(links);
    let hubs = if whole.check().is_ok() { whole.hubs() } else { Vec::new() };
    let plan = Plans::new(&topology, &hubs).map_err(refused)?;
    let soft = if count > 0 { Some((Plans::new(&whole, &hubs).map_err(refused)?, count)) } else { None };
    Ok(Spec {
        scalar,
        bodies,
        gravity,
        controls,
        treatment,
        joints,
        drives,
        forces,
        sensors,
        accelerations: explicit,
        implicit_accelerations: implicit,
        projection,
        implicit_projection,
        rows: topology.joints.iter().map(|joint| joint.rows).sum(),
        connections,
        hubs,
        plan,
        soft,
        has_loops,
        branches: topology.branches(),
    })
}

fn scalar(field: &Field) -> syn::Result<Scalar> {
    match field.value.to_string().as_str() {
        "f64" => Ok(Scalar::F64),
        "f32" => Ok(Scalar::F32),
        "generic" => Ok(Scalar::Generic),
        other => {
            let message = format!("`scalar` must be f64, f32 or generic, found `{other}`");
            Err(syn::Error::new(field.span, message))
        }
    }
}

/// Names are given once: those of a section, and those that become fields or methods.
fn check_names(sections: [(&str, Vec<Ident>); 6], mistakes: &mut Mistakes) {
    let mut seen: Vec<(&str, &Ident)> = Vec::new();
    for (kind, names) in &sections {
        for name in names {
            if name == GROUND {
                mistakes.add(name.span(), format!("`{GROUND}` is the name of what does not move"));
            } else if TAKEN.iter().any(|taken| name == taken) && *kind != "joint" {
                mistakes.add(name.span(), format!("`{name}` is a name that every mechanism has"));
            } else if let Some((other, _)) = seen.iter().find(|(_, earlier)| *earlier == name) {
                let message = if other == kind {
                    format!("there are two {} called `{name}`", plural(kind))
                } else {
                    format!("`{name}` is the name of a {other} and of a {kind}")
                };
                mistakes.add(name.span(), message);
            }
            seen.push((kind, name));
        }
    }
}

fn plural(kind: &str) -> String {
    kind.strip_suffix('y').map_or_else(|| format!("{kind}s"), |stem| format!("{stem}ies"))
}

/// Numbers the connections: each drive follows its joint. Gives their number.
fn number(joints: &mut [Joint], drives: &mut [Drive]) -> usize {
    let mut next = 0;
    for (index, joint) in joints.iter_mut().enumerate() {
        joint.first = next;
        next += joint.len();
        for drive in drives.iter_mut().filter(|drive| drive.of.joint == index) {
            drive.first = next;
            next += drive.len();
        }
    }
    next
}

/// Every body has a joint, or is said to be free.
fn check_held(bodies: &[Body], joints: &[Joint], mistakes: &mut Mistakes) {
    let held: Vec<usize> =
        joints.iter().flat_map(Joint::topology).flat_map(|joint| joint.ends).flatten().collect();
    for body in bodies {
        let loose = (0..body.len()).find(|index| !held.contains(&(body.first + index)));
        match loose {
            Some(index) if !body.free => {
                let name = &body.name;
                let which = body.count.map_or(format!("`{name}`"), |_| format!("`{name}[{index}]`"));
                let message =
                    format!("body {which} has no joint; if it is meant to fly, write `{name}: free ...`");
                mistakes.add(name.span(), message);
            }
            _ => {}
        }
    }
}

/// All bodies and connections in their order, and whether joints close loops: drives do not.
fn topology(bodies: &[Body], joints: &[Joint], drives: &[Drive], connections: usize) -> (Topology, bool) {
    let flexible: Vec<bool> =
        bodies.iter().flat_map(|body| std::iter::repeat_n(body.is_flexible(), body.len())).collect();
    let alone =
        Topology { flexible: flexible.clone(), joints: joints.iter().flat_map(Joint::topology).collect() };
    let mut all = Vec::with_capacity(connections);
    for (index, joint) in joints.iter().enumerate() {
        all.extend(joint.topology());
        let own = drives.iter().filter(|drive| drive.of.joint == index);
        all.extend(own.flat_map(|drive| drive.topology(joints)));
    }
    let has_loops = alone.check().is_ok() && alone.has_loops();
    (Topology { flexible, joints: all }, has_loops)
}
