//! Bodies far from the origin.

use ffrf::nalgebra::Vector3;
use ffrf::{FlexibleBody, FreeBody};

use crate::row;
use crate::settings::{Rod, Setting, largest};
use crate::table::{Figure, Real, Section, below, refused};

/// Units in the last place of a position 1e9 m away: as often as it enters a residual (both ends, and the turned arms, which are
/// exact beside it), and as many as a projection leaves, twice 2ε of it.
const RESOLVED: [f64; 2] = [8.0 * 1.2e-7, 8.0 * 64.0];

pub fn section() -> Section {
    Section {
        title: "A body 1e9 m from the origin",
        text: "The equations of a body know its place only through loads and joints: orientation, deformation and all \
               velocities of a free rod at (1e9, 1e9, 1e9) m are those at the origin to the last bit. A joint between bodies \
               there is met as far as the number type resolves places: 1.2e-7 m in f64, 64 m in f32 (largest residual in \
               100 steps of a pendulum of 1 m, in m). In f32 nothing moves there by less than 64 m: it turns in place.",
        rows: vec![
            row!("free rod", free_rod),
            row!("pendulum, RK4", pendulum, false),
            row!("pendulum, linearly implicit", pendulum, true),
        ],
    }
}

fn free_rod<T: Real>() -> Figure {
    let start = |distance: f64| {
        let mut body = FreeBody::new(Rod)
            .with_position(Vector3::repeat(T::of(distance)))
            .with_spin(Vector3::new(T::of(10.0), T::of(200.0), T::of(-30.0)))
            .with_velocity(Vector3::new(T::of(100.0), T::zero(), T::one()));
        body.state.modal_coordinates.as_mut_slice()[0] = T::of(1e-4);
        body
    };
    let (mut near, mut far) = (start(0.0), start(1e9));
    let step = FlexibleBody::<T>::largest_stable_step(&Rod).unwrap() * T::of(0.25);
    for _ in 0..1_000 {
        near.step_rk4(step, &()).unwrap();
        far.step_rk4(step, &()).unwrap();
    }
    near.state.position = far.state.position;
    assert_eq!(near.state, far.state);
    Figure::Holds("same bits")
}

fn pendulum<T: Real>(implicit: bool) -> Figure {
    let mut setting = Setting::<T>::of(
        "[simulation]\nduration = 1.0\nstep = 1e-3\ngravity = [0.0, -9.81, 0.0]\n\
         [bodies.bob]\nmass = 1.0\ninertia = [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]\n\
         position = [1000000001.0, 1e9, 0.0]\n\
         [joints.pin]\nkind = \"revolute\"\nfirst = \"ground\"\nfirst_position = [1e9, 1e9, 0.0]\nsecond = \"bob\"\n\
         second_position = [-1.0, 0.0, 0.0]\naxis = [0.0, 0.0, 1.0]\n",
    );
    let mut residual = 0.0;
    for _ in 0..100 {
        let step = T::of(1e-3);
        let report = setting.step(step, implicit);
        match report {
            Ok(report) => residual = largest([residual, report.drift.position.double()]),
            Err(error) => return refused(error),
        }
    }
    assert!(setting.is_finite());
    below::<T>(residual, RESOLVED)
}
