//! Stiffness from zero to 1e15.

use ffrf::nalgebra::Vector3;
use ffrf::{FreeBody, Gravity, State, StepError, StepReport};
use ffrf_host::HostBody;

use crate::row;
use crate::settings::{Setting, largest};
use crate::table::{Figure, Real, Section, below, refused};
use crate::tolerances::{FRAME_OF_STIFF_MODE, STIFF_SPRING};
use crate::two_masses::{kernels, modal, two_masses};

/// Units: s.
const STEP: f64 = 1e-3;

const STIFFNESS: [f64; 6] = [0.0, 1.0, 1e4, 1e8, 1e12, 1e15];

pub fn section() -> Section {
    let mut rows = Vec::new();
    for stiffness in STIFFNESS {
        rows.push(row!(format!("mode of {stiffness:.0e} N/m, linearly implicit"), implicit_mode, stiffness));
    }
    for stiffness in STIFFNESS {
        rows.push(row!(format!("mode of {stiffness:.0e} N/m, RK4"), explicit_mode, stiffness));
    }
    for stiffness in STIFFNESS {
        rows.push(row!(format!("spring of {stiffness:.0e} N/m, linearly implicit"), spring, stiffness, true));
    }
    for stiffness in STIFFNESS {
        rows.push(row!(format!("spring of {stiffness:.0e} N/m, RK4"), spring, stiffness, false));
    }
    Section {
        title: "Stiffness from 0 to 1e15 N/m",
        text: "1,000 steps of 1 ms. Mode: a mass of 0.5 kg on a spring in a free frame of 1 kg that falls and turns with 1 rad/s: \
               distance (m) of the frame's centre and of the mode from where a rigid body is and a steady force holds the mode, \
               for stiffness from 1e4 N/m on; below, that it is finite. Spring: a body of 1 kg hangs on it between bodies that \
               turn, and comes to rest where its weight holds it: what is left (m) of vibration after 1 s. Implicit steps take any stiffness; \
               explicit ones are refused beyond their limit, if anything moves the mode: nothing does here, so that it stays where \
               it is. `ffrf simulate` says which step modes, joints and force elements together allow.",
        rows,
    }
}

fn free<T: Real>(stiffness: f64) -> FreeBody<HostBody<T>, T> {
    let body = kernels::<T>(&two_masses(0.5, stiffness)).unwrap();
    FreeBody::new(body).with_deformation(modal(&[0.0]), modal(&[0.0])).with_spin(Vector3::new(
        T::zero(),
        T::zero(),
        T::one(),
    ))
}

fn mode<T: Real>(
    stiffness: f64,
    step: impl Fn(&mut FreeBody<HostBody<T>, T>, &Gravity<T>) -> Result<StepReport<T>, StepError>,
) -> Figure {
    let gravity = Gravity { acceleration: Vector3::new(T::zero(), T::zero(), T::of(-9.81)) };
    let mut body = free::<T>(stiffness);
    for k in 1..=1_000 {
        if let Err(error) = step(&mut body, &gravity) {
            return refused(error);
        }
        assert!(body.state.is_finite(), "step {k}");
    }
    if stiffness < 1e4 {
        return Figure::Holds("finite");
    }
    let fallen = -9.81 * 0.5;
    let off = Vector3::new(
        body.state.position.x.double(),
        body.state.position.y.double(),
        body.state.position.z.double() - fallen,
    );
    below::<T>(off.norm() + body.state.modal_coordinates.0[0].double().abs(), FRAME_OF_STIFF_MODE)
}

fn implicit_mode<T: Real>(stiffness: f64) -> Figure {
    mode(stiffness, |body, gravity| body.step_linearly_implicit(T::of(STEP), gravity))
}

fn explicit_mode<T: Real>(stiffness: f64) -> Figure {
    mode(stiffness, |body, gravity| body.step_rk4(T::of(STEP), gravity))
}

fn spring<T: Real>(stiffness: f64, implicit: bool) -> Figure {
    // half of critical damping
    let damping = stiffness.sqrt();
    let mut setting = Setting::<T>::of(&format!(
        "[simulation]\nduration = 1.0\nstep = 1e-3\ngravity = [0.0, 0.0, -9.81]\n\
         [bodies.wheel]\nmass = 1.0\ninertia = [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]\n\
         angular_velocity = [0.0, 0.0, 1.0]\n\
         [bodies.bob]\nmass = 1.0\ninertia = [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]\nposition = [0.0, 0.0, -1.0]\n\
         [joints.pin]\nkind = \"revolute\"\nfirst = \"ground\"\nsecond = \"wheel\"\n\
         [joints.guide]\nkind = \"prismatic\"\nfirst = \"ground\"\nsecond = \"bob\"\n\
         [forces.spring]\nkind = \"spring\"\nfirst = \"wheel\"\nsecond = \"bob\"\nstiffness = {stiffness:e}\n\
         damping = {damping:e}\nrest = 1.0\n"
    ));
    let step = T::of(STEP);
    for k in 0..1_000 {
        let report = setting.step(step, implicit);
        if let Err(error) = report {
            return refused(error);
        }
        assert!(setting.is_finite(), "step {k}");
    }
    if stiffness < 1e4 {
        return Figure::Holds("finite");
    }
    let State { position, .. } = &setting.states[1];
    let held = -1.0 - 9.81 / stiffness;
    below::<T>(largest([(position.z.double() - held).abs()]), STIFF_SPRING)
}
