//! The same part in other units.

use std::path::Path;

use ffrf::{ModalVector, State};
use ffrf_host::HostModal;
use ffrf_model::ReducedBody;

use crate::row;
use crate::settings::{Setting, largest};
use crate::table::{Figure, Real, Section, below, refused};
use crate::tolerances::SAME_IN_UNITS;

pub fn section() -> Section {
    Section {
        title: "Units: mm, t, s against SI, and others",
        text: "The connecting rod (2 modes) hangs on a pin, with a weight on a ball joint at its other end, a bushing, a spring \
               and friction; 500 steps of 2 µs (RK4) and 100 µs (linearly implicit). Written in other units, the motion is the \
               same: distance of positions and velocities from those in SI over their largest, orientations as they are. \
               Tolerances have units: what a projection may leave is 1e-6 units of length (1e-4 in f32), and it ends at 16 roundings of \
               one; so a unit in which a part is between 1e-3 and 1e3 is best.",
        rows: vec![
            row!("mm, t, s: RK4", other_units, [1e3, 1e-3], false),
            row!("mm, t, s: linearly implicit", other_units, [1e3, 1e-3], true),
            row!("µm, ng, s: RK4", other_units, [1e6, 1e12], false),
            row!("µm, ng, s: linearly implicit", other_units, [1e6, 1e12], true),
            row!("km, kt, s: RK4", other_units, [1e-3, 1e-6], false),
            row!("km, kt, s: linearly implicit", other_units, [1e-3, 1e-6], true),
        ],
    }
}

/// A model in units of which one metre has `length` and one kilogram `mass`.
fn in_units(mut body: ReducedBody, [length, mass]: [f64; 2]) -> ReducedBody {
    let scale = |numbers: &mut [f64], factor: f64| numbers.iter_mut().for_each(|x| *x *= factor);
    let inertia = &mut body.inertia;
    inertia.mass *= mass;
    scale(&mut inertia.first_moment, mass * length);
    // modal coordinates stay numbers of the same size: mode shapes have the unit of length
    scale(inertia.modal_first_moment.as_flattened_mut(), mass * length);
    let square = mass * length * length;
    scale(inertia.second_moment.as_flattened_mut(), square);
    scale(inertia.position_mode_moment.as_flattened_mut().as_flattened_mut(), square);
    for row in &mut inertia.mode_mode_moment {
        scale(row.as_flattened_mut().as_flattened_mut(), square);
    }
    for row in body.stiffness.iter_mut().chain(&mut body.damping) {
        scale(row, square);
    }
    for marker in &mut body.markers {
        scale(&mut marker.position, length);
        scale(marker.translation.as_flattened_mut(), length);
    }
    body.stress_markers.clear();
    body.geometric_stiffness = None;
    body
}

fn setting<T: Real>([length, mass]: [f64; 2]) -> Setting<T> {
    let models = Path::new(env!("CARGO_MANIFEST_DIR")).join("models");
    let body = in_units(ReducedBody::read(models.join("conrod.ffrf.json")).unwrap(), [length, mass]);
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("rod.ffrf.json");
    std::fs::write(&model, body.to_json().unwrap()).unwrap();
    let big_end = body.markers.iter().find(|marker| marker.name == "BIG_END").unwrap().position[0];
    let small_end = body.markers.iter().find(|marker| marker.name == "SMALL_END").unwrap().position[0];
    let (square, force, model) = (mass * length * length, mass * length, model.display());
    let text = format!(
        "[simulation]\nduration = 1.0\nstep = 1e-3\ngravity = [0.0, {gravity:e}, 0.0]\n\
         [bodies.rod]\nmodel = \"{model}\"\nmodes = 2\nposition = [{start:e}, 0.0, 0.0]\n\
         [bodies.bob]\nmass = {bob:e}\ninertia = [[{i:e}, 0.0, 0.0], [0.0, {i:e}, 0.0], [0.0, 0.0, {i:e}]]\n\
         position = [{end:e}, 0.0, 0.0]\nangular_velocity = [3.0, 0.0, 5.0]\n\
         [joints.pin]\nkind = \"revolute\"\nfirst = \"ground\"\nsecond = \"rod.BIG_END\"\n\
         [joints.ball]\nkind = \"spherical\"\nfirst = \"rod.SMALL_END\"\nsecond = \"bob\"\n\
         [forces.spring]\nkind = \"spring\"\nfirst = \"ground\"\nfirst_position = [0.0, {length:e}, 0.0]\nsecond = \"bob\"\n\
         stiffness = {spring:e}\ndamping = {mass:e}\nrest = {length:e}\n\
         [forces.bushing]\nkind = \"bushing\"\nfirst = \"rod\"\nsecond = \"bob\"\n\
         stiffness_matrix = [0.0, 0.0, 0.0, {coil:e}, {coil:e}, {coil:e}]\ndamping_matrix = [0.0, 0.0, 0.0, {rub:e}, {rub:e}, {rub:e}]\n\
         [forces.rubbing]\nkind = \"friction\"\njoint = \"pin\"\nlimit = {limit:e}\nspeed = 0.1\n\
         [forces.push]\nkind = \"force\"\nsecond = \"rod.SMALL_END\"\nvalue = [0.0, 0.0, {force:e}]\n",
        gravity = -9.81 * length,
        start = -big_end,
        bob = 0.2 * mass,
        i = 1e-4 * square,
        end = small_end - big_end,
        spring = 100.0 * mass,
        coil = 0.1 * square,
        rub = 1e-4 * square,
        limit = 0.01 * square,
    );
    Setting::of(&text)
}

fn other_units<T: Real>(units: [f64; 2], implicit: bool) -> Figure {
    let (mut si, mut other) = (setting::<T>([1.0, 1.0]), setting::<T>(units));
    let step = T::of(if implicit { 1e-4 } else { 2e-6 });
    for _ in 0..500 {
        for setting in [&mut si, &mut other] {
            let report = setting.step(step, implicit);
            if let Err(error) = report {
                return refused(error);
            }
        }
    }
    let mut worst = 0.0;
    for (one, two) in si.states.iter().zip(&other.states) {
        let parts = |state: &State<HostModal<T>, T>, length: f64| {
            let q = &state.modal_coordinates;
            [
                state.position.iter().map(|x| x.double() / length).collect::<Vec<f64>>(),
                state.velocity.iter().map(|x| x.double() / length).collect(),
                state.angular_velocity.iter().map(|x| x.double()).collect(),
                state.orientation.coords.iter().map(|x| x.double()).collect(),
                q.as_slice().iter().map(|x| x.double()).collect(),
            ]
        };
        for (one, two) in parts(one, 1.0).iter().zip(&parts(two, units[0])) {
            let size = largest(one.iter().map(|x| x.abs())).max(1e-300);
            worst = largest([worst, largest(one.iter().zip(two).map(|(a, b)| (a - b).abs())) / size]);
        }
    }
    below::<T>(worst, SAME_IN_UNITS)
}
