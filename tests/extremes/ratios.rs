//! Masses that are a million million times as large as others.

use ffrf::FreeBody;

use crate::row;
use crate::settings::{Setting, largest};
use crate::table::{Figure, Real, Section, below, refused};
use crate::tolerances::{PENDULUM, vibration_of_ratio};
use crate::two_masses::{kernels, modal, two_masses};

pub fn section() -> Section {
    let mut rows = vec![
        row!("second body 1e-12 of the first", double_pendulum, 1e-12),
        row!("second body 1e-6 of the first", double_pendulum, 1e-6),
        row!("second body 1e6 of the first", double_pendulum, 1e6),
        row!("second body 1e12 of the first", double_pendulum, 1e12),
        row!("path of a pendulum with 1e-12 of its mass hanging on it", path),
    ];
    for exponent in [-12, -6, 0, 3, 6, 9, 12] {
        rows.push(row!(format!("mode of 1e{exponent} of the frame's mass"), modes, 10.0_f64.powi(exponent)));
    }
    Section {
        title: "Mass ratios from 1e-12 to 1e12",
        text: "Bodies: a double pendulum, 1,000 RK4 steps of 1 ms: drift of the energy over the largest kinetic energy, and the \
               residual of the joints (m) before they are corrected; bodies of any ratio keep their digits, because joints that close no loop \
               are swept over. Modes: a mass on a spring in a free frame of 1 kg, 1,000 RK4 steps of 0.01 rad: distance from the \
               exact vibration over its amplitude. What a heavy mode leaves of the frame's mass is a difference; from 1e10 on the model is refused, from 5e5 on in f32.",
        rows,
    }
}

fn text(mass: Option<f64>) -> String {
    let mut text = "[simulation]\nduration = 1.0\nstep = 1e-3\ngravity = [0.0, -9.81, 0.0]\n\
         [bodies.upper]\nmass = 1.0\ninertia = [[0.01, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]\nposition = [0.5, 0.0, 0.0]\n"
        .to_owned();
    let pin = "[joints.pin]\nkind = \"revolute\"\nfirst = \"ground\"\nsecond = \"upper\"\nsecond_position = [-0.5, 0.0, 0.0]\n";
    if let Some(mass) = mass {
        let [small, large] = [0.01 * mass, 0.1 * mass];
        text += &format!(
            "[bodies.lower]\nmass = {mass:e}\ninertia = [[{large:e}, 0.0, 0.0], [0.0, {small:e}, 0.0], [0.0, 0.0, {large:e}]]\n\
             position = [1.0, -0.5, 0.0]\n{pin}\
             [joints.hinge]\nkind = \"revolute\"\nfirst = \"upper\"\nfirst_position = [0.5, 0.0, 0.0]\nsecond = \"lower\"\n\
             second_position = [0.0, 0.5, 0.0]\n"
        );
    } else {
        text += pin;
    }
    text
}

fn double_pendulum<T: Real>(mass: f64) -> Figure {
    let mut setting = Setting::<T>::of(&text(Some(mass)));
    let first = setting.energy();
    let (mut drift, mut kinetic, mut residual) = (0.0_f64, 0.0_f64, 0.0);
    for _ in 0..1_000 {
        match setting.step(T::of(1e-3), false) {
            Ok(report) => residual = largest([residual, report.drift.position.double()]),
            Err(error) => return refused(error),
        }
        let energy = setting.energy();
        drift = largest([drift, (energy - first).abs()]);
        kinetic = kinetic.max(setting.kinetic_energy());
    }
    below::<T>(largest([drift / kinetic, residual]), PENDULUM)
}

fn path<T: Real>() -> Figure {
    let (mut with, mut alone) = (Setting::<T>::of(&text(Some(1e-12))), Setting::<T>::of(&text(None)));
    let mut apart = 0.0;
    for _ in 0..1_000 {
        with.step(T::of(1e-3), false).unwrap();
        alone.step(T::of(1e-3), false).unwrap();
        apart = largest([apart, (with.states[0].position - alone.states[0].position).norm().double()]);
    }
    below::<T>(apart, PENDULUM)
}

/// Units: rad/s.
const FREQUENCY: f64 = 10.0;
/// Units: m.
const AMPLITUDE: f64 = 0.01;

fn modes<T: Real>(ratio: f64) -> Figure {
    // the mass and the frame against each other
    let reduced = ratio / (1.0 + ratio);
    let body = match kernels::<T>(&two_masses(ratio, FREQUENCY * FREQUENCY * reduced)) {
        Ok(body) => body,
        Err(error) => return refused(error),
    };
    let mut free = FreeBody::new(body).with_deformation(modal(&[AMPLITUDE]), modal(&[0.0]));
    let step = 0.01 / FREQUENCY;
    let mut worst = 0.0;
    for k in 1..=1_000 {
        if let Err(error) = free.step_rk4(T::of(step), &()) {
            return refused(error);
        }
        let exact = AMPLITUDE * (FREQUENCY * step * f64::from(k)).cos();
        worst = largest([worst, (free.state.modal_coordinates.0[0].double() - exact).abs() / AMPLITUDE]);
    }
    below::<T>(worst, vibration_of_ratio(ratio))
}
